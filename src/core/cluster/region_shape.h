// RegionShapes: what the outline of a region is like: how many loops, whether it is a disk, where it touches
// itself, how many corners it has. Internal to this folder.
//
// A fan is a run of faces of one region round a vertex. A vertex is a corner where 3 fans meet, or 2 at the
// mesh's border. Half-edges are corners of the FaceGraph, with the region on their left. Indices: 0-based.
// Threads: one thread at a time, for its scratch arrays.
#pragma once

#include <span>
#include <vector>

#include "core/cluster/face_graph.h"

namespace planewright {

struct RegionShape {
  std::vector<std::vector<int>> loops;  // half-edges, each loop counter-clockwise
  int euler = 0;                        // V - E + F, a vertex counted once for each fan
  int touching = -1;                    // a vertex with two of its fans, the first along the loops
  int corners = 0;                      // along all loops
  bool disk() const { return loops.size() == 1 && euler == 1; }
};

class RegionShapes {
 public:
  // region_of_face: #F, is looked at anew by every call.
  RegionShapes(const FaceGraph& graph, const std::vector<int>& region_of_face);

  // faces: all of region_of_face[faces[0]]. O(#faces).
  RegionShape of(std::span<const int> faces);
  // Runs of faces of one region round v; an inner vertex of a region has 1.
  int fans_at(int v) const;
  bool is_corner(int v) const { return fans_at(v) >= (graph_.on_border[v] ? 2 : 3); }
  // Whether half-edge c is on the outline of its face's region.
  bool on_outline(int c) const {
    return graph_.beside[c] < 0 ||
           region_of_face_[graph_.beside[c]] != region_of_face_[graph_.face_of_corner[c]];
  }

 private:
  int next_on_outline(int c) const;

  const FaceGraph& graph_;
  const std::vector<int>& region_of_face_;
  std::vector<int> seen_vertex_, seen_corner_, left_;
  int stamp_ = 0;
};

// The faces of each region, ascending (#K lists).
Polygons faces_of_regions(const std::vector<int>& region_of_face, int count);

}  // namespace planewright
