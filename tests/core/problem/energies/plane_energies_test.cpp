// The energies of planes: normal smoothness, proxy normal, offset.
#include <gtest/gtest.h>

#include <set>

#include "core/problem/energies/normal_smoothness_energy.h"
#include "core/problem/energies/offset_energy.h"
#include "core/problem/energies/proxy_normal_energy.h"
#include "energy_rows.h"

namespace planewright {
namespace {

using namespace test;

Layout layout_of(const TangentComplex& complex) {
  return {complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
}

std::multiset<std::pair<int, int>> panel_pairs(const TangentComplex& complex) {
  const Layout layout = layout_of(complex);
  const auto energy = make_normal_smoothness_energy({complex, layout});
  EXPECT_EQ(energy->rows(), 3 * energy->terms());
  std::multiset<std::pair<int, int>> pairs;
  for (int term = 0; term < energy->terms(); ++term) {
    const auto first = stencil(*energy, 3 * term);
    const int i = (first[0] - layout.n(0)) / 3, k = (first[1] - layout.n(0)) / 3;
    pairs.insert({i, k});
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(stencil(*energy, 3 * term + axis), (std::vector{layout.n(i, axis), layout.n(k, axis)}));
      EXPECT_TRUE(energy->curvature(3 * term + axis).empty());
    }
  }
  return pairs;
}

TEST(NormalSmoothnessEnergy, ComparesPanelsThatShareAnEdge) {
  using Pairs = std::multiset<std::pair<int, int>>;
  // 2-3
  // 0-1
  EXPECT_EQ(panel_pairs(build_planarize(grid(2, 2).mesh()).value()), (Pairs{{0, 1}, {2, 3}, {0, 2}, {1, 3}}));
  EXPECT_EQ(panel_pairs(build_planarize(mixed_polygons().mesh()).value()),
            (Pairs{{0, 1}, {0, 2}, {0 + 1, 2}, {1, 3}, {2, 3}}));
  EXPECT_TRUE(panel_pairs(build_planarize(grid(1, 1).mesh()).value()).empty());
  // A dual's panels are neighbours where the mesh has an edge, along its border too.
  EXPECT_EQ(panel_pairs(build_dual(fan(3, true).mesh()).value()),
            (Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}}));
  // Two quads round a point of valence 2 share two edges and are one pair.
  const Shape doublet{make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0.3}}),
                      {{0, 1, 2, 4}, {0, 4, 2, 3}}};
  EXPECT_EQ(panel_pairs(build_planarize(doublet.mesh()).value()), (Pairs{{0, 1}}));
}

TEST(NormalSmoothnessEnergy, IsTheDifferenceOfTheNormals) {
  const SharedComplex complex = planarize_of(grid(2, 1).mesh());
  const auto problem = problem_of(complex, {{"normal-smoothness", 2.0}});
  State state = initial_state(*complex);
  EXPECT_EQ(objective(*problem, state), 0.0);
  state.n.row(0) << 0.6, 0, 0.8;
  state.n.row(1) << 0, 0.6, 0.8;
  // 6 points, one pair.
  EXPECT_NEAR(objective(*problem, state), 2.0 * 6.0 * 0.72, 1e-14);
  const Vector slope = gradient(*problem, problem->from_state(state));
  const Layout& layout = problem->layout();
  const Vector3d expected = 2.0 * 2.0 * 6.0 * Vector3d(0.6, -0.6, 0);
  EXPECT_NEAR((slope.segment<3>(layout.n(0)) - expected).norm(), 0.0, 1e-13);
  EXPECT_NEAR((slope.segment<3>(layout.n(1)) + expected).norm(), 0.0, 1e-13);
  EXPECT_NEAR(slope.norm(), std::sqrt(2.0) * expected.norm(), 1e-13);
}

TEST(ProxyNormalEnergy, ComparesEachPlaneWithTheBuilders) {
  const TangentComplex complex = build_planarize(twisted_grid(2, 2).mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_proxy_normal_energy({complex, layout});
  EXPECT_EQ(energy->name(), "proxy-normal");
  EXPECT_EQ(energy->terms(), 4);
  ASSERT_EQ(energy->rows(), 12);
  const State state = perturbed(complex, 0.3);
  const Vector z = unknowns(layout, state);
  for (int i = 0; i < 4; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 3 * i + axis;
      EXPECT_EQ(stencil(*energy, row), std::vector{layout.n(i, axis)});
      EXPECT_TRUE(energy->curvature(row).empty());
      EXPECT_DOUBLE_EQ(value(*energy, row, z), state.n(i, axis) - complex.normals(i, axis));
      EXPECT_EQ(slope(*energy, row, z)[0], 1.0);
    }
}

TEST(OffsetEnergy, ComparesEachPlaneWithTheLayersOffset) {
  Shape shape = grid(2, 2);
  shape.positions *= 4.0;
  const SharedComplex complex = planarize_of(shape.mesh(), {2.0});
  const auto problem = problem_of(complex, {{"offset", 3.0}});
  const Layout& layout = problem->layout();
  const auto energy = make_offset_energy({problem->normalised(), layout});
  EXPECT_EQ(energy->name(), "offset");
  EXPECT_EQ(energy->terms(), 4);
  ASSERT_EQ(energy->rows(), 4);
  State state = initial_state(*complex);
  EXPECT_EQ(objective(*problem, state), 0.0);
  state.h[2] += 1.0;  // a quarter of an edge
  const Vector z = problem->from_state(state);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(stencil(*energy, i), std::vector{layout.h(i)});
    EXPECT_TRUE(energy->curvature(i).empty());
    EXPECT_DOUBLE_EQ(value(*energy, i, z), i == 2 ? 0.25 : 0.0);
    EXPECT_EQ(slope(*energy, i, z)[0], 1.0);
  }
  EXPECT_DOUBLE_EQ(objective(*problem, state), 3.0 * 9.0 / 4.0 * 0.0625);
}

}  // namespace
}  // namespace planewright
