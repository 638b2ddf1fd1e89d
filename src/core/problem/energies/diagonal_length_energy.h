// Diagonal length: (|x_a - x_b|^2 - L^2) / (2 L) per diagonal ab of a panel ([Z] section 4.1; the polynomial
// form: ours), L its length at the wanted positions (length_rows.h). Diagonals are the skip-one pairs of a
// panel's outline: both of a quad, five of a pentagon, none of a triangle; one that two panels have counts
// once. Edge and diagonal lengths together hold a panel's shape. Degree 4; unit of a residual: edges. One
// term per diagonal.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_diagonal_length_energy(const EnergyContext& context);

}  // namespace planewright
