// Offset band: the signed offset of each panel's plane from its anchor (dual: the mesh vertex, planarize: the
// face's centroid) stays in a band,  low <= h_i <= high, along the plane's normal, whichever side the layer
// is on ([Z 2.4]). Either end may be missing. Linear; unit: edges. One row per panel.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: low, high. Fails with ErrorCode::Infeasible: an empty band.
Result<Constraints> make_offset_band_demand(const DemandContext& context);

}  // namespace planewright
