// Cutting a polygon, planar or not, convex or not, into triangles: for drawing, picking and STL.
//
// Ear clipping in the plane of the Newell normal. Always returns n - 2 triangles over the given corners in
// their own orientation; a polygon that crosses itself gets triangles too (some overlap), never fewer.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

// points: #N x 3; polygon: n >= 3 indices into it. Result: n - 2 triples of indices into `points`.
std::vector<std::array<int, 3>> triangulate(const Points& points, std::span<const int> polygon);

}  // namespace planewright
