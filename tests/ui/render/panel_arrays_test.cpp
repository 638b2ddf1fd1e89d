#include "ui/render/panel_arrays.h"

#include <gtest/gtest.h>

#include "test_layers.h"

namespace planewright::render {
namespace {

TEST(PanelArrays, KeepsTheGeometryOfTheSamePolygons) {
  const PolygonLayer layer = torus(12, 9);
  const PanelArrays first = make_panel_arrays(layer.points, layer.polygons);
  ASSERT_TRUE(first.geometry);
  EXPECT_EQ(first.places.size(), static_cast<size_t>(first.geometry->vertex_count()));
  EXPECT_TRUE(first.shadow);

  const Points moved = 1.5 * layer.points;
  const PanelArrays second = make_panel_arrays(moved, layer.polygons, first.geometry);
  EXPECT_EQ(second.geometry, first.geometry);  // the same object
  const int corner = first.geometry->corners[7];
  EXPECT_FLOAT_EQ(second.places[7].x, static_cast<float>(moved(corner, 0)));

  const PolygonLayer other = torus(12, 8);
  const PanelArrays third = make_panel_arrays(other.points, other.polygons, first.geometry);
  EXPECT_NE(third.geometry, first.geometry);
  EXPECT_EQ(third.geometry->polygons, other.polygons);
}

TEST(PanelArrays, CutsFoldedPanelsAnewWithoutTouchingTheOldGeometry) {
  const PolygonLayer layer = letter_l();
  const PanelArrays first = make_panel_arrays(layer.points, layer.polygons);
  const std::vector<int> corners = first.geometry->corners;
  const Points moved = rows({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}});
  const PanelArrays second = make_panel_arrays(moved, layer.polygons, first.geometry);
  EXPECT_NE(second.geometry, first.geometry);
  EXPECT_EQ(first.geometry->corners, corners);
  EXPECT_TRUE(find_folded(*second.geometry, moved).empty());
}

TEST(PanelArrays, KeepsTheGeometryOfPanelsThatNoCutUnfolds) {
  const PolygonLayer square = unit_square();
  const PanelArrays first = make_panel_arrays(square.points, square.polygons);
  // A bow tie, heavier on one side so that it has a normal.
  const Points bow = rows({{0, 0, 0}, {2, 0, 0}, {0.5, 1, 0}, {1, 1, 0}});
  ASSERT_FALSE(find_folded(*first.geometry, bow).empty());
  const PanelArrays once = make_panel_arrays(bow, square.polygons, first.geometry);
  const PanelArrays twice = make_panel_arrays(bow, square.polygons, once.geometry);
  EXPECT_EQ(once.geometry, twice.geometry);
}

TEST(PanelArrays, OfNothingIsNothing) {
  const PanelArrays none = make_panel_arrays(Points(0, 3), {});
  EXPECT_EQ(none.geometry->vertex_count(), 0);
  EXPECT_FALSE(none.shadow);
  EXPECT_TRUE(make_line_arrays({}).indices.empty());
  const GhostArrays ghost = make_ghost_arrays(Points(0, 3), {});
  EXPECT_TRUE(ghost.lines.vertices.empty());
  EXPECT_EQ(ghost.mean_edge, 0.0f);
}

TEST(GhostArrays, HasEveryEdgeOnce) {
  const PolygonLayer layer = two_squares();
  const GhostArrays ghost = make_ghost_arrays(layer.points, layer.polygons);
  EXPECT_EQ(ghost.lines.vertices.size(), 4u * 7u);
  EXPECT_EQ(ghost.lines.indices.size(), 6u * 7u);
  EXPECT_FLOAT_EQ(ghost.mean_edge, 1.0f);
  EXPECT_EQ(ghost.faces.geometry->polygons, layer.polygons);
}

TEST(PanelArrays, TheTrianglesOfSomePolygonsAreThoseOfAll) {
  PolygonLayer layer = two_squares();
  const PanelArrays all = make_panel_arrays(layer.points, layer.polygons);
  const PanelArrays second = triangles_of(all, {1});
  ASSERT_TRUE(second.geometry);
  EXPECT_EQ(second.geometry->vertex_count(), 6);
  ASSERT_EQ(second.places.size(), 6u);
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(second.geometry->corners[i], all.geometry->corners[6 + i]);
    EXPECT_EQ(second.places[i].x, all.places[6 + i].x);
    EXPECT_GE(second.places[i].x, 1.0f);
    EXPECT_EQ(second.geometry->shapes[i].edge_mask, all.geometry->shapes[6 + i].edge_mask);
  }
  EXPECT_EQ(triangles_of(all, {}).geometry->vertex_count(), 0);
  EXPECT_EQ(triangles_of({}, {0}).geometry, nullptr);
}

}  // namespace
}  // namespace planewright::render
