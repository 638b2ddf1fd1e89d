// RunOptions: what every comparison takes from the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "child_process.h"

namespace planewright::bench {

struct RunOptions {
  std::vector<std::string> only;  // contenders
  std::vector<std::string> models;
  std::string meshes;  // folder; empty: looked for
  int repeat = 1;      // best CPU time of so many
  ChildLimits limits;
};

// The defaults of only and models are those that options hold already.
inline void declare_models(CLI::App& command, RunOptions& options) {
  command
      .add_option("--models", options.models,
                  "torus-1k, torus-10k, torus-100k, torus-1m, fertility, dragon, train-station")
      ->delimiter(',')
      ->capture_default_str();
  command.add_option(
      "--meshes", options.meshes,
      "Folder of the real meshes (default: $PLANEWRIGHT_MESHES, else shared/meshes near the source)");
  command.add_option("--repeat", options.repeat, "Measure each row so often; the least CPU time counts")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_option("--limit", options.limits.seconds, "Cut a row off after so many seconds of wall time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command
      .add_option("--memory", options.limits.memory_gb, "Refuse a row more address space, GB; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

inline void declare_solvers(CLI::App& command, RunOptions& options) {
  command.add_option("--only", options.only, "Solvers: default, tuned, ipopt, tangent, auto")
      ->delimiter(',')
      ->capture_default_str();
}

}  // namespace planewright::bench
