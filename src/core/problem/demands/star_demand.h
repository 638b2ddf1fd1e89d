// Star: every panel is star-shaped about a centre s, so that it does not cross itself and no corner hides
// behind another,
//   n_i . ((x_k - s) x (x_l - s)) / L >= eps L   for every step k -> l of its outline,
// L the wanted size of the panel (star_rows.h, which also says which s). Ours. Trilinear; unit: edges. One
// row per panel and step; triangles have one, panels of two points none.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: eps, share of the squared size, from 0 to 1.
Result<Constraints> make_star_demand(const DemandContext& context);

}  // namespace planewright
