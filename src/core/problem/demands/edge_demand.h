// Edge: no panel edge dips under the mesh edge that it crosses ([Z] section 3). For mesh edge ij with the
// points x_k of its left and x_l of its right face
//   side * ((x_k - v_i) x (x_l - v_i)) . (v_j - v_i) / (|v_j - v_i| L) >= margin,
// L the wanted length of the panel edge (at least kLeastLength): how high the panel edge passes over the mesh
// edge. The border point of a border edge takes the place of the missing neighbour. Bilinear; unit: edges.
// One row per panel edge that crosses a mesh edge.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

Result<Constraints> make_edge_demand(const DemandContext& context);

}  // namespace planewright
