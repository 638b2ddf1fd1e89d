#include "core/cluster/clustering.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>
#include <random>

#include "support/clusters.h"
#include "support/shared_meshes.h"

namespace planewright {
namespace {

using namespace test;

ClusterOptions options(int panels, ClusterMetric metric = {}, SeedKind seeds = SeedKind::Farthest) {
  ClusterOptions o;
  o.panels = panels;
  o.metric = metric;
  o.seeds = seeds;
  return o;
}

struct Listener final : ClusterObserver {
  void on_iteration(const ClusterProgress& progress) override {
    EXPECT_EQ(progress.iteration, static_cast<int>(errors.size()) + 1);
    errors.push_back(progress.error);
    if (stop_after == static_cast<int>(errors.size())) source.request_stop();
  }
  std::vector<double> errors;
  int stop_after = 0;
  std::stop_source source;
};

TEST(Clustering, CoversEveryMeshWithConnectedRegions) {
  const PolygonMesh meshes[] = {make_sample("dome", 300).value(),
                                make_sample("alpine-hut", 400).value(),
                                make_torus(20, 30),
                                make_sample("twisted-roof", 200).value(),
                                cube().mesh(),
                                sphere(6).mesh()};
  for (const PolygonMesh& mesh : meshes) {
    const FaceGraph graph = graph_of(mesh);
    for (const int panels : {1, 4, 6, 25, 120})
      for (const ClusterMetric& metric :
           {ClusterMetric{}, ClusterMetric::l21(), ClusterMetric::l2(), ClusterMetric{0.5, 2.0, 0.2}})
        for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random}) {
          if (panels > mesh.face_count()) continue;
          const auto clustering = cluster(graph, options(panels, metric, seeds));
          ASSERT_TRUE(clustering) << clustering.error().text();
          EXPECT_EQ(clustering->regions(), panels);
          expect_whole(graph, *clustering, metric);
        }
  }
}

TEST(Clustering, FindsTheFacesOfACube) {
  // Each side cut into 5 x 5 quads: six regions without error, whatever the seeds.
  Shape shape;
  std::vector<Vector3d> points;
  const Shape base = cube();
  for (int f = 0; f < 6; ++f) {
    const auto q = base.faces[f];
    const Vector3d o = base.positions.row(q[0]), u = base.positions.row(q[1]).transpose() - o,
                   v = base.positions.row(q[3]).transpose() - o;
    const auto at = [&](int i, int j) {
      const Vector3d p = o + u * i / 5.0 + v * j / 5.0;
      for (size_t k = 0; k < points.size(); ++k)
        if ((points[k] - p).norm() < 1e-9) return static_cast<int>(k);
      points.push_back(p);
      return static_cast<int>(points.size()) - 1;
    };
    for (int i = 0; i < 5; ++i)
      for (int j = 0; j < 5; ++j)
        shape.faces.push_back(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  }
  shape.positions.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (size_t k = 0; k < points.size(); ++k) shape.positions.row(static_cast<Eigen::Index>(k)) = points[k];
  const FaceGraph graph = graph_of(shape.mesh());
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    ClusterOptions o = options(6, ClusterMetric::l21(), SeedKind::Random);
    o.seed_number = seed;
    const Clustering clustering = cluster(graph, o).value();
    EXPECT_LT(clustering.error, 1e-12) << seed;
    for (int f = 0; f < 150; ++f)
      EXPECT_EQ(clustering.region_of_face[f], clustering.region_of_face[f / 25 * 25]) << seed;
  }
}

TEST(Clustering, ErrorsFallFromIterationToIteration) {
  const FaceGraph graph = graph_of(make_torus(30, 40));
  for (const ClusterMetric& metric : {ClusterMetric{}, ClusterMetric::l21(), ClusterMetric::l2()})
    for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random}) {
      Listener listener;
      ClusterOptions o = options(40, metric, seeds);
      const Clustering clustering = cluster(graph, o, &listener).value();
      EXPECT_GE(listener.errors.size(), 3u);
      EXPECT_EQ(clustering.iterations, static_cast<int>(listener.errors.size()));
      for (size_t k = 1; k < listener.errors.size(); ++k)
        EXPECT_LT(listener.errors[k], listener.errors[k - 1]);
      EXPECT_NEAR(listener.errors.back(), clustering.error, 1e-12);
    }
}

TEST(Clustering, TeleportsLeaveBadMinima) {
  const FaceGraph graph = graph_of(make_sample("alpine-hut", 900).value());
  ClusterOptions o = options(30, ClusterMetric::l21(), SeedKind::Given);
  for (int f = 0; f < 30; ++f) o.given.push_back(f);  // all in one corner of the roof
  o.teleports = 0;
  const Clustering without = cluster(graph, o).value();
  o.teleports = 60;
  const Clustering with = cluster(graph, o).value();
  EXPECT_EQ(without.teleports, 0);
  EXPECT_GT(with.teleports, 0);
  EXPECT_LT(with.error, without.error);
  EXPECT_EQ(with.regions(), 30);
}

TEST(Clustering, SameInputSameBits) {
  const FaceGraph graph = graph_of(make_torus(25, 30));
  for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random}) {
    const Clustering a = cluster(graph, options(37, {}, seeds)).value();
    const Clustering b = cluster(graph_of(make_torus(25, 30)), options(37, {}, seeds)).value();
    EXPECT_EQ(a.region_of_face, b.region_of_face);
    EXPECT_EQ(a.error, b.error);
  }
  ClusterOptions other = options(37, {}, SeedKind::Random);
  other.seed_number = 2;
  EXPECT_NE(cluster(graph, other)->region_of_face,
            cluster(graph, options(37, {}, SeedKind::Random))->region_of_face);
}

TEST(Clustering, ScaleAndPlaceChangeNothing) {
  const PolygonMesh mesh = make_sample("saddle", 400).value();
  const FaceGraph graph = graph_of(mesh);
  for (const ClusterMetric& metric : {ClusterMetric{}, ClusterMetric::l2(), ClusterMetric{1.0, 3.0, 0.3}}) {
    const Clustering plain = cluster(graph, options(24, metric)).value();
    // By powers of 2, which round nothing: the same regions.
    for (const double scale : {1.0 / 1024, 4096.0}) {
      const FaceGraph scaled =
          graph_of(PolygonMesh::from_polygons(mesh.positions() * scale, mesh.faces()).value());
      const Clustering clustering = cluster(scaled, options(24, metric)).value();
      EXPECT_EQ(clustering.region_of_face, plain.region_of_face);
      EXPECT_NEAR(clustering.error, plain.error, 1e-13);
    }
    // Turned, moved and scaled by any number: as good, up to what rounding decides.
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    Points moved = mesh.positions() * turn.transpose() * 3.7;
    moved.rowwise() += Eigen::RowVector3d(1000, 2000, -500);
    const FaceGraph other = graph_of(PolygonMesh::from_polygons(moved, mesh.faces()).value());
    // The same regions have the same error there.
    EXPECT_NEAR(clustering_of(other, plain.region_of_face, metric)->error, plain.error, 1e-9);
    EXPECT_NEAR(cluster(other, options(24, metric))->error / plain.error, 1.0, 0.05);
  }
}

TEST(Clustering, OrderOfTheFacesDecidesOnlyTies) {
  const PolygonMesh mesh = make_sample("saddle", 400).value();
  std::vector<int> order(static_cast<size_t>(mesh.face_count()));
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 random(5);
  for (size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[random() % (k + 1)]);
  const Polygons faces = mesh.faces();
  Polygons shuffled;
  for (const int f : order) shuffled.push_back(faces[f]);
  const FaceGraph graph = graph_of(mesh),
                  other = graph_of(PolygonMesh::from_polygons(mesh.positions(), shuffled).value());
  const Clustering a = cluster(graph, options(24)).value(), b = cluster(other, options(24)).value();
  EXPECT_NEAR(b.error / a.error, 1.0, 0.05);
}

TEST(Clustering, GrowsToATargetError) {
  const FaceGraph graph = graph_of(sphere(16).mesh());
  ClusterOptions o = options(400);
  o.target_normal = 0.25;
  const Clustering met = cluster(graph, o).value();
  EXPECT_TRUE(met.target_met);
  EXPECT_LE(met.normal_error, 0.25);
  EXPECT_LT(met.regions(), 100);
  expect_whole(graph, met, o.metric);
  // Hardly fewer would do.
  const Clustering fewer = cluster(graph, options(met.regions() * 4 / 5)).value();
  EXPECT_GT(fewer.normal_error, 0.25);

  o.target_normal.reset();
  o.target_distance = 0.01;
  const Clustering close = cluster(graph, o).value();
  EXPECT_TRUE(close.target_met);
  EXPECT_LE(close.distance_error, 0.01);

  o.panels = 7;
  const Clustering not_met = cluster(graph, o).value();
  EXPECT_FALSE(not_met.target_met);
  EXPECT_EQ(not_met.regions(), 7);
}

TEST(Clustering, AWarmStartKeepsMostRegions) {
  const FaceGraph graph = graph_of(make_torus(40, 50));
  const Clustering start = cluster(graph, options(60)).value();
  for (const int panels : {60, 61, 59, 64, 40, 100, 500, 1}) {
    const Clustering next = cluster(graph, options(panels), nullptr, {}, &start).value();
    EXPECT_EQ(next.regions(), panels);
    expect_whole(graph, next, {});
    if (std::abs(panels - 60) > 1) continue;
    int same = 0;
    for (size_t f = 0; f < next.region_of_face.size(); ++f)
      same += next.region_of_face[f] == start.region_of_face[f];
    EXPECT_GT(same, graph.face_count() * 7 / 10) << panels;
    const double fresh = cluster(graph, options(panels))->error;
    EXPECT_LT(next.error, 1.1 * fresh) << panels;
  }
  Clustering foreign = start;
  foreign.region_of_face.pop_back();
  const auto refused = cluster(graph, options(60), nullptr, {}, &foreign);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Usage);
}

TEST(Clustering, StopsWithAWholeClustering) {
  const FaceGraph graph = graph_of(make_torus(30, 40));
  Listener listener;
  listener.stop_after = 2;
  const Clustering stopped = cluster(graph, options(50), &listener, listener.source.get_token()).value();
  EXPECT_TRUE(stopped.stopped);
  EXPECT_EQ(stopped.iterations, 2);
  expect_whole(graph, stopped, {});
  std::stop_source before;
  before.request_stop();
  const Clustering at_once = cluster(graph, options(50), nullptr, before.get_token()).value();
  EXPECT_TRUE(at_once.stopped);
  EXPECT_EQ(at_once.regions(), 50);
  expect_whole(graph, at_once, {});
}

TEST(Clustering, OneRegionForEachFaceIsTheLimit) {
  const FaceGraph graph = graph_of(cube().mesh());
  const Clustering all = cluster(graph, options(6)).value();
  EXPECT_NEAR(all.normal_error, 0.0, 1e-12);
  const auto more = cluster(graph, options(7));
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().code, ErrorCode::Usage);
  EXPECT_NE(more.error().text().find("7 panels"), std::string::npos) << more.error().text();
  EXPECT_NE(more.error().text().find("6 faces"), std::string::npos) << more.error().text();
  EXPECT_FALSE(cluster(graph, options(0)));
  EXPECT_FALSE(cluster(graph, options(-3)));
}

TEST(Clustering, EverySeparatePartGetsARegion) {
  const FaceGraph graph =
      graph_of(both(both(sphere(4), grid(3, 3), {5, 0, 0}), tetrahedron(), {0, 9, 0}).mesh());
  const auto few = cluster(graph, options(2));
  ASSERT_FALSE(few);
  EXPECT_NE(few.error().text().find("3 separate parts"), std::string::npos) << few.error().text();
  EXPECT_NE(few.error().text().find("2 panels"), std::string::npos) << few.error().text();
  for (const int panels : {3, 4, 12})
    for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random})
      expect_whole(graph, cluster(graph, options(panels, {}, seeds)).value(), {});
  const Clustering many = cluster(graph, options(12)).value();
  expect_whole(graph, cluster(graph, options(3), nullptr, {}, &many).value(), {});
}

TEST(Clustering, RefusesSeedsThatDoNotFit) {
  const FaceGraph graph = graph_of(both(grid(3, 3), grid(2, 2), {9, 0, 0}).mesh());
  ClusterOptions o = options(3, {}, SeedKind::Given);
  for (const auto& [given, word] :
       std::vector<std::pair<std::vector<int>, std::string>>{{{1, 2}, "2 seed faces for 3 panels"},
                                                             {{1, 2, 13}, "no face 13"},
                                                             {{1, 2, -1}, "no face -1"},
                                                             {{1, 1, 10}, "twice"},
                                                             {{1, 2, 3}, "face 9 has no seed"}}) {
    o.given = given;
    const auto refused = cluster(graph, o);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find(word), std::string::npos) << refused.error().text();
  }
  o.given = {1, 5, 10};
  expect_whole(graph, cluster(graph, o).value(), {});
  o.target_normal = -1.0;
  EXPECT_FALSE(cluster(graph, o));
}

TEST(Clustering, NamesWhatIsWrongWithLabels) {
  const FaceGraph graph = graph_of(grid(3, 1).mesh());
  EXPECT_TRUE(clustering_of(graph, {0, 0, 1}, {}));
  for (const auto& [labels, word] :
       std::vector<std::pair<std::vector<int>, std::string>>{{{0, 1, 0}, "not connected"},
                                                             {{0, 0}, "2 numbers"},
                                                             {{0, 0, 2}, "no face"},
                                                             {{0, -1, 0}, "no region"},
                                                             {{0, 0, 77}, "no region 77"}}) {
    const auto refused = clustering_of(graph, labels, {});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find(word), std::string::npos) << refused.error().text();
  }
}

TEST(Clustering, FacesWithoutAreaBelongSomewhere) {
  Shape shape = triangle_grid(6, 6);
  shape.positions.row(24) = shape.positions.row(25);  // two faces shrink to nothing
  const FaceGraph graph = graph_of(shape.mesh());
  for (const SeedKind seeds : {SeedKind::Farthest, SeedKind::Random})
    for (const int panels : {1, 5, 30, 72})
      expect_whole(graph, cluster(graph, options(panels, {}, seeds)).value(), {});
}

TEST(Clustering, TakesRealMeshes) {
  PLANEWRIGHT_SHARED_MESHES_OR_SKIP(folder);
  for (const char* file :
       {"tri/bunny1k.obj", "tri/train-station.off", "tri/two_spheres.obj", "poly/suzanne.obj"}) {
    SCOPED_TRACE(file);
    const FaceGraph graph = graph_of(load_mesh(folder / file)->mesh);
    double before = 1e9;
    for (const int panels : {50, 200}) {
      const Clustering clustering = cluster(graph, options(panels)).value();
      expect_whole(graph, clustering, {});
      EXPECT_LT(clustering.error, before);
      before = clustering.error;
    }
  }
}

}  // namespace
}  // namespace planewright
