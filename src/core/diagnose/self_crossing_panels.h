// Panels whose outline crosses itself (panel_shape.h), as findings.
//
// Measure: the share of the outline's length that the loop behind the crossing has, at most a half; of
// several crossings the largest. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// Loops of more than `threshold` (0..0.5) of the outline; ascending by panel.
std::vector<Finding> find_self_crossing_panels(const Subject& subject, double threshold);

}  // namespace planewright
