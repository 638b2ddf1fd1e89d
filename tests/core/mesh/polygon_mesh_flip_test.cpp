#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/mesh/polygon_mesh.h"
#include "core/mesh/sample_shapes.h"
#include "support/shapes.h"

namespace planewright {
namespace {

using test::grid;
using test::Shape;
using test::triangle_grid;

// The faces without regard to their order and first corners.
std::multiset<std::vector<int>> face_set(const PolygonMesh& mesh) {
  std::multiset<std::vector<int>> result;
  const Polygons faces = mesh.faces();
  for (int f = 0; f < faces.size(); ++f) {
    std::vector<int> corners(faces[f].begin(), faces[f].end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

std::vector<std::pair<int, int>> edge_ends(const PolygonMesh& mesh) {
  std::vector<std::pair<int, int>> ends;
  for (int e = 0; e < mesh.edge_count(); ++e) ends.emplace_back(std::minmax(mesh.edge(e).a, mesh.edge(e).b));
  return ends;
}

// The mesh must be one that from_polygons would build, and agree with itself.
void expect_consistent(const PolygonMesh& mesh) {
  const auto again = PolygonMesh::from_polygons(mesh.positions(), mesh.faces());
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->edge_count(), mesh.edge_count());
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    EXPECT_EQ(again->is_border_vertex(v), mesh.is_border_vertex(v));
    auto faces = mesh.faces_around(v), same_faces = again->faces_around(v);
    if (mesh.is_border_vertex(v)) {
      EXPECT_EQ(faces, same_faces);  // the border says where the list begins
    }
    std::sort(faces.begin(), faces.end());
    std::sort(same_faces.begin(), same_faces.end());
    EXPECT_EQ(faces, same_faces);
  }
  const Polygons faces = mesh.faces();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    EXPECT_EQ(mesh.find_edge(edge.a, edge.b), e);
    ASSERT_GE(edge.left, 0);
    const auto left = faces[edge.left];
    const auto at = std::find(left.begin(), left.end(), edge.a) - left.begin();
    EXPECT_EQ(left[static_cast<size_t>(at + 1) % left.size()], edge.b);
  }
}

TEST(Flip, JoinsTheOppositeCorners) {
  PolygonMesh mesh = triangle_grid(1, 1).mesh();  // 0 1 3 and 0 3 2, cut from 0 to 3
  const int e = mesh.find_edge(0, 3);
  // Corners 1 and 2 have valence 2, 0 and 3 have 3: they may lose one at the border.
  ASSERT_TRUE(mesh.can_flip(e));
  EXPECT_TRUE(mesh.flip(e));
  EXPECT_EQ(mesh.find_edge(1, 2), e);
  EXPECT_EQ(mesh.find_edge(0, 3), -1);
  EXPECT_EQ(face_set(mesh), (std::multiset<std::vector<int>>{{0, 1, 2}, {1, 3, 2}}));
  expect_consistent(mesh);
}

TEST(Flip, TwiceRestoresWithLeftAndRightExchanged) {
  PolygonMesh mesh = triangle_grid(4, 3).mesh();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto faces = face_set(mesh);
    const auto ends = edge_ends(mesh);
    const MeshEdge before = mesh.edge(e);
    if (!mesh.can_flip(e)) {
      EXPECT_FALSE(mesh.flip(e));
      EXPECT_EQ(face_set(mesh), faces);
      continue;
    }
    ASSERT_TRUE(mesh.flip(e));
    expect_consistent(mesh);
    EXPECT_NE(face_set(mesh), faces);
    ASSERT_TRUE(mesh.flip(e));
    EXPECT_EQ(face_set(mesh), faces);
    EXPECT_EQ(edge_ends(mesh), ends);
    EXPECT_EQ(mesh.edge(e).a, before.b);
    EXPECT_EQ(mesh.edge(e).b, before.a);
    // The faces' numbers change places, as left and right do.
    ASSERT_TRUE(mesh.flip(e) && mesh.flip(e));
    EXPECT_EQ(mesh.edge(e).left, before.left);
    EXPECT_EQ(mesh.edge(e).right, before.right);
  }
}

TEST(Flip, LeavesOtherEdgesAlone) {
  PolygonMesh mesh = triangle_grid(3, 3).mesh();
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const auto before = edge_ends(mesh);
    if (!mesh.flip(e)) continue;
    const auto after = edge_ends(mesh);
    for (int other = 0; other < mesh.edge_count(); ++other)
      EXPECT_EQ(before[other] == after[other], other != e);
    mesh.flip(e);
  }
}

TEST(Flip, RefusesBorderAndPolygons) {
  PolygonMesh quads = grid(2, 1).mesh();
  for (int e = 0; e < quads.edge_count(); ++e) EXPECT_FALSE(quads.flip(e));
  PolygonMesh triangles = triangle_grid(2, 2).mesh();
  for (int e = 0; e < triangles.edge_count(); ++e)
    if (triangles.edge(e).border()) {
      EXPECT_FALSE(triangles.can_flip(e));
    }
  EXPECT_FALSE(triangles.can_flip(-1));
  EXPECT_FALSE(triangles.can_flip(triangles.edge_count()));
}

TEST(Flip, RefusesTrianglesBesideAQuad) {
  // The edge between a triangle and a quad stays; the edge between the two triangles may turn.
  const Points positions =
      test::make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}});
  PolygonMesh mesh = PolygonMesh::from_polygons(positions, {{0, 1, 4, 3}, {1, 2, 5}, {1, 5, 4}}).value();
  EXPECT_FALSE(mesh.can_flip(mesh.find_edge(1, 4)));
  EXPECT_TRUE(mesh.flip(mesh.find_edge(1, 5)));
  expect_consistent(mesh);
}

TEST(Flip, RefusesAnEdgeThatExists) {
  PolygonMesh mesh = test::tetrahedron().mesh();
  for (int e = 0; e < mesh.edge_count(); ++e) EXPECT_FALSE(mesh.can_flip(e));
}

TEST(Flip, KeepsLeastValences) {
  PolygonMesh inner = test::fan(3).mesh();  // the hub has valence 3
  for (int e : inner.edges_around(0)) EXPECT_FALSE(inner.can_flip(e));
  PolygonMesh hub = test::fan(4).mesh();
  const int e = hub.find_edge(0, 1);
  EXPECT_TRUE(hub.flip(e));
  for (int other : hub.edges_around(0)) EXPECT_FALSE(hub.can_flip(other));
  // At the border: vertices 1 and 2 of a fan of two triangles have valence 2 and 3.
  PolygonMesh strip = test::fan(3, true).mesh();
  const int middle = strip.find_edge(0, 2);
  EXPECT_TRUE(strip.can_flip(middle));
}

TEST(Flip, SurvivesThousandsInARow) {
  PolygonMesh mesh = make_torus(12, 15);
  const int edges = mesh.edge_count();
  unsigned state = 1;
  int flips = 0;
  for (int i = 0; i < 20'000; ++i) {
    state = state * 1664525u + 1013904223u;
    flips += mesh.flip(static_cast<int>((state >> 8) % static_cast<unsigned>(edges))) ? 1 : 0;
  }
  EXPECT_GT(flips, 5'000);
  EXPECT_EQ(mesh.edge_count(), edges);
  expect_consistent(mesh);
}

TEST(Flip, SurvivesThousandsAtTheBorder) {
  PolygonMesh mesh = triangle_grid(3, 2).mesh();
  unsigned state = 7;
  for (int i = 0; i < 5'000; ++i) {
    state = state * 1664525u + 1013904223u;
    mesh.flip(static_cast<int>((state >> 8) % static_cast<unsigned>(mesh.edge_count())));
    if (i % 50 == 0) expect_consistent(mesh);
  }
  expect_consistent(mesh);
}

// Rebuilt from its faces alone, a flipped mesh numbers its edges anew; with the list it does not.
TEST(Flip, EdgesKeepTheirNumbersWhenTheyAreListed) {
  PolygonMesh mesh = triangle_grid(4, 4).mesh();
  for (int e = 0; e < mesh.edge_count(); e += 3) mesh.flip(e);
  std::vector<std::array<int, 2>> edges;
  for (int e = 0; e < mesh.edge_count(); ++e) edges.push_back({mesh.edge(e).a, mesh.edge(e).b});
  const auto plain = PolygonMesh::from_polygons(mesh.positions(), mesh.faces()).value();
  const auto rebuilt = PolygonMesh::from_polygons(mesh.positions(), mesh.faces(), edges).value();
  expect_consistent(rebuilt);
  EXPECT_EQ(rebuilt.faces(), mesh.faces());
  bool differs = false;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge a = mesh.edge(e), b = rebuilt.edge(e), c = plain.edge(e);
    EXPECT_TRUE(a.a == b.a && a.b == b.b && a.left == b.left && a.right == b.right) << e;
    differs = differs || a.a != c.a || a.b != c.b;
  }
  EXPECT_TRUE(differs);
}

TEST(Flip, RefusesListedEdgesThatAreNotTheFaces) {
  const Points positions = test::make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto error = [&](std::vector<std::array<int, 2>> edges) {
    const auto mesh = PolygonMesh::from_polygons(positions, {{0, 1, 2}}, edges);
    return mesh ? std::string() : mesh.error().text();
  };
  EXPECT_EQ(error({{2, 0}, {0, 1}, {1, 2}}), "");
  EXPECT_NE(error({{2, 0}, {0, 1}}).find("3 edges, but 2 are listed"), std::string::npos);
  EXPECT_NE(error({{2, 0}, {0, 1}, {2, 1}}).find("from vertex 2 to vertex 1"), std::string::npos);
  EXPECT_NE(error({{2, 0}, {0, 1}, {0, 1}}).find("edge 2"), std::string::npos);
  EXPECT_NE(error({{2, 0}, {0, 1}, {7, -1}}).find("edge 2"), std::string::npos);
}

}  // namespace
}  // namespace planewright
