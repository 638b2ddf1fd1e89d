// Edge direction: (I - d d^T) (x_a - x_b) per panel edge ab ([Z] section 4.1), d the edge's unit direction at
// the wanted positions: the part of the edge that leans away from it. It resists neither collapse nor
// reversal of an edge. Edges shorter than kLeastReferenceLength there have no direction and are left out.
// Degree 2; unit of a residual: edges. One term per panel edge that has a direction.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_edge_direction_energy(const EnergyContext& context);

}  // namespace planewright
