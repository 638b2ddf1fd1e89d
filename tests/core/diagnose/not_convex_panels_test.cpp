#include "core/diagnose/not_convex_panels.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

constexpr double kThreshold = 10.0, kLeastDefect = 1e-3;

std::vector<Finding> found_in(const Scene& scene, double threshold = kThreshold) {
  return find_not_convex_panels(scene.subject(), threshold, kLeastDefect);
}

TEST(NotConvexPanels, OfAConvexFaceHaveAReflexCorner) {
  Scene scene = Scene::flat_grid(3, 3);
  EXPECT_TRUE(found_in(scene).empty());
  scene.put(5, 1.4, 1.4);
  EXPECT_TRUE(found_in(scene).empty());  // still convex
  scene.put(5, 1.7, 1.7);
  const auto found = found_in(scene);
  ASSERT_EQ(indices_of(found), std::vector<int>{4});
  expect_well_formed(found[0]);
  EXPECT_NEAR(found[0].measure, std::atan2(0.4, 0.42) * 180.0 / std::numbers::pi, 1e-9);
  EXPECT_LT((found[0].place - Vector3d(1.7, 1.7, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(found_in(scene, 50.0).empty());
}

TEST(NotConvexPanels, AreNotBlamedOnAFaceThatWasNotConvexItself) {
  Shape shape = grid(3, 3);
  shape.positions.row(5) << 1.7, 1.7, 0.0;
  EXPECT_TRUE(found_in(Scene(planarize_of(shape.mesh()))).empty());
}

TEST(NotConvexPanels, AreNotTheOnesThatCrossThemselves) {
  Scene scene = Scene::flat_grid(3, 3);
  scene.put(5, 2.0, 1.0);
  scene.put(6, 1.0, 1.0);
  for (const int panel : indices_of(found_in(scene))) EXPECT_TRUE(panel != 1 && panel != 4);
}

// The panel of the hub, with one corner pulled in.
Scene dented(const Shape& shape) {
  Scene scene(dual_of(shape.mesh()));
  const Vector3d middle = centroid(scene.state.x, scene.complex->panels[0]);
  const int corner = scene.complex->panels[0][0];
  scene.state.x.row(corner) += 0.9 * (middle - scene.state.x.row(corner).transpose()).transpose();
  return scene;
}

TEST(NotConvexPanels, OfADualAreThoseWhereTheDesignBulges) {
  const auto found = found_in(dented(fan(6)));
  ASSERT_EQ(indices_of(found), std::vector<int>{0});
  EXPECT_EQ(found[0].mesh_edges.size(), 6u);
  // Up and down by turns: the angles round the hub sum up to more than a circle.
  Shape saddle = fan(6);
  saddle.positions(0, 2) = 0.0;
  for (int k = 1; k <= 6; ++k) saddle.positions(k, 2) = k % 2 ? 0.5 : -0.5;
  EXPECT_TRUE(found_in(dented(saddle)).empty());
  // Flat: neither.
  Shape flat = fan(6);
  flat.positions.col(2).setZero();
  EXPECT_TRUE(found_in(dented(flat)).empty());
}

// Three points round a vertex of a tetrahedron: any three corners are convex.
TEST(NotConvexPanels, AreNeverTriangles) {
  Scene scene(dual_of(tetrahedron().mesh()));
  scene.state = perturbed(*scene.complex, 1.0);
  EXPECT_TRUE(found_in(scene, 0.0).empty());
}

}  // namespace
}  // namespace planewright
