// What the star and uncrossed demands share: about which centre a panel is to be star-shaped, and its rows.
//
//   n_i . ((x_k - s) x (x_l - s)) / L >= eps L    for every step k -> l of the panel's outline
//
// L: panel_size(). Once round a centre, such an outline does not cross itself; twice round (a pentagram) the
// rows hold as well, and only what else is demanded, or where a solve starts, tells the two apart.
//
// Centre s, in this order:
//   - a triangle has one row, about its first point: all centres say the same;
//   - the mean of the panel's points, if the wanted panel is star-shaped about it. Panels of more than
//     kMostForMean points take the place of their anchor, held fixed, instead: the mean would couple every
//     row with all points, and the cost would grow with the square of their number;
//   - else that candidate about which the smallest value at the wanted points and normal is largest: the one
//     above, the anchor (duals), each own point. The rows of the two steps at an own point vanish and are
//     left out. Ties: the first.
// Threads: free functions.
#pragma once

#include "core/problem/demands/demand_context.h"
#include "core/problem/demands/panel_triangle_rows.h"

namespace planewright {

inline constexpr int kMostForMean = 12;

// L: square root of the panel's wanted area, but at least a quarter of its mean wanted edge (outlines whose
// loops cancel out have no area) and 0.05 edges. Edges.
double panel_size(const TangentComplex& complex, int panel);

// panel: of at least 3 points.
TriangleCentre star_centre(const TangentComplex& complex, int panel, double eps);

void add_star_rows(const DemandContext& context, int panel, double eps, PanelTriangleRows& rows);

}  // namespace planewright
