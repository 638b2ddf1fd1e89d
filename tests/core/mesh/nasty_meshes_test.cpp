// The external meshes that are broken on purpose: a clear error, or a report of what was done.
#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

struct Broken {
  const char* file;
  const char* where;  // after the path
  const char* what;
};

TEST(NastyMeshes, GiveClearErrors) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const Broken& broken : {
           Broken{"test-nan.obj", ":12", "the coordinate \"nan\" is not a finite number"},
           Broken{"OutOfMemory.off", ":2", "promises 353535235358 vertices"},
           Broken{"malformed.obj", ":28", "vertex 0, but OBJ files count from 1"},
           Broken{"truncated_output.off", ":7760", "ends inside face 3878 (of 8823"},
       }) {
    SCOPED_TRACE(broken.file);
    const auto path = folder / "nasty" / broken.file;
    const auto mesh = load_mesh(path);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(mesh.error().where, path.string() + broken.where);
    EXPECT_NE(mesh.error().what.find(broken.what), std::string::npos) << mesh.error().text();
    EXPECT_FALSE(mesh.error().remedy.empty());
  }
}

struct Mended {
  const char* file;
  const char* health;
  int vertices, faces, components, border_loops, border_edges;
};

TEST(NastyMeshes, LoadWithAReport) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const Mended& mended : {
           Mended{"fan3.obj", "1 non-manifold edge (faces detached)", 9, 3, 3, 3, 9},
           Mended{"hourglass_ico.obj", "1 non-manifold vertex (split into 2 vertices)", 24, 40, 2, 0, 0},
           Mended{"moebius.obj", "1 one-sided component (cut open along 4 edges)", 285, 224, 1, 1, 120},
           Mended{"quad5.ply", "1 inconsistently oriented face (turned round)", 6, 6, 1, 1, 4},
           Mended{"QuadMesh.off", "1 index list that counts from 1 (read as counting from 1)", 1085, 976, 1,
                  3, 220},
           Mended{"catenoid3.off", "2933 duplicate vertices (kept)", 9900, 1650, 1650, 1650, 9900},
       }) {
    SCOPED_TRACE(mended.file);
    const auto mesh = load_mesh(folder / "nasty" / mended.file);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(mesh->health.summary(), mended.health);
    EXPECT_EQ(mesh->mesh.vertex_count(), mended.vertices);
    EXPECT_EQ(mesh->mesh.face_count(), mended.faces);
    EXPECT_EQ(mesh->health.components, mended.components);
    EXPECT_EQ(mesh->health.border_loops, mended.border_loops);
    EXPECT_EQ(mesh->health.border_edges, mended.border_edges);
  }
}

}  // namespace
}  // namespace planewright
