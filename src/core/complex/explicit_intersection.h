// Explicit tangent plane intersection (TPI, [Troche 2008]; [Z] equation 1): x_j = N_j^-1 b_j with the start's
// planes. Kept as the baseline that [Z] improves on: it says which points it could not compute.
#pragma once

#include <vector>

#include "core/complex/state.h"

namespace planewright {

enum class TpiFailure {
  TooFewPlanes,   // fewer than three planes: no unique point
  Parallel,       // (nearly) dependent normals: the intersection does not exist or is unstable
  Overdetermined  // more than three planes that have no common point
};
const char* name(TpiFailure failure);

struct TpiResult {
  State state;  // failed points stay at their wanted position
  struct Failed {
    int point;
    TpiFailure why;
    double smallest_singular_value;  // of N_j
    double residual;                 // model units; > 0 only for Overdetermined
  };
  std::vector<Failed> failed;  // ascending
};

// singular_tolerance: a point whose N_j (unit rows) has a third singular value below it is not computed.
// residual_tolerance: mean edges; how far an overdetermined point may lie from its planes.
TpiResult explicit_intersection(const TangentComplex& complex, double singular_tolerance = 1e-6,
                                double residual_tolerance = 1e-9);

}  // namespace planewright
