// Closeness: m_j . (x_j - y_j) - d_j, the signed distance of x_j from the reference surface minus the
// distance it should have there (ours; users of every planarizer ask for it). y_j is the point of the surface
// closest to where x_j was when the problem was stated, m_j the direction in which the signed distance grows
// there (foot_points.h); both are held still while a problem is solved. Degree 2; unit of a residual: edges.
// One term per point.
//
// d_j is the mean of the offsets that the builder gave the planes of point j (TangentComplex::offsets): the
// layer's offset. Not 0, or closeness would draw a layer that is meant to float above the design back onto
// it; not the planes' present h either, which is free and would make closeness follow whatever the solve
// does.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

std::unique_ptr<Energy> make_closeness_energy(const EnergyContext& context);

}  // namespace planewright
