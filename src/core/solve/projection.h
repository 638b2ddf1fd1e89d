// Projection: moves a whole state, points and planes together, as little as possible onto its incidences, so
// that planarity reaches rounding whatever accuracy the solver stopped at.
//
// Levenberg-Marquardt on 1/2 |c|^2 with damping in proportion to |c|^2: safe far away, quadratic near the
// end, and unlike a fixed damping not slowed down in flat places, where the incidences become dependent. The
// points are eliminated (design notes, vtpi.md section 7), which leaves one positive definite system on the
// planes, three unknowns each: two turns of n and the change of h. Threads: uses MUMPS through its gate.
// Deterministic.
#pragma once

#include <stop_token>

#include "core/complex/state.h"
#include "core/problem/layout.h"

namespace planewright {

inline constexpr double kProjectionTarget = 1e-13;  // mean edges
inline constexpr int kProjectionSteps = 60;

struct ProjectionReport {
  double before = 0.0, after = 0.0;  // largest |incidence residual|, mean edges
  double move = 0.0;                 // farthest that a point moved, mean edges
  int factorisations = 0;
  bool reached = false;  // after <= 10 targets: rounding may not let it get closer
};

// state: in model units, changed in place; each accepted step lowers the residual, so it is never worse than
// before. target: mean edges. Freedom says which of n and h may move; with Fixed only points move, each to
// the place on its planes nearest to it. A stop request ends it after the running factorisation.
ProjectionReport project_onto_incidences(const TangentComplex& complex, State& state, Freedom freedom,
                                         double target = kProjectionTarget,
                                         int max_factorisations = kProjectionSteps,
                                         std::stop_token stop = {});

}  // namespace planewright
