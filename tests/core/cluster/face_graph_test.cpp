#include "core/cluster/face_graph.h"

#include <gtest/gtest.h>

#include "support/clusters.h"

namespace planewright {
namespace {

using namespace test;

TEST(FaceGraph, AgreesWithTheMeshOnNeighbours) {
  for (const auto& mesh :
       {cube().mesh(), triangle_grid(4, 3).mesh(), make_torus(6, 9), fan(5, true).mesh()}) {
    const FaceGraph graph = graph_of(mesh);
    EXPECT_EQ(graph.edge_count, mesh.edge_count());
    int borders = 0;
    for (int c = 0; c < static_cast<int>(graph.across.size()); ++c) {
      const MeshEdge edge = mesh.edge(mesh.find_edge(graph.tail(c), graph.head(c)));
      const int other = edge.left == graph.face_of_corner[c] ? edge.right : edge.left;
      EXPECT_EQ(graph.beside[c], other);
      if (graph.across[c] < 0) {
        ++borders;
        continue;
      }
      EXPECT_EQ(graph.across[graph.across[c]], c);
      EXPECT_EQ(graph.tail(graph.across[c]), graph.head(c));
    }
    EXPECT_EQ(borders > 0, !graph.closed[0]);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_EQ(graph.on_border[v] != 0, mesh.is_border_vertex(v));
      std::vector<int> faces;
      const int start = graph.corner_of_vertex[v];
      for (int c = start; c >= 0 && (c != start || faces.empty()); c = graph.turn_left(c)) {
        EXPECT_EQ(graph.tail(c), v);
        faces.push_back(graph.face_of_corner[c]);
      }
      auto expected = mesh.faces_around(v);
      if (!mesh.is_border_vertex(v))  // may begin anywhere
        std::rotate(expected.begin(), std::find(expected.begin(), expected.end(), faces[0]), expected.end());
      EXPECT_EQ(faces, expected);
    }
  }
}

TEST(FaceGraph, MeasuresFacesInItsOwnUnits) {
  Shape shape = grid(3, 2);
  shape.positions *= 7.0;
  shape.positions.rowwise() += Eigen::RowVector3d(1e5, -2e5, 3e5);
  const FaceGraph graph = graph_of(shape.mesh());
  EXPECT_NEAR(graph.length, 7.0 * std::sqrt(6.0), 1e-9);
  const double side = 1.0 / std::sqrt(6.0);
  for (int f = 0; f < 6; ++f) {
    EXPECT_NEAR(graph.shapes[f].area, 1.0 / 6.0, 1e-12);
    EXPECT_NEAR((graph.shapes[f].normal - Vector3d::UnitZ()).norm(), 0.0, 1e-12);
    const Vector3d corner = shape.positions.row(shape.faces[f][0]);
    EXPECT_NEAR((graph.to_model(graph.shapes[f].centre) - corner - Vector3d(3.5, 3.5, 0)).norm(), 0.0, 1e-8);
    // A square of side s: s^4 / 12 along both sides.
    const double expected = std::pow(side, 4) / 12.0;
    EXPECT_NEAR(graph.moments[f][0], expected, 1e-12);
    EXPECT_NEAR(graph.moments[f][3], expected, 1e-12);
    for (const int k : {1, 2, 4, 5}) EXPECT_NEAR(graph.moments[f][k], 0.0, 1e-12);
  }
}

TEST(FaceGraph, CountsPartsAndTheEulerCharacteristic) {
  EXPECT_EQ(graph_of(sphere(3).mesh()).euler_characteristic(), 2);
  EXPECT_EQ(graph_of(make_torus(5, 7)).euler_characteristic(), 0);
  EXPECT_EQ(graph_of(grid(3, 3).mesh()).euler_characteristic(), 1);
  const FaceGraph two = graph_of(both(sphere(2), grid(2, 2), {5, 0, 0}).mesh());
  EXPECT_EQ(two.component_count(), 2);
  EXPECT_TRUE(two.closed[0]);
  EXPECT_FALSE(two.closed[1]);
  EXPECT_EQ(two.euler_characteristic(), 3);
}

TEST(FaceGraph, RefusesAMeshWithoutFacesOrArea) {
  const auto none = FaceGraph::create(PolygonMesh());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::Refused);
  const auto flat = FaceGraph::create(
      PolygonMesh::from_polygons(make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), {{0, 1, 2}}).value());
  ASSERT_FALSE(flat);
  EXPECT_NE(flat.error().text().find("area"), std::string::npos);
}

}  // namespace
}  // namespace planewright
