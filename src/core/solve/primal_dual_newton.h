// Primal-dual Newton: the second phase of the tangent solver. Each step solves the linearised optimality
// conditions for the move and the multipliers at once, in the tangent space (tangent_equations.h):
//
//     (H + sum_active rho g g^T + damping) d = -(grad f + sum slopes g),   y+ = y + rho (c + g.d - bound),
//
// H: Gauss-Newton's Hessian plus a share theta of the curvature of rows and residuals. With theta = 1 this is
// Newton's method on the optimality conditions, 1 / rho being a regularisation of the multipliers that lets
// rows depend on each other (flat places); it ends quadratically. Far from the end the full curvature is
// indefinite in a few places: a factorisation that counts negative pivots lowers theta, good ones raise it.
// Step rule: Levenberg-Marquardt damping by the ratio of actual to predicted decrease of an augmented
// Lagrangian with the new multipliers y+ and a moderate penalty of its own, and no step moves a point by more
// than kLongestStep.
//
// Found by trial on the irregular meshes and the paper's constraints (docs/solver.md): equations may get as
// stiff as 1e7 once steps are short; inequalities beyond 1e3 only while the same ones push from step to step,
// since else their active set flips for ever.
// Threads: uses MUMPS through its gate. Deterministic. Units: normalised; energies relative to the largest
// weight.
#pragma once

#include <stop_token>
#include <string>

#include "core/problem/problem.h"
#include "core/solve/planar_frames.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

enum class NewtonEnd {
  Converged,  // rows met to `feasible`, slope of the Lagrangian below `first_order`
  Flat,       // the energy of the projected state no longer falls, the slope does not either
  StepLimit,
  Stopped,
  NotStraight,  // see NewtonOptions::only_straight
  NoStep,       // no step of any damping lowered the merit
  NotFinite,    // a function or a step was not a finite number
  OutOfMemory,
};

struct NewtonOptions {
  int max_steps = 500;  // factorisations that led to an accepted step
  double feasible = 1e-7, first_order = 3e-4;
  // Begin with Gauss-Newton steps and turn to curvature only where they do not converge by themselves.
  bool begin_gauss_newton = false;
  // The start is a solution but for the last digits: full curvature and stiff equations at once.
  bool at_solution = false;
  // End early (NewtonEnd::NotStraight) if Gauss-Newton steps alone do not converge from here: the first one
  // is rejected or leaves a row violated by much, or a later one does not shrink the slope. Another start is
  // better then.
  bool only_straight = false;
  // Levenberg-Marquardt damping of the first step. Too little costs a rejected factorisation per factor of 4
  // to 64, too much only shortens a step.
  double damping = 1e-2;
};

struct NewtonReport {
  NewtonEnd end = NewtonEnd::StepLimit;
  int steps = 0, factorisations = 0;
  double damping = 0.0;  // of the last accepted step: where a warm start from here begins; 0: none was
  double infeasibility = 0.0, first_order = 0.0;  // of the last step, whether or not the state is kept
};

// z, multipliers (#rows, f relative to the largest weight): changed in place. Unless Converged, z is the best
// state found (keeping what was accepted last where none was compared yet), never one that could not be
// evaluated. Throws std::bad_alloc.
NewtonReport minimise_primal_dual(const Problem& problem, Vector& z, Vector& multipliers,
                                  const NewtonOptions& options, TangentCache& cache, PlanarFrames& frames,
                                  const std::stop_token& stop);

}  // namespace planewright
