// Convex parts: their hull, how they are turned, and whether they fit a rectangle at all. Threads: pure.
#pragma once

#include <optional>
#include <vector>

#include "core/pattern/flat_pattern.h"

namespace planewright {

// Counter-clockwise, without corners that lie straight.
Contour convex_hull(const Contour& contour);

Contour turned(const Contour& contour, double radians);
Eigen::Vector2d box_of(const Contour& contour);  // width and height

// The angle by which to turn the hull so that its box is smallest, and wider than high.
double smallest_box_angle(const Contour& hull);

// An angle by which the hull fits width x height (to 1e-6 mm), if any does: found among the finitely many at
// which a side of it lies along the rectangle or its box is just as wide or as high.
std::optional<double> fitting_angle(const Contour& hull, double width, double height);

}  // namespace planewright
