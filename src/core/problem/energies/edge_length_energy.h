// Edge length: (|x_a - x_b|^2 - L^2) / (2 L) per panel edge ab ([Z] section 4.1; the polynomial form: ours),
// L the edge's length at the wanted positions (length_rows.h). Degree 4; unit of a residual: edges. One term
// per panel edge.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_edge_length_energy(const EnergyContext& context);

}  // namespace planewright
