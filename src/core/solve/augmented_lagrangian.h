// Augmented Lagrangian: a few dozen damped Gauss-Newton steps that bring a state close to where its energies
// are low and its rows are met, inequalities included. What an interior point method needs a hundred
// iterations for on an irregular mesh (measured: train station and bunny with the vertex, face and edge
// constraints on), this does in some 25 factorisations; accuracy to rounding is left to the projection
// (demand_projection.h).
//
// For a row with bounds [low, high] and multiplier estimate y,
//     L = f + sum_r rho/2 dist(c_r + y_r / rho, [low_r, high_r])^2
// is minimised by Levenberg-Marquardt steps in the tangent space (tangent_equations.h), at most kInner of
// them between two updates  y += rho (c - nearest in bounds). Both rules were found by trial: multipliers
// that are updated after every single step blow up, and rho beyond a few thousand makes the valley too narrow
// to follow. Threads: uses MUMPS through its gate. Deterministic. Units: normalised.
#pragma once

#include <functional>
#include <stop_token>

#include "core/problem/problem.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

struct AugmentedLagrangianOptions {
  int max_steps = 26;  // factorisations, rejected steps included
  // Ends earlier where rows are met to `feasible` and the slope of L is below `first_order` (weights relative
  // to the largest one).
  double feasible = 1e-7, first_order = 3e-4;
  double most_penalty = 3e3;
  // Called after each accepted step with the state, the slope of L before it and the step's length; may be
  // empty.
  std::function<void(const Vector& z, double first_order, double step)> tell = {};
  // How energies that couple points are treated: Dropped is cheaper, for steps that need not be exact.
  EnergyCoupling coupling = EnergyCoupling::Exact;
  TangentCache* cache = nullptr;
};

struct AugmentedLagrangianReport {
  int steps = 0;               // factorisations
  double infeasibility = 0.0;  // largest violation of a row
  double first_order = 0.0;    // largest component of the slope of L in the tangent space
  bool converged = false;
  bool out_of_memory = false;
  Vector multipliers;  // #rows, as in f + y . c, weights as the problem has them
};

// z: normalised, changed in place; the steps never raise L.
AugmentedLagrangianReport minimise_augmented_lagrangian(const Problem& problem, Vector& z,
                                                        const AugmentedLagrangianOptions& options,
                                                        std::stop_token stop);

}  // namespace planewright
