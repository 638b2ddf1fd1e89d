// The closed solid between an outer and an inner contour of the same sides. Threads: pure.
#pragma once

#include <vector>

#include "core/pattern/thick_panel.h"

namespace planewright {

// A contour in space, with the points where each side of the panel begins and ends on it.
struct SolidContour {
  Points points;
  std::vector<int> start, end;  // #sides
};

// Faces as ThickPanel orders them. A side that is a point on one contour gets a triangle, one that is a point
// on both gets none; a corner that is an edge on one contour gets a triangle (side_of_face -1).
ThickPanel mitred_solid(int panel, const SolidContour& outer, const SolidContour& inner);

}  // namespace planewright
