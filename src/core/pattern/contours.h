// What patterns, nesting and drawings measure on flat contours. Threads: pure.
#pragma once

#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

// Distance of a point from the contour, mm; negative outside it.
double depth_in(const Contour& contour, const Eigen::Vector2d& point);

// Whether the closed region of `outer` contains `inner`, to `slack` mm.
bool contains(const Contour& outer, const Contour& inner, double slack);

// Outline of the union of two contours (counter-clockwise): the one that contains the other, unchanged, else
// cut on a grid of 1e-6 mm, with the corners that are one of theirs put back exactly. Parts that do not
// touch: the larger one.
Contour united(const Contour& a, const Contour& b);

// The point that is deepest in all of the contours at once, found by halving squares, to 1 % of its depth;
// depth <= 0: they have no common inside.
struct DeepestPoint {
  Eigen::Vector2d point;
  double depth;
};
DeepestPoint deepest_point(const std::vector<const Contour*>& contours);

}  // namespace planewright
