#include "core/diagnose/ill_determined_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <numbers>

#include "core/complex/explicit_intersection.h"
#include "core/diagnose/ill_determined.h"
#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

constexpr double kDegree = std::numbers::pi / 180.0;

// Perpendicular planes, anchored at the faces' middles, half a diagonal away.
TEST(TiltMoves, OfACubeAreTheLeverArm) {
  const Scene scene(planarize_of(cube().mesh()));
  const Vector moves = tilt_moves(*scene.complex, scene.state);
  for (const double move : moves) EXPECT_NEAR(move, kDegree * std::sqrt(0.5), 1e-9);
}

// The points of really tilted planes never move farther, and one of the tilts comes near.
TEST(TiltMoves, BoundWhatATiltDoes) {
  const SharedComplex complex = dual_of(make_torus(8, 14));
  const State state = explicit_intersection(*complex).state;
  const Vector moves = tilt_moves(*complex, state);
  constexpr double kTilt = 1e-4;  // degrees
  for (int j = 0; j < complex->point_count(); ++j) {
    const auto planes = complex->planes_of_point[j];
    ASSERT_EQ(planes.size(), 3u);
    double farthest = 0.0;
    for (int tilted = 0; tilted < 3; ++tilted)
      for (int turn = 0; turn < 36; ++turn) {
        Matrix3d normals;
        Vector3d right;
        for (int k = 0; k < 3; ++k) {
          Vector3d n = state.n.row(planes[k]);
          if (k == tilted) {
            const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
            const double angle = 10.0 * kDegree * turn;
            n += kTilt * kDegree * (std::cos(angle) * u + std::sin(angle) * v);
            n.normalize();
          }
          normals.row(k) = n;
          right[k] = n.dot(complex->anchors.row(planes[k])) + state.h[planes[k]];
        }
        const Vector3d x = normals.fullPivLu().solve(right);
        farthest = std::max(farthest, (x - state.x.row(j).transpose()).norm());
      }
    const double per_degree = farthest / kTilt / complex->mean_edge;
    EXPECT_LE(per_degree, 1.01 * moves[j]);
    EXPECT_GE(per_degree, 0.3 * moves[j]);
  }
}

TEST(NotableTiltMove, IsFarAboveTheMedianWithinLimits) {
  EXPECT_DOUBLE_EQ(notable_tilt_move(Vector::Constant(5, 0.5)), 16.0);
  EXPECT_DOUBLE_EQ(notable_tilt_move(Vector::Constant(5, 1e-3)), 2.0);
  EXPECT_DOUBLE_EQ(notable_tilt_move(Vector::Constant(5, 1e3)), 100.0);
  EXPECT_DOUBLE_EQ(notable_tilt_move(Vector::Zero(5)), 100.0);
}

TEST(IllDeterminedPoints, AreThoseOfAFlatPlaceInABentDesign) {
  Scene scene(dual_of(icosahedron().mesh()));
  EXPECT_TRUE(find_ill_determined_points(scene.subject(), 0.0).empty());
  const auto planes = scene.complex->planes_of_point[7];
  for (const int i : planes) scene.state.n.row(i) = scene.state.n.row(planes[0]);
  const auto found = find_ill_determined_points(scene.subject(), 0.0);
  // The place itself, and the three points round it that have two of its planes.
  ASSERT_EQ(indices_of(found), (std::vector<int>{4, 7, 16, 17}));
  expect_well_formed(found[0]);
  EXPECT_EQ(found[0].mesh_edges.size(), 3u);
  EXPECT_EQ(found[0].threshold, 2.0);  // a sharp design: the least that is worth a mark
  EXPECT_GT(found[0].measure, 1e4);
  EXPECT_NEAR(found[0].severity, 0.6, 1e-3);
  EXPECT_TRUE(find_ill_determined_points(scene.subject(), 1e9).empty());
}

TEST(IllDeterminedPoints, LeaveOutTheOutline) {
  const Scene scene(dual_of(triangle_grid(3, 3).mesh()));
  for (const Finding& finding : find_ill_determined_points(scene.subject(), 0.0))
    EXPECT_EQ(scene.complex->point_origin[finding.element.index].kind, PointKind::Face);
}

}  // namespace
}  // namespace planewright
