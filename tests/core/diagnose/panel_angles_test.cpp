#include "core/diagnose/panel_angles.h"

#include <gtest/gtest.h>

#include <numbers>

namespace planewright {
namespace {

// A thin triangle, a square, and a dart whose reflex corner turns by 20 degrees less than round.
TEST(PanelAngles, TheSharpestCornerOfEachPanelIsFound) {
  Points points(11, 3);
  points << 0, 0, 0, 10, 0, 0, 10, 1, 0,        // 0..2
      0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1,       // 3..6
      0, 0, 2, 0.2, 3, 2, 0, 0.4, 2, -3, 3, 2;  // 7..10: reflex at 9
  Polygons polygons;
  polygons.push_back(std::array{0, 1, 2});
  polygons.push_back(std::array{3, 4, 5, 6});
  polygons.push_back(std::array{7, 8, 9, 10});
  const auto acute = find_acute_corners(points, polygons);
  ASSERT_EQ(acute.size(), 2u);
  EXPECT_EQ(acute[0].panel, 0);
  EXPECT_EQ(acute[0].point, 0);
  EXPECT_NEAR(acute[0].degrees, std::atan(0.1) * 180.0 / std::numbers::pi, 1e-12);
  EXPECT_EQ(acute[1].panel, 2);
  EXPECT_EQ(acute[1].point, 8);
  EXPECT_EQ(find_acute_corners(points, polygons, 91.0).size(), 3u);
  EXPECT_TRUE(find_acute_corners(points, polygons, 0.1).empty());
}

TEST(PanelAngles, EdgesWithoutLengthHaveNone) {
  Points points(4, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0;
  Polygons polygons;
  polygons.push_back(std::array{0, 1, 2, 3});
  EXPECT_TRUE(find_acute_corners(points, polygons).empty());
}

}  // namespace
}  // namespace planewright
