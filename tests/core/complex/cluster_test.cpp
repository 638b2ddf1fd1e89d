#include "core/complex/cluster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/complex/mapped_origin.h"
#include "support/clusters.h"
#include "support/complexes.h"

namespace planewright {
namespace {

using namespace test;

Regions regions_of(const PolygonMesh& mesh, int panels) {
  const FaceGraph graph = graph_of(mesh);
  ClusterOptions options;
  options.panels = panels;
  return make_regions(graph, cluster(graph, options).value()).value();
}

TEST(Cluster, PlanesAreProxiesAndPointsAreCorners) {
  for (const auto& mesh : {make_torus(16, 24), make_sample("alpine-hut", 400).value(), sphere(8).mesh()}) {
    const Regions regions = regions_of(mesh, 80);
    const TangentComplex complex = build_cluster(mesh, regions).value();
    EXPECT_EQ(complex.kind, ComplexKind::Cluster);
    ASSERT_EQ(complex.plane_count(), regions.count());
    ASSERT_EQ(complex.point_count(), static_cast<int>(regions.corner_vertex.size()));
    EXPECT_EQ(complex.panels, regions.corners_of_region);
    EXPECT_EQ(complex.planes_of_point, regions.regions_of_corner);
    EXPECT_EQ(complex.region_of_face, regions.region_of_face);
    EXPECT_TRUE(all_finite(complex));
    EXPECT_EQ(complex.offsets, Vector::Zero(regions.count()));
    for (int r = 0; r < regions.count(); ++r) {
      EXPECT_EQ(complex.plane_origin[r], r);
      EXPECT_EQ(complex.normals.row(r), regions.proxies[r].normal.transpose());
      const Vector3d anchor = complex.anchors.row(r).transpose() + complex.origin;
      EXPECT_LT((anchor - regions.proxies[r].centre - regions.origin).norm(), 1e-12);
      // Seen from outside the corners run counter-clockwise.
      EXPECT_GT(newell_vector(complex.preferred, complex.panels[r]).dot(regions.proxies[r].normal), 0.0);
    }
    int moved = 0;
    for (int j = 0; j < complex.point_count(); ++j) {
      EXPECT_EQ(complex.point_origin[j], (PointOrigin{PointKind::Vertex, regions.corner_vertex[j]}));
      const Vector3d wanted = complex.preferred.row(j).transpose() + complex.origin;
      const Vector3d vertex = mesh.positions().row(regions.corner_vertex[j]);
      if (mesh.is_border_vertex(regions.corner_vertex[j])) {
        EXPECT_LT((wanted - vertex).norm(), 1e-12);
        continue;
      }
      // Nearer to its planes than the vertex is, and not far away.
      const auto off_planes = [&](const Vector3d& x) {
        double sum = 0.0;
        for (const int r : regions.regions_of_corner[j]) {
          const Vector3d normal = complex.normals.row(r), anchor = complex.anchors.row(r);
          sum += std::pow(normal.dot(x - complex.origin - anchor), 2);
        }
        return std::sqrt(sum);
      };
      EXPECT_LE(off_planes(wanted), off_planes(vertex) + 1e-12);
      EXPECT_LE((wanted - vertex).norm(), 0.5 * complex.mean_edge);
      moved += (wanted - vertex).norm() > 1e-9;
    }
    EXPECT_GT(moved, complex.point_count() / 4);
    // The panels are a surface like the mesh, with its border.
    EXPECT_EQ(complex.point_count() - static_cast<int>(complex.panel_edges.size()) + complex.plane_count(),
              regions.euler_before);
    for (const PanelEdge& edge : complex.panel_edges) {
      const bool border = mesh.is_border_vertex(complex.point_origin[edge.a].element) &&
                          mesh.is_border_vertex(complex.point_origin[edge.b].element);
      if (edge.border()) {
        EXPECT_TRUE(border);
      }
    }
    EXPECT_EQ(complex.input.faces, mesh.faces());
    EXPECT_EQ(complex.face_of_point.size(), complex.point_origin.size());
    EXPECT_EQ(complex.crossed_edge.size(), complex.panel_edges.size());
  }
}

TEST(Cluster, AnOffsetMovesPlanesAndPoints) {
  const PolygonMesh mesh = sphere(10).mesh();
  const TangentComplex complex = build_cluster(mesh, regions_of(mesh, 40), {0.25}).value();
  EXPECT_EQ(complex.offsets, Vector::Constant(complex.plane_count(), 0.25));
  const TangentComplex on_mesh = build_cluster(mesh, regions_of(mesh, 40)).value();
  for (int j = 0; j < complex.point_count(); ++j)
    EXPECT_NEAR(complex.preferred.row(j).norm(), on_mesh.preferred.row(j).norm() + 0.25, 3e-2);
}

TEST(Cluster, RefusesWhatDoesNotFit) {
  const PolygonMesh mesh = sphere(6).mesh();
  const Regions regions = regions_of(mesh, 12);
  const auto no_number = build_cluster(mesh, regions, {std::numeric_limits<double>::quiet_NaN()});
  ASSERT_FALSE(no_number);
  EXPECT_EQ(no_number.error().code, ErrorCode::Usage);
  const auto other = build_cluster(sphere(5).mesh(), regions);
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::Refused);
}

TEST(Cluster, AStateGoesOnWithTheNextClustering) {
  const PolygonMesh mesh = make_torus(24, 36);
  const FaceGraph graph = graph_of(mesh);
  ClusterOptions options;
  options.panels = 40;
  const Clustering start = cluster(graph, options).value();
  options.panels = 41;
  const Clustering more = cluster(graph, options, nullptr, {}, &start).value();
  const TangentComplex from = build_cluster(mesh, make_regions(graph, start).value()).value(),
                       to = build_cluster(mesh, make_regions(graph, more).value()).value();
  State state = initial_state(from);
  state.x.rowwise() += Eigen::RowVector3d(0, 0, 5);
  state.h += state.n.col(2) * 5.0;  // the same planes, all five higher
  const State next = transfer(from, state, to);
  int taken_over = 0;
  for (int i = 0; i < to.plane_count(); ++i) {
    if (next.h[i] == to.offsets[i]) continue;
    ++taken_over;
    // As high over the new anchor as the old plane is there: near the anchors, which lie in both.
    EXPECT_NEAR(next.h[i], 5.0 * next.n(i, 2), 0.1);
  }
  EXPECT_GT(taken_over, 25);
  // The same complex takes all of itself.
  EXPECT_TRUE(same_bits(transfer(from, state, from).x, state.x));
  EXPECT_TRUE(same_bits(transfer(from, state, from).n, state.n));
  EXPECT_TRUE(plane_origins(identity_map(mesh), ComplexKind::Cluster).to_new.empty());
}

}  // namespace
}  // namespace planewright
