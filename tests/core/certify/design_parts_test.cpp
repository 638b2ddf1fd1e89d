// What the certificate proves of classes of congruent panels and of parts on sheets, each with faults.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <ctime>

#include "core/certify/contours_apart.h"
#include "core/certify/part_checks.h"
#include "support/certify_sample.h"

namespace planewright {
namespace {

using sample::kSide;
using sample::Strip;
using Names = std::vector<std::string>;

Names design(const Strip& strip) {
  Names failed;
  for (const Check& c : certify(strip.folder, {}, strip.content).design)
    if (!c.pass) failed.push_back(c.name);
  return failed;
}

// Moves a part with all that is on it.
void move(Drawing& drawing, int panel, double x, double y) {
  for (DrawingLine& l : drawing.lines)
    if (l.panel == panel) l.points.rowwise() += Eigen::RowVector2d(x, y);
  for (DrawingText& t : drawing.texts)
    if (t.panel == panel) t.at += Eigen::Vector2d(x, y);
}
DrawingLine& cut(Drawing& drawing, int panel) {
  return *std::find_if(drawing.lines.begin(), drawing.lines.end(),
                       [&](const auto& l) { return l.layer == DrawingLayer::Cut && l.panel == panel; });
}

Contour rectangle(double x, double y, double width, double height) {
  Contour c(4, 2);
  c << x, y, x + width, y, x + width, y + height, x, y + height;
  return c;
}

TEST(CertificateClasses, EveryPanelInOneAndLaidAsItSays) {
  const Names wrong{"classes of congruent panels"};
  {
    Strip s;
    s.classes[0].members.pop_back();
    EXPECT_EQ(design(s), wrong);
    s.classes.push_back({{{2}}});
    EXPECT_EQ(design(s), Names{});
    s.classes.push_back({{{1}}});  // again
    EXPECT_EQ(design(s), wrong);
  }
  {
    Strip s;
    s.classes[0].members[0].shift = 1;  // a mother lies on herself as she is
    EXPECT_EQ(design(s), wrong);
  }
  // A rectangle among squares; what is within the tolerance is none.
  for (const double longer : {0.15, 0.25, 3.0}) {
    Strip s;
    s.model.points(3, 0) += longer;
    s.model.points(7, 0) += longer;
    const Names failed = design(s);
    EXPECT_EQ(std::find(failed.begin(), failed.end(), wrong[0]) != failed.end(), longer > 0.2) << longer;
  }
}

// A kite has one way to lie on itself, and one turned over.
TEST(CertificateClasses, ShiftAndMirrorCount) {
  Strip s;
  s.content.drawings.clear();
  s.content.solids = nullptr;
  s.content.patterns = nullptr;
  // Two right-angled triangles of legs 30 and 40 and one that is turned over.
  s.model.points.resize(9, 3);
  s.model.points << 0, 0, 0, 40, 0, 0, 0, 30, 0, /**/ 100, 0, 0, 100, 40, 0, 70, 0, 0, /**/ 200, 0, 0, 240, 0,
      0, 240, 30, 0;
  s.model.panels = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  s.model.edges.clear();
  const Names fine, wrong{"classes of congruent panels"};
  // The first: right angle, 40, 30. The second: right angle, 40, 30, too. The third: 40 comes first: its
  // right angle is at its second corner, and it runs 30, then the longest: turned over.
  s.classes = {{{{0}, {1, false, 0, 0.0}, {2, true, 1, 0.0}}}};
  EXPECT_EQ(design(s), fine);
  for (int shift = 0; shift < 4; ++shift) {
    s.classes[0].members[1].shift = shift;
    EXPECT_EQ(design(s), shift == 0 ? fine : wrong);
  }
  s.classes[0].members[1].shift = 0;
  for (const bool mirrored : {false, true})
    for (int shift = 0; shift < 3; ++shift) {
      s.classes[0].members[2].mirrored = mirrored;
      s.classes[0].members[2].shift = shift;
      EXPECT_EQ(design(s), mirrored && shift == 1 ? fine : wrong) << mirrored << shift;
    }
}

TEST(CertificateClasses, BevelsHaveToAgree) {
  Strip s;
  const Names wrong{"classes of congruent panels"};
  for (PanelPassport& p : s.passports) p.sides[2].bevel = 5.0;
  EXPECT_EQ(design(s), Names{});
  s.content.congruence.bevels = true;
  EXPECT_EQ(design(s), wrong);  // turned, and turned over
  s.classes = {{{{0}, {1, false, 0, 0.0}}}, {{{2}}}};
  EXPECT_EQ(design(s), Names{});
  s.passports[1].sides[2].bevel = 5.2;
  EXPECT_EQ(design(s), wrong);
  s.passports[1].sides[2].bevel = 5.0;
  s.classes = {{{{0}, {1, false, 0, 0.0}, {2, true, 3, 0.0}}}};
  EXPECT_EQ(design(s), wrong);
}

TEST(CertificateParts, ApartByTheSpacingAndInsideTheMargins) {
  {
    Strip s;  // 7/3 mm from its neighbours
    move(s.content.drawings[0], 1, 7.0 / 3.0 - 2.0 - 1e-7, 0.0);
    EXPECT_EQ(design(s), Names{});
    move(s.content.drawings[0], 1, 1e-5, 0.0);
    EXPECT_EQ(design(s), (Names{"parts apart"}));
    move(s.content.drawings[0], 1, 10.0, 0.0);
    EXPECT_EQ(design(s), (Names{"parts apart"}));
    s.content.nesting.reset();
    EXPECT_EQ(design(s), (Names{"parts apart"}));
  }
  {
    Strip s;  // one within the other's place
    move(s.content.drawings[0], 1, -(kSide + 7.0 / 3.0), -1.0);
    EXPECT_EQ(design(s), (Names{"parts apart"}));
    s.content.nesting.reset();
    EXPECT_EQ(design(s), (Names{"parts apart"}));
  }
  {
    Strip s;
    move(s.content.drawings[0], 0, -5.0, -5.0);
    EXPECT_EQ(design(s), Names{});
    move(s.content.drawings[0], 0, 0.0, -1e-5);
    EXPECT_EQ(design(s), (Names{"parts inside the margins"}));
  }
  {
    Strip s;
    move(s.content.drawings[0], 2, 30.4, 0.0);  // beyond 145
    EXPECT_EQ(design(s), (Names{"parts inside the margins"}));
  }
  {
    Strip s;
    s.content.nesting->sheet.height = 61.0;
    EXPECT_EQ(design(s), (Names{"parts inside the margins"}));
  }
}

TEST(CertificateParts, OnceEachAndAsTheirPatterns) {
  {
    Strip s;
    s.content.drawings.push_back(s.content.drawings[0]);
    EXPECT_EQ(design(s), (Names{"every part on one drawing"}));
  }
  {
    Strip s;
    s.content.left_out = {1};
    EXPECT_EQ(design(s), (Names{"every part on one drawing"}));
  }
  {
    Strip s;  // turned by a quarter and somewhat, it stays itself
    Contour& c = cut(s.content.drawings[0], 1).points;
    const Eigen::RowVector2d middle = c.colwise().mean();
    c = (c.rowwise() - middle) * Eigen::Rotation2Dd(M_PI / 2 + 0.01).toRotationMatrix();
    c.rowwise() += middle;
    EXPECT_EQ(design(s), Names{});
    c(2, 0) += 1e-5;
    EXPECT_EQ(design(s), (Names{"parts as their patterns"}));
  }
  {
    Strip s;  // turned over
    for (FlatPattern& p : s.patterns) p.cut(1, 0) = kSide - 5.0;
    for (int p = 0; p < 3; ++p) {
      Contour& line = cut(s.content.drawings[0], p).points;
      const Eigen::RowVector2d corner = line.colwise().minCoeff();
      line = s.patterns[static_cast<size_t>(p)].cut.rowwise() + corner;
    }
    EXPECT_EQ(design(s), Names{});
    Contour& c = cut(s.content.drawings[0], 1).points;
    c.col(0).array() = 2.0 * c.col(0).minCoeff() + kSide - c.col(0).array();
    EXPECT_EQ(design(s), (Names{"parts as their patterns"}));
  }
}

TEST(ContoursApart, WithASpacing) {
  const Contour a = rectangle(0, 0, 10, 10);
  const auto at = [&](double x, double y, double spacing = 1.0) {
    return apart(a, rectangle(x, y, 10, 10), spacing, 1e-6);
  };
  EXPECT_EQ(at(11, 0), Apart::Yes);
  EXPECT_EQ(at(11 - 1e-5, 0), Apart::TooNear);
  EXPECT_EQ(at(10, 0), Apart::Overlap);   // touching
  EXPECT_EQ(at(10, 10), Apart::Overlap);  // at a corner
  EXPECT_EQ(at(9, 9), Apart::Overlap);
  EXPECT_EQ(at(10.7, 10.7), Apart::TooNear);
  EXPECT_EQ(at(10.71, 10.71), Apart::Yes);
  EXPECT_EQ(apart(a, rectangle(2, 2, 1, 1), 1.0, 1e-6), Apart::Overlap);  // inside
  EXPECT_EQ(apart(rectangle(2, 2, 1, 1), a, 1.0, 1e-6), Apart::Overlap);
  // In a notch of an L is room.
  Contour l(6, 2);
  l << 0, 0, 10, 0, 10, 3, 3, 3, 3, 10, 0, 10;
  EXPECT_EQ(apart(l, rectangle(4, 4, 5, 5), 1.0, 1e-6), Apart::Yes);
  EXPECT_EQ(apart(l, rectangle(3.5, 4, 5, 5), 1.0, 1e-6), Apart::TooNear);
}

TEST(ContoursApart, WithoutSpacingTheyMayTouch) {
  const Contour a = rectangle(0, 0, 10, 10);
  const auto at = [&](double x, double y) { return apart(a, rectangle(x, y, 10, 10), 0.0, 1e-6); };
  EXPECT_EQ(at(10, 0), Apart::Yes);
  EXPECT_EQ(at(10, 3), Apart::Yes);
  EXPECT_EQ(at(10 - 1e-7, 3), Apart::Yes);
  EXPECT_EQ(at(10 - 1e-4, 3), Apart::Overlap);
  EXPECT_EQ(at(10 - 1e-4, 0), Apart::Overlap);  // no corner inside, sides on one another
  EXPECT_EQ(at(0, 0), Apart::Overlap);          // the same
  EXPECT_EQ(at(3, 0), Apart::Overlap);
  EXPECT_EQ(apart(rectangle(-5, 4, 20, 2), a, 0.0, 1e-6), Apart::Overlap);  // a cross
  EXPECT_EQ(apart(rectangle(2, 2, 3, 3), a, 0.0, 1e-6), Apart::Overlap);
}

// 1,800 hexagons on a hundred sheets.
TEST(CertificateParts, AreProvedQuickly) {
  Strip s;
  s.content.drawings.clear();
  s.content.patterns = nullptr;
  s.content.nesting = NestingOptions{{3210.0, 6000.0}, 10.0, 10.0, true};
  s.model.names.clear();
  s.model.panels = {};
  for (int sheet = 0; sheet < 100; ++sheet) {
    Drawing d{"sheet", 3210.0, 6000.0, {}, {}};
    for (int i = 0; i < 18; ++i) {
      Contour c(12, 2);
      for (int k = 0; k < 12; ++k)
        c.row(k) << 520.0 + 1040.0 * (i % 3) + 480.0 * std::cos(k * M_PI / 6),
            520.0 + 990.0 * (i / 3) + 480.0 * std::sin(k * M_PI / 6);
      d.lines.push_back({DrawingLayer::Cut, c, true, 18 * sheet + i});
      s.model.names.push_back("P-" + std::to_string(18 * sheet + i));
      s.model.panels.push_back(std::vector{0, 1, 5, 4});
    }
    s.content.drawings.push_back(std::move(d));
  }
  const std::clock_t begin = std::clock();
  for (const Check& check : check_parts(s.content)) EXPECT_TRUE(check.pass) << check.name << check.detail;
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1.0);
}

}  // namespace
}  // namespace planewright
