#include "ui/render/panel_geometry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <map>
#include <set>

#include "test_layers.h"
#include "ui/render/edge_list.h"

namespace planewright::render {
namespace {

using Edge = std::pair<int, int>;
Edge undirected(int a, int b) {
  return std::minmax(a, b);
}

std::multiset<Edge> marked(const PanelGeometry& g, std::uint32_t (*bit)(int)) {
  std::multiset<Edge> edges;
  for (int t = 0; t < g.vertex_count() / 3; ++t) {
    EXPECT_EQ(g.shapes[3 * t].edge_mask, g.shapes[3 * t + 1].edge_mask);
    EXPECT_EQ(g.shapes[3 * t].edge_mask, g.shapes[3 * t + 2].edge_mask);
    for (int k = 0; k < 3; ++k) {
      if ((g.shapes[3 * t].edge_mask & bit(k)) == 0) continue;
      edges.insert(undirected(g.corners[3 * t + (k + 1) % 3], g.corners[3 * t + (k + 2) % 3]));
    }
  }
  return edges;
}

std::multiset<Edge> polygon_edges(const Polygons& polygons) {
  std::multiset<Edge> edges;
  for (int p = 0; p < polygons.size(); ++p) {
    const auto polygon = polygons[p];
    for (size_t k = 0; k < polygon.size(); ++k)
      edges.insert(undirected(polygon[k], polygon[(k + 1) % polygon.size()]));
  }
  return edges;
}

Vector3d unpacked(std::uint32_t normal) {
  Vector3d n;
  for (int k = 0; k < 3; ++k) {
    int v = static_cast<int>(normal >> (10 * k) & 0x3ffu);
    if (v > 511) v -= 1024;
    n[k] = v / 511.0;
  }
  return n;
}

TEST(PanelGeometry, MarksEveryPanelEdgeOnceAndNoDiagonal) {
  for (const PolygonLayer& layer : {unit_square(), two_squares(), letter_l(), cube(), torus(7, 5)}) {
    const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
    EXPECT_EQ(marked(g, edge_bit), polygon_edges(layer.polygons));
  }
}

TEST(PanelGeometry, ConcavePolygonsKeepTheirOutline) {
  const PolygonLayer layer = letter_l();
  const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  ASSERT_EQ(g.vertex_count(), 3 * 4);
  double area = 0.0;
  for (int t = 0; t < 4; ++t) {
    const Vector3d a = layer.points.row(g.corners[3 * t]), b = layer.points.row(g.corners[3 * t + 1]),
                   c = layer.points.row(g.corners[3 * t + 2]);
    EXPECT_GT((b - a).cross(c - a).z(), 0.0);
    area += 0.5 * (b - a).cross(c - a).z();
  }
  EXPECT_NEAR(area, 3.0, 1e-12);
}

TEST(PanelGeometry, BordersAreEdgesOfOnePolygon) {
  const PolygonLayer layer = two_squares();
  const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  const auto borders = marked(g, border_edge_bit);
  EXPECT_EQ(borders.size(), 6u);
  EXPECT_EQ(borders.count(undirected(1, 4)), 0u);
  const PolygonLayer closed = torus(6, 5);
  EXPECT_TRUE(marked(make_panel_geometry(closed.points, closed.polygons), border_edge_bit).empty());
}

TEST(PanelGeometry, SizeIsTheRootOfTheArea) {
  const PolygonLayer layer = letter_l();
  const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  for (const PanelShape& shape : g.shapes) EXPECT_NEAR(shape.size, std::sqrt(3.0), 1e-6);
}

TEST(PanelGeometry, PlacesFollowThePointsAndShareThePanelsNormal) {
  PolygonLayer layer = cube();
  const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  layer.points = layer.points * 2.0;
  std::vector<PanelPlace> places(static_cast<size_t>(g.vertex_count()));
  write_places(g, layer.points, places);
  for (int p = 0; p < layer.polygons.size(); ++p) {
    const Vector3d outwards = centroid(layer.points, layer.polygons[p]).normalized();
    for (int k = 3 * g.first_triangle[p]; k < 3 * g.first_triangle[p + 1]; ++k) {
      const Vector3d expected = layer.points.row(g.corners[k]);
      EXPECT_EQ(Vector3d(places[k].x, places[k].y, places[k].z), expected);
      EXPECT_NEAR((unpacked(places[k].normal) - outwards).norm(), 0.0, 2e-3);
    }
  }
}

TEST(PanelGeometry, CutsPolygonsAgainThatTheirPointsFolded) {
  PolygonLayer layer = letter_l();
  PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  EXPECT_TRUE(find_folded(g, layer.points).empty());
  EXPECT_FALSE(cut_again(g, layer.points, 0));

  layer.points = rows({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}});  // another notch
  EXPECT_EQ(find_folded(g, layer.points), std::vector<int>{0});
  EXPECT_TRUE(cut_again(g, layer.points, 0));
  EXPECT_TRUE(find_folded(g, layer.points).empty());
  EXPECT_EQ(marked(g, edge_bit), polygon_edges(layer.polygons));
  EXPECT_EQ(marked(g, border_edge_bit), polygon_edges(layer.polygons));
  EXPECT_EQ(g.corners, make_panel_geometry(layer.points, layer.polygons).corners);

  layer.points =
      rows({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2.1, 0}, {-1, 2, 0}, {-1, 1, 0}});  // crosses itself
  cut_again(g, layer.points, 0);
  EXPECT_EQ(marked(g, edge_bit), polygon_edges(layer.polygons));
}

TEST(PanelGeometry, PacksNormals) {
  for (const Vector3d& n :
       {Vector3d(0, 0, 5), Vector3d(-1, 2, -3), Vector3d(1e-100, 0, 0), Vector3d(-1, 0, 0)}) {
    EXPECT_NEAR((unpacked(pack_normal(n)) - n.normalized()).norm(), 0.0, 2e-3);
  }
  for (const Vector3d& n : {Vector3d(0, 0, 0), Vector3d(std::nan(""), 0, 0)}) {
    EXPECT_EQ(unpacked(pack_normal(n)), Vector3d(0, 0, 1));
  }
}

TEST(PanelGeometry, SpreadsValuesOfPolygonsOrPoints) {
  const PolygonLayer layer = two_squares();
  const PanelGeometry g = make_panel_geometry(layer.points, layer.polygons);
  std::vector<float> out(static_cast<size_t>(g.vertex_count()));
  Vector of_polygons(2), of_points(6);
  of_polygons << 3.0, std::nan("");
  of_points << 0, 1, 2, 3, 4, 5;

  write_values(g, of_polygons, of_points, out);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(out[k], 3.0f);
  for (int k = 6; k < 12; ++k) EXPECT_EQ(out[k], kNoValue);
  write_values(g, {}, of_points, out);
  for (int k = 0; k < 12; ++k) EXPECT_EQ(out[k], static_cast<float>(g.corners[k]));
  write_values(g, {}, {}, out);
  for (float value : out) EXPECT_EQ(value, kNoValue);
}

TEST(PanelGeometry, LeavesOutWhatIsNoPolygon) {
  const Points points = unit_square().points;
  const PanelGeometry g = make_panel_geometry(points, {{0, 1}, {0, 1, 2}, {}, {3}});
  EXPECT_EQ(g.vertex_count(), 3);
  EXPECT_EQ(g.first_triangle, (std::vector<int>{0, 0, 1, 1, 1}));
  EXPECT_EQ(make_panel_geometry(Points(0, 3), {}).vertex_count(), 0);
}

TEST(EdgeList, ListsEachEdgeOnceWithItsPolygons) {
  const EdgeList closed = list_edges(torus(6, 5).polygons);
  EXPECT_EQ(closed.edges.size(), 60u);
  for (const EdgeUse& edge : closed.edges) EXPECT_EQ(edge.polygons, 2);

  const Polygons two = two_squares().polygons;
  const EdgeList open = list_edges(two);
  EXPECT_EQ(open.edges.size(), 7u);
  ASSERT_EQ(open.edge_of_corner.size(), 8u);
  for (int p = 0; p < 2; ++p) {
    for (int k = 0; k < 4; ++k) {
      const EdgeUse& edge = open.edges[open.edge_of_corner[4 * p + k]];
      EXPECT_EQ(undirected(two[p][k], two[p][(k + 1) % 4]), (Edge{edge.a, edge.b}));
    }
  }
  EXPECT_TRUE(list_edges({}).edges.empty());
}

}  // namespace
}  // namespace planewright::render
