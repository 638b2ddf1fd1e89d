// Crossings: pairs of triangles of two surfaces that penetrate each other, found by exact predicates,
// independent of what a solver believes.
//
// Panels are cut into triangles (mesh/triangulate.h); boxes that overlap are found by a hierarchy, triangles
// that intersect by CGAL's exact predicates. A pair counts only if it has to move by more than `touch` to
// come apart, so touching within a margin is none. Units: model units, both surfaces in one frame. Threads:
// pure.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

struct Surface {
  const Points& points;
  const Polygons& polygons;
};

struct Crossing {
  int first, second;  // polygons of the first and the second surface
  double depth;       // smallest move that parts the two triangles that overlap most, model units
  Vector3d apart;     // unit: direction in which `first` has to move for that
};

// Pairs of polygons (first.polygons, second.polygons) that penetrate each other by more than `touch`; one
// entry a pair, ascending.
std::vector<Crossing> find_crossings(const Surface& first, const Surface& second, double touch);

// The same within one surface, first < second. Polygons that share points are compared only in what lies
// off the shared points.
std::vector<Crossing> find_crossings_within(const Surface& surface, double touch);

}  // namespace planewright
