#include "core/diagnose/close_points.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

TEST(ClosePoints, AreThePanelEdgesBelowTheThreshold) {
  Scene scene = Scene::flat_grid(3, 3);
  EXPECT_TRUE(find_close_points(scene.subject(), 0.15).empty());
  scene.put(5, 1.9, 1.0);
  const auto found = find_close_points(scene.subject(), 0.15);
  ASSERT_EQ(indices_of(found), std::vector<int>{scene.panel_edge(5, 6)});
  expect_well_formed(found[0]);
  EXPECT_NEAR(found[0].measure, 0.1, 1e-12);
  EXPECT_LT((found[0].place - Vector3d(1.95, 1.0, 0.0)).norm(), 1e-12);
  EXPECT_EQ(found[0].mesh_edges, std::vector<int>{scene.mesh.find_edge(5, 6)});
  EXPECT_TRUE(find_close_points(scene.subject(), 0.05).empty());
}

// Whichever way the edge runs; the closer the worse.
TEST(ClosePoints, AreWorseTheCloserTheyAre) {
  Scene scene = Scene::flat_grid(3, 3);
  scene.put(5, 1.9, 1.0);
  const double before = find_close_points(scene.subject(), 0.15).at(0).severity;
  scene.put(5, 2.05, 1.0);
  EXPECT_GT(find_close_points(scene.subject(), 0.15).at(0).severity, before);
}

}  // namespace
}  // namespace planewright
