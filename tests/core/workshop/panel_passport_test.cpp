#include "core/workshop/panel_passport.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "support/panel_designs.h"

namespace planewright {
namespace {

// An L in metres, whose reflex corner is corner 3; turned out of every coordinate plane.
PanelDesign tilted_l() {
  PanelDesign l = flat_panels({{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}});
  const Matrix3d turn(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -0.5).normalized()));
  l.points = l.points * turn.transpose();
  return l;
}

// Two squares of side 1 that meet in the y axis and fall off to both sides by `slope` degrees (a roof), or
// rise (a gutter, negative); outside is above.
PanelDesign two_slopes(double slope) {
  const double c = std::cos(slope * std::numbers::pi / 180.0), s = std::sin(slope * std::numbers::pi / 180.0);
  PanelDesign roof;
  roof.points.resize(6, 3);
  roof.points << 0, 0, 0, 0, 1, 0, c, 0, -s, c, 1, -s, -c, 0, -s, -c, 1, -s;
  roof.panels = {{0, 2, 3, 1}, {0, 1, 5, 4}};
  return roof;
}

TEST(PanelPassport, AnLHasTheMeasuresThatItsDrawingSays) {
  const auto model = model_of(tilted_l());
  const auto passports = make_passports(*model);
  ASSERT_EQ(passports.size(), 1u);
  const PanelPassport& l = passports[0];
  EXPECT_NEAR(l.area, 3e6, 1e-6);
  EXPECT_NEAR(l.perimeter, 8000.0, 1e-9);
  EXPECT_NEAR(l.planarity, 0.0, 1e-9);
  EXPECT_NEAR(l.width, 2000.0, 1e-9);
  EXPECT_NEAR(l.height, 2000.0, 1e-9);
  EXPECT_FALSE(l.crosses_itself);
  const double lengths[] = {2000, 1000, 1000, 1000, 1000, 2000}, interior[] = {90, 90, 90, 270, 90, 90};
  ASSERT_EQ(l.sides.size(), 6u);
  for (size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(l.sides[k].length, lengths[k], 1e-9) << k;
    EXPECT_NEAR(l.sides[k].interior, interior[k], 1e-9) << k;
    EXPECT_EQ(l.sides[k].neighbour, -1) << k;
    EXPECT_EQ(l.sides[k].dihedral, 180.0) << k;
    EXPECT_EQ(l.sides[k].bevel, 0.0) << k;
  }
}

TEST(PanelPassport, SeenFromTheOtherSideAnglesStayInside) {
  PanelDesign l = tilted_l();
  l.panels = {{5, 4, 3, 2, 1, 0}};
  const auto model = model_of(l);
  const auto sides = make_passports(*model)[0].sides;
  EXPECT_NEAR(sides[2].interior, 270.0, 1e-9);
  EXPECT_NEAR(sides[0].interior, 90.0, 1e-9);
}

TEST(PanelPassport, InteriorAnglesBelongToTheCornerWhereTheSideBegins) {
  const double h = std::sqrt(3.0);  // 90, 60 and 30 degrees
  const auto model = model_of(flat_panels({{{0, 0}, {1, 0}, {0, h}}}));
  const auto sides = make_passports(*model)[0].sides;
  EXPECT_NEAR(sides[0].interior, 90.0, 1e-10);
  EXPECT_NEAR(sides[1].interior, 60.0, 1e-10);
  EXPECT_NEAR(sides[2].interior, 30.0, 1e-10);
}

TEST(PanelPassport, ASideWithoutLengthIsNoCorner) {
  const auto model = model_of(flat_panels({{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}}));
  const auto sides = make_passports(*model)[0].sides;
  EXPECT_EQ(sides[1].length, 0.0);
  EXPECT_EQ(sides[1].interior, 180.0);
  EXPECT_NEAR(sides[2].interior, 90.0, 1e-10);
}

TEST(PanelPassport, ACubesEdgesAreRidgesFromOutsideAndValleysFromInside) {
  for (const PanelPassport& side : make_passports(*model_of(cube())))
    for (const SidePassport& edge : side.sides) {
      EXPECT_NEAR(edge.dihedral, 270.0, 1e-10);
      EXPECT_NEAR(edge.bevel, 45.0, 1e-10);  // the inner face of a mitred box is the smaller one
    }
  for (const PanelPassport& side : make_passports(*model_of(cube(false))))
    for (const SidePassport& edge : side.sides) {
      EXPECT_NEAR(edge.dihedral, 90.0, 1e-10);
      EXPECT_NEAR(edge.bevel, -45.0, 1e-10);
    }
}

TEST(PanelPassport, RoofAndGutterLeanBySlope) {
  for (const double slope : {30.0, 5.0, 0.0, -30.0, -80.0}) {
    const auto passports = make_passports(*model_of(two_slopes(slope)));
    const SidePassport &one = passports[0].sides[3], &other = passports[1].sides[0];
    EXPECT_EQ(one.neighbour, 1);
    EXPECT_EQ(other.neighbour, 0);
    for (const SidePassport& side : {one, other}) {
      EXPECT_NEAR(side.dihedral, 180.0 + 2.0 * slope, 1e-9) << slope;
      EXPECT_NEAR(side.bevel, slope, 1e-9) << slope;
    }
  }
}

TEST(PanelPassport, PlanarityIsTheFarthestCornersDistance) {
  PanelDesign saddle = flat_panels({{{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}}});
  for (int v = 0; v < 4; ++v) saddle.points(v, 2) = v % 2 == 0 ? 0.25 : -0.25;
  const auto model = model_of(saddle, in_unit(LengthUnit::Millimetre));
  EXPECT_NEAR(make_passports(*model)[0].planarity, 0.25, 1e-12);
}

TEST(PanelPassport, TheSmallestRectangleIsTurned) {
  const double c = std::cos(0.5), s = std::sin(0.5);
  const auto model = model_of(flat_panels({{{0, 0}, {3 * c, 3 * s}, {3 * c - s, 3 * s + c}, {-s, c}}}),
                              in_unit(LengthUnit::Foot));
  const PanelPassport panel = make_passports(*model)[0];
  EXPECT_NEAR(panel.width, 914.4, 1e-9);
  EXPECT_NEAR(panel.height, 304.8, 1e-9);
}

TEST(PanelPassport, WeightNeedsThicknessAndDensity) {
  const auto model = model_of(wall(1, 1));
  PassportOptions options;
  EXPECT_FALSE(make_passports(*model, options)[0].weight);
  options.thickness = 3.0;
  EXPECT_FALSE(make_passports(*model, options)[0].weight);
  options.density = 2700.0;  // aluminium, 3 mm, 1 m^2
  EXPECT_NEAR(make_passports(*model, options)[0].weight.value(), 8.1, 1e-12);
}

TEST(PanelPassport, DistanceIsInMillimetresOnBothSidesOfTheReference) {
  PanelDesign panels = flat_panels({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{2, 0}, {3, 0}, {3, 1}, {2, 1}}});
  for (int v = 0; v < 8; ++v) panels.points(v, 2) = v < 4 ? 0.25 : -0.5;
  panels.points(2, 2) = 0.75;
  Points corners(4, 3);
  corners << -9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0;
  const Vector3d far(1024.0, -4096.0, 512.0);
  corners.rowwise() += far.transpose();
  panels.points.rowwise() += far.transpose();
  const auto reference = ReferenceSurface::create(corners, {{0, 1, 2, 3}}, "ground.obj").value();
  PassportOptions options;
  options.reference = reference.get();
  for (const LengthUnit unit : length_units()) {
    const auto passports = make_passports(*model_of(panels, in_unit(unit)), options);
    EXPECT_NEAR(passports[0].distance.value(), 0.75 * millimetres_per(unit), 1e-9);
    EXPECT_NEAR(passports[1].distance.value(), 0.5 * millimetres_per(unit), 1e-9);
  }
  EXPECT_FALSE(make_passports(*model_of(panels))[0].distance);
}

TEST(PanelPassport, CrossingOutlinesAreTold) {
  const auto model =
      model_of(flat_panels({{{0, 0}, {2, 0}, {0, 1}, {2, 2}}, {{5, 0}, {6, 0}, {6, 1}, {5, 1}}}));
  const auto passports = make_passports(*model);
  EXPECT_TRUE(passports[0].crosses_itself);
  EXPECT_FALSE(passports[1].crosses_itself);
}

}  // namespace
}  // namespace planewright
