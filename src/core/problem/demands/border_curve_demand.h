// Border: the outline of the design stays on the curve that its wanted points make. Linear; unit: edges.
//
// Planarize: the curve is the polyline of the input's border, moved by the offset as the wanted points are. A
// border vertex where it turns by more than 5 degrees is held there; the others slide along the straight
// piece that is nearest to where they are now (DemandContext::at): two rows d_k . (x_j - start) = 0
// perpendicular to the piece, and a range along it, `margin` away from kinks. Sides in one line are one
// piece. Where pieces meet at less than 5 degrees, a point may reach beyond the end, as far as leaves the
// curve by at most 1e-6 edges: so the next round of solves sees where it is going and lets it continue on the
// next piece. Neighbours on one piece keep their order: d . (x_next - x_j) >= margin.
//
// Dual, border policy closed: corners are held where they are wanted; a border edge's point slides on the
// segment between the wanted corners of the edge's ends, `margin` away from them.
//
// A dual's panel at the border contains its corner and a point on either side of it. Where the border turns
// at the corner, that leaves the panel no plane but the one of the two border edges, unless a point slides
// all the way to the neighbouring corner; so a bent border of a dual costs its panels their inclination.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

// Fails with ErrorCode::Usage: a dual with border policy interior, whose outline stands for no border.
Result<Constraints> make_border_curve_demand(const DemandContext& context);

}  // namespace planewright
