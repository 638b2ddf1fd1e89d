#include "core/solve/ipopt_solver.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <limits>

#include "core/complex/explicit_intersection.h"
#include "core/solve/demand_projection.h"
#include "core/solve/projection.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

State projected_start(const TangentComplex& complex, Freedom freedom = Freedom::NormalsAndOffsets) {
  State state = initial_state(complex);
  project_onto_incidences(complex, state, freedom);
  return state;
}

class SolvesSample : public testing::TestWithParam<std::string_view> {};

TEST_P(SolvesSample, ToAPlanarStationaryState) {
  const SharedComplex complex = sample_complex(GetParam(), 100);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const SolveOptions options;
  const SolveReport report = solve(*problem, options);
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  EXPECT_FALSE(report.stop_reason.empty());
  EXPECT_EQ(report.solver, "ipopt");

  // Planar to rounding, measured by us.
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  EXPECT_LE(report.incidence_residual, 1e-12);
  EXPECT_LE((report.state.n.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14);

  // Better than the projection alone, and than what explicit intersection can do.
  const double energy_now = objective(*problem, report.state);
  EXPECT_LT(energy_now, objective(*problem, projected_start(*complex)));
  const TpiResult exact = explicit_intersection(*complex);
  if (exact.failed.empty()) {
    EXPECT_LT(energy_now, objective(*problem, exact.state));
  }
  ASSERT_EQ(report.energies.size(), 1u);
  EXPECT_EQ(report.energies[0].name, "position");
  EXPECT_EQ(report.energies[0].weight, 1.0);
  EXPECT_NEAR(report.energies[0].value, energy_now, 1e-9 * energy_now);

  // The report's residual is the true one, and no multipliers could hide a slope: what remains of the
  // energy's gradient within the tangent space of the constraints is as small as it says.
  const Vector z = problem->from_state(report.state);
  EXPECT_NEAR(problem->first_order_residual(z.data(), report.multipliers.data()), report.first_order_residual,
              1e-9);
  EXPECT_LE(report.first_order_residual, 10.0 * options.tolerance);
  const Vector slope = gradient(*problem, z);
  const Eigen::MatrixXd rows = jacobian(*problem, z);
  const Vector multipliers = rows.transpose().completeOrthogonalDecomposition().solve(-slope);
  const double left = (slope + rows.transpose() * multipliers).cwiseAbs().maxCoeff();
  EXPECT_LE(left, 1e-3);
  EXPECT_GT(slope.cwiseAbs().maxCoeff(), 10 * left);

  for (const auto& constraint : report.constraints) {
    EXPECT_LE(constraint.max_violation, 1e-12) << constraint.name;
    EXPECT_EQ(constraint.violated, 0) << constraint.name;
  }
}

std::vector<std::string_view> sample_names() {
  std::vector<std::string_view> names;
  for (const SampleInfo& info : samples())
    if (info.name != "straight-strip") names.push_back(info.name);  // its quads are planar as they are
  return names;
}
INSTANTIATE_TEST_SUITE_P(Samples, SolvesSample, testing::ValuesIn(sample_names()), [](const auto& sample) {
  std::string label(sample.param);
  std::replace(label.begin(), label.end(), '-', '_');
  return label;
});

TEST(IpoptSolver, SolvesSmallComplexesOfEveryKind) {
  for (const auto& [label, complex] : small_complexes()) {
    const auto problem = problem_of(complex, {{"position", 1.0}});
    const SolveReport report = solve(*problem);
    EXPECT_EQ(report.status, SolveStatus::Converged) << label << ": " << report.stop_reason;
    EXPECT_LE(off_plane(*complex, report.state), 1e-12) << label;
  }
}

TEST(IpoptSolver, LeavesAnExactDesignWhereItIs) {
  for (const SharedComplex& complex : {dual_of(triangle_grid(4, 3).mesh()), planarize_of(cube().mesh()),
                                       planarize_of(grid(3, 3).mesh(), {0.5})}) {
    const auto problem = problem_of(complex, {{"position", 1.0}});
    const SolveReport report = solve(*problem);
    EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
    EXPECT_LE(report.iterations, 1);
    EXPECT_NEAR(distance(*complex, report.state, initial_state(*complex)), 0.0, 1e-7);
  }
}

// One quad with corners lifted by +-d in turn: the best plane is z = 0, the energy 4 d^2 (to first order).
TEST(IpoptSolver, FindsTheKnownBestPlaneOfOneQuad) {
  Shape shape = grid(1, 1);
  const double d = 0.01;
  for (int j = 0; j < 4; ++j) shape.positions(j, 2) = (j == 0 || j == 3) ? d : -d;
  const SharedComplex complex = planarize_of(shape.mesh());
  const auto problem = problem_of(complex, {{"position", 2.0}});
  const SolveReport report = solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Converged);
  const double edge = complex->mean_edge;
  EXPECT_NEAR(energy(report, "position"), 2.0 * 4 * d * d / (edge * edge), 1e-7);
  const Panels panels = panels_of(*complex, report.state);
  EXPECT_NEAR(panels.points.col(2).cwiseAbs().maxCoeff(), 0.0, 1e-5);
}

TEST(IpoptSolver, ALimitOfIterationsLeavesAPlanarStateAndSaysSo) {
  for (const std::string_view sample : {"train-station", "twisted-roof", "alpine-hut", "dome"}) {
    const SharedComplex complex = sample_complex(sample, 150);
    const auto problem = problem_of(complex, {{"position", 1.0}});
    SolveOptions options;
    options.max_iterations = 3;
    options.tolerance = 1e-9;
    const SolveReport report = solve(*problem, options);
    EXPECT_EQ(report.status, SolveStatus::Planar);
    EXPECT_NE(report.stop_reason.find("limit of 3 iterations"), std::string::npos) << report.stop_reason;
    EXPECT_EQ(report.iterations, 3);
    EXPECT_GT(report.first_order_residual, options.tolerance);
    EXPECT_LE(off_plane(*complex, report.state), 1e-12);
    // The least that it may give is what the projection makes of the start.
    Vector z = problem->from_state(initial_state(*complex));
    ASSERT_TRUE(project_onto_demands(*problem, z).met);
    EXPECT_LE(objective(*problem, report.state), problem->objective(z.data()) * (1.0 + 1e-9));
  }
}

TEST(IpoptSolver, NoIterationsAtAllStillGivePlanarPanels) {
  const SharedComplex complex = sample_complex("twisted-roof", 60);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  SolveOptions options;
  options.max_iterations = 0;
  const SolveReport report = solve(*problem, options);
  EXPECT_EQ(report.status, SolveStatus::Planar);
  EXPECT_EQ(report.iterations, 0);
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
}

TEST(IpoptSolver, StopsBeforeItBegins) {
  const SharedComplex complex = sample_complex("train-station", 100);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  std::stop_source stop;
  stop.request_stop();
  const SolveReport report = solve(*problem, initial_state(*complex), {}, nullptr, stop.get_token());
  EXPECT_EQ(report.status, SolveStatus::Stopped);
  EXPECT_FALSE(report.stop_reason.empty());
  EXPECT_EQ(report.iterations, 0);
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
}

TEST(IpoptSolver, StopsInTheMiddleWithAPlanarState) {
  const SharedComplex complex = sample_complex("train-station", 150);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  SolveOptions options;
  options.tolerance = 1e-12;
  for (const int at : {0, 2, 5}) {
    std::stop_source stop;
    Recorder recorder([&](const Iteration& iteration) {
      if (iteration.number == at) stop.request_stop();
    });
    const SolveReport report = solve(*problem, initial_state(*complex), options, &recorder, stop.get_token());
    EXPECT_EQ(report.status, SolveStatus::Stopped);
    EXPECT_EQ(report.iterations, at);
    EXPECT_EQ(static_cast<int>(recorder.iterations.size()), at + 1);
    EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  }
}

TEST(IpoptSolver, WithoutWeightsFindsSomePlanarState) {
  for (const std::string_view sample : {"train-station", "twisted-roof", "dome"}) {
    const SharedComplex complex = sample_complex(sample, 80);
    for (const std::map<std::string, double>& weights :
         {std::map<std::string, double>{}, {{"position", 0.0}, {"fairing", 0.0}}}) {
      const SolveReport report = solve(*problem_of(complex, weights));
      EXPECT_EQ(report.status, SolveStatus::Converged) << sample << ": " << report.stop_reason;
      EXPECT_LE(off_plane(*complex, report.state), 1e-12);
      EXPECT_TRUE(report.energies.empty());
      // Nothing asks it to go far.
      EXPECT_LT(distance(*complex, report.state, initial_state(*complex)), 3.0) << sample;
    }
  }
}

TEST(IpoptSolver, FairingWeightLowersTheFairingEnergy) {
  for (const std::string_view sample : {"alpine-hut", "twisted-roof"}) {
    const SharedComplex complex = sample_complex(sample, 100);
    const auto measure = problem_of(complex, {{"fairing", 1.0}});
    double before = std::numeric_limits<double>::infinity();
    for (const double weight : {0.0, 0.3, 3.0}) {
      const SolveReport report = solve(*problem_of(complex, {{"position", 1.0}, {"fairing", weight}}));
      EXPECT_EQ(report.status, SolveStatus::Converged)
          << sample << " " << weight << ": " << report.stop_reason;
      const double now = objective(*measure, report.state);
      EXPECT_LT(now, 0.98 * before) << sample << " " << weight;
      before = now;
    }
  }
}

// The unit of the weights is nobody's business: neither the panels nor what counts as converged depend on it.
TEST(IpoptSolver, OnlyTheRatioOfWeightsMatters) {
  const SharedComplex complex = sample_complex("dome", 100);
  const SolveReport one = solve(*problem_of(complex, {{"position", 1.0}, {"fairing", 0.5}}));
  ASSERT_EQ(one.status, SolveStatus::Converged);
  for (const double factor : {1e-5, 10.0, 1e5}) {
    const auto problem = problem_of(complex, {{"position", factor}, {"fairing", 0.5 * factor}});
    const SolveReport same = solve(*problem);
    EXPECT_EQ(same.status, SolveStatus::Converged) << factor << ": " << same.stop_reason;
    EXPECT_EQ(same.iterations, one.iterations) << factor;
    EXPECT_LE(distance(*complex, one.state, same.state), 1e-6) << factor;
    EXPECT_NEAR(energy(same), factor * energy(one), 1e-6 * energy(same));
    EXPECT_NEAR(same.first_order_residual, one.first_order_residual, 0.1 * one.first_order_residual + 1e-12);
    // The multipliers are those of the problem as it was stated.
    const Vector z = problem->from_state(same.state);
    EXPECT_NEAR(problem->first_order_residual(z.data(), same.multipliers.data()) / factor,
                same.first_order_residual, 1e-9);
  }
}

TEST(IpoptSolver, NormalsFreedomKeepsTheOffsets) {
  const SharedComplex complex = dual_of(make_sample("dome", 100).value(), {0.3});
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Normals);
  const SolveReport report = solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  EXPECT_LE((report.state.h - complex->offsets).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_GT((report.state.n - complex->normals).rowwise().norm().maxCoeff(), 1e-4);
  // Fewer unknowns cannot do better.
  const auto all = problem_of(complex, {{"position", 1.0}});
  EXPECT_LE(energy(solve(*all)), energy(report) * (1 + 1e-6));
}

TEST(IpoptSolver, FixedFreedomKeepsThePlanes) {
  const SharedComplex complex = dual_of(domed_triangle_grid(6, 5).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Fixed);
  const SolveReport report = solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  EXPECT_LE((report.state.h - complex->offsets).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LE((report.state.n - complex->normals).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  // Points on three planes are where these meet; the others are the nearest place on theirs.
  const TpiResult exact = explicit_intersection(*complex);
  for (int j = 0; j < complex->point_count(); ++j) {
    const auto planes = complex->planes_of_point[j];
    Vector3d expected = exact.state.x.row(j);
    if (planes.size() == 1) {
      const Vector3d n = complex->normals.row(planes[0]);
      expected -= n * n.dot(complex->preferred.row(j) - complex->anchors.row(planes[0]));
    }
    if (planes.size() == 2) continue;
    EXPECT_NEAR((report.state.x.row(j).transpose() - expected).norm(), 0.0, 1e-6) << j;
  }
}

// A flat roof with fixed planes: nothing is determined there but by the energies.
TEST(IpoptSolver, FixedFreedomSettlesFlatPlaces) {
  const SharedComplex complex = dual_of(triangle_grid(4, 4).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Fixed);
  const SolveReport report = solve(*problem, perturbed(*complex, 0.0));
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  EXPECT_NEAR(distance(*complex, report.state, initial_state(*complex)), 0.0, 1e-6);
}

TEST(IpoptSolver, IsDeterministic) {
  for (const std::string_view sample : {"train-station", "twisted-roof"}) {
    const SharedComplex complex = sample_complex(sample, 150);
    const auto problem = problem_of(complex, {{"position", 1.0}, {"fairing", 0.1}});
    const SolveReport first = solve(*problem);
    solve(*problem_of(sample_complex("dome", 40), {{"position", 1.0}}));  // whatever else this process solves
    const SolveReport second = solve(*problem);
    EXPECT_EQ(first.iterations, second.iterations);
    EXPECT_TRUE(same_bits(first.state.x, second.state.x));
    EXPECT_TRUE(same_bits(first.state.n, second.state.n));
    EXPECT_TRUE(same_bits(first.state.h, second.state.h));
    EXPECT_EQ(first.first_order_residual, second.first_order_residual);
  }
}

TEST(IpoptSolver, FromAConvergedStateConvergesInFewIterations) {
  for (const std::string_view sample : {"train-station", "twisted-roof"}) {
    const SharedComplex complex = sample_complex(sample, 150);
    const auto problem = problem_of(complex, {{"position", 1.0}});
    const SolveReport cold = solve(*problem);
    ASSERT_EQ(cold.status, SolveStatus::Converged) << cold.stop_reason;
    const SolveReport warm = solve(*problem, cold.state);
    EXPECT_EQ(warm.status, SolveStatus::Converged) << warm.stop_reason;
    EXPECT_LE(warm.iterations, 5) << sample << " (cold: " << cold.iterations << ")";
    EXPECT_LE(distance(*complex, warm.state, cold.state), 1e-2);
    EXPECT_LE(energy(warm), energy(cold) * (1 + 1e-4));
  }
}

TEST(IpoptSolver, TellsTheObserverEveryIterationInOrder) {
  const SharedComplex complex = sample_complex("train-station", 150);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  Recorder recorder;
  const SolveReport report = solve(*problem, initial_state(*complex), {}, &recorder);
  ASSERT_GE(recorder.iterations.size(), 3u);
  EXPECT_EQ(static_cast<int>(recorder.iterations.size()), report.iterations + 1);
  double seconds = 0.0;
  for (size_t k = 0; k < recorder.iterations.size(); ++k) {
    EXPECT_EQ(recorder.iterations[k].number, static_cast<int>(k));
    EXPECT_GE(recorder.iterations[k].seconds, seconds);
    seconds = recorder.iterations[k].seconds;
  }
  EXPECT_GE(report.seconds, seconds);
  // States are those of their iterations: the first the start, each of the energy that its scalars say.
  ASSERT_EQ(recorder.states.size(), recorder.iterations.size());
  EXPECT_NEAR(distance(*complex, recorder.states.front(), initial_state(*complex)), 0.0, 1e-12);
  for (size_t k = 0; k < recorder.states.size(); ++k) {
    const Vector z = problem->from_state(recorder.states[k]);
    EXPECT_NEAR(problem->objective(z.data()), recorder.iterations[k].objective,
                1e-9 * (1.0 + recorder.iterations[k].objective));
    EXPECT_NEAR(constraint_values(*problem, z).cwiseAbs().maxCoeff(), recorder.iterations[k].infeasibility,
                1e-9);
  }
  // The last one is what the projection took to rounding.
  EXPECT_LE(distance(*complex, recorder.states.back(), report.state), 1e-4);
  EXPECT_LE(report.projection_move, 1e-4);
}

TEST(IpoptSolver, OptionsReachIpopt) {
  IpoptOverrides overrides;
  overrides.integers["max_iter"] = 2;
  const SharedComplex complex = sample_complex("dome", 60);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  SolveOptions options;
  options.tolerance = 1e-10;
  const SolveReport report =
      make_ipopt_solver(overrides)->solve(*problem, initial_state(*complex), options, nullptr, {});
  EXPECT_EQ(report.iterations, 2);
}

// Asked at every iterate, in the problem's units; what it says yes to is the result.
TEST(IpoptSolver, StopsWhereTheCallersTestIsMet) {
  const SharedComplex complex = sample_complex("dome", 60);
  const auto problem = problem_of(complex, {{"position", 2.0}});
  double least = std::numeric_limits<double>::infinity();
  Vector kept, kept_multipliers;
  int asked = 0;
  IpoptOverrides overrides;
  overrides.own_termination = false;
  overrides.stop_when = [&](const Vector& z, const Vector& multipliers, double infeasibility) {
    ++asked;
    EXPECT_NEAR(constraint_values(*problem, z).cwiseAbs().maxCoeff(), infeasibility, 1e-9);
    kept = z;
    kept_multipliers = multipliers;
    least = std::min(least, problem->first_order_residual(z.data(), multipliers.data()));
    return infeasibility <= 1e-6 && least <= 1e-2;
  };
  const SolveReport report =
      make_ipopt_solver(overrides)->solve(*problem, initial_state(*complex), {}, nullptr, {});
  EXPECT_EQ(asked, report.iterations + 1);
  EXPECT_LE(least, 1e-2);
  const Vector z = problem->from_state(report.state);
  EXPECT_NEAR(problem->first_order_residual(z.data(), report.multipliers.data()),
              2.0 * report.first_order_residual, 1e-12);
  EXPECT_LE(2.0 * report.first_order_residual,
            problem->first_order_residual(z.data(), kept_multipliers.data()) * (1.0 + 1e-9));
  const State at = problem->to_state({kept.data(), static_cast<size_t>(kept.size())});
  EXPECT_LE(distance(*complex, report.state, at), 1e-4);  // but for the projection
}

TEST(IpoptSolver, ExactStepsAloneFindAStationaryStateToo) {
  IpoptOverrides overrides;
  overrides.gauss_newton_iterations = 0;
  const SharedComplex complex = sample_complex("twisted-roof", 80);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const SolveReport exact =
      make_ipopt_solver(overrides)->solve(*problem, initial_state(*complex), {}, nullptr, {});
  EXPECT_EQ(exact.status, SolveStatus::Converged) << exact.stop_reason;
  EXPECT_LE(exact.first_order_residual, 1e-3);
  EXPECT_LE(off_plane(*complex, exact.state), 1e-12);
}

// A start that is far from everything, even turned over, ends in words and with a state.
TEST(IpoptSolver, SurvivesAWildStart) {
  const SharedComplex complex = sample_complex("train-station", 60);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const State wild = perturbed(*complex, 3.0, 5);
  SolveOptions options;
  options.max_iterations = 60;
  const SolveReport report = solve(*problem, wild, options);
  EXPECT_FALSE(report.stop_reason.empty());
  EXPECT_TRUE(report.state.x.allFinite());
  EXPECT_EQ(report.status == SolveStatus::NotPlanar || report.status == SolveStatus::Failed,
            off_plane(*complex, report.state) > 1e-9)
      << name(report.status) << " " << off_plane(*complex, report.state);
}

TEST(SolveStatus, HasNames) {
  EXPECT_STREQ(name(SolveStatus::Converged), "converged");
  EXPECT_STREQ(name(SolveStatus::Planar), "planar, not converged");
  EXPECT_STREQ(name(SolveStatus::Stopped), "stopped");
  EXPECT_STREQ(name(SolveStatus::NotPlanar), "not planar");
  EXPECT_STREQ(name(SolveStatus::Infeasible), "infeasible");
  EXPECT_STREQ(name(SolveStatus::Failed), "failed");
}

}  // namespace
}  // namespace planewright
