// Corner angle: which corners and edges, at which angles and lengths, with which slopes, and what it does to
// panels.
#include "core/problem/energies/corner_angle_energy.h"

#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "core/diagnose/panel_angles.h"
#include "energy_rows.h"
#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

Layout layout_of(const TangentComplex& complex) {
  return {complex.point_count(), complex.plane_count(), Freedom::NormalsAndOffsets};
}

// Planar: a unit square and a triangle to its right whose tip, point 4, has `degrees`.
Shape kite(double degrees) {
  const double reach = 0.5 / std::tan(0.5 * degrees * std::numbers::pi / 180.0);
  return {make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1 + reach, 0.5, 0}}),
          {{0, 1, 2, 3}, {1, 4, 2}}};
}

// Row of the corner at point `at` between the neighbours a and b, in either order.
int row_of(const Energy& energy, int a, int at, int b) {
  for (int row = 0; row < energy.terms(); ++row) {
    const auto variables = stencil(energy, row);
    if (variables[3] / 3 == at && std::set{variables[0] / 3, variables[6] / 3} == std::set{a, b}) return row;
  }
  ADD_FAILURE() << "no corner " << a << " " << at << " " << b;
  return 0;
}

TEST(CornerAngleEnergy, HasARowPerCornerAndOnePerEdge) {
  const TangentComplex complex = build_planarize(mixed_polygons().mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_corner_angle_energy({complex, layout});
  EXPECT_EQ(energy->name(), "corner-angle");
  EXPECT_EQ(energy->terms(), 4 + 3 + 5 + 7);
  EXPECT_EQ(energy->rows(), 19 + 14) << "an edge of two panels is one";
  std::multiset<std::array<int, 3>> corners;
  for (int row = 0; row < energy->terms(); ++row) {
    const auto variables = stencil(*energy, row);
    ASSERT_EQ(variables.size(), 9u);
    for (int k = 0; k < 9; ++k)
      EXPECT_EQ(variables[static_cast<size_t>(k)],
                layout.x(variables[static_cast<size_t>(3 * (k / 3))] / 3, k % 3));
    corners.insert({variables[0] / 3, variables[3] / 3, variables[6] / 3});
  }
  std::multiset<std::array<int, 3>> expected;
  for (const std::vector<int>& panel :
       std::vector<std::vector<int>>{{0, 1, 2, 3}, {3, 2, 4}, {2, 1, 6, 5, 4}, {3, 4, 5, 10, 9, 8, 7}})
    for (size_t k = 0; k < panel.size(); ++k)
      expected.insert(
          {panel[(k + panel.size() - 1) % panel.size()], panel[k], panel[(k + 1) % panel.size()]});
  EXPECT_EQ(corners, expected);
  std::multiset<std::pair<int, int>> edges;
  for (int row = energy->terms(); row < energy->rows(); ++row) {
    const auto variables = stencil(*energy, row);
    ASSERT_EQ(variables.size(), 6u);
    edges.insert({variables[0] / 3, variables[3] / 3});
  }
  for (size_t k = 0; k < complex.panel_edges.size(); ++k)
    EXPECT_EQ(edges.count({complex.panel_edges[k].a, complex.panel_edges[k].b}), 1u);
}

// By the formula: with lengths a and b of the two edges, an angle t, and s, l of the header.
TEST(CornerAngleEnergy, GrowsAsTheCornerCloses) {
  for (const double degrees : {10.0, 25.0, 44.0, 46.0, 90.0, 150.0}) {
    const TangentComplex complex = build_planarize(kite(degrees).mesh()).value();
    const Layout layout = layout_of(complex);
    const auto energy = make_corner_angle_energy({complex, layout});
    const Vector z = unknowns(layout, initial_state(complex));
    const double side = (complex.preferred.row(1) - complex.preferred.row(4)).norm();
    const double cosine = std::cos(degrees * std::numbers::pi / 180.0) * side * side / (side * side + 0.01);
    const double wanted = std::pow(std::max(0.0, (cosine - std::sqrt(0.5)) / (1.0 - std::sqrt(0.5))), 2);
    EXPECT_NEAR(value(*energy, row_of(*energy, 1, 4, 2), z), wanted, 1e-12) << degrees;
    EXPECT_EQ(wanted > 0.0, degrees < 45.0);
    // Those of the square are right angles, whatever the triangle does.
    for (int at = 0; at < 4; ++at)
      EXPECT_EQ(value(*energy, row_of(*energy, (at + 3) % 4, at, (at + 1) % 4), z), 0.0);
    for (int row = energy->terms(); row < energy->rows(); ++row)
      EXPECT_EQ(value(*energy, row, z), 0.0) << "no edge is short";
  }
}

// The tip, pulled from 20 degrees: downhill opens it, by moving it towards its neighbours and these apart.
TEST(CornerAngleEnergy, OpensTheCornerDownhill) {
  const TangentComplex complex = build_planarize(kite(20.0).mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_corner_angle_energy({complex, layout});
  const Vector z = unknowns(layout, initial_state(complex));
  const int row = row_of(*energy, 1, 4, 2);
  const auto variables = stencil(*energy, row);
  const Vector down = -slope(*energy, row, z);
  ASSERT_EQ(variables[3], layout.x(4, 0));
  EXPECT_LT(down[3], -0.1) << "the tip goes back";
  EXPECT_NEAR(down[4], 0.0, 1e-12);
  for (const int end : {0, 6}) {
    const bool low = variables[static_cast<size_t>(end)] == layout.x(1, 0);
    EXPECT_GT((low ? -1.0 : 1.0) * down[end + 1], 0.1) << "its neighbours go apart";
  }
  // Neither a shift nor a turn changes an angle.
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(down[axis] + down[3 + axis] + down[6 + axis], 0.0, 1e-12);
  EXPECT_EQ(down[2], 0.0);
}

TEST(CornerAngleEnergy, IsTheSameOnEitherSideOfAPanel) {
  Shape shape = kite(20.0);
  const TangentComplex complex = build_planarize(shape.mesh()).value();
  shape.faces = {{3, 2, 1, 0}, {2, 4, 1}};
  const TangentComplex turned = build_planarize(shape.mesh()).value();
  const Layout layout = layout_of(complex);
  const Vector z = unknowns(layout, initial_state(complex));
  const double one = mean_square(*make_corner_angle_energy({complex, layout}), z);
  EXPECT_GT(one, 1e-3);
  EXPECT_NEAR(mean_square(*make_corner_angle_energy({turned, layout}), z), one, 1e-15);
}

TEST(CornerAngleEnergy, LengthensShortEdges) {
  const TangentComplex complex = build_planarize(grid(1, 1).mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_corner_angle_energy({complex, layout});
  const int row = energy->terms();
  const auto variables = stencil(*energy, row);
  for (const double length : {0.0, 0.01, 0.15, 0.29, 0.31, 2.0}) {
    Vector z = unknowns(layout, initial_state(complex));
    z.segment<3>(variables[3]) = z.segment<3>(variables[0]) + length * Vector3d(0.6, 0.0, 0.8);
    const double hinge = std::max(0.0, 1.0 - length * length / 0.09);
    EXPECT_NEAR(value(*energy, row, z), hinge * hinge, 1e-13) << length;
    const Vector down = -slope(*energy, row, z);
    const double pull = 4.0 * hinge * length / 0.09;
    EXPECT_NEAR((down.tail<3>() - pull * Vector3d(0.6, 0.0, 0.8)).norm(), 0.0, 1e-12) << length;
    EXPECT_NEAR((down.head<3>() + down.tail<3>()).norm(), 0.0, 1e-12) << length;
  }
}

// To shrink an edge of a sharp corner must not pay: the edge's own row outweighs what the corner gains.
TEST(CornerAngleEnergy, DoesNotRewardACollapse) {
  const TangentComplex complex = build_planarize(kite(15.0).mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_corner_angle_energy({complex, layout});
  Vector z = unknowns(layout, initial_state(complex));
  const auto at = [&](double length) {  // of the edge from the tip to point 1
    const Vector3d tip = complex.preferred.row(4), back = complex.preferred.row(1);
    z.segment<3>(layout.x(1)) = tip + length * (back - tip).normalized();
    double sum = 0.0;
    for (int row = energy->terms(); row < energy->rows(); ++row) sum += std::pow(value(*energy, row, z), 2);
    return sum + std::pow(value(*energy, row_of(*energy, 1, 4, 2), z), 2);
  };
  EXPECT_GT(at(0.0), at(0.5));
  EXPECT_GT(at(0.05), at(0.5));
}

TEST(CornerAngleEnergy, IsNotFiniteWhereAPointIsNot) {
  const TangentComplex complex = build_planarize(kite(20.0).mesh()).value();
  const Layout layout = layout_of(complex);
  const auto energy = make_corner_angle_energy({complex, layout});
  Vector z = unknowns(layout, initial_state(complex));
  z[layout.x(4, 1)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(std::isfinite(value(*energy, row_of(*energy, 1, 4, 2), z)));
}

// Both solvers blunt the corners of a sheared roof; not to the same minimum, for there are several.
TEST(CornerAngleEnergy, BluntsAcutePanels) {
  Shape sheared = shape_of(make_sample("twisted-roof", 60).value());
  sheared.positions.col(0) += 2.2 * sheared.positions.col(1);
  const SharedComplex complex = planarize_of(sheared.mesh());
  const auto acute = [&](const State& state) {
    const Panels panels = panels_of(*complex, state);
    return find_acute_corners(panels.points, panels.polygons).size();
  };
  const auto plain = problem_of(complex, {{"position", 1.0}}),
             blunt = problem_of(complex, {{"position", 1.0}, {"corner-angle", 10.0}});
  const State start = tangent_solve(*plain).state;
  const size_t before = acute(start);
  EXPECT_GT(before, 20u);
  const SolveReport ours = tangent_solve(*blunt, start), theirs = solve(*blunt, start);
  for (const SolveReport* report : {&ours, &theirs}) {
    EXPECT_EQ(report->status, SolveStatus::Converged) << report->stop_reason;
    EXPECT_LT(acute(report->state), before / 4);
    EXPECT_LT(energy(*report), 0.5 * objective(*blunt, start));
  }
}

}  // namespace
}  // namespace planewright
