#include "core/design/reference_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "core/mesh/health_report.h"
#include "support/temporary_folder.h"

namespace planewright {
namespace {

class ReferenceFile : public testing::Test {
 protected:
  void refused(const std::string& name, const Vector3d& low, const Vector3d& high, ErrorCode code,
               const std::string& says) const {
    const auto loaded = load_reference(folder_ / name, low, high);
    ASSERT_FALSE(loaded) << name;
    EXPECT_EQ(loaded.error().code, code);
    EXPECT_NE(loaded.error().where.find((folder_ / name).string()), std::string::npos)
        << loaded.error().text();
    EXPECT_NE(loaded.error().text().find(says), std::string::npos) << loaded.error().text();
  }
  test::TemporaryFolder folder_;
};

TEST_F(ReferenceFile, IsReadForAMeshItCanBeMeantFor) {
  folder_.write("square.obj", "v 0 0 2\nv 4 0 2\nv 4 4 2\nv 0 4 2\nf 1 2 3 4\n");
  const auto loaded = load_reference(folder_ / "square.obj", Vector3d(0, 0, 0), Vector3d(4, 4, 1));
  ASSERT_TRUE(loaded) << loaded.error().text();
  EXPECT_NEAR((*loaded)->closest({1, 1, 3.5}, Vector3d::Zero()).distance, 1.5, 1e-12);
  EXPECT_EQ((*loaded)->high(), Vector3d(4, 4, 2));
}

TEST_F(ReferenceFile, IsRefusedWithItsName) {
  folder_.write("square.obj", "v 0 0 2\nv 4 0 2\nv 4 4 2\nv 0 4 2\nf 1 2 3 4\n");
  folder_.write("bad.obj", "v 0 0 x\n");
  folder_.write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const Vector3d low(0, 0, 0), high(4, 4, 1), far(1e5, 0, 0);
  refused("none.obj", low, high, ErrorCode::Unreadable, "");
  refused("bad.obj", low, high, ErrorCode::Unreadable, "bad.obj:1");
  refused("line.obj", low, high, ErrorCode::Refused, "");
  refused("square.obj", low + far, high + far, ErrorCode::Refused, "away from the mesh");
  refused("square.obj", low, 1e4 * high, ErrorCode::Refused, "100 times");
}

// For a mesh it is its box that counts.
TEST_F(ReferenceFile, TheBoxIsThatOfTheMesh) {
  folder_.write("square.obj", "v 0 0 2\nv 4 0 2\nv 4 4 2\nv 0 4 2\nf 1 2 3 4\n");
  const auto mesh = [](double x) {
    Points points(3, 3);
    points << x, 0, 0, x + 4, 0, 0, x, 4, 0;
    return check_and_repair(points, Polygons{{0, 1, 2}}).value().mesh;
  };
  EXPECT_TRUE(load_reference(folder_ / "square.obj", mesh(0)));
  EXPECT_FALSE(load_reference(folder_ / "square.obj", mesh(1e5)));
}

}  // namespace
}  // namespace planewright
