#include "core/diagnose/collapsed_quads.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

std::vector<Finding> found_in(const Scene& scene) {
  return find_collapsed_quads(scene.subject(), 0.1);
}

TEST(CollapsedQuads, HaveTwoCornersInOnePlace) {
  Scene scene = Scene::flat_grid(2, 1);
  EXPECT_TRUE(found_in(scene).empty());
  scene.put(1, 1.0, 0.98);
  const auto found = found_in(scene);
  ASSERT_EQ(indices_of(found), (std::vector<int>{0, 1}));
  for (const Finding& finding : found) {
    expect_well_formed(finding);
    EXPECT_NEAR(finding.measure, 0.02 / 0.51, 1e-9);
    EXPECT_EQ(finding.mesh_edges, std::vector<int>{scene.mesh.find_edge(1, 4)});
  }
}

TEST(CollapsedQuads, HaveACornerOnTheLineBetweenItsNeighbours) {
  Scene scene = Scene::flat_grid(1, 1);
  scene.put(3, 0.5, 0.5);
  const auto found = found_in(scene);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].measure, 0.0, 1e-12);
  scene.put(3, 0.4, 0.4);  // past it
  EXPECT_EQ(found_in(scene).size(), 1u);
  scene.put(3, -1.0, -1.0);  // turned over
  EXPECT_EQ(found_in(scene).size(), 1u);
}

TEST(CollapsedQuads, AreNoneOfOtherPanels) {
  EXPECT_TRUE(found_in(Scene(planarize_of(tetrahedron().mesh()))).empty());
  EXPECT_TRUE(found_in(Scene(dual_of(octahedron().mesh()))).empty());
}

}  // namespace
}  // namespace planewright
