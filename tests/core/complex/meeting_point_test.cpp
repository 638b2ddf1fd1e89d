#include "core/complex/meeting_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace planewright {
namespace {

TEST(MeetingPoint, IsWherePlanesMeetIfThatIsNear) {
  const std::vector<WantedPlane> planes{{{1, 0, 0}, 0.2}, {{0, 1, 0}, -0.1}, {{0, 0.6, 0.8}, 0.3}};
  const Vector3d meet(0.2, -0.1, (0.3 + 0.06) / 0.8);
  EXPECT_LT((meeting_point(planes, {0, 0, 0}, 1.0) - meet).norm(), 5e-3);
  const Vector3d held = meeting_point(planes, {0, 0, 0}, 0.1);
  EXPECT_LE(held.norm(), 0.1);
  EXPECT_GT(held.norm(), 0.05);
  EXPECT_GT(held.dot(meet), 0.0);
}

TEST(MeetingPoint, OfOnePlaneOrParallelOnesIsTheNearestPoint) {
  const Vector3d from(3, 4, 5), up(0, 0, 1);
  EXPECT_LT((meeting_point(std::vector<WantedPlane>{{up, 5.5}}, from, 1.0) - Vector3d(3, 4, 5.5)).norm(),
            1e-3);
  EXPECT_LT((meeting_point(std::vector<WantedPlane>{{up, 5.4}, {up, 5.6}, {up, 5.5}}, from, 1.0) -
             Vector3d(3, 4, 5.5))
                .norm(),
            1e-3);
}

// Planes that are nearly parallel meet 100 away; the point comes nearer to them, and stays within reach.
TEST(MeetingPoint, DoesNotFollowNearlyParallelPlanes) {
  const double tilt = 1e-3;
  const std::vector<WantedPlane> planes{{Vector3d(tilt, 0, 1).normalized(), 0.1},
                                        {Vector3d(-tilt, 0, 1).normalized(), -0.1},
                                        {Vector3d(0, tilt, 1).normalized(), 0.0}};
  const Vector3d point = meeting_point(planes, {0, 0, 0}, 0.3);
  EXPECT_LE(point.norm(), 0.3);
  const auto off = [&](const Vector3d& x) {
    double sum = 0.0;
    for (const WantedPlane& plane : planes) sum += std::pow(plane.normal.dot(x) - plane.height, 2);
    return sum;
  };
  EXPECT_LE(off(point), off({0, 0, 0}));
}

TEST(MeetingPoint, WithoutPlanesOrReachIsWhereItCameFrom) {
  EXPECT_EQ(meeting_point({}, {1, 2, 3}, 1.0), Vector3d(1, 2, 3));
  EXPECT_LT(
      (meeting_point(std::vector<WantedPlane>{{{1, 0, 0}, 7.0}}, {1, 2, 3}, 0.0) - Vector3d(1, 2, 3)).norm(),
      1e-5);
}

}  // namespace
}  // namespace planewright
