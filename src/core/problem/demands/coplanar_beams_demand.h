// Coplanar beams: for every panel edge ab and the same edge a'b' of the neighbour layer, held as it is, the
// four points lie in one plane, so that a straight flat beam joins both edges (asked for by users; [Z]
// section 4.3 builds beams between parallel layers):
//   (b' - a') . ((a - a') x (b - a')) / (|b' - a'| w) = 0,
// w the distance between the wanted edge's middle and the neighbour's (at least kLeastWidth): how far one
// corner of the beam lies off the plane of the others. Bilinear equations; unit: edges. One row per panel
// edge of a selected panel; none where the neighbour's edge is shorter than kLeastDirected.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// Fails with ErrorCode::Usage without a neighbour layer, or where its points or panels are not those of this
// one.
Result<Constraints> make_coplanar_beams_demand(const DemandContext& context);

}  // namespace planewright
