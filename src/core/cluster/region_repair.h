// Repair of regions that cannot be panels: a panel is a disk whose outline touches itself nowhere and has
// three corners or more.
//
//   closed rings, holes, handles   split, round a hole in sectors that begin at it
//   touches itself at a vertex     the faces there go to a neighbour if both stay disks, else it is split
//   there fewer than three corners       split between the two it has, or merged if it is a single face. A
//   region on
//                                  the border needs none of that: extra corners on the border will do
//   two borders between the same   one of the regions is split, so that no two edges of panels join the same
//   two corners                    two corners
//
// Indices: 0-based. Threads: pure, deterministic.
#pragma once

#include <string>
#include <vector>

#include "core/cluster/face_graph.h"
#include "core/cluster/proxy.h"

namespace planewright {

enum class RepairKind {
  SplitRing,
  SplitTouching,
  MovedFaces,
  SplitFewCorners,
  SplitForNeighbour,
  MergedFewCorners,
  SplitSharedEnds
};

struct RegionRepair {
  RepairKind kind;
  int region;  // final number of the repaired one, or of what it was merged into
  int other;   // final number of the new region, or of that which took faces; region itself after a merge
  int faces;   // that changed their region
};
// "Region 4 was closed to a ring or had a hole: split, the new part is region 12 (31 faces)"
std::string describe(const RegionRepair& repair);

// region_of_face: 0..count-1, each region connected and not empty; is changed, numbers stay dense. Refused
// (ErrorCode::Refused): no repair leads to panels, naming the region; a mesh of few faces, or with vertices
// of valence 2.
Result<std::vector<RegionRepair>> repair_regions(const FaceGraph& graph, std::vector<int>& region_of_face,
                                                 int& count, const ClusterMetric& metric);

}  // namespace planewright
