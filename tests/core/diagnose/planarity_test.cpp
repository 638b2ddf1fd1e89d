#include "core/diagnose/planarity.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

// Corners lifted by +d, -d in turn: the least-squares plane is the middle one, every corner d away.
TEST(Planarity, OfATwistedQuadIsItsLift) {
  for (const double d : {0.1, 1e-3, 1e-9}) {
    Shape shape = grid(1, 1);
    for (int j = 0; j < 4; ++j) shape.positions(j, 2) = (j == 0 || j == 3) ? d : -d;
    const Planarity planarity = measure_planarity(shape.positions, shape.faces);
    EXPECT_NEAR(planarity.max, d, 1e-6 * d + 1e-16);
    EXPECT_NEAR(planarity.mean, d, 1e-6 * d + 1e-16);
    EXPECT_EQ(planarity.worst, 0);
    EXPECT_NEAR(planarity.max_relative_to_bbox, d / std::sqrt(2.0 + 4 * d * d), 1e-6 * d + 1e-16);
  }
}

TEST(Planarity, DoesNotDependOnPlaceDirectionOrScale) {
  Shape shape = twisted_grid(2, 2);
  const Planarity before = measure_planarity(shape.positions, shape.faces);
  const Matrix3d turn = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  shape.positions = (1e-3 * shape.positions * turn.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3);
  const Planarity after = measure_planarity(shape.positions, shape.faces);
  EXPECT_NEAR((after.per_panel * 1e3 - before.per_panel).norm(), 0.0, 1e-11);
  EXPECT_EQ(after.worst, before.worst);
}

TEST(Planarity, NamesTheWorstPanelAndTheMean) {
  // Three quads in a row, the middle edge of the last two lifted at one end.
  Shape shape = grid(3, 1);
  shape.positions(2, 2) = 0.1;
  const Planarity planarity = measure_planarity(shape.positions, shape.faces);
  EXPECT_NEAR(planarity.per_panel[0], 0.0, 1e-16);
  EXPECT_GT(planarity.per_panel[1], 0.02);
  EXPECT_NEAR(planarity.per_panel[1], planarity.per_panel[2], 1e-12);
  EXPECT_NEAR(planarity.mean, planarity.per_panel.sum() / 3, 1e-16);
  EXPECT_EQ(planarity.max, planarity.per_panel.maxCoeff());
  EXPECT_TRUE(planarity.worst == 1 || planarity.worst == 2);
}

TEST(Planarity, TrianglesAndFlatPanelsArePlanar) {
  const Shape triangles = domed_triangle_grid(3, 3);
  EXPECT_EQ(measure_planarity(triangles.positions, triangles.faces).max, 0.0);
  const Shape box = cube();
  EXPECT_LE(measure_planarity(box.positions, box.faces).max, 1e-16);
}

TEST(Planarity, HandlesPanelsWithoutArea) {
  // All corners on a line, all in one place: planar. Three on a line and one beside: planar as well.
  const Points points = make_points({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {0, 1, 0}});
  const Planarity planarity = measure_planarity(points, {{0, 1, 2, 3}, {0, 0, 0, 0}, {0, 1, 2, 4}});
  for (int p = 0; p < 3; ++p) EXPECT_NEAR(planarity.per_panel[p], 0.0, 1e-15) << p;
}

TEST(Planarity, SeesPanelsOfAnySize) {
  Shape shape = grid(1, 1);
  for (int j = 0; j < 4; ++j) shape.positions(j, 2) = (j == 0 || j == 3) ? 0.1 : -0.1;
  for (const double scale : {1e-120, 1e-9, 1e9, 1e120}) {
    const Planarity planarity = measure_planarity(shape.positions * scale, shape.faces);
    EXPECT_NEAR(planarity.max / scale, 0.1, 1e-12) << scale;
  }
}

// The box is that of the used points: a stray one far away does not make anything look planar.
TEST(Planarity, IgnoresUnusedPoints) {
  Shape shape = twisted_grid(1, 1);
  const Planarity before = measure_planarity(shape.positions, shape.faces);
  shape.positions.conservativeResize(5, 3);
  shape.positions.row(4) << 1e9, 0, 0;
  EXPECT_EQ(measure_planarity(shape.positions, shape.faces).max_relative_to_bbox,
            before.max_relative_to_bbox);
}

TEST(Planarity, OfNoPanels) {
  const Planarity planarity = measure_planarity(Points(0, 3), {});
  EXPECT_EQ(planarity.max, 0.0);
  EXPECT_EQ(planarity.worst, -1);
  EXPECT_EQ(planarity.max_relative_to_bbox, 0.0);
}

TEST(Displacement, IsTheDistancePointByPoint) {
  const Points reference = make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}});
  Points points = reference;
  points.row(0) += Eigen::RowVector3d(1, 2, 2);
  points.row(2) += Eigen::RowVector3d(0, 0, -1);
  const Displacement displacement = measure_displacement(points, reference);
  EXPECT_NEAR((displacement.per_point - Vector{{3, 0, 1, 0}}).norm(), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(displacement.max, 3.0);
  EXPECT_DOUBLE_EQ(displacement.rms, std::sqrt(10.0 / 4.0));
  EXPECT_EQ(measure_displacement(Points(0, 3), Points(0, 3)).rms, 0.0);
}

}  // namespace
}  // namespace planewright
