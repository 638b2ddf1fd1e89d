// Vertex: every point stays in front of the mesh face it belongs to ([Z] section 3),
//   side * m_j . (x_j - v) >= margin   for every corner v of the face, m_j its normal (Newell for polygons).
// A border point takes the demand of its one face; a corner of the outline has none (its panel's face demand
// holds it). Linear; unit: edges. One row per point: the corner that asks for most.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

Result<Constraints> make_vertex_demand(const DemandContext& context);

}  // namespace planewright
