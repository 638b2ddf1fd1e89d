// Normal smoothness: n_i - n_k per pair of panels that share an edge, each pair once ([Z] section 4.3).
// Degree 2; a residual has no unit. One term per pair.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_normal_smoothness_energy(const EnergyContext& context);

}  // namespace planewright
