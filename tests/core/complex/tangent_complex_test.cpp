#include "core/complex/tangent_complex.h"

#include <gtest/gtest.h>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

const PanelEdge* find(const TangentComplex& complex, int a, int b) {
  for (const PanelEdge& edge : complex.panel_edges)
    if ((edge.a == a && edge.b == b) || (edge.a == b && edge.b == a)) return &edge;
  return nullptr;
}

std::vector<int> list(std::span<const int> span) {
  return {span.begin(), span.end()};
}

// Points 0..5 below, 3..5 above:  3-4-5
//                                 0-1-2   panels 0 (left) and 1 (right).
TangentComplex two_squares() {
  return build_planarize(grid(2, 1).mesh()).value();
}

TEST(PanelEdges, TellLeftFromRight) {
  const TangentComplex complex = two_squares();
  ASSERT_EQ(complex.panel_edges.size(), 7u);
  // The edge 1-4 in the middle: panel 0 runs 1 -> 4, panel 1 runs 4 -> 1.
  const PanelEdge* middle = find(complex, 1, 4);
  ASSERT_NE(middle, nullptr);
  EXPECT_EQ(middle->a == 1 ? middle->left : middle->right, 0);
  EXPECT_EQ(middle->a == 1 ? middle->right : middle->left, 1);
  EXPECT_FALSE(middle->border());
  const PanelEdge* bottom = find(complex, 0, 1);
  ASSERT_NE(bottom, nullptr);
  EXPECT_TRUE(bottom->border());
  EXPECT_EQ(bottom->a == 0 ? bottom->left : bottom->right, 0);
  EXPECT_EQ(bottom->a == 0 ? bottom->right : bottom->left, -1);
}

TEST(PanelEdges, EveryPanelRunsAlongItsLeftEdgesForward) {
  for (const auto& [name, complex] : small_complexes()) {
    int sides = 0;
    for (const PanelEdge& edge : complex->panel_edges) {
      EXPECT_TRUE(edge.left >= 0 || edge.right >= 0);
      for (const auto& [panel, from, to] :
           {std::tuple{edge.left, edge.a, edge.b}, std::tuple{edge.right, edge.b, edge.a}}) {
        if (panel < 0) continue;
        ++sides;
        const auto corners = complex->panels[panel];
        const auto at = std::find(corners.begin(), corners.end(), from) - corners.begin();
        ASSERT_LT(static_cast<size_t>(at), corners.size()) << name;
        EXPECT_EQ(corners[(static_cast<size_t>(at) + 1) % corners.size()], to) << name;
      }
    }
    EXPECT_EQ(sides, static_cast<int>(complex->panels.indices().size())) << name;
  }
}

TEST(MeanEdge, IsMeasuredAtThePreferredPositions) {
  Shape shape = grid(2, 1);
  shape.positions.col(0) *= 3.0;  // four edges of 3, three of 1
  EXPECT_DOUBLE_EQ(build_planarize(shape.mesh()).value().mean_edge, 15.0 / 7.0);
  TangentComplex complex = two_squares();
  complex.preferred *= 10.0;
  finish(complex);
  EXPECT_DOUBLE_EQ(complex.mean_edge, 10.0);
  EXPECT_EQ(complex.panel_edges.size(), 7u);  // and finishing twice adds nothing
}

TEST(MeanEdge, IsOneWhereAllPointsCoincide) {
  TangentComplex complex = two_squares();
  complex.preferred.setConstant(2.0);
  finish(complex);
  EXPECT_EQ(complex.mean_edge, 1.0);
}

TEST(FairingNeighbours, OfTheOutlineLieOnTheOutline) {
  // 6-7-8
  // 3-4-5
  // 0-1-2
  const Polygons neighbours = build_planarize(grid(2, 2).mesh()).value().fairing_neighbours();
  ASSERT_EQ(neighbours.size(), 9);
  EXPECT_EQ(list(neighbours[4]), (std::vector{1, 3, 5, 7}));
  EXPECT_EQ(list(neighbours[1]), (std::vector{0, 2}));  // not 4
  EXPECT_EQ(list(neighbours[3]), (std::vector{0, 6}));
  EXPECT_EQ(list(neighbours[0]), (std::vector{1, 3}));
  EXPECT_EQ(list(neighbours[8]), (std::vector{5, 7}));
}

TEST(FairingNeighbours, OfAClosedMeshAreAllAlongPanelEdges) {
  const TangentComplex complex = build_dual(icosahedron().mesh()).value();
  const Polygons neighbours = complex.fairing_neighbours();
  for (int j = 0; j < complex.point_count(); ++j) {
    EXPECT_EQ(neighbours.valence(j), 3);
    for (const int k : neighbours[j]) EXPECT_NE(find(complex, j, k), nullptr);
  }
}

// A closed dual's border: face points look at their neighbouring faces and border points, the outline's
// points along the outline alone.
TEST(FairingNeighbours, AtADualsBorder) {
  const PolygonMesh mesh = domed_triangle_grid(3, 3).mesh();
  const TangentComplex complex = build_dual(mesh).value();
  const Polygons neighbours = complex.fairing_neighbours();
  for (int j = 0; j < complex.point_count(); ++j) {
    if (complex.point_origin[j].kind == PointKind::Face) {
      EXPECT_EQ(neighbours.valence(j), 3);
      continue;
    }
    EXPECT_EQ(neighbours.valence(j), 2);
    for (const int k : neighbours[j]) EXPECT_NE(complex.point_origin[k].kind, PointKind::Face);
  }
}

}  // namespace
}  // namespace planewright
