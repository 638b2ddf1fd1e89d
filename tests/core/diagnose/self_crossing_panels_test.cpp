#include "core/diagnose/self_crossing_panels.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

TEST(SelfCrossingPanels, AreMeasuredByTheirSmallerLoop) {
  Scene scene = Scene::flat_grid(3, 3);
  EXPECT_TRUE(find_self_crossing_panels(scene.subject(), 0.0).empty());
  // Two corners change places: the panels on both sides become bow ties of two equal loops.
  scene.put(5, 2.0, 1.0);
  scene.put(6, 1.0, 1.0);
  const auto found = find_self_crossing_panels(scene.subject(), 0.0);
  ASSERT_EQ(indices_of(found), (std::vector<int>{1, 4}));
  for (const Finding& finding : found) {
    expect_well_formed(finding);
    EXPECT_NEAR(finding.measure, 0.5, 1e-12);
    EXPECT_DOUBLE_EQ(finding.severity, 1.0);
    EXPECT_EQ(finding.mesh_edges.size(), 4u);
  }
  EXPECT_LT((found[0].place - Vector3d(1.5, 0.5, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(find_self_crossing_panels(scene.subject(), 0.5).empty());
}

TEST(SelfCrossingPanels, ASmallLoopIsLessSevere) {
  Scene scene = Scene::flat_grid(3, 3);
  scene.put(5, 1.5, 1.0);
  scene.put(6, 1.4, 1.0);
  const auto found = find_self_crossing_panels(scene.subject(), 0.0);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_GT(found[0].measure, 0.0);
  EXPECT_LT(found[0].measure, 0.2);
  EXPECT_LT(found[0].severity, 0.9);
}

}  // namespace
}  // namespace planewright
