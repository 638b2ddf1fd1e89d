// Fairing: x_j minus the mean of its neighbours along panel edges ([Z] section 4.3); a point of the outline
// is compared with its neighbours along the outline. Degree 2; unit of a residual: edges. One term per point.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_fairing_energy(const EnergyContext& context);

}  // namespace planewright
