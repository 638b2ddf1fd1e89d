// planewright-bench live: how long after a slider moves the window could show the first planar panels.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_live(CLI::App& app);

}  // namespace planewright::bench
