#include "core/diagnose/twisted_beams.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/findings.h"

namespace planewright {
namespace {

using namespace test;

// The same panels higher up, turned by so many degrees.
NeighbourLayer turned(const Scene& scene, double degrees) {
  State state = scene.state;
  const Matrix3d turn =
      Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, Vector3d::UnitZ()).toRotationMatrix();
  state.x = (state.x * turn.transpose()).eval();
  state.x.col(2).array() += 1.0;
  return {scene.complex, state};
}

TEST(TwistedBeams, JoinEdgesThatAreNotParallel) {
  const Scene scene = Scene::flat_grid(2, 2);
  EXPECT_TRUE(find_twisted_beams(scene.subject(), turned(scene, 0.0), 5.0).empty());
  EXPECT_TRUE(find_twisted_beams(scene.subject(), turned(scene, 4.0), 5.0).empty());
  const auto found = find_twisted_beams(scene.subject(), turned(scene, 8.0), 5.0);
  ASSERT_EQ(found.size(), scene.complex->panel_edges.size());
  for (const Finding& finding : found) {
    expect_well_formed(finding);
    EXPECT_NEAR(finding.measure, 8.0, 1e-9);
    EXPECT_NEAR(finding.place.z(), 0.5, 1e-12);
    EXPECT_EQ(finding.mesh_edges.size(), 1u);
  }
  EXPECT_LT(found[0].severity, find_twisted_beams(scene.subject(), turned(scene, 120.0), 5.0).at(0).severity);
}

TEST(TwistedBeams, BetweenLayersOfOtherPanelsAreNone) {
  const Scene scene = Scene::flat_grid(2, 2), other = Scene::flat_grid(3, 2);
  EXPECT_TRUE(find_twisted_beams(scene.subject(), turned(other, 50.0), 5.0).empty());
}

}  // namespace
}  // namespace planewright
