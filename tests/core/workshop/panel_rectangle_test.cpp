#include "core/workshop/panel_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace planewright {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> box(double width, double height, double angle = 0.0) {
  const Vector2d u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
  return {Vector2d(0, 0), width * u, width * u + height * v, height * v};
}

TEST(PanelRectangle, TheHullLeavesOutWhatIsInsideOrOnASide) {
  const auto hull = convex_hull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 0}});
  ASSERT_EQ(hull.size(), 4u);
  double area = 0.0;
  for (size_t k = 0; k < 4; ++k)
    area += hull[k].x() * hull[(k + 1) % 4].y() - hull[k].y() * hull[(k + 1) % 4].x();
  EXPECT_EQ(area, 8.0);  // twice 4, anticlockwise
}

TEST(PanelRectangle, CalipersFindWhatTryingAllAnglesFinds) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 50; ++run) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 3 + run % 20; ++i) points.emplace_back(5.0 * normal(random), normal(random));
    const SmallestRectangle found = smallest_rectangle(points);
    double least = 1e300;
    for (int step = 0; step < 20000; ++step) {
      const double angle = step * 0.5 * std::numbers::pi / 20000;
      const Vector2d u(std::cos(angle), std::sin(angle)), v(-u.y(), u.x());
      Vector2d low(1e300, 1e300), high = -low;
      for (const Vector2d& p : points) {
        low = low.cwiseMin(Vector2d(u.dot(p), v.dot(p)));
        high = high.cwiseMax(Vector2d(u.dot(p), v.dot(p)));
      }
      least = std::min(least, (high - low).prod());
    }
    EXPECT_LE(found.width * found.height, least * (1.0 + 1e-9) + 1e-9);
    EXPECT_GE(found.width * found.height, least * (1.0 - 2e-2));
    EXPECT_GE(found.width, found.height);
    // `along` is the direction of the width.
    double low = 1e300, high = -1e300;
    for (const Vector2d& p : points) {
      low = std::min(low, found.along.dot(p));
      high = std::max(high, found.along.dot(p));
    }
    EXPECT_NEAR(high - low, found.width, 1e-9);
  }
}

TEST(PanelRectangle, WithoutAreaThereIsALengthAlone) {
  const SmallestRectangle line = smallest_rectangle({{0, 0}, {3, 4}, {1.5, 2}});
  EXPECT_NEAR(line.width, 5.0, 1e-14);
  EXPECT_EQ(line.height, 0.0);
}

TEST(PanelRectangle, APanelFitsHoweverItLies) {
  for (const double angle : {0.0, 0.3, 1.0, 2.0}) {
    EXPECT_TRUE(fits_rectangle(box(3.0, 2.0, angle), 3.0, 2.0, 1e-9)) << angle;
    EXPECT_TRUE(fits_rectangle(box(3.0, 2.0, angle), 2.0, 3.0, 1e-9)) << angle;
    EXPECT_FALSE(fits_rectangle(box(3.0, 2.0, angle), 2.999, 2.0, 1e-9)) << angle;
    EXPECT_FALSE(fits_rectangle(box(3.0, 2.0, angle), 3.0, 1.999, 1e-9)) << angle;
  }
}

TEST(PanelRectangle, ALongPanelFitsAslant) {
  // Least across where 10.5 cos a + 0.1 sin a = 10: a = 18.2 degrees, 10.5 sin a + 0.1 cos a = 3.37.
  EXPECT_TRUE(fits_rectangle(box(10.5, 0.1), 10.0, 3.4, 0.0));
  EXPECT_FALSE(fits_rectangle(box(10.5, 0.1), 10.0, 3.3, 0.0));
}

}  // namespace
}  // namespace planewright
