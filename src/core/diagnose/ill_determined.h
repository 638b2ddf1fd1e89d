// Ill-determined points: places where the planes through a point are nearly parallel, so that a small change
// of a plane throws the point far away. [Z 4.3] lights them up and advises to flip an edge there.
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
// Below which measure a point of this design is worth a mark. On a fine or gently curved design neighbouring
// planes are nearly parallel everywhere, as it should be; what stands out is a point far below the others: a
// quarter of the median over points on at least three planes, kept within 0.001 (always ill) and 0.05
// (never).
double notable_threshold(const TangentComplex& complex, const State& state);

// Points on at least three planes whose measure is below the threshold; worst first, ties by index.
std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state,
                                               double threshold);
// The same with the design's notable_threshold().
std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state);

}  // namespace planewright
