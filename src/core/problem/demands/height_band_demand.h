// Height band: each point stays in a band over the mesh,  low <= m . (x_j - v) <= high  ([Z 2.4]), whichever
// side the layer is on. Either end may be missing. Linear; unit: edges. One row per point.
//
//   dual, point of a face or a border edge: m the face's normal, v the face's centroid (for a triangle any
//     corner means the same)
//   dual, corner of the outline, and planarize: m the vertex's normal, v the vertex
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: low, high. Fails with ErrorCode::Infeasible: an empty band.
Result<Constraints> make_height_band_demand(const DemandContext& context);

}  // namespace planewright
