// Patch: the rings of a mesh round an edit as a mesh of their own, so that what an edit does there can be
// solved in milliseconds.
//
// Rings are counted in edges from the centre's vertices. A patch has every face with a vertex at most
// `radius` + 1 edges away: the fans of all vertices that a free plane's points meet are then complete, and
// what is built for them is what is built for the whole. Indices 0-based. Threads: pure.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/mesh/element_map.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct Patch {
  PolygonMesh mesh;
  ElementMap from_whole;   // old: of the whole mesh, new: of the patch
  std::vector<int> rings;  // per vertex of the patch, edges from the centre
  int radius = 0;
};

// centre: vertices, at least one. Where the faces of a ring would meet in a vertex alone, the faces between
// are taken too. O(patch), but for the maps, which are as long as the mesh.
Result<Patch> cut_patch(const PolygonMesh& mesh, const std::vector<int>& centre, int radius);

}  // namespace planewright
