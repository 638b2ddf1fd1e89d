#include "core/cluster/region_edits.h"

#include <gtest/gtest.h>

#include <array>

#include "support/clusters.h"

namespace planewright {
namespace {

using namespace test;

// A 4 x 1 strip of quads in regions of one or two faces.
struct Strip {
  FaceGraph graph = graph_of(grid(4, 1).mesh());
  Clustering clustering = clustering_of(graph, {0, 1, 1, 2}, {}).value();
};

template <class T>
void expect_refused(const Result<T>& result, const std::string& words) {
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::Refused);
  EXPECT_NE(result.error().text().find(words), std::string::npos) << result.error().text();
  EXPECT_FALSE(result.error().where.empty());
  EXPECT_FALSE(result.error().remedy.empty());
}

TEST(RegionEdits, MergesNeighboursUnderTheLowerNumber) {
  const Strip strip;
  EXPECT_EQ(merge_regions(strip.graph, strip.clustering, 1, 0)->region_of_face, (std::vector{0, 0, 0, 1}));
  EXPECT_EQ(merge_regions(strip.graph, strip.clustering, 1, 2)->region_of_face, (std::vector{0, 1, 1, 1}));
  expect_refused(merge_regions(strip.graph, strip.clustering, 0, 2), "share no edge");
  expect_refused(merge_regions(strip.graph, strip.clustering, 1, 1), "with itself");
  expect_refused(merge_regions(strip.graph, strip.clustering, 1, 3), "no such region");
  expect_refused(merge_regions(strip.graph, strip.clustering, -1, 0), "no such region");
}

TEST(RegionEdits, TheLastRegionTakesTheFreedNumber) {
  const FaceGraph graph = graph_of(grid(5, 1).mesh());
  const Clustering five = clustering_of(graph, {0, 1, 2, 3, 4}, {}).value();
  EXPECT_EQ(merge_regions(graph, five, 0, 1)->region_of_face, (std::vector{0, 0, 2, 3, 1}));
}

TEST(RegionEdits, SplitsWhereTheSurfaceBends) {
  // Four quads, the last two of them folded up.
  Shape shape = grid(4, 1);
  for (int v = 0; v < shape.positions.rows(); ++v)
    if (const double beyond = shape.positions(v, 0) - 2.0; beyond > 0.0) {
      shape.positions(v, 0) = 2.0;
      shape.positions(v, 2) = beyond;
    }
  const FaceGraph graph = graph_of(shape.mesh());
  const Clustering one = clustering_of(graph, {0, 0, 0, 0}, {}).value();
  const Clustering two = split_region(graph, one, 0).value();
  EXPECT_EQ(two.region_of_face[0], two.region_of_face[1]);
  EXPECT_EQ(two.region_of_face[2], two.region_of_face[3]);
  EXPECT_NE(two.region_of_face[0], two.region_of_face[3]);
  EXPECT_NEAR(two.normal_error, 0.0, 1e-7);
  const Strip strip;
  expect_refused(split_region(strip.graph, strip.clustering, 0), "single face");
  expect_refused(split_region(strip.graph, strip.clustering, 5), "no such region");
}

TEST(RegionEdits, SplitsAndMergesBackOnRealRegions) {
  const FaceGraph graph = graph_of(make_torus(20, 30));
  ClusterOptions options;
  options.panels = 12;
  const Clustering start = cluster(graph, options).value();
  for (int r = 0; r < 12; ++r) {
    const Clustering split = split_region(graph, start, r).value();
    EXPECT_EQ(split.regions(), 13);
    EXPECT_LT(split.distance_error,
              start.distance_error);  // the error itself weighs them by the number of regions
    expect_whole(graph, split, {});
    EXPECT_EQ(merge_regions(graph, split, r, 12)->region_of_face, start.region_of_face);
  }
}

TEST(RegionEdits, PaintsFacesWhoseRegionsStayWhole) {
  const Strip strip;
  EXPECT_EQ(paint_face(strip.graph, strip.clustering, 1, 0)->region_of_face, (std::vector{0, 0, 1, 2}));
  expect_refused(paint_face(strip.graph, strip.clustering, 0, 1), "without a face");
  expect_refused(paint_face(strip.graph, strip.clustering, 1, 1), "already");
  expect_refused(paint_face(strip.graph, strip.clustering, 1, 2), "not beside");
  expect_refused(paint_face(strip.graph, strip.clustering, 9, 2), "no such face");
  expect_refused(paint_face(strip.graph, strip.clustering, 1, 7), "no such region");
  // The middle one of three in a row holds the others together.
  const FaceGraph graph = graph_of(grid(3, 2).mesh());
  const Clustering rows = clustering_of(graph, {0, 0, 0, 1, 1, 1}, {}).value();
  expect_refused(paint_face(graph, rows, 1, 1), "fall apart");
  EXPECT_TRUE(paint_face(graph, rows, 0, 1));
}

TEST(RegionEdits, PaintsManyFacesInWhateverOrderWorks) {
  const FaceGraph graph = graph_of(grid(3, 2).mesh());
  const Clustering rows = clustering_of(graph, {0, 0, 0, 1, 1, 1}, {}).value();
  // The middle one cannot go before an end has gone, the last one of the three not at all.
  const auto painted = paint_faces(graph, rows, std::array{1, 0}, 1).value();
  EXPECT_TRUE(painted.changed);
  EXPECT_EQ(painted.clustering.region_of_face, (std::vector{1, 1, 0, 1, 1, 1}));
  EXPECT_TRUE(painted.refused.empty());
  EXPECT_FALSE(painted.why);
  expect_whole(graph, painted.clustering, {});
  const auto all = paint_faces(graph, rows, std::array{0, 1, 2}, 1).value();
  EXPECT_EQ(all.clustering.region_of_face, painted.clustering.region_of_face);
  EXPECT_EQ(all.refused, (std::vector{2}));
  ASSERT_TRUE(all.why);
  EXPECT_NE(all.why->what.find("without a face"), std::string::npos);

  const auto idle = paint_faces(graph, rows, std::array{4, 77}, 1).value();
  EXPECT_FALSE(idle.changed);
  EXPECT_EQ(idle.clustering.region_of_face, rows.region_of_face);
  EXPECT_EQ(idle.refused, (std::vector{77}));
  expect_refused(paint_faces(graph, rows, std::array{0}, 5), "no such region");
}

}  // namespace
}  // namespace planewright
