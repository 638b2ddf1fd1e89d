#include "core/solve/primal_dual_newton.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/solve/multipliers.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

// A run with all that goes with it.
struct Newton {
  explicit Newton(SharedProblem of, double off = 0.0) : problem(std::move(of)) {
    z = problem->from_state(perturbed(problem->complex(), off));
    multipliers = Vector::Zero(problem->rows());
  }
  NewtonReport go(const NewtonOptions& options = {}, SolveObserver* observer = nullptr,
                  std::stop_token stop = {}) {
    PlanarFrames frames(*problem, observer, cache, stop);
    return minimise_primal_dual(*problem, z, multipliers, options, cache, frames, stop);
  }
  // Of the problem's own function, with the multipliers of the unit normals filled in.
  double first_order() const {
    Vector y = multipliers * problem->largest_weight();
    complete_unit_normals(*problem, z, y);
    return problem->first_order_residual(z.data(), y.data()) / problem->largest_weight();
  }
  double violation() const {
    double worst = 0.0;
    for (const auto& row : problem->violated_rows(z.data(), 0.0)) worst = std::max(worst, row.amount);
    return worst;
  }

  SharedProblem problem;
  Vector z, multipliers;
  TangentCache cache;
};

SharedProblem dome_problem(double factor = 1.0) {
  return problem_of(sample_complex("dome", 80), {{"position", factor}, {"fairing", 0.2 * factor}});
}

TEST(PrimalDualNewton, ConvergesToAStationaryStateThatMeetsTheRows) {
  struct Case {
    const char* sample;
    bool gauss_newton;
  };
  // From the folds of a twisted roof stiff Gauss-Newton steps alone find no way.
  for (const auto& [sample, gauss_newton] : {Case{"dome", false}, {"dome", true}, {"twisted-roof", false}}) {
    Newton run(problem_of(sample_complex(sample, 80), {{"position", 1.0}, {"fairing", 0.2}}));
    ASSERT_GT(run.violation(), 1e-3);
    NewtonOptions options;
    options.begin_gauss_newton = gauss_newton;
    const NewtonReport report = run.go(options);
    EXPECT_EQ(report.end, NewtonEnd::Converged) << sample;
    EXPECT_GT(report.steps, 0);
    EXPECT_GE(report.factorisations, report.steps);
    EXPECT_LE(run.violation(), options.feasible) << sample;
    EXPECT_LE(run.first_order(), options.first_order * (1.0 + 1e-6)) << sample;
    EXPECT_GT(run.multipliers.cwiseAbs().maxCoeff(), 1e-3);
    // The report says what is there.
    EXPECT_NEAR(report.infeasibility, run.violation(), 1e-12);
    EXPECT_NEAR(report.first_order, run.first_order(), 0.8 * report.first_order);
  }
}

TEST(PrimalDualNewton, EndsQuadratically) {
  Newton run(dome_problem());
  NewtonOptions options;
  options.first_order = options.feasible = 1e-11;
  Recorder recorder;
  const NewtonReport report = run.go(options, &recorder);
  EXPECT_EQ(report.end, NewtonEnd::Converged);
  EXPECT_LE(run.first_order(), 2e-11);
  // From a slope of 1e-4 to rounding in a handful of steps.
  int last_steps = 0;
  for (const Iteration& told : recorder.iterations) last_steps += told.first_order < 1e-4;
  EXPECT_LE(last_steps, 6);
}

TEST(PrimalDualNewton, MeetsInequalitiesWithMultipliersThatPushInwards) {
  Newton run(Problem::create(sample_complex("dome", 80, 0.05),
                             demanding({demand("vertex"), demand("face"), demand("edge")}))
                 .value());
  ASSERT_GT(run.violation(), 1e-2);
  const NewtonReport report = run.go();
  EXPECT_EQ(report.end, NewtonEnd::Converged);
  EXPECT_LE(run.violation(), 1e-7);
  int pushing = 0;
  for (int r = 0; r < run.problem->rows(); ++r) {
    const Bounds bounds = run.problem->bounds(r);
    if (bounds.low == bounds.high) continue;
    EXPECT_LE(run.multipliers[r], 0.0) << r;
    pushing += run.multipliers[r] < -1e-6;
  }
  EXPECT_GT(pushing, 3);
}

TEST(PrimalDualNewton, OnlyTheRatioOfWeightsMatters) {
  Newton one(dome_problem()), many(dome_problem(1e4));
  const NewtonReport a = one.go(), b = many.go();
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_NEAR(a.first_order, b.first_order, 1e-3 * a.first_order);
  EXPECT_LE((one.z - many.z).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LE((one.multipliers - many.multipliers).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(PrimalDualNewton, StoppedBeforeItBeginsChangesNothing) {
  Newton run(dome_problem(), 0.1);
  const Vector before = run.z;
  std::stop_source stop;
  stop.request_stop();
  const NewtonReport report = run.go({}, nullptr, stop.get_token());
  EXPECT_EQ(report.end, NewtonEnd::Stopped);
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_EQ(run.z, before);
  EXPECT_EQ(run.multipliers, Vector::Zero(run.problem->rows()));
}

TEST(PrimalDualNewton, StopsWithinAStepAndGoesOnFromThere) {
  Newton through(dome_problem());
  NewtonOptions options;
  options.first_order = 1e-9;
  const int all = through.go(options).steps;
  ASSERT_GT(all, 4);
  Newton run(dome_problem());
  std::stop_source stop;
  Recorder recorder([&](const Iteration& iteration) {
    if (iteration.number == 2) stop.request_stop();
  });
  const NewtonReport report = run.go(options, &recorder, stop.get_token());
  EXPECT_EQ(report.end, NewtonEnd::Stopped);
  EXPECT_EQ(report.steps, 2);
  EXPECT_TRUE(run.z.allFinite());
  Newton again(dome_problem());
  again.z = run.z;
  again.multipliers = run.multipliers;
  EXPECT_EQ(again.go(options).end, NewtonEnd::Converged);
  EXPECT_LE((again.z - through.z).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(PrimalDualNewton, TheLimitOfStepsIsKept) {
  for (const int most : {0, 1, 3}) {
    Newton run(dome_problem());
    const Vector before = run.z;
    NewtonOptions options;
    options.max_steps = most;
    options.first_order = 1e-12;
    Recorder recorder;
    const NewtonReport report = run.go(options, &recorder);
    EXPECT_EQ(report.end, NewtonEnd::StepLimit);
    EXPECT_EQ(report.steps, most);
    EXPECT_EQ(static_cast<int>(recorder.iterations.size()), most);
    EXPECT_EQ(run.z == before, most == 0);
  }
}

// Never far in one step: what is shown does not jump, and the linearisation means something.
TEST(PrimalDualNewton, NoStepIsLong) {
  Newton run(problem_of(sample_complex("train-station", 80), {{"position", 1.0}}), 0.3);
  Recorder recorder;
  run.go({}, &recorder);
  ASSERT_GT(recorder.iterations.size(), 3u);
  double longest = 0.0;
  for (const Iteration& told : recorder.iterations) longest = std::max(longest, told.step);
  EXPECT_LE(longest, 0.6);
  EXPECT_GT(longest, 0.05);
}

// A function that overflows is no number to go by; the state is left as it was.
TEST(PrimalDualNewton, SaysThatAFunctionIsNotFinite) {
  Newton run(dome_problem());
  run.z[7] = 1e200;
  const Vector before = run.z;
  const NewtonReport report = run.go();
  EXPECT_EQ(report.end, NewtonEnd::NotFinite);
  EXPECT_EQ(report.steps, 0);
  EXPECT_EQ(run.z, before);
}

TEST(PrimalDualNewton, AStateThatIsNoNumberEndsAtOnce) {
  Newton run(dome_problem());
  run.z[7] = std::numeric_limits<double>::quiet_NaN();
  const NewtonReport report = run.go();
  EXPECT_EQ(report.end, NewtonEnd::NotFinite);
  EXPECT_EQ(report.steps, 0);
}

TEST(PrimalDualNewton, AtASolutionOnlyTheLastDigitsMove) {
  Newton run(dome_problem());
  NewtonOptions options;
  options.feasible = 1e-7;
  options.first_order = 1e-7;
  ASSERT_EQ(run.go(options).end, NewtonEnd::Converged);
  const Vector solved = run.z;
  // The state moved by little, as a projection moves it.
  for (int k = 0; k < run.z.size(); ++k) run.z[k] += 1e-6 * std::sin(1.7 * k);
  for (int i = 0; i < run.problem->layout().planes; ++i)
    run.z.segment<3>(run.problem->layout().n(i)).normalize();
  ASSERT_GT(run.violation(), 1e-7);
  options.at_solution = true;
  const NewtonReport report = run.go(options);
  EXPECT_EQ(report.end, NewtonEnd::Converged);
  EXPECT_LE(report.steps, 3);
  EXPECT_EQ(report.factorisations, report.steps);
  EXPECT_LE((run.z - solved).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(PrimalDualNewton, OnlyStraightGivesUpWhereTheLinearisationDoesNotHold) {
  NewtonOptions options;
  options.begin_gauss_newton = options.only_straight = true;
  Newton smooth(problem_of(dual_of(make_torus(8, 12)), {{"position", 1.0}}));
  EXPECT_EQ(smooth.go(options).end, NewtonEnd::Converged);
  Newton folded(problem_of(sample_complex("train-station", 100), {{"position", 1.0}}), 0.3);
  const NewtonReport report = folded.go(options);
  EXPECT_EQ(report.end, NewtonEnd::NotStraight);
  EXPECT_LE(report.steps, 10);
}

TEST(PrimalDualNewton, TheSameInputGivesTheSameBits) {
  Newton a(dome_problem(), 0.1), b(dome_problem(), 0.1);
  const NewtonReport first = a.go();
  b.cache.find_or_make(*dome_problem(), EnergyCoupling::Dropped);  // whatever the cache has seen before
  const NewtonReport second = b.go();
  EXPECT_EQ(first.steps, second.steps);
  EXPECT_EQ(first.factorisations, second.factorisations);
  EXPECT_TRUE(same_bits(a.z, b.z));
  EXPECT_TRUE(same_bits(a.multipliers, b.multipliers));
}

// Frames and observers look on: with or without them the steps are the same.
TEST(PrimalDualNewton, AnObserverChangesNoBit) {
  Newton watched(dome_problem(), 0.1), alone(dome_problem(), 0.1);
  Recorder recorder;
  const NewtonReport report = watched.go({}, &recorder);
  alone.go();
  EXPECT_EQ(static_cast<int>(recorder.iterations.size()), report.steps);
  EXPECT_FALSE(recorder.states.empty());
  EXPECT_TRUE(same_bits(watched.z, alone.z));
  EXPECT_TRUE(same_bits(watched.multipliers, alone.multipliers));
}

}  // namespace
}  // namespace planewright
