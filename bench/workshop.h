// planewright-bench workshop: what an export in all formats costs, certificate included, stage by stage.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_workshop(CLI::App& app);

}  // namespace planewright::bench
