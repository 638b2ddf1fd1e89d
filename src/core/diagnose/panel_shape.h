// What makes a planar panel hard to build all the same: outlines that cross themselves, and edges too short
// to make. Measured on the panels alone. Crossings between different panels are another matter.
#pragma once

#include <span>
#include <vector>

#include "core/complex/state.h"

namespace planewright {

// Panels whose outline crosses itself, ascending: two edges that share no corner meet in an inner point, seen
// along the panel's Newell normal (panels whose loops cancel out: along the least-squares normal). Touching
// is no crossing. points: #N x 3; polygons over them. Cost per panel: the square of its corners.
std::vector<int> find_self_crossing(const Points& points, const Polygons& polygons);
// The same of one panel.
bool crosses_itself(const Points& points, std::span<const int> polygon);

struct ShortEdge {
  int edge;       // index into TangentComplex::panel_edges
  double length;  // model units
};
// Panel edges below `threshold` mean edges; shortest first, ties by index.
std::vector<ShortEdge> find_short_edges(const TangentComplex& complex, const State& state,
                                        double threshold = 0.05);

}  // namespace planewright
