#include "core/base/geometry.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "support/shapes.h"

namespace planewright {
namespace {

using test::make_points;

TEST(Polygons, HoldListsInOneBuffer) {
  Polygons lists{{4, 5, 6}, {}, {7}};
  ASSERT_EQ(lists.size(), 3);
  EXPECT_FALSE(lists.empty());
  EXPECT_EQ(lists.valence(0), 3);
  EXPECT_EQ(lists.valence(1), 0);
  EXPECT_EQ(lists[2][0], 7);
  EXPECT_EQ(lists.indices(), (std::vector<int>{4, 5, 6, 7}));
  EXPECT_EQ(lists.offsets(), (std::vector<int>{0, 3, 3, 4}));
  lists[0][1] = 50;
  EXPECT_EQ(lists, (Polygons{{4, 50, 6}, {}, {7}}));
  EXPECT_NE(lists, (Polygons{{4, 50}, {6}, {7}}));
}

TEST(Polygons, StartEmpty) {
  const Polygons none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.size(), 0);
}

TEST(NewellVector, IsTwiceTheAreaAlongTheNormal) {
  const Points points = make_points({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}});
  EXPECT_EQ(newell_vector(points, std::vector{0, 1, 2, 3}), Vector3d(0, 0, 12));
  EXPECT_EQ(newell_vector(points, std::vector{3, 2, 1, 0}), Vector3d(0, 0, -12));
}

TEST(NewellVector, HandlesConcavePolygonsFromAnyCorner) {
  // An L of area 3, whose reflex corner is where a plain fan would go wrong.
  const Points points = make_points({{0, 0, 1}, {2, 0, 1}, {2, 1, 1}, {1, 1, 1}, {1, 2, 1}, {0, 2, 1}});
  std::vector<int> polygon{0, 1, 2, 3, 4, 5};
  for (int turn = 0; turn < 6; ++turn) {
    EXPECT_EQ(newell_vector(points, polygon), Vector3d(0, 0, 6)) << turn;
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
}

TEST(NewellVector, KeepsItsDigitsFarFromTheOrigin) {
  Points points = make_points({{0, 0, 0}, {0.5, 0, 0}, {0.5, 0.25, 0}});
  const Vector3d near = newell_vector(points, std::vector{0, 1, 2});
  points.rowwise() += Eigen::RowVector3d(1 << 30, -(1 << 29), 1 << 28);
  EXPECT_EQ(newell_vector(points, std::vector{0, 1, 2}), near);
}

TEST(NewellVector, IsZeroWithoutArea) {
  const Points points = make_points({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}});
  EXPECT_EQ(newell_vector(points, std::vector{0, 1, 2}).norm(), 0.0);
  EXPECT_EQ(newell_vector(points, std::vector{0, 1}).norm(), 0.0);
  EXPECT_EQ(newell_vector(points, std::vector<int>{}).norm(), 0.0);
}

TEST(Centroid, IsTheMeanOfThePickedPoints) {
  const Points points = make_points({{0, 0, 0}, {100, 100, 100}, {3, 0, 0}, {0, 3, 6}});
  EXPECT_EQ(centroid(points, std::vector{0, 2, 3}), Vector3d(1, 1, 2));
  EXPECT_EQ(centroid(points, std::vector{1}), Vector3d(100, 100, 100));
}

TEST(BoundingDiagonal, SpansTheBox) {
  EXPECT_DOUBLE_EQ(bounding_diagonal(make_points({{1, 1, 1}, {2, 3, 3}, {1.5, 2, 2}})), 3.0);
  EXPECT_EQ(bounding_diagonal(make_points({{5, 6, 7}})), 0.0);
  EXPECT_EQ(bounding_diagonal(Points(0, 3)), 0.0);
}

}  // namespace
}  // namespace planewright
