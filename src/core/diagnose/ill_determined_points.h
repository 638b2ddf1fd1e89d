// Points whose planes are nearly parallel (ill_determined.h), as findings.
//
// Measure: tilt_moves(), mean edges per degree. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// threshold: edges per degree; 0: the design's own, notable_tilt_move(). Ascending by point.
std::vector<Finding> find_ill_determined_points(const Subject& subject, double threshold);

}  // namespace planewright
