// Proxy normal: n_i minus the normal that the builder gave the plane ([Z] section 4.2), which is the mesh's
// own there. Degree 2; a residual has no unit. One term per panel.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_proxy_normal_energy(const EnergyContext& context);

}  // namespace planewright
