// Solving one layer of a design as a designer means it: rounds of solves of one Problem after another, until
// what the layer demands is met, what is frozen has settled, and an independent test agrees.
//
//   - closeness: foot points are taken anew until none moves by more than kFootSettled edges;
//   - no_penetration: panels that still cross the mesh get separating planes and a re-solve, until a
//     geometric test (diagnose/crossings.h) counts none;
//   - demands that cannot be met together: a set of them is found without which the solve succeeds; the
//     report is Infeasible, names the set, and keeps that state.
//
// Threads: as Solver; the observer is called on the solving thread, iterations of all rounds count on.
#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/design/layer_settings.h"
#include "core/problem/problem.h"
#include "core/solve/solver.h"

namespace planewright {

struct LayerProblem {
  std::shared_ptr<const TangentComplex> complex;
  LayerSettings settings;
  std::vector<Selection> selections;
  std::shared_ptr<const ReferenceSurface> reference;  // null: the mesh itself
  std::shared_ptr<const NeighbourLayer> neighbour;    // null: none
};

// solver: solves each round; what it keeps between solves serves the next one too. start and the report's
// state: model units. Fails as Problem::create does; every other outcome is a report.
Result<SolveReport> solve_layer(Solver& solver, const LayerProblem& layer, const State& start,
                                const SolveOptions& options, SolveObserver* observer, std::stop_token stop);

}  // namespace planewright
