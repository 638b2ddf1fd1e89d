#include "core/pattern/flat_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/pattern/contours.h"
#include "support/workshop_models.h"

namespace planewright {
namespace {

using namespace test;
using Eigen::Vector2d;

double panel_area(const WorkshopModel& model, int panel) {
  return newell_vector(model.points, model.panels[panel]).norm() / 2;
}

double segment(const Contour& contour, int k) {
  return (contour.row((k + 1) % contour.rows()) - contour.row(k)).norm();
}

Contour contour(std::initializer_list<std::array<double, 2>> rows) {
  Contour result(static_cast<Eigen::Index>(rows.size()), 2);
  Eigen::Index i = 0;
  for (const auto& row : rows) result.row(i++) << row[0], row[1];
  return result;
}

WorkshopModel ball() {
  return workshop_model(ball_of_tangent_planes(150, 10000.0), 1.0);
}

TEST(FlatPattern, KeepsAreasAndLengths) {
  const WorkshopModel model = ball();
  const std::vector<FlatPattern> patterns = flatten(model, nullptr);
  ASSERT_EQ(static_cast<int>(patterns.size()), model.panel_count());
  double flat = 0.0, curved = 0.0;
  for (int i = 0; i < model.panel_count(); ++i) {
    const FlatPattern& pattern = patterns[i];
    EXPECT_EQ(pattern.panel, i);
    ASSERT_EQ(pattern.nominal.rows(), model.panels.valence(i));
    EXPECT_NEAR(signed_area(pattern.nominal) / panel_area(model, i), 1.0, 1e-9);
    flat += signed_area(pattern.nominal);
    curved += panel_area(model, i);
    EXPECT_EQ(pattern.outer, pattern.nominal);
    EXPECT_EQ(pattern.cut, pattern.nominal);
    EXPECT_EQ(pattern.inner.rows(), 0);
  }
  EXPECT_NEAR(flat / curved, 1.0, 1e-12);
  for (const WorkshopEdge& edge : model.edges) {
    const double length = (model.points.row(edge.a) - model.points.row(edge.b)).norm();
    EXPECT_NEAR(segment(patterns[edge.left].nominal, edge.left_side), length, 1e-8);
    EXPECT_NEAR(segment(patterns[edge.right].nominal, edge.right_side), length, 1e-8);
  }
}

TEST(FlatPattern, IsSeenFromOutsideWithUpUpwards) {
  const WorkshopModel model = ball();
  const ThickPanels solids = thicken(model, {30.0, 4.0}).value();
  for (const ThickPanels* thick : {static_cast<const ThickPanels*>(nullptr), &solids})
    for (const FlatPattern& pattern : flatten(model, thick, 4.0)) {
      EXPECT_NEAR(pattern.frame.linear().determinant(), 1.0, 1e-12);
      EXPECT_NEAR((pattern.frame.linear() * pattern.frame.linear().transpose() - Matrix3d::Identity()).norm(),
                  0.0, 1e-12);
      EXPECT_NEAR((pattern.frame.linear().col(2).transpose() - model.normals.row(pattern.panel)).norm(), 0.0,
                  1e-12);
      EXPECT_GT(pattern.frame.linear()(2, 1), 0.0) << "y points upwards";
      EXPECT_NEAR(pattern.frame.linear()(2, 0), 0.0, 1e-12) << "x lies level";
      EXPECT_NEAR(pattern.cut.colwise().minCoeff().norm(), 0.0, 1e-12);
      for (int k = 0; k < pattern.nominal.rows(); ++k) {
        const Vector3d there = pattern.frame * Vector3d(pattern.nominal(k, 0), pattern.nominal(k, 1), 0.0);
        EXPECT_NEAR((there.transpose() - model.points.row(model.panels[pattern.panel][k])).norm(), 0.0, 1e-8);
      }
      if (!thick) continue;
      const ThickPanel& solid = solids.panels[pattern.panel];
      for (int k = 0; k < solid.points.rows(); ++k) {
        const bool outer = k < solid.outer;
        const Vector2d at = outer ? pattern.outer.row(k) : pattern.inner.row(k - solid.outer);
        const Vector3d there = pattern.frame * Vector3d(at.x(), at.y(), outer ? 0.0 : -30.0);
        EXPECT_NEAR((there.transpose() - solid.points.row(k)).norm(), 0.0, 1e-8);
      }
    }
}

TEST(FlatPattern, PanelsThatLieFlatHaveNorthUp) {
  const WorkshopModel model = workshop_model(cube(), 100.0);
  const std::vector<FlatPattern> patterns = flatten(model, nullptr);
  for (int i = 0; i < 6; ++i) {
    const bool flat = std::abs(model.normals(i, 2)) > 0.5;
    EXPECT_EQ(patterns[i].lies_flat, flat);
    EXPECT_NEAR((patterns[i].frame.linear().col(1) - (flat ? Vector3d::UnitY() : Vector3d::UnitZ())).norm(),
                0.0, 1e-12);
  }
  WorkshopModel turned = workshop_model(cube(), 100.0);
  turned.up = Vector3d::UnitY();
  for (const FlatPattern& pattern : flatten(turned, nullptr))
    if (pattern.lies_flat) {
      EXPECT_NEAR((pattern.frame.linear().col(1) - Vector3d::UnitX()).norm(), 0.0, 1e-12);
    }
}

TEST(FlatPattern, TheGapIsHalvedAlongInnerSidesAlone) {
  const WorkshopModel model = workshop_model(grid(2, 1), 1000.0);
  const std::vector<FlatPattern> patterns = flatten(model, nullptr, 8.0);
  for (const FlatPattern& pattern : patterns) {
    EXPECT_NEAR(signed_area(pattern.nominal), 1e6, 1e-6);
    EXPECT_NEAR(signed_area(pattern.cut), 996.0 * 1000.0, 1e-6);
    EXPECT_EQ(pattern.side_of_segment, (std::vector<int>{0, 1, 2, 3}));
  }
  EXPECT_NEAR(patterns[0].nominal.col(0).maxCoeff(), 1000.0, 1e-9);
  EXPECT_NEAR(patterns[1].nominal.col(0).minCoeff(), -4.0, 1e-9) << "the box of cut begins at 0";
}

TEST(FlatPattern, OfMitredPanelsHasBothContours) {
  // Outside of a cube the inner face is the smaller one, inside the larger.
  const Shape outside = cube();
  Shape inside{outside.positions, {}};
  for (int i = 0; i < 6; ++i) {
    std::vector<int> face(outside.faces[i].begin(), outside.faces[i].end());
    std::reverse(face.begin(), face.end());
    inside.faces.push_back(face);
  }
  for (const Shape* shape : {&outside, static_cast<const Shape*>(&inside)}) {
    const WorkshopModel model = workshop_model(*shape, 1000.0);
    const ThickPanels solids = thicken(model, {50.0, 0.0}).value();
    const double width = shape == &outside ? 900.0 : 1100.0;
    for (const FlatPattern& pattern : flatten(model, &solids)) {
      EXPECT_NEAR(signed_area(pattern.outer), 1e6, 1e-5);
      EXPECT_NEAR(signed_area(pattern.inner), width * width, 1e-5);
      EXPECT_EQ(pattern.cut, shape == &outside ? pattern.outer : pattern.inner) << "exactly";
      EXPECT_EQ(pattern.side_of_segment, (std::vector<int>{0, 1, 2, 3}));
      EXPECT_NEAR(pattern.label_room, std::min(width, 1000.0) / 2, 0.011 * width / 2);
    }
  }
}

TEST(FlatPattern, CutHoldsOuterAndInnerOfASaddle) {
  const WorkshopModel model = workshop_model(saddle(4, 0.2), 1000.0);
  const ThickPanels solids = thicken(model, {60.0, 3.0}).value();
  int mixed = 0;
  for (const FlatPattern& pattern : flatten(model, &solids)) {
    ASSERT_FALSE(pattern.empty());
    mixed += pattern.cut.rows() > 4;
    for (const Contour* part : {&pattern.outer, &pattern.inner}) {
      EXPECT_TRUE(contains(pattern.cut, *part, 5e-6));
      EXPECT_LE(signed_area(*part), signed_area(pattern.cut) + 1e-3);
    }
    EXPECT_GT(depth_in(pattern.outer, pattern.label), 100.0);
    EXPECT_GT(depth_in(pattern.inner, pattern.label), 100.0);
  }
  EXPECT_GT(mixed, 0) << "no pattern needed a union";
}

TEST(FlatPattern, SegmentsOfLostSidesAreNone) {
  // A gap that swallows the short side of a panel.
  const Points points = make_points({{0, 0, 0},
                                     {1000, 0, 0},
                                     {1000, 500, 0},
                                     {995, 505, 0},
                                     {0, 505, 0},
                                     {2000, 0, 0},
                                     {2000, 505, 0},
                                     {2000, 1000, 0},
                                     {0, 1000, 0}});
  const WorkshopModel model =
      workshop_model(points, {{0, 1, 2, 3, 4}, {1, 5, 6, 2}, {2, 6, 7, 3}, {4, 3, 7, 8}});
  const FlatPattern pattern = flatten(model, nullptr, 100.0)[0];
  EXPECT_EQ(pattern.nominal.rows(), 5);
  ASSERT_EQ(pattern.outer.rows(), 4) << "the sides beside it meet";
  std::vector<int> sides = pattern.side_of_segment;
  std::sort(sides.begin(), sides.end());
  EXPECT_EQ(sides, (std::vector<int>{0, 1, 3, 4}));
  for (int k = 0; k < 4; ++k) {
    // Each segment is parallel to its side.
    const int side = pattern.side_of_segment[k];
    const Vector2d segment = pattern.outer.row((k + 1) % 4) - pattern.outer.row(k),
                   own = pattern.nominal.row((side + 1) % 5) - pattern.nominal.row(side);
    EXPECT_NEAR(segment.normalized().dot(own.normalized()), 1.0, 1e-12);
  }
}

TEST(FlatPattern, OfPanelsWithoutSolidIsEmptyButForTheirCorners) {
  const WorkshopModel crossing = workshop_model(
      make_points({{0, 0, 0}, {100, 0, 0}, {20, 120, 0}, {100, 100, 0}, {0, 100, 0}}), {{0, 1, 2, 3, 4}});
  EXPECT_TRUE(flatten(crossing, nullptr)[0].empty());
  EXPECT_EQ(flatten(crossing, nullptr)[0].nominal.rows(), 5);
  const WorkshopModel model = workshop_model(cube(), 100.0);
  const ThickPanels solids = thicken(model, {60.0, 0.0}).value();
  for (const FlatPattern& pattern : flatten(model, &solids)) {
    EXPECT_TRUE(pattern.empty());
    EXPECT_EQ(pattern.outer.rows(), 0);
    EXPECT_NEAR(signed_area(pattern.nominal), 1e4, 1e-8);
  }
  for (const FlatPattern& pattern : flatten(workshop_model(grid(3, 3), 100.0), nullptr, 101.0))
    EXPECT_EQ(pattern.empty(), pattern.panel % 2 == 1 || pattern.panel == 4) << pattern.panel;
}

TEST(Contours, DepthIsTheDistanceFromTheContour) {
  const Contour l = contour({{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}});
  EXPECT_NEAR(depth_in(l, {4, 15}), 4.0, 1e-12);
  EXPECT_NEAR(depth_in(l, {12, 13}), -2.0, 1e-12);
  EXPECT_NEAR(depth_in(l, {23, 14}), -5.0, 1e-12);
  // Deepest where the notch's corner and both outer sides are equally far: x = y = r, r = (10 - r) sqrt 2.
  const double r = 10 * std::sqrt(2.0) / (1 + std::sqrt(2.0));
  const DeepestPoint deepest = deepest_point({&l});
  EXPECT_NEAR(deepest.depth, r, 0.01 * r);
  EXPECT_LE(deepest.depth, r + 1e-12);
}

TEST(Contours, ContainingIsOfRegionsNotOfCorners) {
  // A slot from above passes over the bar, all of whose corners are inside.
  const Contour slotted = contour({{0, 0}, {30, 0}, {30, 20}, {16, 20}, {16, 4}, {14, 4}, {14, 20}, {0, 20}});
  const Contour bar = contour({{5, 8}, {25, 8}, {25, 12}, {5, 12}});
  EXPECT_FALSE(contains(slotted, bar, 1e-9));
  EXPECT_TRUE(contains(slotted, contour({{0, 0}, {30, 0}, {30, 4}, {0, 4}}), 1e-9));
  EXPECT_FALSE(contains(slotted, contour({{0, 0}, {30, 0}, {30, 5}, {0, 5}}), 1e-9));
}

TEST(Contours, TheUnionKeepsCornersExactly) {
  const Contour a = contour({{0.1, 0.2}, {10.3, 0.2}, {10.3, 5.7}, {0.1, 5.7}});
  const Contour b = contour({{3.3333333333, -2}, {6.6666666666, -2}, {6.6666666666, 9}, {3.3333333333, 9}});
  const Contour both = united(a, b);
  EXPECT_EQ(both.rows(), 12);
  EXPECT_NEAR(signed_area(both), signed_area(a) + signed_area(b) - 3.3333333333 * 5.5, 1e-4);
  for (const Contour* own : {&a, &b})
    for (Eigen::Index k = 0; k < 4; ++k) {
      bool kept = false;
      for (Eigen::Index j = 0; j < both.rows(); ++j) kept = kept || both.row(j) == own->row(k);
      EXPECT_TRUE(kept) << k;
    }
}

}  // namespace
}  // namespace planewright
