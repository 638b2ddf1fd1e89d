// Offset: h_i - d_i, d_i the offset that the builder gave the plane (the layer's), so that every panel keeps
// its distance from its anchor ([Z] section 2.4 allows it). Degree 2; unit of a residual: edges. One term per
// panel.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_offset_energy(const EnergyContext& context);

}  // namespace planewright
