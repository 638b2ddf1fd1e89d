#include "core/design/clustered_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/mesh/mesh_edits.h"
#include "support/clusters.h"

namespace planewright {
namespace {

std::shared_ptr<const PolygonMesh> ball() {
  return std::make_shared<const PolygonMesh>(test::sphere(6).mesh());
}
SharedClusters clustered(std::shared_ptr<const PolygonMesh> mesh, int panels) {
  ClusterOptions options;
  options.panels = panels;
  return cluster_mesh(std::move(mesh), options).value();
}
void expect_true_regions(const ClusteredMesh& of) {
  EXPECT_EQ(of.regions.region_of_face.size(), static_cast<std::size_t>(of.mesh->face_count()));
  EXPECT_TRUE(clustering_of(*of.graph, of.regions.region_of_face, of.options.metric));
  for (int r = 0; r < of.regions.count(); ++r) EXPECT_GE(of.regions.corners_of_region.valence(r), 3);
}
// A region and one beside it.
std::array<int, 2> neighbours(const ClusteredMesh& of) {
  for (std::size_t c = 0; c < of.graph->beside.size(); ++c) {
    const int g = of.graph->beside[c];
    if (g < 0) continue;
    const int a = of.regions.region_of_face[of.graph->face_of_corner[c]], b = of.regions.region_of_face[g];
    if (a != b) return {a, b};
  }
  return {-1, -1};
}

TEST(ClusteredMesh, GoesOnToAnotherNumberOnTheSameGraph) {
  const auto of = clustered(ball(), 20);
  ClusterOptions options = of->options;
  options.panels = 30;
  const auto more = recluster(*of, options).value();
  EXPECT_EQ(more->graph, of->graph);
  EXPECT_EQ(more->mesh, of->mesh);
  EXPECT_EQ(more->clustering.regions(), 30);
  EXPECT_EQ(more->options.panels, 30);
  expect_true_regions(*more);
  options.panels = of->mesh->face_count() + 1;
  const auto refused = recluster(*of, options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().what.find("cannot be made of a mesh"), std::string::npos);
}

TEST(ClusteredMesh, IsMergedAndSplitByTheNumbersThatAreSeen) {
  const auto of = clustered(ball(), 20);
  const auto [a, b] = neighbours(*of);
  const auto merged = with_regions_merged(*of, a, b).value();
  EXPECT_EQ(merged->clustering.regions(), of->regions.count() - 1);
  EXPECT_EQ(merged->options.panels, merged->clustering.regions());
  expect_true_regions(*merged);
  const auto split = with_region_split(*of, a).value();
  EXPECT_EQ(split->clustering.regions(), of->regions.count() + 1);
  expect_true_regions(*split);
  const auto refused = with_regions_merged(*of, a, a);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Refused);
}

TEST(ClusteredMesh, TakesPaintInWhateverOrderWorks) {
  const auto of = clustered(ball(), 20);
  const auto [a, b] = neighbours(*of);
  // All of the neighbour, the farthest first: all but the last face can go over, if none falls apart.
  std::vector<int> theirs;
  int from = -1;
  for (int f = 0; f < of->mesh->face_count(); ++f) {
    if (of->regions.region_of_face[f] == b) theirs.push_back(f);
    if (of->regions.region_of_face[f] == a && from < 0) from = f;
  }
  const auto painted = with_faces_painted(*of, theirs, from).value();
  EXPECT_LT(painted.refused.size(), theirs.size());
  EXPECT_FALSE(painted.refused.empty());
  ASSERT_TRUE(painted.why);
  EXPECT_FALSE(painted.why->remedy.empty());
  expect_true_regions(*painted.clusters);
  // What is there already is no refusal.
  const auto idle = with_faces_painted(*of, std::array{from}, from).value();
  EXPECT_TRUE(idle.refused.empty());
  EXPECT_EQ(idle.clusters->regions.region_of_face, of->regions.region_of_face);
}

TEST(ClusteredMesh, FollowsEditsOfTheMesh) {
  const auto of = clustered(ball(), 20);
  std::shared_ptr<const PolygonMesh> mesh = of->mesh;
  SharedClusters now = of;
  for (int k = 0; k < 40; ++k) {
    const MeshEdit edits[] = {
        MeshEdit::split_edge(7 * k % mesh->edge_count()), MeshEdit::flip(11 * k % mesh->edge_count()),
        MeshEdit::collapse(13 * k % mesh->edge_count()), MeshEdit::delete_face(17 * k % mesh->face_count())};
    const auto edited = apply(*mesh, edits[k % 4]);
    if (!edited) continue;
    const auto next = std::make_shared<const PolygonMesh>(edited->mesh);
    const auto carried = carried_over(*now, next, edited->map.faces);
    if (!carried) {
      EXPECT_FALSE(carried.error().what.empty());
      return;
    }
    expect_true_regions(**carried);
    EXPECT_EQ((*carried)->mesh, next);
    mesh = next;
    now = *carried;
  }
}

TEST(ClusteredMesh, OfAnEditThatKeepsTheFacesIsWhatItWas) {
  const auto of = clustered(ball(), 20);
  const auto carried = carried_over(*of, of->mesh, identity_map(*of->mesh).faces).value();
  EXPECT_EQ(carried->regions.region_of_face, of->regions.region_of_face);
}

TEST(ClusteredMesh, KnowsTheSameRegionsAgain) {
  const std::vector<int> before = {0, 0, 0, 1, 1, 2, 2, 2}, after = {1, 1, 0, 0, 0, 2, 2, 2};
  const IndexMap map = same_regions(before, 3, after, 3);
  EXPECT_EQ(map.to_new, (std::vector{1, 0, 2}));
  // One that was divided stays in its greater part; the other part is new.
  EXPECT_EQ(same_regions({0, 0, 0}, 1, {1, 0, 0}, 2).to_old, (std::vector{0, -1}));
}

}  // namespace
}  // namespace planewright
