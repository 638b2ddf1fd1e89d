// The external meshes, with the counts that their list (MESHES.md) gives.
#include <gtest/gtest.h>

#include <map>

#include "core/mesh/mesh_io.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

struct Expected {
  const char* file;
  int vertices, faces;
  std::map<int, int> valences;  // corners: faces
  int border_loops, border_edges, components;
  const char* health;
};

const Expected kMeshes[] = {
    {"quad/fertility_quad.off", 3351, 3357, {{4, 3357}}, 0, 0, 1, "healthy"},
    {"quad/bunny_quad.obj", 2073, 2071, {{4, 2071}}, 0, 0, 1, "healthy"},
    {"quad/botijo_miq_quad.obj", 1048, 1056, {{4, 1056}}, 0, 0, 1, "healthy"},
    {"quad/dragon_quad.obj", 23159, 23157, {{4, 23157}}, 0, 0, 1, "healthy"},
    {"quad/inspired_mesh_quads_Conjugate.off", 1749, 1633, {{4, 1633}}, 1, 230, 1, "healthy"},
    {"quad/tubemesh.off", 200, 171, {{4, 171}}, 1, 56, 1, "healthy"},
    {"quad/hypar.obj", 81, 64, {{4, 64}}, 1, 32, 1, "healthy"},
    {"quad/six.off", 720, 656, {{4, 656}}, 2, 128, 1, "healthy"},
    {"tri/train-station.off", 1753, 3330, {{3, 3330}}, 2, 176, 1, "healthy"},
    {"tri/aqua-center.off", 5000, 9669, {{3, 9669}}, 3, 333, 1, "healthy"},
    {"tri/fertility.off", 4494, 9000, {{3, 9000}}, 0, 0, 1, "healthy"},
    {"tri/feline.obj", 4998, 10000, {{3, 10000}}, 0, 0, 1, "healthy"},
    {"tri/bunny1k.obj", 1047, 2090, {{3, 2090}}, 0, 0, 1, "healthy"},
    {"tri/torus.off", 288, 576, {{3, 576}}, 0, 0, 1, "healthy"},
    {"tri/two_spheres.obj", 1060, 2112, {{3, 2112}}, 0, 0, 2, "healthy"},
    {"poly/dome1_tri_pattern_10.off",
     17916,
     8833,
     {{4, 4416}, {6, 2986}, {10, 9}, {12, 1419}, {14, 3}},
     1,
     756,
     1,
     "healthy"},
    {"poly/enneper2.off", 1920, 900, {{6, 900}}, 1, 238, 1, "healthy"},
    {"poly/rhombitruncated_cubeoctahedron_fixed.off",
     52,
     26,
     {{4, 12}, {6, 8}, {8, 6}},
     0,
     0,
     1,
     "4 isolated vertices (kept)"},
    {"poly/suzanne.obj", 507, 500, {{3, 32}, {4, 468}}, 4, 42, 3, "2 duplicate vertices (kept)"},
};

TEST(RealMeshes, LoadWithTheKnownCounts) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const Expected& expected : kMeshes) {
    SCOPED_TRACE(expected.file);
    const auto mesh = load_mesh(folder / expected.file);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(mesh->mesh.vertex_count(), expected.vertices);
    EXPECT_EQ(mesh->mesh.face_count(), expected.faces);
    std::map<int, int> valences;
    const Polygons faces = mesh->mesh.faces();
    for (int f = 0; f < faces.size(); ++f) ++valences[faces.valence(f)];
    EXPECT_EQ(valences, expected.valences);
    EXPECT_EQ(mesh->health.vertices, expected.vertices);
    EXPECT_EQ(mesh->health.faces, expected.faces);
    EXPECT_EQ(mesh->health.border_loops, expected.border_loops);
    EXPECT_EQ(mesh->health.border_edges, expected.border_edges);
    EXPECT_EQ(mesh->health.components, expected.components);
    EXPECT_EQ(mesh->health.summary(), expected.health);
    EXPECT_FALSE(mesh->health.repaired);
  }
}

TEST(RealMeshes, SurviveEveryFormat) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const Expected& expected : kMeshes) {
    SCOPED_TRACE(expected.file);
    const auto mesh = load_mesh(folder / expected.file);
    ASSERT_TRUE(mesh) << mesh.error().text();
    for (MeshFormat format : {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply}) {
      const auto text = format_mesh(format, mesh->mesh.positions(), mesh->mesh.faces());
      ASSERT_TRUE(text);
      const auto soup = parse_mesh(*text, format, "again");
      ASSERT_TRUE(soup) << soup.error().text();
      EXPECT_EQ(soup->positions, mesh->mesh.positions());
      EXPECT_EQ(soup->faces, mesh->mesh.faces());
    }
  }
}

}  // namespace
}  // namespace planewright
