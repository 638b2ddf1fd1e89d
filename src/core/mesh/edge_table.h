// EdgeTable: which corners of a list of polygons share an edge. Internal to this folder.
//
// Corner c is an entry of `faces.indices()`; its edge runs from there to the next corner of the same face.
// Edges are undirected and numbered by their first corner, so the numbering follows the order of the faces.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

struct EdgeTable {
  std::vector<int> face_of_corner;  // #C
  std::vector<int> edge_of_corner;  // #C
  std::vector<int> first;    // #E + 1: edge e has the corners corners[first[e]] .. corners[first[e + 1] - 1]
  std::vector<int> corners;  // #C, increasing inside an edge

  int size() const { return static_cast<int>(first.size()) - 1; }
  int corner_count(int e) const { return first[e + 1] - first[e]; }
  int corner(int e, int k) const { return corners[first[e] + k]; }
};

// Precondition: every index is inside 0..vertex_count-1, every face has at least 3 distinct corners. O(C log
// C).
EdgeTable build_edge_table(const Polygons& faces, int vertex_count);

// Numbers the edges anew: edge e is the one that edges[e] names by its ends, and begins with the corner that
// runs that way. Returns -1, or, with the table unchanged, the first e that is no edge of the faces in that
// direction or stands there twice. Precondition: edges.size() == table.size().
int renumber(EdgeTable& table, const Polygons& faces, std::span<const std::array<int, 2>> edges);

// The corner after, or before, corner c in its face f.
inline int next_corner(const Polygons& faces, int f, int c) {
  return c + 1 == faces.offsets()[f + 1] ? faces.offsets()[f] : c + 1;
}
inline int previous_corner(const Polygons& faces, int f, int c) {
  return c == faces.offsets()[f] ? faces.offsets()[f + 1] - 1 : c - 1;
}

}  // namespace planewright
