// Crossings: pairs of polygons of two surfaces (or of one) that penetrate each other, found by exact
// predicates, independent of what a solver believes.
//
// Polygons are cut into triangles (mesh/triangulate.h); boxes that overlap are found by Eigen's hierarchy of
// bounding volumes, triangles that intersect by CGAL's exact predicates. The depth of a pair of triangles is
// the length of the smallest translation that parts them: the least overlap of their shadows along the two
// normals and the nine products of their edges (separating axis theorem). A pair counts only if it
// intersects and its depth exceeds `touch`, so touching within a margin is none; with touch = 0 rounding
// (1e-13 of the triangles' size) is still no penetration. Triangles in one plane touch: moving along the
// normal parts them at once. Within one surface that is different, see find_crossings_within.
//
// Triangles without area (three corners on a line) count as the segment they are; those with a coordinate
// that is not finite are left out. Units: model units, both surfaces in one frame, wherever it lies. Indices
// 0-based. Threads: pure.
#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

// A view: both have to outlive the call.
struct Surface {
  const Points& points;      // #N x 3
  const Polygons& polygons;  // at least 3 corners each
};

struct Crossing {
  int first, second;  // polygons of the first and the second surface
  double depth;       // smallest move that parts the two triangles that overlap most, model units
  Vector3d apart;     // unit: direction in which `first` has to move for that
  // Those two triangles, as indices into the points of their surface, in the orientation of their polygon. A
  // plane across `apart` can be put between their corners.
  std::array<int, 3> first_corners, second_corners;
};

// Pairs of polygons (first.polygons, second.polygons) that penetrate each other by more than `touch` >= 0;
// one entry a pair, ascending by (first, second). The surfaces share no points.
std::vector<Crossing> find_crossings(const Surface& first, const Surface& second, double touch);

// The same within one surface, first < second. Contact in shared points and along shared edges is none: with
// one shared corner the opposite edge of one triangle has to meet the other triangle, with a shared edge only
// a fold onto itself is left. Polygons of one surface must not lie on one another either: triangles that lie
// in one plane (each within `touch` of the other's) cross if parting them within that plane takes more than
// `touch`, and depth and apart are then those of that move. A polygon that crosses itself is none
// (diagnose/panel_shape.h finds those).
std::vector<Crossing> find_crossings_within(const Surface& surface, double touch);

}  // namespace planewright
