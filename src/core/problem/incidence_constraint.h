// Incidence: n_i . (x_j - v_i) - h_i = 0 for every point j on plane i ([Z] equation 1 with the offset of
// section 2.2, sign as derived there; see tangent_complex.h). Bilinear; unit: edges. Rows: points in order,
// each point's planes ascending, as in incidence_residuals().
#pragma once

#include <memory>

#include "core/complex/tangent_complex.h"
#include "core/problem/constraint.h"
#include "core/problem/layout.h"

namespace planewright {

// complex: normalised; must outlive the result.
std::unique_ptr<Constraint> make_incidence_constraint(const TangentComplex& complex, const Layout& layout);

}  // namespace planewright
