#include "core/workshop/congruence.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include "core/mesh/sample_shapes.h"
#include "support/panel_designs.h"

namespace planewright {
namespace {

using Outline = std::vector<std::array<double, 2>>;

const Outline kScalene{{0, 0}, {400, 0}, {350, 210}, {30, 150}};  // mm, no symmetry

Outline moved(const Outline& outline, double angle, double x, double y, bool mirrored = false) {
  Outline result;
  for (const auto& [px, py] : outline) {
    const double qx = mirrored ? -px : px;
    result.push_back(
        {std::cos(angle) * qx - std::sin(angle) * py + x, std::sin(angle) * qx + std::cos(angle) * py + y});
  }
  if (mirrored) std::reverse(result.begin(), result.end());  // anticlockwise again
  return result;
}

Outline begun_at(Outline outline, int corner) {
  std::rotate(outline.begin(), outline.begin() + corner, outline.end());
  return outline;
}

Outline box(double width, double height, double x = 0.0) {
  return {{x, 0}, {x + width, 0}, {x + width, height}, {x, height}};
}

std::vector<CongruenceClass> classes_of(const PanelDesign& design, const CongruenceOptions& options = {},
                                        LengthUnit unit = LengthUnit::Millimetre) {
  const auto model = model_of(converted(design, unit), in_unit(unit));
  return congruence_classes(*model, make_passports(*model), options);
}

std::vector<std::vector<int>> panels_of(const std::vector<CongruenceClass>& classes) {
  std::vector<std::vector<int>> panels;
  for (const auto& one : classes) {
    panels.emplace_back();
    for (const auto& member : one.members) panels.back().push_back(member.panel);
  }
  return panels;
}

TEST(Congruence, MovedAndTurnedPanelsAreOneClassWithTheShiftOfTheirCorners) {
  const auto classes = classes_of(flat_panels(
      {kScalene, begun_at(moved(kScalene, 1.1, 900, 50), 1), begun_at(moved(kScalene, -2.0, 0, 990), 3)}));
  ASSERT_EQ(panels_of(classes), (std::vector<std::vector<int>>{{0, 1, 2}}));
  const auto& members = classes[0].members;
  EXPECT_EQ(members[0].shift, 0);
  EXPECT_EQ(members[0].deviation, 0.0);
  EXPECT_EQ(members[1].shift, 3);  // begun at 1: the mother's corner 0 is its last
  EXPECT_EQ(members[2].shift, 1);
  for (const auto& member : members) {
    EXPECT_FALSE(member.mirrored);
    EXPECT_LT(member.deviation, 1e-9);
  }
}

TEST(Congruence, AMirroredPairIsOneClassTurnedOver) {
  const auto classes = classes_of(flat_panels(
      {kScalene, moved(kScalene, 0.4, 1500, 0, true), begun_at(moved(kScalene, 2.4, 0, 1500, true), 2)}));
  ASSERT_EQ(panels_of(classes), (std::vector<std::vector<int>>{{0, 1, 2}}));
  EXPECT_TRUE(classes[0].members[1].mirrored);
  EXPECT_EQ(classes[0].members[1].shift, 3);  // reversed: the mother's corner 0 is its last
  EXPECT_TRUE(classes[0].members[2].mirrored);
  EXPECT_EQ(classes[0].members[2].shift, 1);
}

TEST(Congruence, SymmetricPanelsAreNotTurnedOver) {
  const auto classes = classes_of(flat_panels({box(300, 200), box(300, 200, 500), box(200, 300, 900)}));
  ASSERT_EQ(classes.size(), 1u);
  for (const auto& member : classes[0].members) EXPECT_FALSE(member.mirrored);
  EXPECT_EQ(classes[0].members[1].shift, 0);  // 2 would do as well
  EXPECT_EQ(classes[0].members[2].shift, 1);
}

TEST(Congruence, TheSameCornersInAnotherOrderAreAnotherPanel) {
  // Equal sides and area, other angles: a rhombus and a square of its side; and one more corner.
  const double h = std::sqrt(0.75) * 100.0;
  EXPECT_EQ(classes_of(flat_panels({box(100, 100), {{200, 0}, {300, 0}, {350, h}, {250, h}}})).size(), 2u);
  EXPECT_EQ(
      classes_of(flat_panels({box(100, 100), {{200, 0}, {250, 0}, {300, 0}, {300, 100}, {200, 100}}})).size(),
      2u);
}

TEST(Congruence, ToleranceIsOfCornersAfterTheBestMotion) {
  // Wider by 0.15: each corner is off by half of it, 0.075.
  const auto classes = classes_of(flat_panels({box(100, 50), box(100.15, 50, 300)}));
  ASSERT_EQ(classes.size(), 1u);
  EXPECT_NEAR(classes[0].members[1].deviation, 0.075, 1e-9);
  CongruenceOptions tight;
  tight.tolerance = 0.074;
  EXPECT_EQ(classes_of(flat_panels({box(100, 50), box(100.15, 50, 300)}), tight).size(), 2u);
}

TEST(Congruence, AChainOfNearPanelsIsCutRoundItsMother) {
  const PanelDesign chain =
      flat_panels({box(100, 50), box(100.15, 50, 300), box(100.3, 50, 600), box(100.45, 50, 900)});
  EXPECT_EQ(panels_of(classes_of(chain)), (std::vector<std::vector<int>>{{0, 1}, {2, 3}}));
}

TEST(Congruence, OfTwoMothersTheFirstTakesIt) {
  const PanelDesign between = flat_panels({box(100, 50), box(100.3, 50, 300), box(100.18, 50, 600)});
  EXPECT_EQ(panels_of(classes_of(between)), (std::vector<std::vector<int>>{{0, 2}, {1}}));
}

TEST(Congruence, AToleranceHitExactlyHoldsInEveryUnit) {
  const PanelDesign pair = flat_panels({box(100, 50), box(100.25, 50, 300)});
  CongruenceOptions options;
  options.tolerance = 0.125;
  for (const LengthUnit unit : length_units()) {
    EXPECT_EQ(classes_of(pair, options, unit).size(), 1u) << symbol(unit);
    CongruenceOptions less = options;
    less.tolerance -= 1e-9;
    EXPECT_EQ(classes_of(pair, less, unit).size(), 2u) << symbol(unit);
  }
}

// Two squares that meet at an edge, the second falling off by `degrees`, and a third by itself.
PanelDesign folded(double degrees) {
  PanelDesign design = wall(1, 2);
  for (int v = 0; v < 6; ++v) design.points.row(v) << design.points(v, 0), design.points(v, 2), 0.0;
  const double a = degrees * std::numbers::pi / 180.0;
  for (const int v : {2, 5}) design.points.row(v) << 1.0 + std::cos(a), design.points(v, 1), -std::sin(a);
  Points more(10, 3);
  more << design.points, 5, 0, 0, 6, 0, 0, 6, 1, 0, 5, 1, 0;
  design.points = more * 1000.0;
  design.panels.push_back(std::array{6, 7, 8, 9});
  return design;
}

TEST(Congruence, BevelsPartPanelsOfOneOutline) {
  CongruenceOptions bevels;
  bevels.bevels = true;
  EXPECT_EQ(classes_of(folded(20.0)).size(), 1u);
  // The first two agree, each with one side of 10 degrees: side 1 of the first, side 3 of the second.
  const auto classes = classes_of(folded(20.0), bevels);
  EXPECT_EQ(panels_of(classes), (std::vector<std::vector<int>>{{0, 1}, {2}}));
  EXPECT_EQ(classes[0].members[1].shift, 2);
  EXPECT_EQ(classes_of(folded(0.1), bevels).size(), 1u);  // 0.05 degrees are within 0.1
}

TEST(Congruence, MitredPanelsHaveNoMirrorImages) {
  const auto scalene_with_wing = [](bool mirrored) {
    // The panel and a wing that falls off from its side 0.
    PanelDesign d;
    d.points.resize(6, 3);
    d.points << 0, 0, 0, 400, 0, 0, 350, 210, 0, 30, 150, 0, 400, -90, -90, 0, -90, -90;
    d.panels = {{0, 1, 2, 3}, {1, 0, 5, 4}};
    if (mirrored) {
      d.points.col(0) *= -1.0;
      d.panels = {{3, 2, 1, 0}, {4, 5, 0, 1}};
    }
    return d;
  };
  PanelDesign both = scalene_with_wing(false);
  const PanelDesign other = scalene_with_wing(true);
  Points points(12, 3);
  points << both.points, (other.points.rowwise() + Eigen::RowVector3d(2000, 0, 0));
  both.points = points;
  for (int p = 0; p < 2; ++p) {
    std::vector<int> corners(other.panels[p].begin(), other.panels[p].end());
    for (int& v : corners) v += 6;
    both.panels.push_back(corners);
  }
  EXPECT_EQ(panels_of(classes_of(both)), (std::vector<std::vector<int>>{{0, 2}, {1, 3}}));
  CongruenceOptions bevels;
  bevels.bevels = true;
  // The wings are rectangles: turned in their plane, not over, they agree.
  EXPECT_EQ(panels_of(classes_of(both, bevels)), (std::vector<std::vector<int>>{{0}, {1, 3}, {2}}));
  // Cut square, a panel may be turned over.
  EXPECT_EQ(classes_of(flat_panels({kScalene, moved(kScalene, 0.4, 1500, 0, true)}), bevels).size(), 1u);
}

// A torus of revolution of quads: rows are rings.
TEST(Congruence, ATorusOfRevolutionHasOneClassForEachRingOrLess) {
  constexpr int kRings = 12, kRound = 40;
  PanelDesign torus;
  torus.points.resize(kRings * kRound, 3);
  for (int r = 0; r < kRings; ++r)
    for (int c = 0; c < kRound; ++c) {
      const double a = 2.0 * std::numbers::pi * r / kRings, b = 2.0 * std::numbers::pi * c / kRound;
      const double radius = 10000.0 + 4000.0 * std::cos(a);
      torus.points.row(r * kRound + c) << radius * std::cos(b), radius * std::sin(b), 4000.0 * std::sin(a);
    }
  for (int r = 0; r < kRings; ++r)
    for (int c = 0; c < kRound; ++c) {
      const int s = (r + 1) % kRings, d = (c + 1) % kRound;
      torus.panels.push_back(std::array{r * kRound + c, r * kRound + d, s * kRound + d, s * kRound + c});
    }
  for (const LengthUnit unit : length_units()) {
    const auto classes = classes_of(torus, {}, unit);
    ASSERT_EQ(classes.size(), 6u) << symbol(unit);  // above and below alike
    for (const auto& one : classes) EXPECT_EQ(one.members.size(), 80u);
  }
}

TEST(Congruence, EveryPanelIsInOneClassAndClassesAreInOrder) {
  const PolygonMesh mesh = make_sample("twisted-roof", 400).value();
  CongruenceOptions loose;
  loose.tolerance = 100.0;
  const auto classes = classes_of({mesh.positions() * 1000.0, mesh.faces()}, loose);
  std::vector<int> seen(static_cast<size_t>(mesh.face_count()), 0);
  int last = -1;
  for (const auto& one : classes) {
    EXPECT_GT(one.members.front().panel, last);
    last = one.members.front().panel;
    for (const auto& member : one.members) {
      ++seen[static_cast<size_t>(member.panel)];
      EXPECT_LE(member.deviation, 100.0);
    }
  }
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
  EXPECT_LT(classes.size(), seen.size());
}

// The bound is far above what it takes, and far below laying each on every mother.
TEST(Congruence, TenThousandDifferentPanelsTakeNoLongerThanMustBe) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> offset(-60.0, 60.0);
  std::vector<Outline> outlines;
  for (int i = 0; i < 10000; ++i) {
    Outline hexagon;
    for (int k = 0; k < 6; ++k) {
      const double a = k * std::numbers::pi / 3.0;
      hexagon.push_back({500.0 * std::cos(a) + offset(random), 500.0 * std::sin(a) + offset(random)});
    }
    outlines.push_back(hexagon);
  }
  const auto model = model_of(flat_panels(outlines), in_unit(LengthUnit::Millimetre));
  const auto passports = make_passports(*model);
  const auto start = std::chrono::steady_clock::now();
  const auto classes = congruence_classes(*model, passports, {});
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("seconds", std::to_string(seconds));
  EXPECT_GT(classes.size(), 9900u);
  EXPECT_LT(seconds, 5.0);
}

}  // namespace
}  // namespace planewright
