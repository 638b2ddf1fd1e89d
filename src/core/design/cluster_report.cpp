#include "core/design/cluster_report.h"

#include <utility>

#include "core/cluster/anchor_polygons.h"

namespace planewright {
namespace {

std::optional<TwoSidedDistance> if_measured(const Result<TwoSidedDistance>& distance) {
  return distance ? std::optional(*distance) : std::nullopt;
}

Result<std::shared_ptr<const ClusteredMesh>> with_regions(const FaceGraph& graph, ClusteredMesh clustered) {
  RegionOptions options;
  options.metric = clustered.options.metric;
  auto regions = make_regions(graph, clustered.clustering, options);
  if (!regions) return tl::unexpected(regions.error());
  clustered.regions = std::move(*regions);
  return std::make_shared<const ClusteredMesh>(std::move(clustered));
}

}  // namespace

Result<std::shared_ptr<const ClusteredMesh>> cluster_mesh(std::shared_ptr<const PolygonMesh> mesh,
                                                          const ClusterOptions& options,
                                                          ClusterObserver* observer, std::stop_token stop) {
  const auto graph = FaceGraph::create(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  auto clustering = cluster(*graph, options, observer, std::move(stop));
  if (!clustering) return tl::unexpected(clustering.error());
  return with_regions(*graph, {std::move(mesh), options, false, std::move(*clustering), {}});
}

Result<std::shared_ptr<const ClusteredMesh>> mesh_of_regions(std::shared_ptr<const PolygonMesh> mesh,
                                                             std::vector<int> region_of_face,
                                                             const ClusterMetric& metric) {
  const auto graph = FaceGraph::create(*mesh);
  if (!graph) return tl::unexpected(graph.error());
  auto clustering = clustering_of(*graph, std::move(region_of_face), metric);
  if (!clustering) return tl::unexpected(clustering.error());
  ClusterOptions options;
  options.panels = clustering->regions();
  options.metric = metric;
  return with_regions(*graph, {std::move(mesh), options, true, std::move(*clustering), {}});
}

ClusterReport measure_clusters(const ClusteredMesh& clustered, const Panels& panels) {
  const Regions& regions = clustered.regions;
  const PolygonMesh& mesh = *clustered.mesh;
  ClusterReport report;
  report.options = clustered.options;
  report.given = clustered.given;
  report.clusters = clustered.clustering.regions();
  report.iterations = clustered.clustering.iterations;
  report.teleports = clustered.clustering.teleports;
  report.target_met = clustered.clustering.target_met;
  report.stopped = clustered.clustering.stopped;
  report.l21 = regions.normal_error * regions.normal_error;
  report.error = regions.error;
  report.distance = regions.distance_error;
  report.repairs = regions.repairs;
  report.euler_before = regions.euler_before;
  report.euler_after = regions.euler_after;
  report.corners_by_valence = regions.corners_by_valence();
  report.panels_to_mesh =
      if_measured(surface_distance(panels.points, panels.polygons, mesh.positions(), mesh.faces()));
  report.anchors_to_mesh = if_measured(surface_distance(
      anchor_points(mesh, regions), regions.corners_of_region, mesh.positions(), mesh.faces()));
  report.acute = find_acute_corners(panels.points, panels.polygons);
  return report;
}

}  // namespace planewright
