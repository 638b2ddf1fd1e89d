// Acute corners: interior angles of planar panels too sharp to be made well. Panels of clusters have them
// where regions run out in a point; [Z 4.2] leaves that to the clustering.
//
// Threads: pure.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace planewright {

inline constexpr double kAcuteDegrees = 30.0;

struct AcuteCorner {
  int panel, point;
  double degrees;  // interior angle, 0..limit
};
// The sharpest corner of each panel that has one below `limit` degrees, by panel; of equal ones the first. A
// reflex corner is not acute; sides are told by the panel's Newell normal. Edges without length have no
// angle. points: #N x 3; polygons over them.
std::vector<AcuteCorner> find_acute_corners(const Points& points, const Polygons& polygons,
                                            double limit = kAcuteDegrees);

}  // namespace planewright
