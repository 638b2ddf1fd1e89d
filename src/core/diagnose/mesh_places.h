// MeshPlaces: which edges of the mesh an element of a complex goes back to, i.e. where an edit of the mesh
// would change it.
//
//   dual        panel edge: the mesh edge that it crosses; panel: the edges at its vertex; point: the edges
//   of
//               its face, or its border edge
//   planarize   panel edge: the same edge of the mesh; panel: the edges of its face; point: those at its
//   vertex
//   cluster     panel edge: the edges between its two regions; panel: those round its region; point: those at
//   its vertex
//
// Edges are ascending indices into InputSurface::edges; none for the outline's corners. The complex has to
// outlive it. Cost of building: linear. Threads: immutable.
#pragma once

#include <compare>
#include <vector>

#include "core/complex/tangent_complex.h"

namespace planewright {

class MeshPlaces {
 public:
  explicit MeshPlaces(const TangentComplex& complex);

  std::vector<int> of_panel_edge(int panel_edge) const;
  std::vector<int> of_panel(int panel) const;
  std::vector<int> of_point(int point) const;
  // The edge that joins two vertices of the mesh; -1: none.
  int find_edge(int a, int b) const;

 private:
  std::vector<int> round_vertex(int v) const;
  std::vector<int> round_face(int f) const;
  std::vector<int> between_regions(int a, int b) const;

  const TangentComplex& complex_;
  std::vector<int> first_;  // #V + 1
  struct Spoke {
    int other, edge;
  };
  std::vector<Spoke> spokes_;  // 2 #E, grouped by vertex, edges ascending
  // Cluster: mesh edges along the outline of a region, each once for either side; ascending.
  struct Outline {
    int region, beside, edge;  // beside: -1 at the border
    auto operator<=>(const Outline&) const = default;
  };
  std::vector<Outline> outlines_;
};

// All of several lists, ascending, each once.
std::vector<int> united(std::vector<int> edges, const std::vector<int>& others);

}  // namespace planewright
