// Where planes nearly meet, not far from a given point: what a corner of planar panels had better aim at.
//
// Minimises sum_i (n_i . x - d_i)^2 + e |x - from|^2 with the least e of a ladder for which x stays within
// `reach` of `from`. Three planes that are far from parallel meet within reach, and x is there; nearly
// parallel ones may meet anywhere, and x only comes nearer to them. One plane or two: the nearest point of
// both. Threads: pure.
#pragma once

#include <span>

#include "core/base/geometry.h"

namespace planewright {

struct WantedPlane {
  Vector3d normal;  // unit
  double height;    // normal . x = height on the plane
};
// Lengths all in one unit. No planes: `from`.
Vector3d meeting_point(std::span<const WantedPlane> planes, const Vector3d& from, double reach);

}  // namespace planewright
