// TangentSolver: the structured solver of this project (design notes, vtpi.md section 7). Where Ipopt
// factorises one large indefinite system a step, this one turns planes in tangent coordinates, eliminates
// points, and factorises a small positive definite matrix whose analysis it keeps from solve to solve:
// milliseconds where the general solver takes seconds, and exactly planar panels in every frame
// (planar_frames.h).
//
//   1. Gauss-Newton steps straight from the start, where the linearisation holds there: smooth designs, and
//      every solve that starts at the result of one of nearly the same problem.
//   2. Otherwise, and with demands, an augmented Lagrangian first (augmented_lagrangian.h): softly held rows
//      find their way past folds that stiff ones get caught in.
//   3. Primal-dual Newton steps to the end (primal_dual_newton.h), for energies and demands alike.
//   4. A projection onto all rows, planarity to rounding (demand_projection.h), and multipliers there.
//
// Takes every energy, demand and pin that a Problem can have. Uses MUMPS through its gate. Deterministic.
#pragma once

#include <memory>

#include "core/solve/solver.h"

namespace planewright {

// The returned solver keeps analyses, multipliers and the damping between solves: use it for one design at a
// time.
std::unique_ptr<Solver> make_tangent_solver();

}  // namespace planewright
