#include "core/cluster/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/cluster/region_shape.h"
#include "support/clusters.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

using namespace test;

// Disks with three corners or more, every corner where it has to be, the panels a surface like the mesh.
void expect_panels(const FaceGraph& graph, const Regions& regions) {
  const int count = regions.count();
  ASSERT_TRUE(clustering_of(graph, regions.region_of_face, {}));
  const Polygons faces = faces_of_regions(regions.region_of_face, count);
  ASSERT_EQ(faces.size(), count);
  ASSERT_EQ(regions.corners_of_region.size(), count);
  ASSERT_EQ(regions.regions_of_corner.size(), static_cast<int>(regions.corner_vertex.size()));
  RegionShapes shapes(graph, regions.region_of_face);
  std::vector<std::set<int>> regions_of(regions.corner_vertex.size());
  std::map<std::pair<int, int>, int> steps;
  for (int r = 0; r < count; ++r) {
    const RegionShape shape = shapes.of(faces[r]);
    EXPECT_TRUE(shape.disk()) << r;
    EXPECT_LT(shape.touching, 0) << r;
    const auto corners = regions.corners_of_region[r];
    ASSERT_GE(corners.size(), 3u) << r;
    // In the order of the outline, which has the region on its left.
    size_t next = 0;
    for (const int c : shape.loops.front()) {
      if (next < corners.size() && graph.tail(c) == regions.corner_vertex[corners[next]])
        ++next;
      else
        EXPECT_FALSE(shapes.is_corner(graph.tail(c)));
    }
    EXPECT_EQ(next, corners.size()) << r;
    for (size_t k = 0; k < corners.size(); ++k) {
      EXPECT_TRUE(regions_of[corners[k]].insert(r).second);
      ++steps[{corners[k], corners[(k + 1) % corners.size()]}];
    }
  }
  for (size_t c = 0; c < regions_of.size(); ++c) {
    const auto listed = regions.regions_of_corner[static_cast<int>(c)];
    EXPECT_EQ(std::set<int>(listed.begin(), listed.end()), regions_of[c]);
    EXPECT_TRUE(std::is_sorted(listed.begin(), listed.end()));
    EXPECT_GE(listed.size(), graph.on_border[regions.corner_vertex[c]] ? 1u : 3u);
  }
  EXPECT_EQ(regions.euler_after, regions.euler_before);
  // As polygons they are a manifold mesh again.
  if (std::all_of(steps.begin(), steps.end(), [](const auto& s) { return s.second == 1; })) {
    Points points(static_cast<Eigen::Index>(regions.corner_vertex.size()), 3);
    for (size_t c = 0; c < regions.corner_vertex.size(); ++c)
      points.row(static_cast<Eigen::Index>(c)) = graph.vertices.row(regions.corner_vertex[c]);
    const auto mesh = PolygonMesh::from_polygons(points, regions.corners_of_region);
    EXPECT_TRUE(mesh) << mesh.error().text();
  } else {
    ADD_FAILURE() << "two edges of panels join the same two corners";
  }
}

Regions made(const FaceGraph& graph, std::vector<int> labels) {
  const auto regions = make_regions(graph, clustering_of(graph, std::move(labels), {}).value());
  EXPECT_TRUE(regions) << regions.error().text();
  return *regions;
}

bool has(const Regions& regions, RepairKind kind) {
  return std::any_of(regions.repairs.begin(), regions.repairs.end(),
                     [&](const RegionRepair& r) { return r.kind == kind && !describe(r).empty(); });
}

TEST(Regions, LeaveGoodOnesAsTheyAre) {
  const FaceGraph graph = graph_of(grid(4, 4).mesh());
  std::vector<int> quarters;
  for (int f = 0; f < 16; ++f) quarters.push_back((f / 8) * 2 + f % 4 / 2);
  const Regions regions = made(graph, quarters);
  EXPECT_EQ(regions.region_of_face, quarters);
  EXPECT_TRUE(regions.repairs.empty());
  // The middle, the middles of the sides, and the corners of the sheet as anchors.
  EXPECT_EQ(regions.corner_vertex, (std::vector{0, 2, 4, 10, 12, 14, 20, 22, 24}));
  for (int r = 0; r < 4; ++r) EXPECT_EQ(regions.corners_of_region.valence(r), 4);
  EXPECT_EQ(regions.corners_by_valence(), (std::map<int, int>{{1, 4}, {2, 4}, {4, 1}}));
  EXPECT_EQ(regions.euler_before, 1);
  expect_panels(graph, regions);
}

TEST(Regions, ASheetOfOneRegionKeepsItsOutline) {
  const FaceGraph graph = graph_of(grid(6, 3).mesh());
  const Regions regions = made(graph, std::vector<int>(18, 0));
  EXPECT_EQ(regions.count(), 1);
  EXPECT_EQ(regions.corner_vertex, (std::vector{0, 6, 21, 27}));
  expect_panels(graph, regions);
  // A round one gets as many corners as the tolerance asks for.
  const FaceGraph round = graph_of(fan(64).mesh());
  const Clustering one = clustering_of(round, std::vector<int>(64, 0), {}).value();
  size_t before = 0;
  for (const double tolerance : {0.5, 0.1, 0.02}) {
    RegionOptions options;
    options.border_tolerance = tolerance;
    const Regions disk = make_regions(round, one, options).value();
    expect_panels(round, disk);
    EXPECT_GT(disk.corner_vertex.size(), before);
    before = disk.corner_vertex.size();
  }
}

TEST(Regions, SplitARingRoundItsHole) {
  // A bare island: three sectors round it give it three corners.
  const FaceGraph graph = graph_of(grid(7, 7).mesh());
  std::vector<int> island(49, 0);
  for (const int f : {16, 17, 18, 23, 24, 25, 30, 31, 32}) island[f] = 1;
  const Regions regions = made(graph, island);
  EXPECT_TRUE(has(regions, RepairKind::SplitRing));
  EXPECT_EQ(regions.count(), 4);
  EXPECT_EQ(regions.corners_of_region.valence(1), 3);
  expect_panels(graph, regions);
}

TEST(Regions, SplitAHoleOfTheMesh) {
  Shape shape = grid(7, 7), holed{shape.positions, {}};
  for (int f = 0; f < 49; ++f)
    if (f != 24) holed.faces.push_back(shape.faces[f]);
  const FaceGraph graph = graph_of(holed.mesh());
  const Regions regions = made(graph, std::vector<int>(48, 0));
  EXPECT_EQ(regions.euler_before, 0);
  EXPECT_TRUE(has(regions, RepairKind::SplitRing));
  expect_panels(graph, regions);
}

TEST(Regions, SplitClosedModelsIntoFourAtLeast) {
  const FaceGraph graph = graph_of(sphere(8).mesh());
  std::vector<int> halves;
  for (int f = 0; f < graph.face_count(); ++f) halves.push_back(graph.shapes[f].centre.z() > 0.0 ? 1 : 0);
  const Regions two = made(graph, halves);
  EXPECT_EQ(two.count(), 4);
  EXPECT_TRUE(has(two, RepairKind::SplitFewCorners));
  expect_panels(graph, two);
  const Regions one = made(graph, std::vector<int>(halves.size(), 0));
  EXPECT_GE(one.count(), 4);
  EXPECT_LE(one.count(), 6);
  expect_panels(graph, one);
  const FaceGraph ring = graph_of(make_torus(12, 18));
  const Regions torus = made(ring, std::vector<int>(432, 0));
  EXPECT_EQ(torus.euler_after, 0);
  expect_panels(ring, torus);
}

TEST(Regions, SplitAWedgeWithTwoCorners) {
  // Regions 1 and 2 make a lens between the halves of the sheet; the lens is one region first.
  const FaceGraph graph = graph_of(grid(8, 8).mesh());
  std::vector<int> labels;
  for (int f = 0; f < 64; ++f) {
    const int x = f % 8, y = f / 8;
    labels.push_back((y == 3 || y == 4) && x >= 2 && x < 6 ? 2 : y < 4 ? 0 : 1);
  }
  const Regions regions = made(graph, labels);
  EXPECT_EQ(regions.count(), 4);
  EXPECT_TRUE(has(regions, RepairKind::SplitFewCorners));
  expect_panels(graph, regions);
}

TEST(Regions, ASingleFaceWithTwoCornersIsTakenIn) {
  const FaceGraph graph = graph_of(grid(6, 6).mesh());
  std::vector<int> labels;
  for (int f = 0; f < 36; ++f) labels.push_back(f / 6 < 3 ? 0 : 1);
  labels[14] = 2;  // beside the border between the two: corners at two of its vertices
  const Regions regions = made(graph, labels);
  EXPECT_TRUE(has(regions, RepairKind::MergedFewCorners));
  EXPECT_EQ(regions.count(), 2);
  expect_panels(graph, regions);
}

TEST(Regions, MendAVertexWhereARegionTouchesItself) {
  // Two arms of region 1 meet at a vertex, round region 2.
  const FaceGraph graph = graph_of(grid(6, 6).mesh());
  std::vector<int> arms(36, 0);
  for (const int f : {7, 8, 9, 13, 15, 19, 20}) arms[f] = 1;
  arms[14] = 2;
  const Regions regions = made(graph, arms);
  EXPECT_FALSE(regions.repairs.empty());
  expect_panels(graph, regions);
}

TEST(Regions, GiveASmallTouchToANeighbour) {
  // Region 0 reaches round face (3, 2) and meets itself at one of its vertices; a face of it will do.
  const FaceGraph graph = graph_of(grid(6, 6).mesh());
  std::vector<int> labels;
  for (int f = 0; f < 36; ++f) labels.push_back(f % 6 < 3 ? 0 : f / 6 < 3 ? 1 : 2);
  for (const auto& [x, y] : {std::pair(3, 1), {3, 3}, {4, 3}, {4, 2}}) labels[6 * y + x] = 0;
  labels[6 * 2 + 3] = 3;
  const Regions regions = made(graph, labels);
  EXPECT_TRUE(has(regions, RepairKind::MovedFaces));
  expect_panels(graph, regions);
}

TEST(Regions, EverythingThatClusteringMakesBecomesPanels) {
  const PolygonMesh meshes[] = {make_sample("dome", 300).value(),
                                make_sample("alpine-hut", 500).value(),
                                make_torus(24, 36),
                                make_sample("train-station", 600).value(),
                                sphere(10).mesh(),
                                make_sample("twisted-roof", 300).value(),
                                make_sample("vault", 300).value(),
                                cube().mesh()};
  for (const PolygonMesh& mesh : meshes) {
    const FaceGraph graph = graph_of(mesh);
    for (const int panels : {1, 2, 3, 5, 8, 13, 30, 60, 150, mesh.face_count()})
      for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random}) {
        if (panels > mesh.face_count()) continue;
        SCOPED_TRACE(std::to_string(mesh.face_count()) + " faces, " + std::to_string(panels) + " panels");
        ClusterOptions options;
        options.panels = panels;
        options.seeds = seeds;
        options.iterations = panels % 2 ? 30 : 0;  // and as ragged as seeds alone leave them
        options.teleports = panels % 2 ? 10 : 0;
        const auto regions = make_regions(graph, cluster(graph, options).value());
        ASSERT_TRUE(regions) << regions.error().text();
        expect_panels(graph, *regions);
      }
  }
}

TEST(Regions, RandomLabelsBecomePanelsOrAreRefused) {
  // Ragged on purpose: regions grown face by face at random.
  const FaceGraph graph = graph_of(make_torus(14, 20));
  std::mt19937 random(7);
  for (int run = 0; run < 40; ++run) {
    const int count = 1 + static_cast<int>(random() % 40);
    std::vector<int> labels(static_cast<size_t>(graph.face_count()), -1), front;
    for (int r = 0; r < count; ++r) {
      int f;
      do f = static_cast<int>(random() % labels.size());
      while (labels[f] >= 0);
      labels[f] = r;
      front.push_back(f);
    }
    while (!front.empty()) {
      const size_t k = random() % front.size();
      const int f = front[k];
      std::vector<int> free;
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c)
        if (labels[graph.beside[c]] < 0) free.push_back(graph.beside[c]);
      if (free.empty()) {
        front.erase(front.begin() + static_cast<std::ptrdiff_t>(k));
        continue;
      }
      const int g = free[random() % free.size()];
      labels[g] = labels[f];
      front.push_back(g);
    }
    const auto regions = make_regions(graph, clustering_of(graph, labels, {}).value());
    ASSERT_TRUE(regions) << run << ": " << regions.error().text();
    expect_panels(graph, *regions);
  }
}

TEST(Regions, RefuseWhatIsNotTheirs) {
  const FaceGraph graph = graph_of(grid(3, 3).mesh());
  Clustering clustering = clustering_of(graph, std::vector<int>(9, 0), {}).value();
  RegionOptions options;
  options.border_tolerance = 0.0;
  EXPECT_FALSE(make_regions(graph, clustering, options));
  options.border_tolerance = NAN;
  EXPECT_FALSE(make_regions(graph, clustering, options));
  clustering.region_of_face.pop_back();
  EXPECT_FALSE(make_regions(graph, clustering));
}

TEST(Regions, NastyMeshesAreTakenOrRefused) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const auto& entry : std::filesystem::directory_iterator(folder / "nasty")) {
    const auto loaded = load_mesh(entry.path());
    if (!loaded) continue;
    const auto graph = FaceGraph::create(loaded->mesh);
    if (!graph) continue;
    for (const int more : {0, 3, 40}) {
      SCOPED_TRACE(entry.path().filename().string() + " in " + std::to_string(more));
      ClusterOptions options;
      options.panels = std::min(graph->component_count() + more, graph->face_count());
      const auto clustering = cluster(*graph, options);
      ASSERT_TRUE(clustering) << clustering.error().text();
      const auto regions = make_regions(*graph, *clustering);
      if (regions)
        expect_panels(*graph, *regions);
      else
        EXPECT_FALSE(regions.error().where.empty() || regions.error().remedy.empty());
    }
  }
}

TEST(Regions, TakeRealMeshes) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const char* file :
       {"tri/bunny1k.obj", "tri/fertility.off", "tri/feline.obj", "tri/train-station.off",
        "tri/aqua-center.off", "tri/two_spheres.obj", "poly/suzanne.obj", "quad/six.off"}) {
    const FaceGraph graph = graph_of(load_mesh(folder / file)->mesh);
    for (const int panels : {8, 50, 200, 500}) {
      SCOPED_TRACE(std::string(file) + " in " + std::to_string(panels));
      if (panels > graph.face_count()) continue;
      ClusterOptions options;
      options.panels = panels;
      const auto regions = make_regions(graph, cluster(graph, options).value());
      ASSERT_TRUE(regions) << regions.error().text();
      expect_panels(graph, *regions);
      // Repairs are the exception; thin limbs in few panels need many.
      if (panels >= 200) {
        EXPECT_LT(regions->count(), panels * 5 / 4);
      }
    }
  }
}

}  // namespace
}  // namespace planewright
