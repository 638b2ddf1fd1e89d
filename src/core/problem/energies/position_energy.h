// Position: x_j - f_j per point ([Z] section 2.1, F_pos). Degree 2; unit of a residual: edges. One term per
// point.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_position_energy(const EnergyContext& context);

}  // namespace planewright
