#include "core/diagnose/far_points.h"

#include <gtest/gtest.h>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

TEST(FarPoints, AreThoseBeyondTheThreshold) {
  Scene scene = Scene::flat_grid(3, 3);
  EXPECT_TRUE(find_far_points(scene.subject(), 1.0).empty());
  scene.put(5, 1.0, 2.5);
  scene.put(6, 2.0, 1.9);
  const auto found = find_far_points(scene.subject(), 1.0);
  ASSERT_EQ(indices_of(found), std::vector<int>{5});
  expect_well_formed(found[0]);
  EXPECT_NEAR(found[0].measure, 1.5, 1e-12);
  EXPECT_EQ(found[0].mesh_edges.size(), 4u);
  EXPECT_EQ(indices_of(find_far_points(scene.subject(), 0.5)), (std::vector<int>{5, 6}));
}

}  // namespace
}  // namespace planewright
