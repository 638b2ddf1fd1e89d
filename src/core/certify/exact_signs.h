// Signs that no rounding decides: exact predicates on the given doubles. Internal to certify/.
//
// Coordinates have to be finite (the readers refuse others). Threads: pure.
#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"
#include "core/pattern/flat_pattern.h"

namespace planewright {

// > 0: a, b, c turn counter-clockwise.
int orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);
// > 0: d lies on the side of plane a, b, c from which these run counter-clockwise.
int orientation(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d);

// Whether closed segments a-b and c-d have a point in common.
bool segments_meet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                   const Eigen::Vector2d& d);

// At least three corners; sides meet in nothing but the corner that follows, none has length 0.
bool is_simple(const Contour& contour);

// > 0: counter-clockwise.
int area_sign(const Contour& contour);

// Whether p lies inside or on the border of a closed contour (even-odd).
bool covers(const Contour& contour, const Eigen::Vector2d& p);

// Sign of the volume that closed triangles bound; > 0: they run counter-clockwise seen from outside.
int volume_sign(const Points& points, const std::vector<std::array<int, 3>>& triangles);

}  // namespace planewright
