#include "core/advise/patch.h"

#include <gtest/gtest.h>

#include "core/mesh/sample_shapes.h"

namespace planewright {
namespace {

TEST(Patch, HasTheFansOfAllVerticesWithinItsRings) {
  const PolygonMesh mesh = make_torus(20, 20);
  const Patch patch = cut_patch(mesh, {105, 106}, 2).value();
  int inside = 0;
  for (int v = 0; v < patch.mesh.vertex_count(); ++v) {
    const int whole = patch.from_whole.vertices.to_old[static_cast<size_t>(v)];
    EXPECT_EQ(patch.mesh.positions().row(v), mesh.positions().row(whole));
    if (patch.rings[static_cast<size_t>(v)] > 3) continue;
    ++inside;
    EXPECT_EQ(patch.mesh.faces_around(v).size(), mesh.faces_around(whole).size())
        << "ring " << patch.rings[v];
  }
  EXPECT_GT(inside, 30);
  EXPECT_LT(patch.mesh.vertex_count(), mesh.vertex_count() / 2);
}

TEST(Patch, MapsEveryElementToItsOwn) {
  const PolygonMesh mesh = make_torus(12, 12);
  const Patch patch = cut_patch(mesh, {30}, 1).value();
  const ElementMap& map = patch.from_whole;
  for (int e = 0; e < patch.mesh.edge_count(); ++e) {
    const MeshEdge here = patch.mesh.edge(e), there = mesh.edge(map.edges.to_old[static_cast<size_t>(e)]);
    EXPECT_EQ(std::minmax(map.vertices.to_old[here.a], map.vertices.to_old[here.b]),
              std::minmax(there.a, there.b));
  }
  for (int f = 0; f < patch.mesh.face_count(); ++f) {
    std::vector<int> corners = patch.mesh.corners(f);
    for (int& v : corners) v = map.vertices.to_old[static_cast<size_t>(v)];
    EXPECT_EQ(corners, mesh.corners(map.faces.to_old[static_cast<size_t>(f)]));
  }
}

TEST(Patch, OfASmallMeshIsTheWholeMesh) {
  const PolygonMesh mesh = make_torus(4, 4);
  const Patch patch = cut_patch(mesh, {0}, 3).value();
  EXPECT_EQ(patch.mesh.vertex_count(), mesh.vertex_count());
  EXPECT_EQ(patch.mesh.face_count(), mesh.face_count());
}

}  // namespace
}  // namespace planewright
