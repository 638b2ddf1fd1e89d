// Problems with demands, and what of them a state meets.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/problem/derivative_check.h"
#include "support/solves.h"

namespace planewright::test {

inline Demand demand(std::string name, std::vector<double> values = {}, std::string selection = "") {
  return {std::move(name), true, std::move(selection), std::move(values)};
}

inline ProblemSettings demanding(std::vector<Demand> list, std::vector<Selection> selections = {},
                                 double side = 1.0) {
  ProblemSettings settings;
  settings.demands.list = std::move(list);
  settings.selections = std::move(selections);
  settings.side = side;
  return settings;
}

// The rows of one demand, in order.
inline std::vector<int> rows_of(const Problem& problem, std::string_view name) {
  std::vector<int> rows;
  for (int r = 0; r < problem.rows(); ++r)
    if (problem.row_name(r) == name) rows.push_back(r);
  return rows;
}
inline std::vector<int> rows_of(const Problem& problem, std::string_view name, const ElementRef& element) {
  std::vector<int> rows;
  for (int r : rows_of(problem, name))
    if (problem.row_element(r) == element) rows.push_back(r);
  return rows;
}

// How far a row is inside its bounds at a state: negative outside.
inline double room(const Problem& problem, const Vector& values, int row) {
  return std::min(values[row] - problem.bounds(row).low, problem.bounds(row).high - values[row]);
}
inline Vector row_values(const Problem& problem, const State& state) {
  return constraint_values(problem, problem.from_state(state));
}

// Largest violation of a demand at a state.
inline double violation(const Problem& problem, const State& state, std::string_view name) {
  for (const auto& entry : problem.violations(problem.from_state(state).data(), 0.0))
    if (entry.name == name) return entry.max_violation;
  ADD_FAILURE() << "no rows of " << name;
  return -1.0;
}

// What a solve may still miss a demand by, mean edges.
inline constexpr double kMet = 1e-9;

// Solves without and with the demands of `settings`: without, each of them is violated by more than `least`;
// with, every one is met and the panels are planar. Returns the state with.
inline State expect_demands_take_effect(const SharedComplex& complex, const ProblemSettings& settings,
                                        double least, const FrozenGeometry& frozen = {}) {
  ProblemSettings without = settings;
  without.demands = {};
  const auto free = Problem::create(complex, without).value();
  const auto made = Problem::create(complex, settings, frozen);
  if (!made) {
    ADD_FAILURE() << made.error().text();
    return initial_state(*complex);
  }
  const State before = solve(*free).state;
  const SolveReport report = solve(**made);
  EXPECT_TRUE(report.status == SolveStatus::Converged || report.status == SolveStatus::Planar)
      << name(report.status) << ": " << report.stop_reason;
  EXPECT_LE(off_plane(*complex, report.state), 1e-9);
  for (const Demand& d : settings.demands.list) {
    EXPECT_GT(violation(**made, before, d.name), least) << d.name;
    EXPECT_LE(violation(**made, report.state, d.name), kMet) << d.name;
  }
  return report.state;
}

// Derivatives of the demands of `settings` at three states, one of them without any extent.
inline void expect_right_derivatives(const SharedComplex& complex, ProblemSettings settings,
                                     const std::string& what) {
  settings.weights = {};
  const auto problem = Problem::create(complex, settings).value();
  State flat = initial_state(*complex);
  flat.x.rowwise() = Eigen::RowVector3d(flat.x.row(0));
  for (const State& state : {initial_state(*complex), perturbed(*complex, 0.3), flat}) {
    const DerivativeCheck check = check_derivatives(*problem, problem->from_state(state));
    EXPECT_LT(check.jacobian_error, 1e-7) << what << ", " << check.worst;
    EXPECT_LT(check.hessian_error, 1e-7) << what << ", " << check.worst;
    EXPECT_GT(check.jacobian_norm, 0.0) << what;
  }
}

}  // namespace planewright::test
