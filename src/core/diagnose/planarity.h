// How planar panels are, and how far points moved: measured on the polygons themselves, independent of any
// solver.
#pragma once

#include "core/base/geometry.h"

namespace planewright {

struct Planarity {
  Vector per_panel;  // #P, greatest distance of a corner from the panel's least-squares plane, model units
  double max = 0.0, mean = 0.0;
  double max_relative_to_bbox = 0.0;  // max / diagonal of the bounding box of all used points; 0 if that is 0
  int worst = -1;                     // the panel with the maximum, -1 for no panels
};

// points: #N x 3; polygons over them. Triangles are planar by definition; panels without area count their
// distance from the best plane all the same.
Planarity measure_planarity(const Points& points, const Polygons& polygons);

struct Displacement {
  Vector per_point;  // #N, model units
  double rms = 0.0, max = 0.0;
};
// Distance of each point from its reference; both #N x 3.
Displacement measure_displacement(const Points& points, const Points& reference);

}  // namespace planewright
