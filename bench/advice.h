// planewright-bench advice: how well the gain that a local solve predicts ranks edits, against the gain after a full
// re-solve, and what the rating costs.
#pragma once

#include <CLI/CLI.hpp>

namespace planewright::bench {

void declare_advice(CLI::App& app);

}  // namespace planewright::bench
