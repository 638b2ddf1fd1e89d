// What the badge over the model says: which solver made what is shown, how that stands, how planar it is and
// what it took. Words alone; draw_solve_badge() of panels.h draws them.
//
// Threads: pure functions. Units: planarity in model units, residuals as reports have them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/solve/iteration.h"
#include "core/solve/solve_report.h"

namespace planewright::ui {

class AppState;

// How the solve of the active layer stands.
struct SolveStanding {
  std::string opening;      // name of what is being opened; empty: nothing
  std::string other_layer;  // name of the layer that the solver works on instead; empty: none
  bool solving = false;
  bool polishing = false;  // that solve is a polish
  bool polished = false;   // the result is one of a polish
  bool outdated = false;   // the result is of an earlier design
  bool saved = false;      // what is shown is as a project had it; there is no report
  std::string made_by;     // what is shown: "tangent", "ipopt", "tangent, ipopt"; empty: nothing is shown
  const SolveReport* report = nullptr;  // of the newest result; null: none
  const Iteration* newest = nullptr;    // step of the running solve; null: none yet
  double milliseconds_per_step = 0.0;   // 0: unknown
  std::optional<double> planarity;      // of the panels shown
  double planarity_tolerance = 0.0;
};
SolveStanding standing_of(const AppState& state);

struct SolveBadge {
  enum class Tone { Quiet, Busy, Good, Confirmed, Warning };
  Tone tone = Tone::Quiet;
  std::string headline;   // "Tangent, live"; empty: there is nothing to say
  std::string planarity;  // "planar to 2e-10 m"
  std::string pace;       // "31 ms/step", "14 steps, 0.4 s"
  std::vector<std::pair<std::string, std::string>> details;  // name and value
  std::string explanation;                                   // a sentence or two, may be empty
};
SolveBadge solve_badge(const SolveStanding& standing, const std::string& unit);

// "Tangent", "Ipopt": who had the last word.
std::string last_solver(const std::string& solvers);
// As a report names it: "Tangent, confirmed by Ipopt".
std::string solver_line(const SolveReport& report);

}  // namespace planewright::ui
