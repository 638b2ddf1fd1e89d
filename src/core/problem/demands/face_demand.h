// Face: no mesh vertex pokes through its panel ([Z] section 3),  side * h_i >= margin. Linear; unit: edges.
// One row per panel.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

Result<Constraints> make_face_demand(const DemandContext& context);

}  // namespace planewright
