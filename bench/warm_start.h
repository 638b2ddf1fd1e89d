// planewright-bench warm-start: how many iterations Ipopt needs alone, and how many to confirm what the
// tangent solver hands it (auto).
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_warm_start(CLI::App& app);

}  // namespace planewright::bench
