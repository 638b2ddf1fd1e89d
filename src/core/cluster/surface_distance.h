// How far two surfaces of polygons are from each other, by samples spread evenly over both: what tells how
// well panels follow the mesh that they were made from.
//
// Units: model units. Threads: pure, deterministic.
#pragma once

#include <algorithm>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace planewright {

struct SurfaceDistance {
  double max = 0.0;  // at samples and corners
  double rms = 0.0;  // over the area
};

struct TwoSidedDistance {
  SurfaceDistance from_first, from_second;  // of points on the one to the other
  double max() const { return std::max(from_first.max, from_second.max); }
  double rms() const { return std::max(from_first.rms, from_second.rms); }
};

// points: #N x 3, polygons: lists of them, triangulated as triangulate() does; about `samples` samples on
// each surface, and all of its corners. Refused: a surface without area, with coordinates that are not
// finite, or fewer than one sample.
Result<TwoSidedDistance> surface_distance(const Points& first_points, const Polygons& first,
                                          const Points& second_points, const Polygons& second,
                                          int samples = 20000);

}  // namespace planewright
