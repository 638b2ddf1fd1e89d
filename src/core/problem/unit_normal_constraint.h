// Unit normals: (|n_i|^2 - 1) / 2 = 0 for every plane ([Z] section 2.2, E_norm; halved, so that the row's
// gradient is n_i itself, as long as an incidence row's). Quadratic; unit-free.
#pragma once

#include <memory>

#include "core/problem/constraint.h"
#include "core/problem/layout.h"

namespace planewright {

std::unique_ptr<Constraint> make_unit_normal_constraint(const Layout& layout);

}  // namespace planewright
