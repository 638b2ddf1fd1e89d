// PointEquations: what the planes of one point demand of it, as the linear system N m = b for its move m from
// the wanted position ([Z] equation 1, taken relative to f_j so that a nearly singular system errs about the
// wanted position and not about the origin). Units: those of the complex. Threads: a plain value.
#pragma once

#include "core/complex/tangent_complex.h"

namespace planewright {

struct PointEquations {
  // The system of point j with the complex's own planes (anchors, normals, offsets).
  PointEquations(const TangentComplex& complex, int j);

  Eigen::MatrixXd normals;  // #planes x 3, unit rows
  Vector right;             // #planes
};

}  // namespace planewright
