#include "core/problem/energies/edge_direction_energy.h"

#include <gtest/gtest.h>

#include "energy_rows.h"

namespace planewright {
namespace {

using namespace test;

TEST(EdgeDirectionEnergy, IsThePartOfTheEdgeThatLeansAway) {
  TangentComplex complex = build_planarize(mixed_polygons().mesh()).value();
  const Layout layout{complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
  const auto energy = make_edge_direction_energy({complex, layout});
  EXPECT_EQ(energy->name(), "edge-direction");
  ASSERT_EQ(energy->terms(), static_cast<int>(complex.panel_edges.size()));
  ASSERT_EQ(energy->rows(), 3 * energy->terms());
  const Vector z = unknowns(layout, perturbed(complex, 0.4));
  for (int e = 0; e < energy->terms(); ++e) {
    const PanelEdge& edge = complex.panel_edges[static_cast<size_t>(e)];
    const Vector3d d = (complex.preferred.row(edge.a) - complex.preferred.row(edge.b)).normalized();
    const Vector3d along = z.segment<3>(layout.x(edge.a)) - z.segment<3>(layout.x(edge.b));
    const Vector3d across = along - d.dot(along) * d;
    for (int axis = 0; axis < 3; ++axis) {
      const int row = 3 * e + axis;
      EXPECT_EQ(stencil(*energy, row),
                (std::vector{layout.x(edge.a, 0), layout.x(edge.a, 1), layout.x(edge.a, 2),
                             layout.x(edge.b, 0), layout.x(edge.b, 1), layout.x(edge.b, 2)}));
      EXPECT_TRUE(energy->curvature(row).empty());
      EXPECT_NEAR(value(*energy, row, z), across[axis], 1e-14);
      Vector3d expected = -d[axis] * d;
      expected[axis] += 1.0;
      const Vector found = slope(*energy, row, z);
      EXPECT_NEAR((found.head<3>() - expected).norm(), 0.0, 1e-14);
      EXPECT_NEAR((found.tail<3>() + expected).norm(), 0.0, 1e-14);
    }
  }
}

// Along the edge everything is free, collapse and reversal too; across it nothing is.
TEST(EdgeDirectionEnergy, LetsEdgesStretchButNotTurn) {
  const SharedComplex complex = planarize_of(grid(2, 2).mesh());
  const auto problem = problem_of(complex, {{"edge-direction", 1.0}});
  State state = initial_state(*complex);
  for (const double stretch : {3.0, 0.0, -1.0}) {
    state.x.col(0) = stretch * initial_state(*complex).x.col(0);
    EXPECT_NEAR(objective(*problem, state), 0.0, 1e-26);
  }
  state = initial_state(*complex);
  state.x(4, 2) += 0.5;  // the middle: four edges lean by 0.5; 9 points, 12 edges
  EXPECT_NEAR(objective(*problem, state), 9.0 / 12.0 * 4 * 0.25, 1e-14);
}

TEST(EdgeDirectionEnergy, LeavesOutEdgesThatHaveNoDirection) {
  TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  const Layout layout{complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
  for (const auto& [length, terms] : {std::pair{0.0, 6}, {0.9e-3, 6}, {1.1e-3, 7}}) {
    complex.preferred.row(1) = complex.preferred.row(0);
    complex.preferred(1, 0) += length;
    const auto energy = make_edge_direction_energy({complex, layout});
    EXPECT_EQ(energy->terms(), terms) << length;
    EXPECT_EQ(energy->rows(), 3 * terms);
    const Vector z = unknowns(layout, initial_state(complex));
    for (int row = 0; row < energy->rows(); ++row) EXPECT_NEAR(value(*energy, row, z), 0.0, 1e-15);
  }
}

}  // namespace
}  // namespace planewright
