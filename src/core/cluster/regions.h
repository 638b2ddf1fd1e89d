// Regions: a clustering made ready for panels. Every region is a disk with one outline, three corners or
// more, and touches itself nowhere; what had to be repaired for that is told.
//
// A corner is a mesh vertex where three regions or more meet, or two at the border; on the border also
// anchors (Cohen-Steiner et al. 2004, section 4), where the outline would stray too far from the chord
// between the corners beside it, so that the mesh's outline survives.
//
// Invariants: region_of_face is 0..K-1; each region has at least three corners, counter-clockwise seen from
// outside; a corner is in the list of each of its regions, and only there. Units: model units, relative to
// `origin`. Indices: 0-based, vertices and faces are the mesh's. Threads: plain data.
#pragma once

#include <map>
#include <vector>

#include "core/cluster/clustering.h"
#include "core/cluster/region_repair.h"

namespace planewright {

struct RegionOptions {
  ClusterMetric metric;  // of the proxies after repairs
  // How far the border may stray from the chord between its corners, in mean panel sizes (the square root of
  // area / K).
  double border_tolerance = 0.1;
};

struct Regions {
  std::vector<int> region_of_face;     // #F
  Vector3d origin = Vector3d::Zero();  // model coordinates of the local 0
  std::vector<Proxy> proxies;          // #K, centres in model units relative to origin
  std::vector<int> corner_vertex;      // #C mesh vertices, ascending
  Polygons regions_of_corner;          // #C lists, ascending
  Polygons corners_of_region;          // #K lists of corners
  std::vector<RegionRepair> repairs;
  int euler_before = 0, euler_after = 0;  // V - E + F of the mesh, and of the panels
  // Of the regions as they are after the repairs, as Clustering tells them.
  double error = 0.0, normal_error = 0.0, distance_error = 0.0;

  int count() const { return static_cast<int>(proxies.size()); }
  // Corners by the number of their regions.
  std::map<int, int> corners_by_valence() const;
};

// Refused: a clustering of another mesh, a tolerance that is not positive, regions that no repair makes
// panels of (see repair_regions()).
Result<Regions> make_regions(const FaceGraph& graph, const Clustering& clustering,
                             const RegionOptions& options = {});

}  // namespace planewright
