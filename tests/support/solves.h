// Solving and watching a solve, for the tests of solve/ and above.
#pragma once

#include <functional>
#include <vector>

#include "core/solve/ipopt_solver.h"
#include "support/problems.h"

namespace planewright::test {

// Keeps everything it is told; `on` may ask for more after each iteration.
class Recorder final : public SolveObserver {
 public:
  explicit Recorder(std::function<void(const Iteration&)> on = {}) : on_(std::move(on)) {}
  void on_iteration(const Iteration& iteration, const State* state) override {
    iterations.push_back(iteration);
    if (state) states.push_back(*state);
    if (on_) on_(iteration);
  }
  std::vector<Iteration> iterations;
  std::vector<State> states;

 private:
  std::function<void(const Iteration&)> on_;
};

inline SolveReport solve(const Problem& problem, const State& start, const SolveOptions& options = {},
                         SolveObserver* observer = nullptr, std::stop_token stop = {}) {
  return make_ipopt_solver()->solve(problem, start, options, observer, stop);
}
inline SolveReport solve(const Problem& problem, const SolveOptions& options = {}) {
  return solve(problem, initial_state(problem.complex()), options);
}

inline double energy(const SolveReport& report, const std::string& name) {
  for (const auto& entry : report.energies)
    if (entry.name == name) return entry.value;
  return -1.0;
}
inline double energy(const SolveReport& report) {
  double sum = 0.0;
  for (const auto& entry : report.energies) sum += entry.value;
  return sum;
}

// Farthest distance of two states' points, mean edges.
inline double distance(const TangentComplex& complex, const State& a, const State& b) {
  return (a.x - b.x).rowwise().norm().maxCoeff() / complex.mean_edge;
}

}  // namespace planewright::test
