// Derivative check: compares every derivative of a problem with central differences of the level below
// (gradient with values, Hessian with gradients), entry by entry, and says where they differ most. Tests run
// it over several meshes and degenerate states; it also asks that derivatives are not zero, so that a missing
// term cannot pass.
#pragma once

#include <string>

#include "core/problem/problem.h"

namespace planewright {

struct DerivativeCheck {
  double gradient_error = 0.0;  // largest |analytic - difference| / max(1, |analytic|)
  double jacobian_error = 0.0;
  double hessian_error = 0.0;
  double gradient_norm = 0.0, jacobian_norm = 0.0, hessian_norm = 0.0;  // largest analytic entry
  std::string worst;  // where the largest error is: "hessian(17, 4)"
};

// z: #variables. Multipliers of the constraints' Hessian are taken as a fixed, irregular sequence.
// Cost: O(#variables * #slots); meant for small problems.
DerivativeCheck check_derivatives(const Problem& problem, const Vector& z, double step = 1e-5);

}  // namespace planewright
