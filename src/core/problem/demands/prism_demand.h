// Prism: each point stays inside the extrusion of its mesh face along the face's normal ([Z 2.4]),
//   (m x (b - a)) / |m x (b - a)| . (x_j - a) >= margin   for each edge ab of the face's outline, seen along
//   m,
// m the face's normal. Linear; unit: edges. One row per edge.
//
// The outline is the convex hull of the face's corners seen along m: the face itself where it is convex. A
// face so narrow that the margin would leave it no inside keeps a quarter of its own width instead; one
// without area has no inside, and asks nothing. The point of a border edge belongs to no face's inside: it
// stays between the two planes through the edge's ends, perpendicular to the edge. Corners of the outline are
// free.
#pragma once

#include "core/problem/demands/demand_catalogue.h"

namespace planewright {

Result<Constraints> make_prism_demand(const DemandContext& context);

}  // namespace planewright
