// Two solvers of different making, one problem: where it has but one minimum they have to end at the same
// energy, and each has to convince the problem's own measures.
#include <gtest/gtest.h>

#include "core/design/presets.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

// A pillow: raised in the middle, flat along its border.
Shape pillow(Shape shape, double rise) {
  const Eigen::RowVector3d low = shape.positions.colwise().minCoeff();
  const Eigen::RowVector3d size = shape.positions.colwise().maxCoeff() - low;
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v) {
    const double x = (shape.positions(v, 0) - low[0]) / size[0],
                 y = (shape.positions(v, 1) - low[1]) / size[1];
    shape.positions(v, 2) = rise * x * (1 - x) * y * (1 - y) * (1.0 + 0.5 * x);
  }
  return shape;
}

// Convex, or so gently curved that there is but one way to go. offset: mean edges.
struct Design {
  const char* name;
  SharedComplex complex;
};
SharedComplex dual_at(const Shape& shape, double offset) {
  return dual_of(shape.mesh(), {offset * dual_of(shape.mesh())->mean_edge});
}
Design dome(double offset = 0.0) {
  return {"dome", sample_complex("dome", 80, offset)};
}
Design vault(double offset = 0.0) {
  return {"vault", sample_complex("vault", 80, offset)};
}
Design gentle_roof(double offset = 0.0) {
  return {"gentle roof", dual_at(domed_triangle_grid(7, 6, 0.01), offset)};
}
Design flat_pillow() {
  return {"pillow", dual_at(pillow(triangle_grid(8, 6), 2.0), 0.0)};
}
Design pillow_of_quads() {
  return {"pillow of quads", planarize_of(pillow(grid(7, 6), 4.0).mesh())};
}
Design gentle_roof_of_quads() {
  return {"gentle roof of quads", planarize_of(twisted_grid(7, 5, 0.005).mesh())};
}

// Tight, so that what remains says something of the minimum and not of where a solver ended.
constexpr double kTolerance = 1e-5;

void expect_agreement(const Problem& problem, const std::string& what) {
  SCOPED_TRACE(what);
  SolveOptions options;
  options.tolerance = kTolerance;
  const SolveReport ipopt = solve(problem, options), tangent = tangent_solve(problem, options);
  for (const SolveReport* report : {&ipopt, &tangent}) {
    EXPECT_EQ(report->status, SolveStatus::Converged) << report->solver << ": " << report->stop_reason;
    expect_sound(problem, *report, report->solver);
    EXPECT_LE(first_order(problem, *report), kTolerance) << report->solver;
  }
  EXPECT_NEAR(energy(tangent), energy(ipopt), 5e-5 * energy(ipopt));
  EXPECT_LE(distance(problem.complex(), tangent.state, ipopt.state), 1e-2);
}

TEST(Agreement, OfThePositionEnergy) {
  for (const auto& [label, complex] :
       {dome(), vault(), flat_pillow(), gentle_roof(), pillow_of_quads(), gentle_roof_of_quads()})
    expect_agreement(*problem_of(complex, {{"position", 1.0}}), label);
}

TEST(Agreement, OfEveryFreedom) {
  for (const Freedom freedom : {Freedom::Fixed, Freedom::Normals})
    for (const auto& [label, complex] : {dome(0.1), vault(0.1)})
      expect_agreement(*problem_of(complex, {{"position", 1.0}}, freedom), label);
}

TEST(Agreement, OfEveryPreset) {
  for (const Preset& preset : presets()) {
    ProblemSettings settings;
    settings.weights = preset.weights;
    settings.demands.list = preset.demands;
    if (preset.for_dual)
      for (const auto& [label, complex] : {dome(), flat_pillow(), gentle_roof()})
        expect_agreement(*Problem::create(complex, settings).value(), preset.name + ", " + label);
    // Quads slide along the surface, turn into planes near theirs, or open their corners: several minima.
    if (preset.for_planarize && preset.name != "close" && preset.name != "proxy-planes" &&
        preset.name != "blunt-corners")
      for (const auto& [label, complex] : {pillow_of_quads(), gentle_roof_of_quads()})
        expect_agreement(*Problem::create(complex, settings).value(), preset.name + ", " + label);
  }
}

// Every combination of the other energies that the presets of figure 5 weigh.
TEST(Agreement, OfEveryCombinationOfOnePresetsEnergies) {
  const Preset& preset = *find_preset("hhh").value();
  const SharedComplex complex = pillow_of_quads().complex;
  std::vector<std::string> others;
  for (const auto& [energy_name, weight] : preset.weights)
    if (energy_name != "position") others.push_back(energy_name);
  ASSERT_EQ(others.size(), 3u);
  for (unsigned chosen = 0; chosen < 8; ++chosen) {
    std::map<std::string, double> weights{{"position", 0.1}};
    std::string what = "position";
    for (size_t k = 0; k < others.size(); ++k)
      if (chosen >> k & 1u) {
        weights[others[k]] = preset.weights.at(others[k]);
        what += ", " + others[k];
      }
    expect_agreement(*problem_of(complex, weights), what);
  }
}

TEST(Agreement, WithDemandsAgainstPenetration) {
  for (const double side : {1.0, -1.0})
    for (const std::vector<const char*>& families :
         {std::vector{"vertex"}, std::vector{"face"}, std::vector{"edge"},
          std::vector{"vertex", "face", "edge"}}) {
      std::vector<Demand> list;
      std::string what = side > 0.0 ? "outside" : "inside";
      for (const char* family : families) {
        list.push_back(demand(family));
        what += std::string(" ") + family;
      }
      for (const auto& [label, complex] : {dome(side * 0.05), vault(side * 0.05), gentle_roof(side * 0.05)})
        expect_agreement(*Problem::create(complex, demanding(list, {}, side)).value(), what + ", " + label);
    }
}

}  // namespace
}  // namespace planewright
