// Points that came to lie far from where they were wanted: no planar panels are near the design there.
//
// Measure: |x - f|, mean edges. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// Points more than `threshold` mean edges away; ascending.
std::vector<Finding> find_far_points(const Subject& subject, double threshold);

}  // namespace planewright
