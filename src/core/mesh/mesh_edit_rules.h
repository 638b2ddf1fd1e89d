// What mesh edits do to their neighbourhood, shared by their checks and by the edits themselves. Internal to
// this folder.
#pragma once

#include <vector>

#include "core/mesh/polygon_mesh.h"

namespace planewright {

// The corner of a triangle that is not an end of its edge.
int opposite_corner(const PolygonMesh& mesh, int triangle, const MeshEdge& edge);

// Which end of an edge outlives its collapse.
struct Collapsed {
  int survivor, gone;
  bool keeps_place;  // the survivor alone is on the border and stays where it is
};
Collapsed collapsed_ends(const PolygonMesh& mesh, const MeshEdge& edge);

}  // namespace planewright
