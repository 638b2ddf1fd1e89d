// Solver: the interface behind which the tangent solver, Ipopt, and both after each other work on the same
// Problem.
//
// Threads: a solver object is used by one thread at a time; the stop token may be triggered from any other.
#pragma once

#include <stop_token>

#include "core/problem/problem.h"
#include "core/solve/iteration.h"
#include "core/solve/solve_report.h"

namespace planewright {

struct SolveOptions {
  int max_iterations = 500;
  double tolerance = 3e-4;            // first-order residual, see SolveReport::first_order_residual
  double planarity_tolerance = 1e-9;  // mean edges; what counts as planar after the projection
  // The start is the result of a solve of nearly the same problem: where it (almost) meets every row, what
  // finds such a state is left out.
  bool near_solution = false;
  // Multipliers at the start, of another solver that has just solved this very problem
  // (SolveReport::multipliers): Ipopt then begins with its exact Hessian and next to no barrier. Empty: none.
  Vector multipliers = {};
  // Of a problem with demands: end as soon as they are met, a few percent above the lowest energy (Planar).
  bool draft = false;
  std::stop_token abandoned;  // nobody wants the result any more: end without the final projection
};

class Solver {
 public:
  virtual ~Solver() = default;
  // start and the report's state: model units. Every outcome, a breakdown included, is a report with the best
  // state so far. A stop request ends the steps within one factorisation; where no planar state has been
  // shown yet, a short projection follows, unless the result is abandoned. observer may be null.
  virtual SolveReport solve(const Problem& problem, const State& start, const SolveOptions& options,
                            SolveObserver* observer, std::stop_token stop) = 0;
};

}  // namespace planewright
