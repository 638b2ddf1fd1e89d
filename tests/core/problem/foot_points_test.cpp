#include "core/problem/foot_points.h"

#include <gtest/gtest.h>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

TEST(FootPoints, AreInTheComplexsFrame) {
  for (const double away : {0.0, 1e7}) {
    Shape shape = cube();
    shape.positions.rowwise() += Eigen::RowVector3d(away, -away, 2 * away);
    const SharedComplex complex = dual_of(shape.mesh(), {0.25});
    const auto reference = ReferenceSurface::create(shape.positions, shape.faces, "cube").value();
    Points x = complex->preferred;
    for (const ReferenceSurface* surface : {static_cast<const ReferenceSurface*>(nullptr), reference.get()}) {
      const FootPoints feet = foot_points(*complex, x, surface).value();
      ASSERT_EQ(feet.foot.rows(), 6);
      for (int j = 0; j < 6; ++j) {
        const Vector3d normal = complex->input.face_normals.row(j);
        EXPECT_NEAR((feet.normal.row(j).transpose() - normal).norm(), 0.0, 1e-12);
        EXPECT_NEAR((x.row(j) - feet.foot.row(j)).dot(normal), 0.25, 1e-14);
        EXPECT_NEAR((feet.foot.row(j) + 0.25 * normal.transpose() - x.row(j)).norm(), 0.0, 1e-14);
      }
    }
  }
}

// Signed distances grow along the normals, outside and inside.
TEST(FootPoints, NormalsPointOutOnBothSides) {
  const SharedComplex complex = planarize_of(cube().mesh());
  for (const double scale : {0.8, 1.2}) {
    const Points x = scale * complex->preferred;
    const FootPoints feet = foot_points(*complex, x, nullptr).value();
    for (int j = 0; j < 8; ++j) {
      EXPECT_GT(feet.normal.row(j).dot(complex->preferred.row(j)), 0.4);
      const double distance = feet.normal.row(j).dot(x.row(j) - feet.foot.row(j));
      EXPECT_NEAR(distance, scale > 1 ? 0.1 * std::sqrt(3.0) : -0.1, 1e-14);
    }
  }
}

TEST(FootPoints, BeyondABorderKeepTheSurfacesNormal) {
  const SharedComplex complex = planarize_of(grid(2, 2).mesh());
  const Points x = 1.5 * complex->preferred;
  const FootPoints feet = foot_points(*complex, x, nullptr).value();
  for (int j = 0; j < 9; ++j) {
    EXPECT_NEAR((feet.foot.row(j) - complex->preferred.row(j)).norm(), 0.0, 1e-14);
    EXPECT_NEAR((feet.normal.row(j) - Eigen::RowVector3d(0, 0, 1)).norm(), 0.0, 1e-14);
  }
}

TEST(FootPoints, RefuseWhatHasNone) {
  const SharedComplex complex = planarize_of(cube().mesh());
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points x = complex->preferred;
    x(3, 1) = bad;
    const auto feet = foot_points(*complex, x, nullptr);
    ASSERT_FALSE(feet);
    EXPECT_EQ(feet.error().code, ErrorCode::Refused);
    EXPECT_NE(feet.error().text().find("point 3"), std::string::npos);
  }
  TangentComplex flat = *complex;
  flat.input.vertices.setZero();
  EXPECT_FALSE(foot_points(flat, flat.preferred, nullptr));
}

}  // namespace
}  // namespace planewright
