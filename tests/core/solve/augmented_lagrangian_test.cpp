#include "core/solve/augmented_lagrangian.h"

#include <gtest/gtest.h>

#include "core/solve/demand_start.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

struct Heard final : SolveObserver {
  std::vector<Iteration> iterations;
  bool always_a_state = true;
  void on_iteration(const Iteration& iteration, const State* state) override {
    iterations.push_back(iteration);
    always_a_state = always_a_state && state != nullptr && state->x.allFinite();
  }
};

SharedProblem dome_with(std::vector<Demand> demands,
                        std::map<std::string, double> weights = {{"position", 1.0}}) {
  ProblemSettings settings{Freedom::NormalsAndOffsets, std::move(weights)};
  settings.demands.list = std::move(demands);
  const double edge = dual_of(make_sample("dome", 150).value())->mean_edge;
  return Problem::create(dual_of(make_sample("dome", 150).value(), {0.1 * edge}), settings).value();
}

double worst(const Problem& problem, const Vector& z) {
  double most = 0.0;
  for (const auto& v : problem.violations(z.data(), 1e-9)) most = std::max(most, v.max_violation);
  return most;
}

TEST(AugmentedLagrangian, ComesToAStationaryStateThatMeetsTheRows) {
  const auto problem = dome_with({{"vertex"}, {"face"}, {"edge"}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  const double before = worst(*problem, z);
  ASSERT_GT(before, 1e-3);
  AugmentedLagrangianOptions options;
  options.max_steps = 300;
  int told = 0;
  Vector told_last;
  options.tell = [&](const Vector& at, double first_order, double step) {
    ++told;
    told_last = at;
    EXPECT_GE(first_order, 0.0);
    EXPECT_GT(step, 0.0);
  };
  const auto report = minimise_augmented_lagrangian(*problem, z, options, {});
  EXPECT_TRUE(report.converged) << report.infeasibility << " " << report.first_order;
  EXPECT_LE(worst(*problem, z), 1e-6);
  ASSERT_EQ(report.multipliers.size(), problem->rows());

  // The multipliers are those of the problem: the slope of f + y.c vanishes along the moves that keep normals
  // unit, and an inequality only pushes inwards.
  Vector y = report.multipliers;
  const Layout& layout = problem->layout();
  const auto [first, last] = problem->unit_normal_rows();
  Vector slope = gradient(*problem, z) + jacobian(*problem, z).transpose() * y;
  for (int i = 0; i < layout.planes; ++i)
    y[first + i] = -slope.segment<3>(layout.n(i)).dot(z.segment<3>(layout.n(i)));
  EXPECT_LE(problem->first_order_residual(z.data(), y.data()), 5e-3);
  int pushing = 0;
  for (int row = 0; row < problem->rows(); ++row) {
    if (row >= first && row < last) continue;
    const Bounds bounds = problem->bounds(row);
    if (bounds.low == bounds.high) continue;
    EXPECT_LE(y[row], 0.0) << "row " << row;
    pushing += y[row] < -1e-6;
  }
  EXPECT_GT(pushing, 0);
  EXPECT_GT(told, 0);
  EXPECT_LE(told, report.steps);
  EXPECT_EQ(told_last, z);
}

TEST(AugmentedLagrangian, AWeightOfZeroEverywhereStillMeetsTheRows) {
  const auto problem = dome_with({{"vertex"}, {"face"}, {"edge"}}, {});
  Vector z = problem->from_state(initial_state(problem->complex()));
  const auto report = minimise_augmented_lagrangian(*problem, z, {}, {});
  EXPECT_LE(report.infeasibility, 1e-2);
  EXPECT_TRUE(z.allFinite());
}

TEST(AugmentedLagrangian, OnlyTheRatioOfWeightsMatters) {
  const auto small = dome_with({{"face"}}, {{"position", 0.01}, {"fairing", 0.02}});
  const auto large = dome_with({{"face"}}, {{"position", 10.0}, {"fairing", 20.0}});
  Vector a = small->from_state(initial_state(small->complex())), b = a;
  minimise_augmented_lagrangian(*small, a, {}, {});
  minimise_augmented_lagrangian(*large, b, {}, {});
  EXPECT_LE((a - b).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(AugmentedLagrangian, StopsWhenAsked) {
  const auto problem = dome_with({{"face"}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  const Vector before = z;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(minimise_augmented_lagrangian(*problem, z, {}, stop.get_token()).steps, 0);
  EXPECT_LE((z - before).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(DemandStart, MeetsEveryRowAndCountsWhatItTold) {
  const auto problem = dome_with({{"vertex"}, {"face"}, {"edge"}});
  const Vector z = problem->from_state(initial_state(problem->complex()));
  Heard heard;
  const DemandStart start = find_demand_start(*problem, z, {}, &heard, {});
  EXPECT_TRUE(start.met);
  EXPECT_LE(worst(*problem, start.z), 1e-9);
  EXPECT_EQ(start.steps, static_cast<int>(heard.iterations.size()));
  EXPECT_TRUE(heard.always_a_state);
  for (size_t k = 0; k < heard.iterations.size(); ++k)
    EXPECT_EQ(heard.iterations[k].number, static_cast<int>(k));
}

}  // namespace
}  // namespace planewright
