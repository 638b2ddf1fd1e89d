// Ill-determined points: places where the planes through a point are nearly parallel, so that a small change of a
// plane throws the point far away. [Z 4.3] lights them up and advises to flip an edge there.
//
// Measure: the third singular value of N_j (#planes x 3, unit rows), i.e. the square root of the smallest
// eigenvalue of N_j^T N_j; 1 for three perpendicular planes, 0 for a flat place. Unit-free.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

// #X values; 0 for points on fewer than three planes that are meant so (border points) is NOT reported by the
// list below, but stands here.
Vector determinacy(const TangentComplex& complex, const State& state);

struct IllDetermined {
  int point;
  double singular_value;
};
// Points on at least three planes whose measure is below the threshold; worst first, ties by index. At the default,
// a plane that turns by a tenth of a degree moves the point by a sixth of an edge; gently curved roofs, whose panels
// meet at a few degrees, have most of their points at 0.02-0.1.
std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state,
                                               double threshold = 0.01);

}  // namespace planewright
