// PlanarFrames: what a running tangent solve shows. Every state that it hands to the observer has been
// projected: each point lies on all of its planes to 1e-9 edges, so that the view shows watertight panels
// while a slider moves. Steps are told one by one; a state goes with the start, with the first steps close to
// planar, and with every few later ones. Where a projection finds no planar state in a few dozen steps, the
// step is told without one. The final state is the report's, not told here. Internal to solve/.
//
// Never changes what the solver does: the projection works on a copy. Costs nothing where the observer wants
// no states (SolveObserver::wants_states).
#pragma once

#include <chrono>
#include <optional>
#include <stop_token>

#include "core/problem/problem.h"
#include "core/solve/iteration.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

class PlanarFrames {
 public:
  // observer may be null.
  PlanarFrames(const Problem& problem, SolveObserver* observer, TangentCache& cache, std::stop_token stop);

  // How dear a projection is from where the solver is now: Gauss-Newton steps with a soft penalty are far
  // from planar, later ones close to it.
  enum class Distance { Far, Near };
  // z: an accepted step's state, normalised; the rest as in Iteration.
  void tell(const Vector& z, double first_order, double step, Distance distance);
  // The state a solve begins with, iteration 0, projected at once.
  void tell_start(const Vector& z);

  int told() const { return number_; }  // steps so far
  // The newest planar state handed out (normalised); none before there was one.
  const std::optional<Vector>& newest() const { return newest_; }
  // Whether it meets every demand too.
  bool newest_meets_demands() const { return newest_meets_demands_; }

 private:
  void hand_out(const Vector& z, double first_order, double step, bool with_state);

  const Problem& problem_;
  SolveObserver* observer_;
  TangentCache& cache_;
  std::stop_token stop_;
  std::chrono::steady_clock::time_point begun_;
  int number_ = 0, since_frame_ = 0;
  std::optional<Vector> newest_;
  bool newest_meets_demands_ = false;
};

}  // namespace planewright
