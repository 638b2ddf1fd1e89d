// Rows of panels, from below, and the order of panels inside each: what names by row are made from. Internal
// to workshop/; the rules are told in panel_names.h. Threads: pure.
#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace planewright {

// Every panel in exactly one row. The answer does not depend on the unit of length. up: unit.
std::vector<std::vector<int>> panel_rows(const Points& points, const Polygons& panels, const Vector3d& up);

}  // namespace planewright
