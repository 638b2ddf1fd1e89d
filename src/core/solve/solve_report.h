// SolveReport: how a solve ended, in words a person understands, with the best state it had.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/complex/state.h"
#include "core/problem/demand.h"

namespace planewright {

// Of a solve with SolveOptions::draft.
inline constexpr const char* kDraftReason = "a draft: the demands are met, the energy may still fall";

enum class SolveStatus {
  Converged,   // feasible and first-order stationary to the tolerances
  Planar,      // the panels are planar, but the energy was still moving: stopped by a limit or a stall
  Stopped,     // by the user; the best state so far is kept
  NotPlanar,   // no planar state was reached
  Infeasible,  // the demands contradict each other (locally)
  Failed,      // numerical breakdown, out of memory; see stop_reason
};
const char* name(SolveStatus status);  // "converged", "planar, not converged", ...

struct SolveReport {
  SolveStatus status = SolveStatus::Failed;
  std::string stop_reason;  // one sentence
  std::string solver;       // who made the state: "tangent", "ipopt", "tangent, ipopt" (begun, confirmed)
  int iterations = 0;
  double seconds = 0.0;  // wall
  // After the final projection, at the reported state:
  // Inf-norm of the Lagrangian's gradient, weights relative to the largest one, lengths in mean edges.
  double first_order_residual = 0.0;
  double incidence_residual = 0.0;  // largest |n.(x - v) - h|, mean edges
  double projection_move = 0.0;     // farthest that the projection moved a point, mean edges
  struct Energy {
    std::string name;
    double weight, value;  // value: weighted contribution to the objective
  };
  std::vector<Energy> energies;
  struct Constraint {
    std::string name;
    double max_violation = 0.0;  // mean edges (or unit-free, as the constraint says)
    int violated = 0;            // rows beyond the tolerance
    std::string unit = {};
    int rows = 0;
    ElementRef worst = {};  // where max_violation is; meaningless if that is 0
    int waived = 0;         // rows that were given up (Demands::waived) and do not count in the others
  };
  std::vector<Constraint> constraints;
  // Infeasible: demands at elements that cannot be met together with the rest; without them (LayerSettings::
  // demands.waived) the same solve succeeds, and `state` is its result.
  std::vector<Waiver> conflicts;
  int rounds = 1;      // solves that it took: renewed foot points, separated crossings, conflicts set aside
  int crossings = -1;  // pairs of a panel and a mesh face that cross; -1: not counted
  int crossings_waived = 0;  // of these, pairs at panels where "no-penetration" was given up
  State state;               // model units, like every State
  Vector multipliers;  // of the problem's constraint rows (normalised units), for warm starts; may be empty
};

}  // namespace planewright
