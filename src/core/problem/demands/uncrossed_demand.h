// Uncrossed: no panel crosses itself. Ours. Three kinds of rows; unit: edges; eps and kappa as given, L the
// panel's wanted size (star_rows.h).
//
//   D, quads:       n_i . ((x_next - x_k) x (x_previous - x_k)) / L >= eps L   at the two ends of one
//   diagonal,
//     so that the panel's two triangles at the other diagonal lie on different sides of it. That is exactly
//     "simple and counter-clockwise": every such quad has an inner diagonal, and a crossed one turns the
//     wrong way at two neighbouring corners. Four rows per quad, corner by corner, of which either the first
//     and the third or the others have to hold: waive_alternatives() keeps the pair whose smaller value is
//     larger, the first and third where they tie. Trilinear.
//   S, 5 points and more: star-shaped (star_rows.h). Trilinear.
//   K, panel edges: d . (x_b - x_a) >= kappa l   with the wanted direction d and length l. Two panels that
//   both
//     want an edge turned round shrink it to a point, where the rows above lose their gradient; K keeps it
//     from going that way. Edges of wanted length below kLeastDirected have no direction and no row. Linear.
//
// Triangles have K alone. Under a selection, the edges of selected panels.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// values: eps (D and S), kappa (K), each from 0 to 1.
Result<Constraints> make_uncrossed_demand(const DemandContext& context);

}  // namespace planewright
