// Panels with a reflex corner where a convex panel is possible.
//
// Dual: the sign of the Gauss curvature decides, i.e. of the angle defect (2 pi minus the angles of the
// faces) at the panel's mesh vertex. Where it is negative, panels in tangent planes cannot be convex; panels
// of border vertices have none and are left out. Planarize: the mesh's face was convex, seen along its
// normal. Panels of three corners are convex, and those that cross themselves are another finding.
//
// Measure: by how much the outline turns the wrong way at its worst corner, degrees. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// threshold, least_defect: degrees (FindingSettings). Ascending by panel.
std::vector<Finding> find_not_convex_panels(const Subject& subject, double threshold, double least_defect);

}  // namespace planewright
