// Solving and watching a solve, for the tests of solve/ and above.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "core/solve/ipopt_solver.h"
#include "core/solve/tangent_solver.h"
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

// By a tangent solver that has not solved anything before.
inline SolveReport tangent_solve(const Problem& problem, const State& start, const SolveOptions& options = {},
                                 SolveObserver* observer = nullptr, std::stop_token stop = {}) {
  return make_tangent_solver()->solve(problem, start, options, observer, stop);
}
inline SolveReport tangent_solve(const Problem& problem, const SolveOptions& options = {}) {
  return tangent_solve(problem, initial_state(problem.complex()), options);
}

// Planar to rounding, by our own measure, and every row met.
inline void expect_sound(const Problem& problem, const SolveReport& report, const std::string& what) {
  const TangentComplex& complex = problem.complex();
  EXPECT_LE(off_plane(complex, report.state), rounding(complex)) << what;
  EXPECT_LE(report.incidence_residual, rounding(complex)) << what;
  EXPECT_LE((report.state.n.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14) << what;
  for (const auto& entry : problem.violations(problem.from_state(report.state).data(), 1e-9)) {
    EXPECT_EQ(entry.violated, 0) << what << ", " << entry.name << ": " << entry.max_violation;
  }
}

// The problem's own first-order residual with the report's multipliers, weights relative to the largest.
inline double first_order(const Problem& problem, const SolveReport& report) {
  return problem.first_order_residual(problem.from_state(report.state).data(), report.multipliers.data()) /
         problem.largest_weight();
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
