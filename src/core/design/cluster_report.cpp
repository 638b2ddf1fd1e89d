#include "core/design/cluster_report.h"

#include "core/cluster/anchor_polygons.h"

namespace planewright {
namespace {

std::optional<TwoSidedDistance> if_measured(const Result<TwoSidedDistance>& distance) {
  return distance ? std::optional(*distance) : std::nullopt;
}

}  // namespace

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
