#include "core/certify/exact_signs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/certify/solid_shape.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

Contour contour(std::initializer_list<std::array<double, 2>> points) {
  Contour c(static_cast<Eigen::Index>(points.size()), 2);
  Eigen::Index row = 0;
  for (const auto& p : points) c.row(row++) << p[0], p[1];
  return c;
}

TEST(ExactSigns, OrientationSeesTheLastBit) {
  // On the line y = x, and one bit off it: in doubles the determinant is 0 both times.
  const Vector2d a(12.0, 12.0), b(24.0, 24.0);
  const double c = 0.5;
  EXPECT_EQ(orientation(a, b, Vector2d(c, c)), 0);
  EXPECT_EQ(orientation(a, b, Vector2d(c, std::nextafter(c, 1.0))), 1);
  EXPECT_EQ(orientation(a, b, Vector2d(c, std::nextafter(c, 0.0))), -1);
}

TEST(ExactSigns, SimpleContours) {
  EXPECT_TRUE(is_simple(contour({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}})));
  EXPECT_TRUE(is_simple(contour({{0, 0}, {1, 0}, {2, 0}, {2, 2}})));           // straight on
  EXPECT_FALSE(is_simple(contour({{0, 0}, {2, 2}, {2, 0}, {0, 2}})));          // bow tie
  EXPECT_FALSE(is_simple(contour({{0, 0}, {2, 0}, {1, 0}, {1, 2}})));          // runs back
  EXPECT_FALSE(is_simple(contour({{0, 0}, {0, 0}, {2, 0}, {1, 2}})));          // a point twice
  EXPECT_FALSE(is_simple(contour({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}})));  // touches itself
  EXPECT_FALSE(is_simple(contour({{0, 0}, {1, 0}})));
}

TEST(ExactSigns, AreasOfNeedles) {
  const double up = std::nextafter(1.0, 2.0);
  EXPECT_EQ(area_sign(contour({{0, 0}, {1, 1}, {2, 2}})), 0);
  EXPECT_EQ(area_sign(contour({{0, 0}, {1, 1}, {1, up}})), 1);
  EXPECT_EQ(area_sign(contour({{1, up}, {1, 1}, {0, 0}})), -1);
}

TEST(ExactSigns, CoversInsideAndBorderAlone) {
  const Contour c = contour({{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}});
  EXPECT_TRUE(covers(c, {1.0, 1.0}));
  EXPECT_TRUE(covers(c, {2.0, 1.0}));
  EXPECT_TRUE(covers(c, {0.0, 0.0}));
  EXPECT_FALSE(covers(c, {2.0, 1.5}));
  EXPECT_FALSE(covers(c, {-1.0, 0.0}));
}

TEST(ExactSigns, VolumesOfFlatTetrahedra) {
  const std::vector<std::array<int, 3>> faces{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  Points p(4, 3);
  p << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.3, 0.3, 1;
  EXPECT_EQ(volume_sign(p, faces), 1);
  // All in the plane x + y + z = 3 but for one bit.
  p << 1, 1, 1, 2, 1, 0, 1, 2, 0, 0.5, 0.5, 2.0;
  EXPECT_EQ(volume_sign(p, faces), 0);
  p(3, 2) = std::nextafter(2.0, 3.0);
  EXPECT_NE(volume_sign(p, faces), 0);
}

TEST(SolidShape, ClosedMeansEveryEdgeOnceEachWay) {
  const Polygons closed{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Polygons open{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}};
  const Polygons turned{{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::vector<int> same{0, 1, 2, 3};
  EXPECT_TRUE(is_closed(closed, all_of(closed), same));
  EXPECT_FALSE(is_closed(open, all_of(open), same));
  EXPECT_FALSE(is_closed(turned, all_of(turned), same));
}

}  // namespace
}  // namespace planewright
