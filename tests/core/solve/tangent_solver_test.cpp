#include "core/solve/tangent_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <new>

#include "core/problem/energies/energy_catalogue.h"
#include "support/demands.h"
#include "support/shape_demands.h"

namespace planewright {
namespace {

using namespace test;

void expect_converged(const Problem& problem, const SolveReport& report, const std::string& what,
                      const SolveOptions& options = {}) {
  EXPECT_EQ(report.status, SolveStatus::Converged) << what << ": " << report.stop_reason;
  EXPECT_EQ(report.solver, "tangent");
  EXPECT_FALSE(report.stop_reason.empty());
  expect_sound(problem, report, what);
  EXPECT_LE(report.first_order_residual, options.tolerance) << what;
  EXPECT_NEAR(first_order(problem, report), report.first_order_residual, 1e-9) << what;
}

struct EnergyCase {
  std::string sample, energy;
};
class SolvesEnergy : public testing::TestWithParam<EnergyCase> {};

TEST_P(SolvesEnergy, ToAPlanarStationaryState) {
  const auto& [sample, energy_name] = GetParam();
  const SharedComplex complex = sample_complex(sample, 80, 0.05);
  const auto problem = problem_of(complex, {{"position", 0.2}, {energy_name, 1.0}});
  const SolveReport report = tangent_solve(*problem);
  expect_converged(*problem, report, energy_name);
  // The energy counts: it is lower than where it has no weight.
  if (energy_name == "position") return;
  const auto alone = problem_of(complex, {{energy_name, 1.0}});
  const double before = objective(*alone, tangent_solve(*problem_of(complex, {{"position", 0.2}})).state);
  if (energy_name == "corner-angle" && before == 0.0)
    EXPECT_EQ(objective(*alone, report.state), 0.0);  // all blunt
  else
    EXPECT_LT(objective(*alone, report.state), before);
}

std::vector<EnergyCase> energy_cases() {
  std::vector<EnergyCase> cases;
  for (const char* sample : {"dome", "twisted-roof"})
    for (const EnergyInfo& info : energy_catalogue()) cases.push_back({sample, info.name});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Energies, SolvesEnergy, testing::ValuesIn(energy_cases()), [](const auto& test) {
  std::string label = test.param.sample + "_" + test.param.energy;
  std::replace(label.begin(), label.end(), '-', '_');
  return label;
});

TEST(TangentSolver, SolvesSmallComplexesOfEveryKind) {
  for (const auto& [label, complex] : small_complexes()) {
    const auto problem = problem_of(complex, {{"position", 1.0}});
    expect_converged(*problem, tangent_solve(*problem), label);
  }
}

TEST(TangentSolver, SolvesEverySample) {
  for (const SampleInfo& info : samples()) {
    const auto problem = problem_of(sample_complex(info.name, 100), {{"position", 1.0}});
    expect_converged(*problem, tangent_solve(*problem), std::string(info.name));
  }
}

TEST(TangentSolver, WithoutWeightsFindsSomePlanarState) {
  for (const char* sample : {"dome", "twisted-roof"}) {
    const SharedComplex complex = sample_complex(sample, 80);
    const auto problem = problem_of(complex, {});
    const SolveReport report = tangent_solve(*problem);
    expect_converged(*problem, report, sample);
    EXPECT_TRUE(report.energies.empty());
    EXPECT_LT(distance(*complex, report.state, initial_state(*complex)), 3.0) << sample;
  }
}

TEST(TangentSolver, LeavesAnExactDesignWhereItIs) {
  for (const SharedComplex& complex : {dual_of(triangle_grid(4, 3).mesh()), planarize_of(cube().mesh()),
                                       planarize_of(grid(3, 3).mesh(), {0.5})}) {
    const auto problem = problem_of(complex, {{"position", 1.0}});
    const SolveReport report = tangent_solve(*problem);
    EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
    EXPECT_NEAR(distance(*complex, report.state, initial_state(*complex)), 0.0, 1e-7);
  }
}

TEST(TangentSolver, NormalsFreedomKeepsTheOffsets) {
  const SharedComplex complex = dual_of(make_sample("dome", 100).value(), {0.3});
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Normals);
  const SolveReport report = tangent_solve(*problem);
  expect_converged(*problem, report, "normals");
  EXPECT_LE((report.state.h - complex->offsets).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_GT((report.state.n - complex->normals).rowwise().norm().maxCoeff(), 1e-4);
  EXPECT_LE(energy(tangent_solve(*problem_of(complex, {{"position", 1.0}}))), energy(report) * (1.0 + 1e-6));
}

TEST(TangentSolver, FixedFreedomKeepsThePlanes) {
  for (const SharedComplex& complex :
       {dual_of(domed_triangle_grid(6, 5).mesh()), dual_of(triangle_grid(4, 4).mesh())}) {
    const auto problem = problem_of(complex, {{"position", 1.0}, {"fairing", 0.1}}, Freedom::Fixed);
    const SolveReport report = tangent_solve(*problem);
    expect_converged(*problem, report, "fixed");
    EXPECT_LE((report.state.h - complex->offsets).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LE((report.state.n - complex->normals).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(TangentSolver, OnlyTheRatioOfWeightsMatters) {
  const SharedComplex complex = sample_complex("dome", 100);
  const SolveReport one = tangent_solve(*problem_of(complex, {{"position", 1.0}, {"fairing", 0.5}}));
  for (const double factor : {1e-5, 1e5}) {
    const auto problem = problem_of(complex, {{"position", factor}, {"fairing", 0.5 * factor}});
    const SolveReport same = tangent_solve(*problem);
    expect_converged(*problem, same, std::to_string(factor));
    EXPECT_EQ(same.iterations, one.iterations) << factor;
    EXPECT_LE(distance(*complex, one.state, same.state), 1e-6) << factor;
    EXPECT_NEAR(energy(same), factor * energy(one), 1e-6 * energy(same));
  }
}

TEST(TangentSolver, TheSameInputGivesTheSameBits) {
  for (const char* sample : {"train-station", "twisted-roof"}) {
    const SharedComplex complex = sample_complex(sample, 120);
    const auto problem = problem_of(complex, {{"position", 1.0}, {"fairing", 0.1}});
    const SolveReport first = tangent_solve(*problem);
    tangent_solve(*problem_of(sample_complex("dome", 40), {{"position", 1.0}}));
    const SolveReport second = tangent_solve(*problem);
    EXPECT_EQ(first.iterations, second.iterations);
    EXPECT_TRUE(same_bits(first.state.x, second.state.x));
    EXPECT_TRUE(same_bits(first.state.n, second.state.n));
    EXPECT_TRUE(same_bits(first.state.h, second.state.h));
    EXPECT_TRUE(same_bits(first.multipliers, second.multipliers));
    EXPECT_EQ(first.first_order_residual, second.first_order_residual);
  }
}

TEST(TangentSolver, AnObserverChangesNoBit) {
  const auto problem = problem_of(sample_complex("twisted-roof", 100), {{"position", 1.0}});
  Recorder recorder;
  const SolveReport watched = tangent_solve(*problem, initial_state(problem->complex()), {}, &recorder);
  EXPECT_TRUE(same_bits(watched.state.x, tangent_solve(*problem).state.x));
}

TEST(TangentSolver, TellsEveryStepInOrderAndShowsPlanarStatesAlone) {
  const SharedComplex complex = sample_complex("train-station", 120);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  Recorder recorder;
  const SolveReport report = tangent_solve(*problem, initial_state(*complex), {}, &recorder);
  ASSERT_EQ(static_cast<int>(recorder.iterations.size()), report.iterations + 1);
  size_t states = 0;
  for (size_t k = 0; k < recorder.iterations.size(); ++k) {
    EXPECT_EQ(recorder.iterations[k].number, static_cast<int>(k));
    states += recorder.iterations[k].planar;
  }
  EXPECT_EQ(recorder.states.size(), states);
  EXPECT_GE(states, 2u);
  for (const State& state : recorder.states) EXPECT_LE(off_plane(*complex, state), 1e-9);
}

// The result of one problem, a weight moved a little: what a slider does.
TEST(TangentSolver, AWarmStartTakesFewerStepsThanACold) {
  for (const char* sample : {"twisted-roof", "train-station"})
    for (const bool demands : {false, true}) {
      SCOPED_TRACE(std::string(sample) + (demands ? " with demands" : ""));
      const SharedComplex complex = sample_complex(sample, 100, demands ? 0.2 : 0.0);
      const auto made = [&](double fairing) {
        ProblemSettings settings =
            demands ? demanding({demand("height-band", {-10.0, 0.19 * complex->mean_edge})})
                    : ProblemSettings{};
        settings.weights = {{"position", 1.0}, {"fairing", fairing}};
        return Problem::create(complex, settings).value();
      };
      const auto before = made(0.1), after = made(0.11);
      const auto solver = make_tangent_solver();
      const SolveReport first = solver->solve(*before, initial_state(*complex), {}, nullptr, {});
      ASSERT_EQ(first.status, SolveStatus::Converged) << first.stop_reason;
      SolveOptions near;
      near.near_solution = true;
      const SolveReport warm = solver->solve(*after, first.state, near, nullptr, {});
      const SolveReport cold = tangent_solve(*after);
      expect_converged(*after, warm, "warm");
      expect_converged(*after, cold, "cold");
      EXPECT_LT(2 * warm.iterations, cold.iterations);
      // With demands there are several minima; a warm start keeps to its own.
      EXPECT_LE(energy(warm), energy(cold) * (demands ? 1.2 : 1.001));
      // The very same problem again: next to nothing to do.
      const SolveReport again = solver->solve(*after, warm.state, near, nullptr, {});
      expect_converged(*after, again, "again");
      EXPECT_LE(again.iterations, 3);
      EXPECT_LE(distance(*complex, again.state, warm.state), 1e-2);
    }
}

// A promise that is wrong costs steps and nothing else.
TEST(TangentSolver, AStartThatIsNotNearIsSolvedAllTheSame) {
  for (const char* sample : {"dome", "wave-roof", "train-station"}) {
    const auto problem = problem_of(sample_complex(sample, 100), {{"position", 1.0}});
    SolveOptions options;
    options.near_solution = true;
    expect_converged(*problem, tangent_solve(*problem, options), sample);
  }
}

// What a solver keeps between solves fits other topologies, or is not used.
TEST(TangentSolver, OneSolverServesOtherDesignsInBetween) {
  const auto solver = make_tangent_solver();
  std::vector<SharedProblem> problems;
  for (const char* sample : {"dome", "twisted-roof", "vault"})
    problems.push_back(problem_of(sample_complex(sample, 80), {{"position", 1.0}}));
  problems.push_back(problem_of(sample_complex("dome", 80), {{"position", 1.0}, {"fairing", 0.5}}));
  for (int round = 0; round < 2; ++round)
    for (const auto& problem : problems) {
      const SolveReport shared = solver->solve(*problem, initial_state(problem->complex()), {}, nullptr, {});
      const SolveReport fresh = tangent_solve(*problem);
      EXPECT_EQ(shared.status, fresh.status);
      EXPECT_LE(distance(problem->complex(), shared.state, fresh.state), 1e-9);
    }
}

TEST(TangentSolver, ALimitOfIterationsLeavesAPlanarStateAndSaysSo) {
  for (const char* sample : {"train-station", "twisted-roof", "dome"})
    for (const int most : {0, 1, 3}) {
      const SharedComplex complex = sample_complex(sample, 100);
      const auto problem = problem_of(complex, {{"position", 1.0}});
      SolveOptions options;
      options.max_iterations = most;
      options.tolerance = 1e-12;
      const SolveReport report = tangent_solve(*problem, options);
      EXPECT_EQ(report.status, SolveStatus::Planar) << sample << ": " << report.stop_reason;
      EXPECT_NE(report.stop_reason.find("limit of " + std::to_string(most) + " iterations"),
                std::string::npos)
          << report.stop_reason;
      EXPECT_LE(report.iterations, most);
      EXPECT_GT(report.first_order_residual, options.tolerance);
      expect_sound(*problem, report, sample);
    }
}

std::shared_ptr<const Problem> station_problem(const SharedComplex& complex, bool demands) {
  return Problem::create(complex, demands ? demanding({demand("vertex"), demand("face"), demand("edge")})
                                          : ProblemSettings{})
      .value();
}

TEST(TangentSolver, StopsBeforeItBegins) {
  for (const bool demands : {false, true}) {
    const SharedComplex complex = sample_complex("train-station", 100, 0.1);
    const auto problem = station_problem(complex, demands);
    std::stop_source stop;
    stop.request_stop();
    const SolveReport report =
        tangent_solve(*problem, initial_state(*complex), {}, nullptr, stop.get_token());
    EXPECT_EQ(report.status, SolveStatus::Stopped) << report.stop_reason;
    EXPECT_FALSE(report.stop_reason.empty());
    EXPECT_EQ(report.iterations, 0);
    EXPECT_LE(off_plane(*complex, report.state), 1e-9);
  }
}

// From within an observer, at every stage of a solve.
TEST(TangentSolver, StopsInTheMiddleWithAPlanarState) {
  for (const bool demands : {false, true}) {
    const SharedComplex complex = sample_complex("train-station", 100, 0.1);
    const auto problem = station_problem(complex, demands);
    SolveOptions options;
    options.tolerance = 1e-13;
    for (const int at : {0, 1, 4, 12, 21}) {
      std::stop_source stop;
      Recorder recorder([&](const Iteration& iteration) {
        if (iteration.number == at) stop.request_stop();
      });
      const SolveReport report =
          tangent_solve(*problem, initial_state(*complex), options, &recorder, stop.get_token());
      EXPECT_EQ(report.status, SolveStatus::Stopped) << at << ": " << report.stop_reason;
      EXPECT_EQ(report.iterations, at);
      EXPECT_EQ(static_cast<int>(recorder.iterations.size()), at + 1);
      EXPECT_LE(off_plane(*complex, report.state), 1e-9) << at;
    }
  }
}

// To rounding, but with no further search for its demands.
TEST(TangentSolver, AStopGivesTheStateShownLast) {
  const SharedComplex complex = sample_complex("train-station", 100, 0.1);
  const auto problem =
      Problem::create(complex, demanding({demand("vertex"), demand("face"), demand("edge")})).value();
  SolveOptions options;
  options.tolerance = 1e-13;
  for (const int at : {1, 12, 21}) {
    std::stop_source stop;
    Recorder recorder([&](const Iteration& iteration) {
      if (iteration.number == at) stop.request_stop();
    });
    const SolveReport report =
        tangent_solve(*problem, initial_state(*complex), options, &recorder, stop.get_token());
    ASSERT_EQ(report.status, SolveStatus::Stopped) << at << ": " << report.stop_reason;
    ASSERT_FALSE(recorder.states.empty()) << at;
    EXPECT_LE(distance(*complex, report.state, recorder.states.back()), 1e-9) << at;
  }
}

TEST(TangentSolver, WithoutMemoryItKeepsTheStateShownLastAndForgetsTheRest) {
  const SharedComplex complex = sample_complex("train-station", 100);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const auto solver = make_tangent_solver();
  Recorder recorder([](const Iteration& iteration) {
    if (iteration.number == 3) throw std::bad_alloc();
  });
  const SolveReport report = solver->solve(*problem, initial_state(*complex), {}, &recorder, {});
  EXPECT_EQ(report.status, SolveStatus::Failed);
  EXPECT_NE(report.stop_reason.find("out of memory"), std::string::npos) << report.stop_reason;
  ASSERT_FALSE(recorder.states.empty());
  EXPECT_EQ((report.state.x - recorder.states.back().x).norm(), 0.0);
  EXPECT_LE(report.incidence_residual, 1e-9);
  expect_converged(*problem, solver->solve(*problem, initial_state(*complex), {}, nullptr, {}), "afterwards");
}

TEST(TangentSolver, AnAbandonedSolveEndsWithoutTheProjection) {
  const auto problem = problem_of(sample_complex("train-station", 100), {{"position", 1.0}});
  std::stop_source stop;
  stop.request_stop();
  SolveOptions options;
  options.abandoned = stop.get_token();
  const SolveReport report =
      tangent_solve(*problem, initial_state(problem->complex()), options, nullptr, stop.get_token());
  EXPECT_EQ(report.status, SolveStatus::Stopped);
  EXPECT_EQ(report.projection_move, 0.0);
  EXPECT_TRUE(report.state.x.allFinite());
}

TEST(TangentSolver, DemandsThatContradictEachOtherAreInfeasible) {
  const SharedComplex saddle = dual_of(make_sample("saddle-roof", 60).value());
  const auto problem = Problem::create(saddle, demanding({demand("convex")})).value();
  const SolveReport report = tangent_solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Infeasible);
  EXPECT_NE(report.stop_reason.find("the demands could not be met together"), std::string::npos)
      << report.stop_reason;
  EXPECT_NE(report.stop_reason.find("not met: "), std::string::npos) << report.stop_reason;
  EXPECT_TRUE(report.state.x.allFinite());
  EXPECT_TRUE(report.state.n.allFinite());
  double worst = 0.0;
  for (const auto& constraint : report.constraints) worst = std::max(worst, constraint.max_violation);
  EXPECT_GT(worst, 1e-9);
  // A state to go on from: nothing has flown away.
  EXPECT_LT(distance(*saddle, report.state, initial_state(*saddle)), 5.0);
}

// Far from everything or not even numbers: words and a state, never a hang.
TEST(TangentSolver, SurvivesAWildStart) {
  for (const double off : {1.0, 3.0, 100.0}) {
    const SharedComplex complex = sample_complex("train-station", 60);
    const auto problem = problem_of(complex, {{"position", 1.0}});
    SolveOptions options;
    options.max_iterations = 60;
    const SolveReport report = tangent_solve(*problem, perturbed(*complex, off, 5), options);
    EXPECT_FALSE(report.stop_reason.empty());
    EXPECT_TRUE(report.state.x.allFinite());
    EXPECT_LE(report.iterations, 60);
    EXPECT_EQ(report.status == SolveStatus::NotPlanar || report.status == SolveStatus::Failed,
              off_plane(*complex, report.state) > 1e-9)
        << name(report.status) << " " << off_plane(*complex, report.state);
  }
}

TEST(TangentSolver, AStartThatIsNoNumberFails) {
  const SharedComplex complex = sample_complex("dome", 40);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200}) {
    State start = initial_state(*complex);
    start.x(3, 1) = bad;
    const SolveReport report = tangent_solve(*problem, start);
    EXPECT_EQ(report.status, SolveStatus::Failed);
    EXPECT_NE(report.stop_reason.find("not a finite number"), std::string::npos) << report.stop_reason;
  }
  State start = initial_state(*complex);
  start.n(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tangent_solve(*problem, start).status, SolveStatus::Failed);
}

// A failed or infeasible solve teaches nothing that would spoil the next one.
TEST(TangentSolver, AFailureIsForgotten) {
  const SharedComplex complex = sample_complex("dome", 80);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const auto solver = make_tangent_solver();
  State bad = initial_state(*complex);
  bad.x(3, 1) = std::numeric_limits<double>::quiet_NaN();
  ASSERT_EQ(solver->solve(*problem, bad, {}, nullptr, {}).status, SolveStatus::Failed);
  SolveOptions near;
  near.near_solution = true;
  const State start = tangent_solve(*problem).state;
  expect_converged(*problem, solver->solve(*problem, start, near, nullptr, {}), "after a failure");
}

// Demands: each is violated where it is not asked for, and met where it is.
struct DemandCase {
  std::string name;
  SharedComplex complex;
  ProblemSettings settings;
  FrozenGeometry frozen = {};
};

std::vector<DemandCase> demand_cases() {
  std::vector<DemandCase> cases;
  const SharedComplex saddle = sample_complex("saddle-roof", 80);
  for (const char* name : {"vertex", "face", "edge"}) {
    cases.push_back({std::string(name) + " outside", saddle, demanding({demand(name)}, {}, 1.0)});
    cases.push_back({std::string(name) + " inside", saddle, demanding({demand(name)}, {}, -1.0)});
  }
  const SharedComplex dome = sample_complex("dome", 80, 0.2);
  const double edge = dome->mean_edge;
  cases.push_back({"offset-band", dome, demanding({demand("offset-band", {0.0, 0.15 * edge})})});
  cases.push_back({"height-band", dome, demanding({demand("height-band", {0.19 * edge, 0.21 * edge})})});
  const SharedComplex quads = sample_complex("twisted-roof", 80);
  cases.push_back(
      {"height-band of quads", quads,
       demanding({demand("height-band", {-0.002 * quads->mean_edge, 0.002 * quads->mean_edge})})});
  const Shape roof = twisted_grid(9, 6, 0.03);
  Selection side{"side", {}, {}, {}};
  for (int v = 0; v <= 9; ++v) side.vertices.push_back(v);
  cases.push_back({"on-plane", planarize_of(roof.mesh()),
                   demanding({demand("on-plane", {0, 0, 0.1, 0, 0, 1}, "side")}, {side})});
  Shape bulge = triangle_grid(8, 6);
  for (Eigen::Index v = 0; v < bulge.positions.rows(); ++v) {
    const double x = bulge.positions(v, 0) / 8, y = bulge.positions(v, 1) / 6;
    bulge.positions(v, 2) = 10.0 * x * (1 - x) * y * (1 - y) * (1.0 + x);
  }
  cases.push_back({"border", dual_of(bulge.mesh()), demanding({demand("border")})});
  // Panels that cross themselves, or are rough, without the demand.
  const SharedComplex pushed = planarize_of(pushed_grid().mesh());
  const SharedComplex rough_quads = planarize_of(jittered(grid(4, 4), 0.25, 0.8, 5).mesh());
  const SharedComplex rough_dual = dual_of(jittered(triangle_grid(4, 4), 0.2, 0.4, 1).mesh(), {0.1});
  const SharedComplex uneven_dual = dual_of(jittered(triangle_grid(4, 4), 0.1, 0.1, 2).mesh(), {0.1});
  cases.push_back({"star", pushed, demanding({demand("star")})});
  cases.push_back({"star of a dual", rough_dual, demanding({demand("star")})});
  cases.push_back({"uncrossed", rough_quads, demanding({demand("uncrossed")})});
  cases.push_back({"convex", pushed, demanding({demand("convex")})});
  cases.push_back({"convex dual", uneven_dual, demanding({demand("convex")})});
  ProblemSettings even = demanding({demand("prism")});
  even.weights = {{"position", 0.001}, {"fairing", 1.0}};
  const Shape uneven =
      jittered(shape_of(make_sample("saddle-roof", 80).value()), 0.4 * saddle->mean_edge, 0.0, 3);
  cases.push_back({"prism", dual_of(uneven.mesh()), even});
  const Shape layers = jittered(domed_triangle_grid(3, 3, 0.1), 0.08, 0.03, 3);
  const SharedComplex inner = dual_of(layers.mesh());
  FrozenGeometry beside;
  beside.neighbour = std::make_shared<const NeighbourLayer>(
      NeighbourLayer{inner, tangent_solve(*problem_of(inner, {{"position", 1.0}})).state});
  cases.push_back(
      {"coplanar-beams", dual_of(layers.mesh(), {0.4}), demanding({demand("coplanar-beams")}), beside});
  const SharedComplex lifted = planarize_of(twisted_grid(4, 3).mesh());
  FrozenGeometry apart;
  apart.separations = {{6, Vector3d::UnitZ(), lifted->preferred(6, 2) + 0.25, 3}};
  cases.push_back({"separation", lifted, {}, apart});
  ProblemSettings pins;
  const Vector3d at = dome->preferred.row(20).transpose() + dome->origin + Vector3d(0.1, -0.1, 0.1) * edge;
  pins.demands.pins = {{dome->point_origin[20], {at[0], at[1], at[2]}}};
  const Vector3d n = (Vector3d(dome->normals.row(5)) + 0.1 * Vector3d::UnitX()).normalized();
  pins.demands.plane_pins = {
      {dome->plane_origin[5],
       PlanePin::Equation{{n[0], n[1], n[2]},
                          n.dot(dome->anchors.row(5).transpose() + dome->origin) + 0.3 * edge}}};
  cases.push_back({"pins", dome, pins});
  return cases;
}

TEST(TangentSolver, MeetsEveryDemand) {
  const std::vector<DemandCase> cases = demand_cases();
  size_t converged = 0;
  for (const auto& [label, complex, settings, frozen] : cases) {
    ProblemSettings without = settings;
    without.demands = {};
    const auto problem = Problem::create(complex, settings, frozen).value();
    const State free = tangent_solve(*Problem::create(complex, without).value()).state;
    ASSERT_FALSE(problem->violated_rows(problem->from_state(free).data(), 1e-4).empty()) << label;
    const SolveReport report = tangent_solve(*problem);
    EXPECT_TRUE(report.status == SolveStatus::Converged || report.status == SolveStatus::Planar)
        << label << ": " << report.stop_reason;
    expect_sound(*problem, report, label);
    if (report.status != SolveStatus::Converged) continue;
    ++converged;
    EXPECT_LE(first_order(*problem, report), SolveOptions{}.tolerance) << label;
  }
  // So narrow a band leaves quads next to no room, and multipliers open: that one may end short of the end.
  EXPECT_GE(converged + 1, cases.size());
}

}  // namespace
}  // namespace planewright
