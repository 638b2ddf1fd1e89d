// Demand projection: moves a whole state as little as possible to where every row of a problem is met at
// once, incidences to rounding and demands within their bounds. The last step of every solve, and what makes
// the tangent solver's frames planar.
//
// Levenberg-Marquardt on  Phi = 1/2 sum c^2 + 1/2 sum (distance from the bounds)^2  with damping in
// proportion to Phi: safe far away, quadratic near the end. Inequalities aim a hair inside their bounds, so
// that rounding cannot flip them; near the end a step is repeated with the rows that it would violate (a
// small active set). A factorisation serves further steps as long as each takes most of what is left (chord
// steps: an eighth of the cost). Of alternatives the one that the state is closer to counts. Energies play no
// part: run more steps of a solver first where its move matters. Threads: uses MUMPS through its gate.
// Deterministic.
#pragma once

#include <stop_token>

#include "core/problem/problem.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

struct DemandProjectionReport {
  double incidence = 0.0;  // largest violation of an equation afterwards, mean edges or unit-free
  // Largest violation of any row but the unit normals and those that cannot change, mean edges or unit-free.
  double violation = 0.0;
  double move = 0.0;  // farthest that a point moved, mean edges
  int steps = 0, factorisations = 0;
  bool met = false;            // every row within kDemandTolerance
  bool planar = false;         // every incidence is, demands or not
  bool out_of_memory = false;  // what ended it
};

inline constexpr double kDemandTolerance = 1e-9;  // mean edges
inline constexpr int kDemandProjectionSteps = 120;
// Incidence violation at which a projection ends, mean edges: as close as rounding allows, and a frame that
// is only looked at.
inline constexpr double kRoundingTarget = 1e-13, kFrameTarget = 1e-11;

// z: normalised, changed in place; each accepted step lowers Phi. Where a row is not a number at z, nothing
// is changed and the violations are infinite. max_steps: accepted steps, chord steps not counted. cache may
// be null. target: mean edges.
DemandProjectionReport project_onto_demands(const Problem& problem, Vector& z,
                                            int max_steps = kDemandProjectionSteps, std::stop_token stop = {},
                                            TangentCache* cache = nullptr, double target = kRoundingTarget);

}  // namespace planewright
