// Beams between two layers (layers/beams.h) that would have to be twisted, because the panel edges that they
// join are not parallel.
//
// Measure: the angle between the two edges, degrees. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"
#include "core/problem/frozen_geometry.h"

namespace planewright {

// Beams twisted by more than `threshold` degrees; ascending by panel edge. None if the layers have not the
// same panels.
std::vector<Finding> find_twisted_beams(const Subject& subject, const NeighbourLayer& other,
                                        double threshold);

}  // namespace planewright
