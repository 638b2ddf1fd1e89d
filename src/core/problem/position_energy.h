// Position: x_j - f_j per point ([Z] section 2.1, F_pos). Degree 2; unit of a residual: edges. One term per
// point.
#pragma once

#include <memory>

#include "core/complex/tangent_complex.h"
#include "core/problem/energy.h"
#include "core/problem/layout.h"

namespace planewright {

// complex: normalised; must outlive the result.
std::unique_ptr<Energy> make_position_energy(const TangentComplex& complex, const Layout& layout);

}  // namespace planewright
