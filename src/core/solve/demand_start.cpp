#include "core/solve/demand_start.h"

#include <algorithm>
#include <chrono>
#include <functional>

#include "core/solve/augmented_lagrangian.h"
#include "core/solve/demand_projection.h"

namespace planewright {
namespace {

// Tells the observer of each step, numbered through all attempts.
class Teller {
 public:
  Teller(const Problem& problem, SolveObserver* observer) : problem_(problem), observer_(observer) {}

  void operator()(const Vector& z, double first_order, double step) {
    Iteration iteration;
    iteration.number = count++;
    iteration.solver = "tangent";
    if (!observer_) return;
    iteration.energies = problem_.energy_shares(z.data());
    for (const auto& share : iteration.energies) iteration.objective += share.value;
    for (const auto& v : problem_.violations(z.data(), kDemandTolerance))
      iteration.infeasibility = std::max(iteration.infeasibility, v.max_violation);
    iteration.first_order = first_order;
    iteration.step = step;
    iteration.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const State state = problem_.to_state({z.data(), static_cast<size_t>(z.size())});
    observer_->on_iteration(iteration, &state);
  }
  int count = 0;

 private:
  const Problem& problem_;
  SolveObserver* observer_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace

DemandStart find_demand_start(const Problem& problem, const Vector& z, const DemandStartOptions& limits,
                              SolveObserver* observer, std::stop_token stop) {
  DemandStart start;
  if (limits.near_solution) {
    start.z = z;
    const DemandProjectionReport report =
        project_onto_demands(problem, start.z, kDemandProjectionSteps, stop);
    start.met = report.met && report.move <= kNearSolution;
    if (start.met) return start;
  }
  int left = limits.max_steps;
  Vector stepped = z;
  Teller teller(problem, observer);
  for (const DemandAttempt& attempt : kDemandAttempts) {
    AugmentedLagrangianOptions options;
    options.max_steps = std::min(attempt.steps, left);
    left -= options.max_steps;
    options.most_penalty = attempt.most_penalty;
    options.tell = std::ref(teller);
    const AugmentedLagrangianReport softened = minimise_augmented_lagrangian(problem, stepped, options, stop);
    start.z = stepped;
    const DemandProjectionReport report =
        project_onto_demands(problem, start.z, kDemandProjectionSteps, stop);
    start.met = report.met;
    start.out_of_memory = softened.out_of_memory || report.out_of_memory;
    if (start.met || start.out_of_memory || left <= 0 || stop.stop_requested()) break;
  }
  start.steps = teller.count;
  return start;
}

}  // namespace planewright
