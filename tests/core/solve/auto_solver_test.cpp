#include "core/solve/auto_solver.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/mesh/mesh_io.h"
#include "support/demands.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

using namespace test;

SolveReport auto_solve(const Problem& problem, const SolveOptions& options = {},
                       SolveObserver* observer = nullptr, std::stop_token stop = {}) {
  return make_auto_solver()->solve(problem, initial_state(problem.complex()), options, observer, stop);
}

// Quads between bounds so narrow that the tangent solver ends short of the tolerance.
SharedProblem narrow_band() {
  const SharedComplex quads = sample_complex("twisted-roof", 80);
  const double small = 0.002 * quads->mean_edge;
  return Problem::create(quads, demanding({demand("height-band", {-small, small})})).value();
}

std::vector<std::pair<std::string, SharedProblem>> some_problems() {
  std::vector<std::pair<std::string, SharedProblem>> problems;
  for (const char* sample : {"dome", "twisted-roof", "train-station", "alpine-hut"})
    problems.push_back(
        {sample, problem_of(sample_complex(sample, 80), {{"position", 1.0}, {"fairing", 0.1}})});
  problems.push_back(
      {"in front", Problem::create(sample_complex("dome", 80, 0.05),
                                   demanding({demand("vertex"), demand("face"), demand("edge")}))
                       .value()});
  problems.push_back(
      {"fixed", problem_of(dual_of(domed_triangle_grid(6, 5).mesh()), {{"position", 1.0}}, Freedom::Fixed)});
  return problems;
}

TEST(AutoSolver, ConfirmsTheTangentSolversStateAndIsNeverWorse) {
  for (const auto& [label, problem] : some_problems()) {
    const SolveReport report = auto_solve(*problem), tangent = tangent_solve(*problem);
    EXPECT_EQ(report.status, SolveStatus::Converged) << label << ": " << report.stop_reason;
    EXPECT_EQ(report.solver, "tangent, ipopt") << label;
    expect_sound(*problem, report, label);
    EXPECT_LE(first_order(*problem, report), SolveOptions{}.tolerance) << label;
    EXPECT_NEAR(first_order(*problem, report), report.first_order_residual, 1e-9) << label;
    EXPECT_LE(energy(report), energy(tangent) * (1.0 + 1e-4)) << label;
    // It went on from there, and had next to nowhere to go.
    EXPECT_LE(distance(problem->complex(), report.state, tangent.state), 0.05) << label;
    EXPECT_LE(report.iterations, tangent.iterations + 12) << label;
    EXPECT_GE(report.iterations, tangent.iterations) << label;
  }
}

TEST(AutoSolver, TellsPlanarStatesAloneAndCountsOn) {
  for (const auto& [label, problem] : some_problems()) {
    struct Watcher final : SolveObserver {
      explicit Watcher(const TangentComplex& of) : complex(of) {}
      void on_iteration(const Iteration& iteration, const State* state) override {
        iterations.push_back(iteration);
        EXPECT_EQ(iteration.planar, state != nullptr);
        if (!state) return;
        ++states;
        EXPECT_STREQ(iteration.solver, "tangent");
        EXPECT_LE(off_plane(complex, *state), 1e-9);
      }
      const TangentComplex& complex;
      std::vector<Iteration> iterations;
      int states = 0;
    } watcher(problem->complex());
    const SolveReport report = auto_solve(*problem, {}, &watcher);
    EXPECT_GT(watcher.states, 0) << label;
    bool by_ipopt = false;
    double seconds = 0.0;
    for (size_t k = 0; k < watcher.iterations.size(); ++k) {
      const Iteration& iteration = watcher.iterations[k];
      EXPECT_EQ(iteration.number, static_cast<int>(k)) << label;
      EXPECT_GE(iteration.seconds, seconds) << label;
      seconds = iteration.seconds;
      const bool ipopt = std::strcmp(iteration.solver, "ipopt") == 0;
      EXPECT_TRUE(ipopt || !by_ipopt) << label;  // first one, then the other
      by_ipopt = ipopt;
    }
    EXPECT_TRUE(by_ipopt) << label;
    EXPECT_GE(report.seconds, seconds) << label;
  }
}

TEST(AutoSolver, TheLimitOfIterationsIsForBothTogether) {
  const auto problem = narrow_band();
  const SolveReport tangent = tangent_solve(*problem);
  ASSERT_EQ(tangent.status, SolveStatus::Planar) << tangent.stop_reason;
  for (const int most : {0, 2, tangent.iterations + 5}) {
    SolveOptions options;
    options.max_iterations = most;
    Recorder recorder;
    const SolveReport report = auto_solve(*problem, options, &recorder);
    EXPECT_LE(report.iterations, most);
    EXPECT_EQ(std::strcmp(recorder.iterations.back().solver, "ipopt") == 0, most > tangent.iterations)
        << most;
    EXPECT_EQ(report.status, SolveStatus::Planar) << report.stop_reason;
    EXPECT_NE(report.stop_reason.find("limit of"), std::string::npos) << report.stop_reason;
    EXPECT_LE(off_plane(problem->complex(), report.state), rounding(problem->complex()));
  }
}

TEST(AutoSolver, StopsInTheFirstHalfWithAPlanarState) {
  const auto problem = problem_of(sample_complex("train-station", 80), {{"position", 1.0}});
  for (const int at : {0, 2, 5}) {
    std::stop_source stop;
    Recorder recorder([&](const Iteration& iteration) {
      if (iteration.number == at) stop.request_stop();
    });
    const SolveReport report = auto_solve(*problem, {}, &recorder, stop.get_token());
    EXPECT_EQ(report.status, SolveStatus::Stopped) << at;
    EXPECT_EQ(report.iterations, at);
    EXPECT_EQ(report.solver, "tangent");
    EXPECT_LE(off_plane(problem->complex(), report.state), 1e-9) << at;
  }
  std::stop_source before;
  before.request_stop();
  const SolveReport report = auto_solve(*problem, {}, nullptr, before.get_token());
  EXPECT_EQ(report.status, SolveStatus::Stopped);
  EXPECT_EQ(report.iterations, 0);
}

// What the tangent solver had found is not thrown away for a stop.
TEST(AutoSolver, AStopInTheSecondHalfKeepsTheTangentSolversState) {
  const auto problem = narrow_band();
  const SolveReport tangent = tangent_solve(*problem);
  std::stop_source stop;
  Recorder recorder([&](const Iteration& iteration) {
    if (iteration.number == tangent.iterations + 3) stop.request_stop();
  });
  const SolveReport report = auto_solve(*problem, {}, &recorder, stop.get_token());
  ASSERT_STREQ(recorder.iterations.back().solver, "ipopt");
  EXPECT_EQ(report.solver, "tangent");
  EXPECT_NE(report.stop_reason.find("stopped before Ipopt had confirmed it"), std::string::npos)
      << report.stop_reason;
  EXPECT_TRUE(same_bits(report.state.x, tangent.state.x));
  EXPECT_GT(report.iterations, tangent.iterations);
}

TEST(AutoSolver, DemandsThatContradictEachOtherAreInfeasible) {
  const auto problem =
      Problem::create(sample_complex("saddle-roof", 60), demanding({demand("convex")})).value();
  const SolveReport report = auto_solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Infeasible);
  EXPECT_FALSE(report.stop_reason.empty());
  EXPECT_TRUE(report.state.x.allFinite());
}

TEST(AutoSolver, TheSameInputGivesTheSameBits) {
  const auto problem = problem_of(sample_complex("train-station", 100), {{"position", 1.0}});
  const SolveReport first = auto_solve(*problem), second = auto_solve(*problem);
  EXPECT_EQ(first.iterations, second.iterations);
  EXPECT_TRUE(same_bits(first.state.x, second.state.x));
  EXPECT_TRUE(same_bits(first.multipliers, second.multipliers));
}

// Real designs, by both parts: planar to rounding and stationary by the problem's own measure.
class RealMesh : public testing::TestWithParam<const char*> {};

TEST_P(RealMesh, BecomesPlanarAndStationary) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  const PolygonMesh mesh = load_mesh(folder / GetParam()).value().mesh;
  const bool triangles = std::string(GetParam()).starts_with("tri/");
  const SharedComplex complex = triangles ? dual_of(mesh) : planarize_of(mesh);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  SolveOptions options;
  options.tolerance = 1e-4;
  const SolveReport tangent = tangent_solve(*problem, options), report = auto_solve(*problem, options);
  for (const SolveReport* made : {&tangent, &report}) {
    EXPECT_EQ(made->status, SolveStatus::Converged) << made->solver << ": " << made->stop_reason;
    expect_sound(*problem, *made, made->solver);
    EXPECT_LE(first_order(*problem, *made), 1e-4) << made->solver;
  }
  EXPECT_LE(energy(report), energy(tangent) * (1.0 + 1e-4));
}

INSTANTIATE_TEST_SUITE_P(AutoSolver, RealMesh,
                         testing::Values("tri/bunny1k.obj", "tri/train-station.off", "tri/torus.off",
                                         "quad/inspired_mesh_quads_Conjugate.off",
                                         "quad/botijo_miq_quad.obj"),
                         [](const auto& test) {
                           std::string label = test.param;
                           for (char& c : label)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return label;
                         });

}  // namespace
}  // namespace planewright
