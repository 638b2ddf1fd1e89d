// Convex: every corner of a panel turns left, seen from the tip of its normal ([Z] section 4.2): for
// consecutive points a, b, c
//   n_i . ((x_b - x_a) x (x_c - x_b)) / (l_ab l_bc) >= eps,
// l the wanted lengths (at least kLeastLength): at the wanted size, the sine of the angle by which the
// outline turns. Trilinear; no unit. One row per panel and corner; of a triangle, whose corners say the same
// but for their lengths, the strictest.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: eps, from 0 to 1.
Result<Constraints> make_convex_demand(const DemandContext& context);

}  // namespace planewright
