// The options that dual, planarize and panels share, as the user gave them.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/design/layer_settings.h"
#include "core/solve/solver_choice.h"

namespace planewright::cli {

struct SolveCommandOptions {
  std::string input, output, report, project, unit = "m";
  SolverKind solver = SolverKind::Auto;
  LayerSettings settings;     // what one option gives whole: mode, offset, freedom, side, limits
  bool mode_by_mesh = false;  // `panels`: triangles become a dual, anything else is planarized
  bool quiet = false, explicit_points = false;

  // Parsed later, with messages of their own.
  std::string preset, weights;
  std::vector<std::string> constraints;
  bool no_penetration = false;
  std::string pins, selections, reference, layers, beams;  // files; layers: or a list
  std::vector<std::string> waive;
  double thickness = 0.0;
};

// Declares them on a command.
void declare_solve_options(CLI::App& command, const std::shared_ptr<SolveCommandOptions>& options);
// Those of a solve whose panels are not written: all but -o, --thickness and --beams. Returned: what only
// steers the solve.
std::vector<CLI::Option*> declare_unwritten_solve_options(
    CLI::App& command, const std::shared_ptr<SolveCommandOptions>& options);
// For duals.
CLI::Option* declare_border_option(CLI::App& command, const std::shared_ptr<SolveCommandOptions>& options);

}  // namespace planewright::cli
