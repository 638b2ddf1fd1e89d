// planewright-bench findings: what each detector of bad places costs, and how many it finds.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_findings(CLI::App& app);

}  // namespace planewright::bench
