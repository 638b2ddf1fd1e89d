#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace planewright {
namespace {

using test::TemporaryFolder;

std::string text_of(MeshFormat format) {
  const test::Shape shape = test::cube();
  return format_mesh(format, shape.positions, shape.faces).value();
}

TEST(LoadMesh, KnowsFormatsByTheirEnding) {
  EXPECT_EQ(format_of("a/b.obj").value(), MeshFormat::Obj);
  EXPECT_EQ(format_of("b.OFF").value(), MeshFormat::Off);
  EXPECT_EQ(format_of("b.c.Ply").value(), MeshFormat::Ply);
  EXPECT_EQ(format_of("b.stl").value(), MeshFormat::Stl);
  for (const char* name : {"b", "b.3dm", ".obj", "obj"}) {
    const auto format = format_of(name);
    ASSERT_FALSE(format) << name;
    EXPECT_EQ(format.error().code, ErrorCode::Usage);
    EXPECT_NE(format.error().text().find(".ply"), std::string::npos);
  }
}

TEST(LoadMesh, ContentThatIsCertainGoesBeforeTheEnding) {
  const TemporaryFolder folder;
  for (MeshFormat format : {MeshFormat::Off, MeshFormat::Ply, MeshFormat::Stl})
    for (const char* name : {"a.obj", "a.off", "a.txt", "a"}) {
      const auto mesh = load_mesh(folder.write(name, text_of(format)));
      ASSERT_TRUE(mesh) << mesh.error().text();
      EXPECT_EQ(mesh->mesh.vertex_count(), 8);
    }
  EXPECT_TRUE(load_mesh(folder.write("a.obj", text_of(MeshFormat::Obj))));
  const auto unknown = load_mesh(folder.write("a.txt", text_of(MeshFormat::Obj)));
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
}

TEST(LoadMesh, RefusesWhatIsNoFile) {
  const TemporaryFolder folder;
  for (const auto& path : {folder / "missing.obj", folder.path(), std::filesystem::path("/dev/zero"),
                           std::filesystem::path("/dev/null")}) {
    const auto mesh = load_mesh(path);
    ASSERT_FALSE(mesh);
    EXPECT_EQ(mesh.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(mesh.error().where, path.string());
  }
}

TEST(LoadMesh, RefusesFilesWithoutFaces) {
  const TemporaryFolder folder;
  const auto points = load_mesh(folder.write("points.obj", "v 0 0 0\nv 1 0 0\n"));
  ASSERT_FALSE(points);
  EXPECT_EQ(points.error().code, ErrorCode::Refused);
  EXPECT_EQ(points.error().where, (folder / "points.obj").string());
  const auto degenerate = load_mesh(folder.write("lines.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n2 0 1\n"));
  ASSERT_FALSE(degenerate);
  EXPECT_EQ(degenerate.error().code, ErrorCode::Refused);
}

TEST(LoadMesh, NamesFileAndLine) {
  const TemporaryFolder folder;
  const auto path = folder.write("bad.obj", "v 0 0 0\nv 0 0 x\n");
  const auto mesh = load_mesh(path);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().where, path.string() + ":2");
}

TEST(LoadMesh, ReportsAnIndexBaseOfOne) {
  const TemporaryFolder folder;
  const auto mesh = load_mesh(folder.write("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 1 2 3\n"));
  ASSERT_TRUE(mesh) << mesh.error().text();
  EXPECT_TRUE(mesh->health.find(DefectKind::IndexBase));
  EXPECT_FALSE(mesh->health.healthy());
  EXPECT_EQ(mesh->mesh.faces(), (Polygons{{0, 1, 2}}));
}

TEST(LoadMesh, RefusesGarbageQuickly) {
  const TemporaryFolder folder;
  std::string garbage(10'000'000, '\0');
  unsigned state = 1;
  for (char& c : garbage) c = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
  std::string text = garbage;
  for (char& c : text)
    if (c == '\0') c = ' ';
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.txt"}) {
    EXPECT_FALSE(load_mesh(folder.write(name, garbage)));
    EXPECT_FALSE(load_mesh(folder.write(name, text)));
    EXPECT_FALSE(load_mesh(folder.write(name, "")));
  }
}

TEST(LoadMesh, TakesAFaceOfAMillionCorners) {
  const TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 1'000'000; ++i) text += "v " + std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
  text += 'f';
  for (int i = 1; i <= 1'000'000; ++i) text += ' ' + std::to_string(i);
  const auto mesh = load_mesh(folder.write("big.obj", text));
  ASSERT_TRUE(mesh) << mesh.error().text();
  EXPECT_EQ(mesh->mesh.edge_count(), 1'000'000);
}

}  // namespace
}  // namespace planewright
