// Demand start: where a solve with demands begins. An interior point method that starts at the wanted points
// of an irregular mesh wanders for hundreds of iterations; from here it needs some sixty (measured: train
// station and bunny with the vertex, face and edge constraints on, offsets 0.1 and 0.3 edges).
//
// A few dozen augmented Lagrangian steps find a state of low energy where the rows are nearly met, the demand
// projection one close by where they are met exactly. Where the projection stalls, more steps are tried
// before the demands are believed to contradict each other here. Internal to solve/.
#pragma once

#include <stop_token>

#include "core/problem/problem.h"
#include "core/solve/iteration.h"

namespace planewright {

// Shared with the tangent solver, which makes the same attempts with its own steps. steps: factorisations of
// the augmented Lagrangian; most_penalty: how stiff it may get. More steps find lower energies with smaller
// violations, which a projection that stalled before can close.
struct DemandAttempt {
  int steps;
  double most_penalty;
};
inline constexpr DemandAttempt kDemandAttempts[] = {{26, 3e3}, {60, 1e4}, {120, 1e4}};
// A projection that moves a point farther than this, mean edges, has left the solution that it was near to.
inline constexpr double kNearSolution = 0.5;

struct DemandStart {
  Vector z;                    // on all rows, as far as the projection came: the least that the solve gives
  bool met = false;            // whether it meets every row
  int steps = 0;               // iterations told to the observer
  bool out_of_memory = false;  // which is why it meets them not
};

struct DemandStartOptions {
  int max_steps = 500;         // factorisations of the augmented Lagrangian, all attempts together
  bool near_solution = false;  // try the projection alone first (SolveOptions::near_solution)
};

DemandStart find_demand_start(const Problem& problem, const Vector& z, const DemandStartOptions& options,
                              SolveObserver* observer, std::stop_token stop);

}  // namespace planewright
