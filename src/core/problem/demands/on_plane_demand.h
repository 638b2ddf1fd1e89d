// On a plane: the selected points lie on a given plane, a floor slab for example:  n . (x_j - p) = 0, n made
// unit. Linear; unit: edges. One row per point.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: p (x, y, z), n (x, y, z; any length but 0). Fails with ErrorCode::Usage: a normal of length 0.
Result<Constraints> make_on_plane_demand(const DemandContext& context);

}  // namespace planewright
