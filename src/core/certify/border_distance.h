// Distances in the plane, of the certificate's own. Internal to certify/. Units: mm. Threads: pure.
#pragma once

#include "core/pattern/flat_pattern.h"

namespace planewright {

// Of a point from the segment a-b, which may have no length.
double to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
// From the nearest side of a closed contour, inside or outside it; infinite where there is none.
double to_border(const Contour& contour, const Eigen::Vector2d& p);

}  // namespace planewright
