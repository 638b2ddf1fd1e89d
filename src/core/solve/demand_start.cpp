#include "core/solve/demand_start.h"

#include <algorithm>

#include "core/solve/augmented_lagrangian.h"
#include "core/solve/demand_projection.h"

namespace planewright {
namespace {

// Counts what the observer was told, so that later iterations go on from there.
class Counter final : public SolveObserver {
 public:
  explicit Counter(SolveObserver* next) : next_(next) {}
  void on_iteration(const Iteration& iteration, const State* state) override {
    count = iteration.number + 1;
    if (next_) next_->on_iteration(iteration, state);
  }
  int count = 0;

 private:
  SolveObserver* next_;
};

// Steps (factorisations) of each attempt, and how stiff its penalty may get. More steps find lower energies
// with smaller violations, which a projection that stalled before can close.
struct Attempt {
  int steps;
  double most_penalty;
};
constexpr Attempt kAttempts[] = {{26, 3e3}, {60, 1e4}, {120, 1e4}};

// A projection that moves a point farther than this, edges, has left the solution that it was near to.
constexpr double kNear = 0.5;

}  // namespace

DemandStart find_demand_start(const Problem& problem, const Vector& z, const DemandStartOptions& limits,
                              SolveObserver* observer, std::stop_token stop) {
  DemandStart start;
  if (limits.near_solution) {
    start.z = z;
    const DemandProjectionReport report =
        project_onto_demands(problem, start.z, kDemandProjectionSteps, stop);
    start.met = report.met && report.move <= kNear;
    if (start.met) return start;
  }
  int left = limits.max_steps;
  Vector stepped = z;
  Counter counter(observer);
  for (const Attempt& attempt : kAttempts) {
    AugmentedLagrangianOptions options;
    options.max_steps = std::min(attempt.steps, left);
    left -= options.max_steps;
    options.most_penalty = attempt.most_penalty;
    options.first_iteration = counter.count;
    minimise_augmented_lagrangian(problem, stepped, options, &counter, stop);
    start.z = stepped;
    start.met = project_onto_demands(problem, start.z, kDemandProjectionSteps, stop).met;
    if (start.met || left <= 0 || stop.stop_requested()) break;
  }
  start.steps = counter.count;
  return start;
}

}  // namespace planewright
