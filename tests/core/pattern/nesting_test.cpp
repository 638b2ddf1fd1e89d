#include "core/pattern/nesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "core/pattern/contours.h"
#include "core/pattern/part_fit.h"

namespace planewright {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

FlatPattern part(int panel, const std::vector<Vector2d>& corners) {
  FlatPattern pattern;
  pattern.panel = panel;
  pattern.cut.resize(static_cast<Eigen::Index>(corners.size()), 2);
  for (size_t k = 0; k < corners.size(); ++k)
    pattern.cut.row(static_cast<Eigen::Index>(k)) = corners[k].transpose();
  pattern.outer = pattern.nominal = pattern.cut;
  return pattern;
}

FlatPattern rectangle(int panel, double width, double height, double turn = 0.0) {
  FlatPattern pattern = part(panel, {{0, 0}, {width, 0}, {width, height}, {0, height}});
  pattern.cut = turned(pattern.cut, turn);
  return pattern;
}

// Irregular hexagons about as wide as 2 r, turned anyhow. Numbers of our own: the same on every machine.
std::vector<FlatPattern> hexagons(int count, double r, double uneven) {
  std::uint64_t state = 1;
  const auto any = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 33) / 2147483648.0;
  };
  std::vector<FlatPattern> parts;
  for (int i = 0; i < count; ++i) {
    std::vector<Vector2d> corners;
    const double turn = 6 * any(), size = r * (1 + uneven * (any() - 0.5));
    for (int k = 0; k < 6; ++k) {
      const double angle = turn + pi / 3 * (k + uneven * (any() - 0.5));
      corners.emplace_back(size * std::cos(angle), size * std::sin(angle));
    }
    parts.push_back(part(3 * i, corners));  // panels need not be numbered without holes
  }
  return parts;
}

Contour placed(const FlatPattern& pattern, const PlacedPart& at) {
  Contour contour = turned(pattern.cut, at.rotation);
  contour.rowwise() += at.shift.transpose();
  return contour;
}

double distance_between(const Contour& a, const Contour& b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < a.rows(); ++k) nearest = std::min(nearest, -depth_in(b, a.row(k)));
  for (Eigen::Index k = 0; k < b.rows(); ++k) nearest = std::min(nearest, -depth_in(a, b.row(k)));
  return nearest;
}

// Each part once; inside the margins; apart by the spacing.
void expect_proper(const std::vector<FlatPattern>& patterns, const Nesting& nesting,
                   const NestingOptions& options) {
  std::map<int, const FlatPattern*> pattern_of;
  for (const FlatPattern& pattern : patterns)
    if (!pattern.empty()) pattern_of[pattern.panel] = &pattern;
  std::set<int> seen(nesting.unplaced.begin(), nesting.unplaced.end());
  EXPECT_EQ(seen.size(), nesting.unplaced.size());
  double all = 0.0;
  for (const NestedSheet& sheet : nesting.sheets) {
    EXPECT_FALSE(sheet.parts.empty());
    std::vector<Contour> contours;
    double used = 0.0;
    for (size_t k = 0; k < sheet.parts.size(); ++k) {
      const PlacedPart& at = sheet.parts[k];
      EXPECT_TRUE(seen.insert(at.panel).second) << at.panel << " twice";
      ASSERT_TRUE(pattern_of.contains(at.panel));
      if (k > 0) {
        EXPECT_LT(sheet.parts[k - 1].panel, at.panel);
      }
      if (!options.rotate) {
        EXPECT_EQ(at.rotation, 0.0);
      }
      const Contour contour = placed(*pattern_of[at.panel], at);
      EXPECT_GE(contour.minCoeff(), options.margin - 1e-6);
      EXPECT_LE(contour.col(0).maxCoeff(), options.sheet.width - options.margin + 1e-6);
      EXPECT_LE(contour.col(1).maxCoeff(), options.sheet.height - options.margin + 1e-6);
      for (const Contour& other : contours) {
        const double apart = distance_between(contour, other);
        EXPECT_GE(apart, options.spacing - 1e-9);
        if (apart < options.spacing) return;
      }
      contours.push_back(contour);
      used += signed_area(contour);
    }
    EXPECT_NEAR(sheet.filled, used / (options.sheet.width * options.sheet.height), 1e-12);
    all += sheet.filled;
  }
  if (!nesting.stopped) {
    EXPECT_EQ(seen.size(), pattern_of.size());
  }
  if (!nesting.sheets.empty()) {
    EXPECT_NEAR(nesting.filled, all / static_cast<double>(nesting.sheets.size()), 1e-12);
  }
}

TEST(Nesting, LaysEveryPartOnceApartAndInsideTheMargins) {
  for (const double uneven : {0.0, 0.4})
    for (const bool rotate : {true, false})
      for (const double spacing : {0.0, 12.0}) {
        const auto parts = hexagons(120, 400.0, uneven);
        NestingOptions options;
        options.rotate = rotate;
        options.spacing = spacing;
        options.margin = 2 * spacing;
        const Nesting nesting = nest(parts, options).value();
        EXPECT_TRUE(nesting.unplaced.empty());
        expect_proper(parts, nesting, options);
      }
}

TEST(Nesting, FillsSheetsWithPlainHexagons) {
  const auto parts = hexagons(150, 620.0, 0.0);  // 1 m^2
  const Nesting nesting = nest(parts, {}).value();
  EXPECT_EQ(nesting.sheets.size(), 10u) << "15 in three columns";
  EXPECT_GT(nesting.filled, 0.75);
  EXPECT_GT(nest(hexagons(200, 500.0, 0.3), {}).value().filled, 0.6);
}

TEST(Nesting, IsTheSameEveryTime) {
  const auto parts = hexagons(80, 500.0, 0.3);
  const Nesting first = nest(parts, {}).value(), second = nest(parts, {}).value();
  ASSERT_EQ(first.sheets.size(), second.sheets.size());
  for (size_t s = 0; s < first.sheets.size(); ++s)
    for (size_t k = 0; k < first.sheets[s].parts.size(); ++k) {
      EXPECT_EQ(first.sheets[s].parts[k].shift, second.sheets[s].parts[k].shift);
      EXPECT_EQ(first.sheets[s].parts[k].rotation, second.sheets[s].parts[k].rotation);
    }
}

TEST(Nesting, NeighboursShareSheets) {
  const auto parts = hexagons(300, 450.0, 0.3);
  const Nesting nesting = nest(parts, {}).value();
  for (const NestedSheet& sheet : nesting.sheets)
    EXPECT_LT(sheet.parts.back().panel - sheet.parts.front().panel,
              3 * 3 * static_cast<int>(sheet.parts.size()));
}

TEST(Nesting, FitsWhatJustFits) {
  NestingOptions options;
  options.sheet = {1000.0, 500.0};
  options.margin = 10.0;
  const auto unplaced = [&](const FlatPattern& pattern) {
    const Nesting nesting = nest({pattern}, options).value();
    expect_proper({pattern}, nesting, options);
    return nesting.unplaced;
  };
  EXPECT_TRUE(unplaced(rectangle(7, 980.0, 480.0)).empty());
  EXPECT_TRUE(unplaced(rectangle(7, 480.0, 980.0)).empty());
  EXPECT_TRUE(unplaced(rectangle(7, 980.0, 480.0, 0.7)).empty());
  EXPECT_EQ(unplaced(rectangle(7, 980.1, 480.0)), std::vector{7});
  EXPECT_EQ(unplaced(rectangle(7, 980.0, 480.1, 0.3)), std::vector{7});
  // Longer than the sheet, but slim: only askew. 1020 x 40 needs an angle a with 1020 cos a + 40 sin a <= 980
  // and 1020 sin a + 40 cos a <= 480.
  EXPECT_TRUE(unplaced(rectangle(7, 1020.0, 40.0)).empty());
  EXPECT_TRUE(unplaced(rectangle(7, 1020.0, 40.0, 2.1)).empty());
  EXPECT_EQ(unplaced(rectangle(7, 1090.0, 40.0)), std::vector{7}) << "the diagonal is 1091";
  options.rotate = false;
  EXPECT_EQ(unplaced(rectangle(7, 480.0, 980.0)), std::vector{7});
  EXPECT_EQ(unplaced(rectangle(7, 1020.0, 40.0)), std::vector{7});
  EXPECT_TRUE(unplaced(rectangle(7, 980.0, 480.0)).empty());
}

TEST(Nesting, NamesPartsThatFitNoSheetAndLaysTheOthers) {
  auto parts = hexagons(10, 300.0, 0.2);
  parts.push_back(rectangle(100, 7000.0, 100.0));
  parts.push_back(rectangle(99, 4000.0, 4000.0));
  FlatPattern none;
  none.panel = 98;
  parts.push_back(none);
  const Nesting nesting = nest(parts, {}).value();
  EXPECT_EQ(nesting.unplaced, (std::vector{99, 100}));
  expect_proper(parts, nesting, {});
  const Nesting all = nest({rectangle(1, 7000, 7000)}, {}).value();
  EXPECT_EQ(all.unplaced, std::vector{1});
  EXPECT_TRUE(all.sheets.empty());
  EXPECT_EQ(all.filled, 0.0);
}

TEST(Nesting, TurnsRectanglesSoThatTheyFillTheSheet) {
  NestingOptions options;
  options.sheet = {1000.0, 1000.0};
  options.margin = 0.0;
  options.spacing = 0.0;
  std::vector<FlatPattern> parts;
  for (int i = 0; i < 8; ++i) parts.push_back(rectangle(i, 499.9, 249.9, 0.3 * i));
  const Nesting nesting = nest(parts, options).value();
  expect_proper(parts, nesting, options);
  EXPECT_EQ(nesting.sheets.size(), 1u);
}

TEST(Nesting, TellsProgressAndStops) {
  const auto parts = hexagons(60, 500.0, 0.2);
  std::vector<int> told;
  std::stop_source stop;
  const auto progress = [&](int done, int total) {
    EXPECT_EQ(total, 60);
    told.push_back(done);
  };
  EXPECT_FALSE(nest(parts, {}, progress, stop.get_token()).value().stopped);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 60);
  const Nesting stopped = nest(
                              parts, {},
                              [&](int done, int) {
                                if (done > 0) stop.request_stop();
                              },
                              stop.get_token())
                              .value();
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.sheets.size(), 1u);
  EXPECT_TRUE(stopped.unplaced.empty());
  expect_proper(parts, stopped, {});
}

TEST(Nesting, BadSheetsAreRefused) {
  for (const NestingOptions& bad : {NestingOptions{{0.0, 100.0}},
                                    {{100.0, -1.0}},
                                    {{100.0, 100.0}, 0.0, 50.0},
                                    {{100.0, 100.0}, -1.0},
                                    {{100.0, 100.0}, 0.0, -1.0},
                                    {{std::nan(""), 100.0}},
                                    {{INFINITY, 100.0}}}) {
    const auto result = nest(hexagons(1, 10.0, 0.0), bad);
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_FALSE(result.error().remedy.empty());
  }
}

TEST(Nesting, SmallPartsAreQuickEnough) {
  const auto parts = hexagons(250, 150.0, 0.3);
  const std::clock_t begin = std::clock();
  const Nesting nesting = nest(parts, {}).value();
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 30.0);
  expect_proper(parts, nesting, {});
}

TEST(PartFit, TheHullLeavesOutNotchesAndStraightCorners) {
  const FlatPattern l = part(0, {{0, 0}, {10, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}});
  const Contour hull = convex_hull(l.cut);
  EXPECT_EQ(hull.rows(), 5);
  EXPECT_NEAR(signed_area(hull), 350.0, 1e-12);
}

TEST(PartFit, TheSmallestBoxIsWiderThanHigh) {
  for (const double turn : {0.0, 0.4, 1.3, 2.0, 4.0}) {
    const Contour hull = convex_hull(rectangle(0, 30.0, 70.0, turn).cut);
    const Vector2d box = box_of(turned(hull, smallest_box_angle(hull)));
    EXPECT_NEAR(box.x(), 70.0, 1e-9);
    EXPECT_NEAR(box.y(), 30.0, 1e-9);
  }
}

}  // namespace
}  // namespace planewright
