// By how much a measure may pass a limit and still count as on it: what rounding makes of coordinates, and
// nothing that can be built.
//
// The same design in mm, m and inches has slightly other last digits: an edge of 500 mm is
// 19.685039370078741 in, and comes back as 500.00000000000006 mm. So that "a measure on the limit passes" in
// every unit, limits are widened by 1e-12 of themselves, and by what the digits of coordinates far from 0 no
// longer tell. Threads: pure.
#pragma once

#include "core/workshop/panel_passport.h"
#include "core/workshop/workshop_model.h"

namespace planewright {

inline constexpr double kRelativeSlack = 1e-12;
inline constexpr double kLargestAngleSlack = 1e-6;  // degrees, however short a side is

// mm: eight units in the last place of the largest coordinate that the document has.
double coordinate_resolution(const WorkshopModel& model);

// Degrees: by how much an angle between directions turns whose ends move by `resolution` over `length` (mm).
double angle_slack(double resolution, double length);

}  // namespace planewright
