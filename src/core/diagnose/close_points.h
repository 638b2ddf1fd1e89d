// Panel edges next to no length: two points "lying too close to each other" [Z 4.3], where a flip or a face
// of higher valence helps.
//
// Measure: the distance, mean edges. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// Panel edges shorter than `threshold` mean edges, whichever way they run; ascending by panel edge.
std::vector<Finding> find_close_points(const Subject& subject, double threshold);

}  // namespace planewright
