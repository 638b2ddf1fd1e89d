#include "core/cluster/surface_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/cluster/anchor_polygons.h"
#include "support/clusters.h"

namespace planewright {
namespace {

using namespace test;

TEST(SurfaceDistance, MeasuresBothSides) {
  // A sheet over a larger one: from above everything is 0.5 away, from below the rim is farther.
  const Shape large = grid(4, 4);
  Shape small = grid(2, 2);
  small.positions.rowwise() += Eigen::RowVector3d(1, 1, 0.5);
  const auto distance = surface_distance(small.positions, small.faces, large.positions, large.faces);
  ASSERT_TRUE(distance) << distance.error().text();
  EXPECT_NEAR(distance->from_first.max, 0.5, 1e-12);
  EXPECT_NEAR(distance->from_first.rms, 0.5, 1e-12);
  EXPECT_NEAR(distance->from_second.max, std::sqrt(2.25), 1e-12);
  // 1/4 everywhere; over the rim the square of the distance to the smaller sheet besides: 4 sides of 2 x 1
  // with 1/3, 4 corners with 2/3, of an area of 16.
  EXPECT_NEAR(distance->from_second.rms, std::sqrt(0.25 + (8.0 / 3.0 + 8.0 / 3.0) / 16.0), 2e-3);
  EXPECT_EQ(distance->max(), distance->from_second.max);
  EXPECT_EQ(distance->rms(), distance->from_second.rms);
}

TEST(SurfaceDistance, IsNoneOfASurfaceToItself) {
  const PolygonMesh torus = make_torus(10, 14);
  Points far = torus.positions();
  far.rowwise() += Eigen::RowVector3d(1e6, 1e6, -1e6);
  const auto distance = surface_distance(far, torus.faces(), far, torus.faces(), 5000);
  EXPECT_LT(distance->max(), 1e-8);
}

TEST(SurfaceDistance, RefusesWhatHasNoArea) {
  const Shape sheet = grid(1, 1);
  EXPECT_FALSE(surface_distance(sheet.positions, sheet.faces, sheet.positions, {}));
  EXPECT_FALSE(surface_distance(sheet.positions, {}, sheet.positions, sheet.faces));
  EXPECT_FALSE(surface_distance(sheet.positions, sheet.faces, sheet.positions, sheet.faces, 0));
}

TEST(AnchorPolygons, LieNearTheSurface) {
  const PolygonMesh mesh = sphere(12).mesh();
  const FaceGraph graph = graph_of(mesh);
  double before = 1.0;
  for (const int panels : {12, 40, 120}) {
    ClusterOptions options;
    options.panels = panels;
    const Regions regions = make_regions(graph, cluster(graph, options).value()).value();
    const auto distance = surface_distance(anchor_points(mesh, regions), regions.corners_of_region,
                                           mesh.positions(), mesh.faces());
    ASSERT_TRUE(distance) << distance.error().text();
    EXPECT_LT(distance->rms(), before);
    before = distance->rms();
  }
  EXPECT_LT(before, 0.02);
}

}  // namespace
}  // namespace planewright
