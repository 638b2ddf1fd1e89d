// Demands that contradict each other are refused before the solve, with the names of both.
#include "core/problem/contradictions.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

Pin pin(PointOrigin point, const Vector3d& at) {
  return {point, {at[0], at[1], at[2]}};
}
Vector3d wanted(const TangentComplex& complex, int point) {
  return complex.preferred.row(point).transpose() + complex.origin;
}

void expect_refused(const SharedComplex& complex, const ProblemSettings& settings,
                    const std::vector<std::string>& names) {
  const auto problem = Problem::create(complex, settings);
  ASSERT_FALSE(problem) << names.front();
  EXPECT_EQ(problem.error().code, ErrorCode::Infeasible);
  for (const std::string& name : names)
    EXPECT_NE(problem.error().text().find(name), std::string::npos)
        << "'" << name << "' is not in: " << problem.error().text();
  EXPECT_FALSE(problem.error().remedy.empty());
}
void expect_accepted(const SharedComplex& complex, const ProblemSettings& settings) {
  const auto problem = Problem::create(complex, settings);
  EXPECT_TRUE(problem) << problem.error().text();
}

class OnADome : public testing::Test {
 protected:
  const SharedComplex complex = dual_of(domed_triangle_grid(5, 4).mesh(), {0.1});
  const double edge = complex->mean_edge;
  const PointOrigin point = complex->point_origin[7];  // of face 7
  const Vector3d up = complex->input.face_normals.row(7);
  const Vector3d here = wanted(*complex, 7);  // 0.1 over face 7
};

TEST_F(OnADome, TwoPinsOnOnePoint) {
  ProblemSettings settings;
  settings.demands.pins = {
      pin(point, here), {complex->point_origin[3], {0.0, {}, {}}}, pin(point, here + Vector3d(0, 0.01, 0))};
  expect_refused(complex, settings, {"pin 1", "pin 3", "the point of face 7"});
  settings.demands.pins[2] = settings.demands.pins[0];
  expect_accepted(complex, settings);
}

TEST_F(OnADome, TwoPlanePinsOnOnePanel) {
  ProblemSettings settings;
  settings.demands.plane_pins = {{8, {}}, {8, PlanePin::Equation{{0, 0, 1}, 0.0}}};
  expect_refused(complex, settings, {"plane pin 1", "plane pin 2", "the panel of vertex 8"});
}

TEST_F(OnADome, AnEmptyBand) {
  for (const std::string name : {"offset-band", "height-band"}) {
    expect_refused(complex, demanding({demand(name, {0.2, 0.1})}), {name, "low", "high", "empty band"});
    expect_refused(complex, demanding({demand(name, {kUnbounded})}), {name, "empty band"});
    expect_accepted(complex, demanding({demand(name, {0.1, 0.2})}));
    expect_accepted(complex, demanding({demand(name, {0.1, 0.1})}));
    expect_accepted(complex, demanding({demand(name, {0.1})}));
    expect_accepted(complex, demanding({demand(name)}));
    // Narrower than two margins is still a band.
    expect_accepted(complex, demanding({demand(name, {0.1, 0.1 + 1e-5 * edge})}));
  }
}

TEST_F(OnADome, APinOutsideAVertexDemand) {
  ProblemSettings settings = demanding({demand("vertex")});
  settings.demands.pins = {pin(point, here - 0.11 * up)};
  expect_refused(complex, settings, {"'vertex' at point 7", "'pin' at point 7"});
  settings.demands.pins = {pin(point, here - 0.09 * up)};
  expect_accepted(complex, settings);
  settings.side = -1.0;
  expect_refused(complex, settings, {"'vertex' at point 7", "'pin' at point 7"});
  // Two coordinates leave the third free.
  settings.demands.pins[0].at[2].reset();
  expect_accepted(complex, settings);
}

TEST_F(OnADome, APinOutsideItsHeightBand) {
  ProblemSettings settings = demanding({demand("height-band", {0.05, 0.15})});
  for (const double off : {-0.06, 0.06}) {
    settings.demands.pins = {pin(point, here + off * up)};
    expect_refused(complex, settings, {"'height-band' at point 7", "'pin' at point 7"});
  }
  settings.demands.pins = {pin(point, here + 0.04 * up)};
  expect_accepted(complex, settings);
}

TEST_F(OnADome, APinOutsideItsPrism) {
  ProblemSettings settings = demanding({demand("prism")});
  const Vector3d aside = up.unitOrthogonal();
  settings.demands.pins = {pin(point, here + 2.0 * aside)};
  expect_refused(complex, settings, {"'prism' at point 7", "'pin' at point 7"});
  settings.demands.pins = {pin(point, here + 0.1 * aside)};
  expect_accepted(complex, settings);
}

TEST_F(OnADome, APinOffAPlaneAndOffTheBorder) {
  ProblemSettings settings =
      demanding({demand("on-plane", {0, 0, here.z() - 0.1, 0, 0, 1}, "one")}, {{"one", {}, {}, {7}}});
  settings.demands.pins = {pin(point, here)};
  expect_refused(complex, settings, {"'on-plane' at point 7", "'pin' at point 7"});
  settings.demands.pins[0].at[2].reset();
  expect_accepted(complex, settings);

  settings = demanding({demand("border")});
  int corner = 0;
  while (complex->point_origin[corner].kind != PointKind::Corner) ++corner;
  settings.demands.pins = {
      pin(complex->point_origin[corner], wanted(*complex, corner) + Vector3d(0, 0, 0.1))};
  expect_refused(complex, settings, {"'border'", "'pin'", text(ElementRef{ElementKind::Point, corner})});
}

TEST_F(OnADome, APlanePinOutsideItsOffsetBand) {
  ProblemSettings settings = demanding({demand("offset-band", {0.2, 0.3})});
  settings.demands.plane_pins = {{8, {}}};  // at 0.1
  expect_refused(complex, settings, {"'offset-band' at panel 8", "'plane pin' at panel 8"});
  settings = demanding({demand("offset-band", {0.05, 0.3})});
  settings.demands.plane_pins = {{8, {}}};
  expect_accepted(complex, settings);
}

TEST_F(OnADome, APinOffAPinnedPlane) {
  const int j = complex->panels[8][0];
  const Vector3d n = complex->normals.row(8);
  const Vector3d on =
      complex->anchors.row(8).transpose() + complex->origin + 0.1 * n + 0.2 * n.unitOrthogonal();
  ProblemSettings settings;
  settings.demands.plane_pins = {{8, {}}};
  settings.demands.pins = {pin(complex->point_origin[j], on)};
  expect_accepted(complex, settings);
  settings.demands.pins = {pin(complex->point_origin[j], on + 0.01 * n)};
  expect_refused(complex, settings,
                 {"'plane pin' at panel 8", "'pin' at " + text(ElementRef{ElementKind::Point, j})});
}

// Two rows in one direction, though nothing is held.
TEST_F(OnADome, RangesThatDoNotMeet) {
  ProblemSettings settings = demanding({demand("offset-band", {0.1, 0.2}), demand("face")}, {}, -1.0);
  expect_refused(complex, settings, {"'offset-band' at panel 0", "'face' at panel 0"});
  settings.side = 1.0;
  expect_accepted(complex, settings);

  expect_refused(complex, demanding({demand("vertex"), demand("height-band", {-0.2, -0.1})}),
                 {"'vertex' at point 0", "'height-band' at point 0"});
  expect_accepted(complex, demanding({demand("vertex"), demand("height-band", {-0.2, 0.1})}));

  const Selection one{"one", {12}, {}, {}};
  expect_refused(
      complex,
      demanding({demand("offset-band", {0.1, 0.2}), demand("offset-band", {0.3, 0.4}, "one")}, {one}),
      {"two demands 'offset-band' at panel 12"});
  expect_accepted(
      complex,
      demanding({demand("offset-band", {0.1, 0.2}, "one"), demand("offset-band", {0.15, 0.4})}, {one}));
}

// What is left free has one direction: a line along z, and two ranges on it.
TEST_F(OnADome, RangesAlongWhatPinsLeaveFree) {
  ProblemSettings settings = demanding({demand("vertex"), demand("prism")});
  settings.demands.pins = {{point, {here.x() + 5.0, here.y(), {}}}};
  expect_refused(complex, settings, {"'prism' at point 7", "at point 7"});
  settings.demands.pins = {{point, {here.x(), here.y(), {}}}};
  expect_accepted(complex, settings);
}

TEST_F(OnADome, WhatTheStageKeepsFixed) {
  ProblemSettings settings = demanding({demand("offset-band", {0.2, 0.3})});
  settings.freedom = Freedom::Normals;
  expect_refused(complex, settings, {"'offset-band' at panel 0", "the fixed offset of panel 0"});
  settings.demands.list[0].values = {0.05, 0.3};
  expect_accepted(complex, settings);

  settings = {};
  settings.freedom = Freedom::Normals;
  settings.demands.plane_pins = {{8, {}}};
  expect_accepted(complex, settings);
  settings.demands.plane_pins = {{8, PlanePin::Equation{{0, 0, 1}, 5.0}}};
  expect_refused(complex, settings, {"'plane pin' at panel 8", "the fixed offset of panel 8"});
}

TEST_F(OnADome, AWaivedDemandContradictsNothing) {
  ProblemSettings settings = demanding({demand("vertex")});
  settings.demands.pins = {pin(point, here - 0.5 * up)};
  settings.demands.waived = {{"vertex", {ElementKind::Point, 7}}};
  expect_accepted(complex, settings);
  settings.demands.waived = {{"vertex", {ElementKind::Point, 8}}};
  expect_refused(complex, settings, {"'vertex' at point 7"});
}

// A separation asks for another round of solves, not for another design.
TEST_F(OnADome, ASeparationIsLeftToTheSolver) {
  ProblemSettings settings;
  settings.demands.pins = {pin(point, here)};
  FrozenGeometry frozen;
  frozen.separations = {{7, Vector3d::UnitZ(), complex->preferred(7, 2) + 1.0, 3}};
  const auto problem = Problem::create(complex, settings, frozen);
  EXPECT_TRUE(problem) << problem.error().text();
}

// Points that keep an order on the border, pinned in the other one.
TEST(Contradictions, BetweenPinsAndARowOfTwoPoints) {
  const SharedComplex complex = planarize_of(grid(4, 1).mesh());
  ProblemSettings settings = demanding({demand("border")});
  settings.demands.pins = {{{PointKind::Vertex, 1}, {3.0, {}, {}}}, {{PointKind::Vertex, 2}, {2.0, {}, {}}}};
  expect_refused(complex, settings, {"'border'", "'pin'"});
  settings.demands.pins[0].at[0] = 0.5;
  expect_accepted(complex, settings);
}

TEST(Contradictions, AMarginThatIsNone) {
  for (const double margin : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    ProblemSettings settings = demanding({demand("face")});
    settings.demands.margin = margin;
    const auto problem = Problem::create(dual_of(cube().mesh()), settings);
    ASSERT_FALSE(problem);
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_EQ(problem.error().where, "margin");
  }
}

}  // namespace
}  // namespace planewright
