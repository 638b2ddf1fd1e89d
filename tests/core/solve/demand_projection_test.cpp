#include "core/solve/demand_projection.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/solve/projection.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

SharedProblem with_demands(SharedComplex complex, std::vector<Demand> demands, double side = 1.0) {
  ProblemSettings settings{Freedom::NormalsAndOffsets, {{"position", 1.0}}};
  settings.demands.list = std::move(demands);
  settings.side = side;
  return Problem::create(std::move(complex), settings).value();
}

double worst(const Problem& problem, const Vector& z) {
  double most = 0.0;
  for (const auto& v : problem.violations(z.data(), 1e-9)) most = std::max(most, v.max_violation);
  return most;
}

TEST(DemandProjection, MeetsThePapersThreeFamiliesFromTheWantedPoints) {
  for (const char* sample : {"dome", "alpine-hut", "train-station", "torus", "vault"}) {
    const SharedComplex shape = dual_of(make_sample(sample, 150).value());
    const auto problem = with_demands(dual_of(make_sample(sample, 150).value(), {0.1 * shape->mean_edge}),
                                      {{"vertex"}, {"face"}, {"edge"}});
    Vector z = problem->from_state(initial_state(problem->complex()));
    EXPECT_GT(worst(*problem, z), 1e-3) << sample << ": nothing to do";
    const Vector before = z;
    const auto report = project_onto_demands(*problem, z);
    EXPECT_TRUE(report.met) << sample << ": " << report.violation;
    EXPECT_LE(worst(*problem, z), kDemandTolerance) << sample;
    EXPECT_LE(report.incidence, 1e-12) << sample;
    EXPECT_LT(report.move, 2.0) << sample;
    const int points = problem->layout().points;
    double move = 0.0;
    for (int j = 0; j < points; ++j) move = std::max(move, (z - before).segment<3>(3 * j).norm());
    EXPECT_NEAR(report.move, move, 1e-12);
  }
}

TEST(DemandProjection, LeavesAStateAloneThatMeetsEverything) {
  const auto problem =
      with_demands(dual_of(domed_triangle_grid(5, 5).mesh(), {0.3}), {{"vertex"}, {"face"}, {"edge"}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  ASSERT_TRUE(project_onto_demands(*problem, z).met);
  const Vector met = z;
  const auto again = project_onto_demands(*problem, z);
  EXPECT_TRUE(again.met);
  EXPECT_LE((z - met).cwiseAbs().maxCoeff(), 1e-9);
}

// Without demands in the way it goes where the projection of planarity alone goes.
TEST(DemandProjection, AgreesWithTheProjectionOntoIncidencesWhereDemandsAreInactive) {
  const SharedComplex complex = dual_of(domed_triangle_grid(5, 4).mesh(), {0.3});
  const auto problem = with_demands(complex, {{"face"}});
  State state = perturbed(*complex, 1e-3);
  Vector z = problem->from_state(state);
  ASSERT_TRUE(project_onto_demands(*problem, z).met);
  project_onto_incidences(*complex, state, Freedom::NormalsAndOffsets);
  const State got = problem->to_state({z.data(), static_cast<size_t>(z.size())});
  // Nearest to second order alone, and its chord steps go another way round.
  EXPECT_LE((got.x - state.x).cwiseAbs().maxCoeff() / complex->mean_edge, 5e-3);
}

TEST(DemandProjection, SaysThatContradictionsAreNotMet) {
  ProblemSettings settings{Freedom::NormalsAndOffsets, {{"position", 1.0}}};
  settings.demands.list = {{"convex"}};
  const SharedComplex saddle = dual_of(make_sample("saddle-roof", 60).value());
  const auto problem = Problem::create(saddle, settings).value();
  Vector z = problem->from_state(initial_state(*saddle));
  const double before = worst(*problem, z);
  const auto report = project_onto_demands(*problem, z);
  EXPECT_FALSE(report.met);
  EXPECT_GT(report.violation, kDemandTolerance);
  EXPECT_LE(report.violation, before);
  EXPECT_TRUE(z.allFinite());
}

TEST(DemandProjection, StopsWhenAsked) {
  const auto problem =
      with_demands(dual_of(make_sample("dome", 150).value()), {{"vertex"}, {"face"}, {"edge"}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  const Vector before = z;
  std::stop_source stop;
  stop.request_stop();
  const auto report = project_onto_demands(*problem, z, kDemandProjectionSteps, stop.get_token());
  EXPECT_EQ(report.factorisations, 0);
  EXPECT_LE((z - before).norm(), 1e-14);  // normals are made unit
}

// Every comparison with a NaN is false, which must not read as 'met'.
TEST(DemandProjection, ARowThatIsNoNumberIsNotMet) {
  const auto problem = with_demands(dual_of(make_sample("dome", 80).value()), {{"vertex"}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  z[problem->layout().h(3)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(worst(*problem, z), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(problem->violated_rows(z.data(), 1e-9).empty());
  const auto report = project_onto_demands(*problem, z);
  EXPECT_FALSE(report.met);
  EXPECT_FALSE(report.planar);
  EXPECT_EQ(report.violation, std::numeric_limits<double>::infinity());
  EXPECT_EQ(report.factorisations, 0);

  z[problem->layout().x(2)] = std::numeric_limits<double>::quiet_NaN();
  const Vector multipliers = Vector::Ones(problem->rows());
  EXPECT_EQ(problem->first_order_residual(z.data(), multipliers.data()),
            std::numeric_limits<double>::infinity());
}

TEST(DemandProjection, IsDeterministic) {
  const auto problem =
      with_demands(dual_of(make_sample("alpine-hut", 150).value(), {0.05}), {{"vertex"}, {"face"}, {"edge"}});
  Vector a = problem->from_state(initial_state(problem->complex())), b = a;
  project_onto_demands(*problem, a);
  project_onto_demands(*problem, b);
  EXPECT_TRUE(a == b);
}

}  // namespace
}  // namespace planewright
