#include "core/mesh/polygon_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "support/shapes.h"

namespace planewright {
namespace {

using test::cube;
using test::fan;
using test::grid;
using test::Shape;
using test::tetrahedron;

std::string refusal(const Points& positions, const Polygons& faces) {
  const auto mesh = PolygonMesh::from_polygons(positions, faces);
  if (mesh) return "accepted";
  EXPECT_EQ(mesh.error().code, ErrorCode::Refused);
  EXPECT_FALSE(mesh.error().remedy.empty());
  return mesh.error().where;
}

TEST(PolygonMesh, KeepsCountsPositionsAndFaces) {
  for (const Shape& shape : {tetrahedron(), cube(), grid(3, 2), fan(5), fan(5, true)}) {
    const PolygonMesh mesh = shape.mesh();
    EXPECT_EQ(mesh.vertex_count(), shape.positions.rows());
    EXPECT_EQ(mesh.face_count(), shape.faces.size());
    EXPECT_EQ(mesh.positions(), shape.positions);
    EXPECT_EQ(mesh.faces(), shape.faces);
  }
  EXPECT_EQ(cube().mesh().edge_count(), 12);
  EXPECT_EQ(grid(3, 2).mesh().edge_count(), 17);
}

TEST(PolygonMesh, EmptyMeshIsEmpty) {
  const PolygonMesh mesh;
  EXPECT_EQ(mesh.vertex_count(), 0);
  EXPECT_EQ(mesh.face_count(), 0);
  EXPECT_EQ(mesh.edge_count(), 0);
  EXPECT_EQ(mesh.positions().rows(), 0);
  EXPECT_TRUE(mesh.faces().empty());
}

TEST(PolygonMesh, CopiesAreDeep) {
  PolygonMesh mesh = test::octahedron().mesh();
  const PolygonMesh before = mesh;
  ASSERT_TRUE(mesh.flip(0));
  EXPECT_FALSE(mesh.faces() == before.faces());
  mesh = before;
  EXPECT_EQ(mesh.faces(), before.faces());
}

TEST(PolygonMesh, EdgesAreNumberedByTheirFirstFace) {
  const PolygonMesh mesh = grid(2, 1).mesh();  // vertices 0 1 2 / 3 4 5, faces 0 1 4 3 and 1 2 5 4
  const MeshEdge first = mesh.edge(0);
  EXPECT_EQ(first.a, 0);
  EXPECT_EQ(first.b, 1);
  EXPECT_EQ(first.left, 0);
  EXPECT_EQ(first.right, -1);
  EXPECT_TRUE(first.border());
  const int inner = mesh.find_edge(4, 1);
  ASSERT_GE(inner, 0);
  EXPECT_EQ(inner, mesh.find_edge(1, 4));
  EXPECT_EQ(mesh.edge(inner).a, 1);
  EXPECT_EQ(mesh.edge(inner).b, 4);
  EXPECT_EQ(mesh.edge(inner).left, 0);
  EXPECT_EQ(mesh.edge(inner).right, 1);
  EXPECT_FALSE(mesh.edge(inner).border());
}

TEST(PolygonMesh, FindsNoEdgeWhereThereIsNone) {
  Shape shape = grid(2, 1);
  shape.positions.conservativeResize(7, 3);
  shape.positions.row(6) << 9, 9, 9;
  const PolygonMesh mesh = shape.mesh();
  EXPECT_EQ(mesh.find_edge(0, 4), -1);
  EXPECT_EQ(mesh.find_edge(0, 6), -1);
  EXPECT_EQ(mesh.find_edge(6, 0), -1);
  EXPECT_EQ(mesh.find_edge(0, 0), -1);
  EXPECT_EQ(mesh.find_edge(-1, 0), -1);
  EXPECT_EQ(mesh.find_edge(0, 7), -1);
}

// The order that faces_around() and edges_around() promise, for every vertex.
void expect_fan_order(const PolygonMesh& mesh) {
  const Polygons faces = mesh.faces();
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const auto around = mesh.faces_around(v);
    const auto edges = mesh.edges_around(v);
    if (mesh.is_isolated(v)) {
      EXPECT_TRUE(around.empty());
      EXPECT_TRUE(edges.empty());
      continue;
    }
    ASSERT_EQ(edges.size(), around.size() + (mesh.is_border_vertex(v) ? 1 : 0));
    for (size_t k = 0; k < around.size(); ++k) {
      // Counter-clockwise: the face leaves v along its first edge and comes back along its second.
      const auto corners = faces[around[k]];
      const auto at = std::find(corners.begin(), corners.end(), v) - corners.begin();
      const auto n = static_cast<std::ptrdiff_t>(corners.size());
      ASSERT_LT(at, n);
      EXPECT_EQ(edges[k], mesh.find_edge(v, corners[(at + 1) % n]));
      EXPECT_EQ(edges[(k + 1) % edges.size()], mesh.find_edge(v, corners[(at + n - 1) % n]));
    }
    if (mesh.is_border_vertex(v)) {
      EXPECT_TRUE(mesh.edge(edges.front()).border());
      EXPECT_TRUE(mesh.edge(edges.back()).border());
    }
  }
}

TEST(PolygonMesh, GoesRoundVerticesCounterClockwise) {
  for (const Shape& shape :
       {tetrahedron(), cube(), grid(3, 2), test::triangle_grid(3, 3), fan(7), fan(7, true)})
    expect_fan_order(shape.mesh());
  const PolygonMesh mesh = fan(4, true).mesh();
  EXPECT_EQ(mesh.faces_around(0), (std::vector{0, 1, 2}));
  EXPECT_TRUE(mesh.is_border_vertex(0));
}

TEST(PolygonMesh, KeepsIsolatedVertices) {
  Shape shape = tetrahedron();
  shape.positions.conservativeResize(5, 3);
  shape.positions.row(4) << 7, 7, 7;
  const PolygonMesh mesh = shape.mesh();
  EXPECT_EQ(mesh.vertex_count(), 5);
  EXPECT_TRUE(mesh.is_isolated(4));
  EXPECT_FALSE(mesh.is_border_vertex(4));
  expect_fan_order(mesh);
}

TEST(PolygonMesh, AcceptsFacesInAnyOrder) {
  // Every second face first: on the way, the vertices have several fans that only the rest joins.
  const Shape shape = fan(12);
  Polygons shuffled;
  for (int start : {0, 1})
    for (int f = start; f < shape.faces.size(); f += 2) shuffled.push_back(shape.faces[f]);
  const auto mesh = PolygonMesh::from_polygons(shape.positions, shuffled);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->faces(), shuffled);
  EXPECT_EQ(mesh->faces_around(0).size(), 12u);
}

TEST(PolygonMesh, RefusesWhatIsNoOrientedManifold) {
  const Shape shape = tetrahedron();
  const Points& p = shape.positions;
  EXPECT_EQ(refusal(p, {{0, 1}}), "face 0");
  EXPECT_EQ(refusal(p, {{0, 1, 2}, {0, 3, 0}}), "face 1");
  EXPECT_EQ(refusal(p, {{0, 1, 4}}), "face 0");
  EXPECT_EQ(refusal(p, {{0, 1, -1}}), "face 0");
  EXPECT_EQ(refusal(p, {{0, 1, 2}, {0, 1, 3}}), "edge (0, 1)");
  Points five(5, 3);
  five << p, 2, 2, 2;
  EXPECT_EQ(refusal(five, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}), "edge (0, 1)");
  EXPECT_EQ(refusal(five, {{0, 1, 2}, {0, 3, 4}}), "vertex 0");
}

TEST(PolygonMesh, RefusesTwoClosedFansAtAVertex) {
  // Two tetrahedra that share vertex 0 alone: no border shows it.
  Points positions(7, 3);
  positions << tetrahedron().positions, -1, 0, 0, 0, -1, 0, 0, 0, -1;
  Polygons faces = tetrahedron().faces;
  for (const auto& face : {std::array{0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {5, 0, 6}}) faces.push_back(face);
  EXPECT_EQ(refusal(positions, faces), "vertex 0");
}

TEST(PolygonMesh, RefusesCoordinatesThatAreNotFinite) {
  Shape shape = tetrahedron();
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    shape.positions(2, 1) = bad;
    EXPECT_EQ(refusal(shape.positions, shape.faces), "vertex 2");
  }
}

TEST(PolygonMesh, BuildsAHubOfManyFacesInReasonableTime) {
  const Shape shape = fan(200'000);
  const auto mesh = PolygonMesh::from_polygons(shape.positions, shape.faces);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->faces_around(0).size(), 200'000u);
  EXPECT_GE(mesh->find_edge(0, 77), 0);
}

}  // namespace
}  // namespace planewright
