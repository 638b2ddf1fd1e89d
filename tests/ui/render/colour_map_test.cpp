#include "ui/render/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planewright::render {
namespace {

double luminance(const glm::vec3& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

ColourScale scale(double low, double high, std::optional<double> tolerance = {}) {
  return {low, high, "Planarity", "mm", tolerance};
}

TEST(ColourMap, LuminanceRisesAllTheWay) {
  double before = -1.0;
  for (int i = 0; i <= 1000; ++i) {
    const double now = luminance(viridis(static_cast<float>(i) / 1000.0f));
    EXPECT_GT(now, before) << i;
    before = now;
  }
}

TEST(ColourMap, EndsAreViridisAndBeyondThemNothingChanges) {
  EXPECT_NEAR(viridis(0.0f).x, 0x44 / 255.0, 1e-3);
  EXPECT_NEAR(viridis(0.0f).z, 0x54 / 255.0, 1e-3);
  EXPECT_NEAR(viridis(1.0f).x, 0xfd / 255.0, 1e-3);
  EXPECT_NEAR(viridis(1.0f).z, 0x25 / 255.0, 1e-3);
  EXPECT_EQ(viridis(-3.0f), viridis(0.0f));
  EXPECT_EQ(viridis(7.0f), viridis(1.0f));
  EXPECT_EQ(viridis(std::numeric_limits<float>::quiet_NaN()), viridis(0.0f));
}

TEST(ColourMap, TableHoldsTheMap) {
  const auto table = viridis_table();
  for (int i = 0; i < 256; ++i) {
    const glm::vec3 c = viridis(static_cast<float>(i) / 255.0f);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(table[4 * i + k], 255.0f * c[k], 0.51f);
    EXPECT_EQ(table[4 * i + 3], 255);
  }
}

TEST(ColourMap, WithoutToleranceTheMapIsEven) {
  const MapScale map = map_scale(scale(2.0, 6.0));
  for (float t : {0.0f, 0.25f, 0.5f, 1.0f}) EXPECT_NEAR(map_position(map, 2.0f + 4.0f * t), t, 1e-6f);
  EXPECT_EQ(map_position(map, 1.0f), 0.0f);
  EXPECT_EQ(map_position(map, 1e30f), 1.0f);
}

TEST(ColourMap, BreaksHardAtTheTolerance) {
  const MapScale map = map_scale(scale(0.0, 4.0, 1.0));
  EXPECT_NEAR(map_position(map, 0.0f), 0.0f, 1e-6f);
  EXPECT_NEAR(map_position(map, 1.0f), kBreakBelow, 1e-6f);  // at the tolerance it is kept
  EXPECT_NEAR(map_position(map, std::nextafter(1.0f, 2.0f)), kBreakAbove, 1e-5f);
  EXPECT_NEAR(map_position(map, 4.0f), 1.0f, 1e-6f);
  float before = -1.0f;
  for (int i = 0; i <= 400; ++i) {
    const float now = map_position(map, 0.01f * static_cast<float>(i));
    EXPECT_GT(now, before);
    before = now;
  }
  EXPECT_GT(luminance(colour_of(scale(0, 4, 1), 1.001)) - luminance(colour_of(scale(0, 4, 1), 1.0)), 0.15);
}

TEST(ColourMap, ToleranceOutsideTheRangeStillSaysWhatKeepsIt) {
  const MapScale all_keep = map_scale(scale(0.0, 1.0, 5.0));
  EXPECT_NEAR(map_position(all_keep, 1.0f), kBreakBelow, 1e-6f);
  const MapScale none_keeps = map_scale(scale(2.0, 3.0, 1.0));
  EXPECT_NEAR(map_position(none_keeps, 2.0f), kBreakAbove, 1e-6f);
  EXPECT_NEAR(map_position(none_keeps, 3.0f), 1.0f, 1e-6f);
}

TEST(ColourMap, DegenerateRangesStayFinite) {
  for (const auto& s :
       {scale(1, 1), scale(1, 1, 1), scale(0, 1e-300), scale(0, 1e-300, 1e-301), scale(3, 1, 2)}) {
    const MapScale map = map_scale(s);
    for (float v : {-1.0f, 0.0f, 1.0f, 1e30f}) {
      EXPECT_TRUE(map_position(map, v) >= 0.0f && map_position(map, v) <= 1.0f);
    }
  }
}

TEST(ColourMap, SeveritiesGoFromPaleOverAmberToRed) {
  const auto luminance = [](glm::vec3 c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; };
  for (int i = 1; i <= 20; ++i) {
    const float t = static_cast<float>(i) / 20.0f;
    EXPECT_LT(luminance(severity_colour(t)), luminance(severity_colour(t - 0.05f))) << t;
  }
  EXPECT_EQ(severity_colour(-1.0f), severity_colour(0.0f));
  EXPECT_EQ(severity_colour(2.0f), severity_colour(1.0f));
  ColourScale scale;
  scale.map = ColourScale::Map::Severity;
  EXPECT_EQ(colour_of(scale, 1.0), severity_colour(1.0f));
}

TEST(ColourMap, VerdictsAreCoolWhereALimitIsKeptAndWarmWhereNot) {
  ColourScale scale;
  scale.map = ColourScale::Map::Verdict;
  scale.low = 0.0;
  scale.high = 2.0;
  scale.tolerance = 1.0;
  for (const double value : {0.0, 0.5, 0.9, 0.999})
    EXPECT_LT(colour_of(scale, value).r, colour_of(scale, value).g);
  for (const double value : {1.001, 1.5, 2.0, 9.0})
    EXPECT_GT(colour_of(scale, value).r, colour_of(scale, value).g);
  // The table that the graphics card reads has the same, next to the break as well.
  const ColourTable table = verdict_table();
  const auto entry = [&](float t) { return static_cast<std::size_t>(4 * std::lround(255.0f * t)); };
  EXPECT_LT(table[entry(kBreakBelow) + 4], table[entry(kBreakBelow) + 5]);
  EXPECT_GT(table[entry(kBreakAbove) - 4], table[entry(kBreakAbove) - 3]);
}

}  // namespace
}  // namespace planewright::render
