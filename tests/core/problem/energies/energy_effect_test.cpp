// What a weight does to a real solve: the energy it names goes down, more so the larger it is.
#include <gtest/gtest.h>

#include "core/problem/energies/energy_catalogue.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;
using Weights = std::map<std::string, double>;

struct Design {
  std::string name;
  SharedComplex complex;
};

class EnergyEffect : public testing::TestWithParam<std::string> {};

TEST_P(EnergyEffect, AWeightLowersItsEnergy) {
  const std::string name = GetParam();
  int lowered = 0;
  for (const auto& [label, complex] :
       {Design{"dome", dual_of(make_sample("dome", 120).value(), {0.1})},
        Design{"wave_roof", dual_of(make_sample("wave-roof", 120).value())},
        Design{"twisted_roof", planarize_of(make_sample("twisted-roof", 100).value())},
        Design{"alpine_hut", dual_of(make_sample("alpine-hut", 120).value())}}) {
    const auto measure = problem_of(complex, {{name, 1.0}});
    double before = std::numeric_limits<double>::infinity();
    State start = initial_state(*complex);
    for (const double weight : {0.0, 1.0, 30.0}) {
      SCOPED_TRACE(label + ", weight " + std::to_string(weight));
      const auto problem = problem_of(complex, {{"position", 1.0}, {name, weight}});
      const SolveReport report = solve(*problem, start);
      EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
      EXPECT_LT(report.incidence_residual, 1e-9);
      const double value = objective(*measure, report.state);
      // Corners that are all blunt leave nothing to lower.
      if (name == "corner-angle" && value == 0.0) break;
      EXPECT_GT(value, 0.0);
      EXPECT_LT(value, weight == 0.0 ? before : 0.98 * before);
      before = value;
      // On the way from the given planes corners close that the energy then does not open again: its weight
      // is raised on solved panels.
      if (name == "corner-angle") start = report.state;
      ++lowered;
    }
  }
  EXPECT_GE(lowered, 3);
}

std::vector<std::string> energies_besides_position() {
  std::vector<std::string> names;
  for (const EnergyInfo& info : energy_catalogue())
    if (info.name != "position") names.push_back(info.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Catalogue, EnergyEffect, testing::ValuesIn(energies_besides_position()),
                         [](const auto& energy) {
                           std::string name = energy.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// The surface that closeness draws to may be another one than the mesh.
TEST(ClosenessEffect, DrawsALayerToItsOffsetFromAnotherSurface) {
  const auto mesh = make_sample("vault", 120).value();
  const double offset = 0.2;
  const SharedComplex complex = dual_of(mesh, {offset});
  Shape lifted = shape_of(mesh);
  const double lift = 0.5 * complex->mean_edge;
  lifted.positions.col(2).array() += lift;
  const auto reference = ReferenceSurface::create(lifted.positions, lifted.faces, "lifted").value();

  const auto mean_distance = [&](const State& state) {
    double sum = 0.0;
    for (int j = 0; j < complex->point_count(); ++j) {
      const ClosestPoint foot = reference->closest(state.x.row(j), complex->origin);
      sum += std::abs(foot.normal.dot(state.x.row(j).transpose() - foot.point) - offset);
    }
    return sum / complex->point_count() / complex->mean_edge;
  };
  const auto solved = [&](double weight) {
    FrozenGeometry frozen;
    frozen.reference = reference;
    const auto problem = Problem::create(
        complex, {Freedom::NormalsAndOffsets, {{"position", 0.01}, {"closeness", weight}}}, frozen);
    const SolveReport report = solve(**problem, initial_state(*complex));
    EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
    return report.state;
  };
  const double without = mean_distance(solved(0.0)), with = mean_distance(solved(10.0));
  EXPECT_GT(without, 0.2);
  EXPECT_LT(with, 0.2 * without);
}

// [Z 2.4]: the solver then just gives the first valid solution.
TEST(EnergyEffect, WithoutAnyWeightASolveStillSucceeds) {
  Weights none;
  for (const EnergyInfo& info : energy_catalogue()) none[info.name] = 0.0;
  for (const SharedComplex& complex : {dual_of(make_sample("dome", 120).value(), {0.1}),
                                       planarize_of(make_sample("twisted-roof", 100).value())}) {
    const SolveReport report = solve(*problem_of(complex, none));
    EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
    EXPECT_LT(report.incidence_residual, 1e-9);
    EXPECT_TRUE(report.energies.empty());
    // Near where it started, not anywhere.
    EXPECT_LT(distance(*complex, report.state, initial_state(*complex)), 2.0);
  }
}

}  // namespace
}  // namespace planewright
