#include "core/diagnose/mesh_places.h"

#include <gtest/gtest.h>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(MeshPlaces, OfADualAreTheEdgesCrossed) {
  const PolygonMesh mesh = fan(6).mesh();
  const SharedComplex complex = dual_of(mesh);
  const MeshPlaces places(*complex);
  int crossed = 0;
  for (size_t e = 0; e < complex->panel_edges.size(); ++e) {
    const auto [i, j] = complex->crossed_edge[e];
    const auto edges = places.of_panel_edge(static_cast<int>(e));
    if (i < 0) {
      EXPECT_TRUE(edges.empty());
    } else {
      EXPECT_EQ(edges, std::vector<int>{mesh.find_edge(i, j)});
      ++crossed;
    }
  }
  EXPECT_EQ(crossed, 12);
  EXPECT_EQ(places.of_panel(0).size(), 6u);  // the hub's
  for (int j = 0; j < complex->point_count(); ++j) {
    const size_t expected = complex->point_origin[j].kind == PointKind::Face         ? 3
                            : complex->point_origin[j].kind == PointKind::BorderEdge ? 1
                                                                                     : 0;
    EXPECT_EQ(places.of_point(j).size(), expected);
  }
}

TEST(MeshPlaces, OfAPlanarizedMeshAreItsOwn) {
  const PolygonMesh mesh = grid(2, 2).mesh();
  const SharedComplex complex = planarize_of(mesh);
  const MeshPlaces places(*complex);
  for (size_t e = 0; e < complex->panel_edges.size(); ++e) {
    const PanelEdge& edge = complex->panel_edges[e];
    EXPECT_EQ(places.of_panel_edge(static_cast<int>(e)), std::vector<int>{mesh.find_edge(edge.a, edge.b)});
  }
  EXPECT_EQ(places.of_panel(0), united({mesh.find_edge(0, 1), mesh.find_edge(1, 4)},
                                       {mesh.find_edge(4, 3), mesh.find_edge(3, 0)}));
  EXPECT_EQ(places.of_point(4).size(), 4u);
  EXPECT_EQ(places.find_edge(0, 4), -1);
}

TEST(United, IsAscendingAndHasEachOnce) {
  EXPECT_EQ(united({5, 1}, {3, 1}), (std::vector<int>{1, 3, 5}));
  EXPECT_TRUE(united({}, {}).empty());
}

}  // namespace
}  // namespace planewright
