// planewright-bench compare: solvers side by side, each to the same first-order residual, and how the result
// stands against the goals.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_compare(CLI::App& app);

}  // namespace planewright::bench
