#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <clocale>
#include <limits>

#include "core/base/atomic_file.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "support/shapes.h"
#include "support/temporary_folder.h"

namespace planewright {
namespace {

constexpr MeshFormat kFormats[] = {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply, MeshFormat::Stl};

// Coordinates that need all their digits, and the extremes.
Points awkward_points(int n) {
  Points points(n, 3);
  unsigned long long state = 42;
  for (int i = 0; i < n; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      state = state * 6364136223846793005ull + 1442695040888963407ull;
      points(i, axis) =
          (static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5) * std::pow(10.0, i % 19 - 9);
    }
  points.row(0) << std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min(), -0.0;
  points.row(1) << 1.0 / 3.0, 1e-300, -std::numeric_limits<double>::min();
  return points;
}

TEST(WriteMesh, RoundTripIsExact) {
  const Points positions = awkward_points(200);
  Polygons faces;
  for (int i = 0; i + 5 < 200; i += 3) faces.push_back(std::array{i, i + 1, i + 3, i + 5, i + 2});
  for (MeshFormat format : {MeshFormat::Obj, MeshFormat::Off, MeshFormat::Ply}) {
    const auto text = format_mesh(format, positions, faces);
    ASSERT_TRUE(text);
    const auto soup = parse_mesh(*text, format, "again");
    ASSERT_TRUE(soup) << soup.error().text();
    ASSERT_EQ(soup->positions.rows(), positions.rows());
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(soup->positions(i, axis), positions(i, axis));
        EXPECT_EQ(std::signbit(soup->positions(i, axis)), std::signbit(positions(i, axis)));
      }
    EXPECT_EQ(soup->faces, faces);
  }
}

TEST(WriteMesh, StlKeepsCornersExactly) {
  const PolygonMesh mesh = make_sample("twisted-roof", 100).value();
  const Polygons quads = mesh.faces();
  const auto text = format_mesh(MeshFormat::Stl, mesh.positions(), quads);
  ASSERT_TRUE(text);
  const auto soup = parse_mesh(*text, MeshFormat::Stl, "again");
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->faces.size(), 2 * quads.size());
  EXPECT_EQ(soup->positions.rows(), mesh.positions().rows());
  for (Eigen::Index i = 0; i < soup->positions.rows(); ++i) {
    bool found = false;
    for (Eigen::Index j = 0; j < mesh.positions().rows() && !found; ++j)
      found = soup->positions.row(i) == mesh.positions().row(j);
    EXPECT_TRUE(found);
  }
}

TEST(WriteMesh, PlyTakesFacesOfManyCorners) {
  const test::Shape shape = test::fan(300);
  std::vector<int> rim;
  for (int k = 1; k <= 300; ++k) rim.push_back(k);
  Polygons faces;
  faces.push_back(rim);
  const auto soup =
      parse_mesh(format_mesh(MeshFormat::Ply, shape.positions, faces).value(), MeshFormat::Ply, "again");
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->faces, faces);
}

TEST(WriteMesh, DoesNotDependOnTheLocale) {
  const test::Shape shape = test::fan(5);
  const auto before = format_mesh(MeshFormat::Obj, shape.positions, shape.faces).value();
  // Whichever of them is installed; none may make a difference.
  const char* changed = nullptr;
  for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"})
    if (!changed) changed = std::setlocale(LC_ALL, locale);
  const auto after = format_mesh(MeshFormat::Obj, shape.positions, shape.faces).value();
  const auto soup = parse_mesh(after, MeshFormat::Obj, "again");
  std::setlocale(LC_ALL, "C");
  EXPECT_EQ(before, after);
  ASSERT_TRUE(soup);
  EXPECT_EQ(soup->positions, shape.positions);
}

TEST(WriteMesh, SavesAndLoadsEveryFormat) {
  const test::TemporaryFolder folder;
  const PolygonMesh mesh = make_sample("dome", 100).value();
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.STL"}) {
    const auto saved = save_mesh(folder / name, mesh.positions(), mesh.faces());
    ASSERT_TRUE(saved) << saved.error().text();
    const auto loaded = load_mesh(folder / name);
    ASSERT_TRUE(loaded) << loaded.error().text();
    EXPECT_EQ(loaded->mesh.vertex_count(), mesh.vertex_count());
    EXPECT_EQ(loaded->mesh.face_count(), mesh.face_count());
    EXPECT_TRUE(loaded->health.healthy()) << loaded->health.summary();
  }
}

TEST(WriteMesh, RefusesWhatAFileCannotHold) {
  test::Shape shape = test::tetrahedron();
  for (MeshFormat format : kFormats) {
    EXPECT_EQ(format_mesh(format, shape.positions, {{0, 1, 9}}).error().where, "face 0");
    EXPECT_EQ(format_mesh(format, shape.positions, {{0, 1, 2}, {0, 1}}).error().where, "face 1");
  }
  shape.positions(1, 1) = std::numeric_limits<double>::quiet_NaN();
  for (MeshFormat format : kFormats)
    EXPECT_EQ(format_mesh(format, shape.positions, shape.faces).error().where, "vertex 1");
}

TEST(WriteMesh, FailureLeavesTheOldFile) {
  const test::TemporaryFolder folder;
  test::Shape shape = test::tetrahedron();
  const auto path = folder.write("a.obj", "what was there before");
  shape.positions(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(save_mesh(path, shape.positions, shape.faces));
  EXPECT_EQ(read_file(path).value(), "what was there before");

  shape = test::tetrahedron();
  const auto missing = save_mesh(folder / "no" / "a.obj", shape.positions, shape.faces);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::Unwritable);
  EXPECT_NE(missing.error().text().find("a.obj"), std::string::npos);
  const auto unknown = save_mesh(folder / "a.xyz", shape.positions, shape.faces);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
  EXPECT_NE(unknown.error().text().find(".obj"), std::string::npos);
  std::filesystem::create_directory(folder / "b.obj");
  EXPECT_FALSE(save_mesh(folder / "b.obj", shape.positions, shape.faces));

  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 2);  // no temporary file is left
}

}  // namespace
}  // namespace planewright
