// What a clustering and the panels made of it are worth: how far they are from the mesh, what was repaired,
// and which panels are hard to build.
//
// Units: model units unless a name says otherwise. Indices: 0-based. Threads: plain data, pure functions.
#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/cluster/surface_distance.h"
#include "core/complex/state.h"
#include "core/design/clustered_mesh.h"
#include "core/diagnose/panel_angles.h"

namespace planewright {

struct ClusterReport {
  ClusterOptions options;
  bool given = false;  // as of ClusteredMesh
  int clusters = 0;    // before the repairs
  int iterations = 0, teleports = 0;
  bool target_met = true;
  bool stopped = false;  // the clustering, before it was done
  // Of the regions after the repairs. l21: the integral of |n_T - n|^2 over the mesh, as a share of its area;
  // error: by the metric; distance: rms of (x - c) . n, as a share of the square root of the area.
  double l21 = 0.0, error = 0.0, distance = 0.0;
  std::vector<RegionRepair> repairs;
  int euler_before = 0, euler_after = 0;
  std::map<int, int> corners_by_valence;
  // First: the panels, second: the mesh; and the same of the anchor polygons. None: a surface that cannot be
  // measured.
  std::optional<TwoSidedDistance> panels_to_mesh, anchors_to_mesh;
  std::vector<AcuteCorner> acute;
};
// panels: solved, of a complex of these regions.
ClusterReport measure_clusters(const ClusteredMesh& clustered, const Panels& panels);

}  // namespace planewright
