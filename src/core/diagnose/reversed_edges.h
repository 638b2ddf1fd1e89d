// Panel edges that run backwards, the sign of a mesh edge flipped the wrong way.
//
// The signed length of the panel edge x_a x_b that crosses the mesh edge from v_i to v_j, with the unit
// normals m of the faces that a and b belong to:
//
//   s = +-|x_b - x_a|, sign of (x_b - x_a) . ((m_a + m_b) x (v_j - v_i))
//
// so that s < 0 where the outline of i's panel turns back. Where no mesh edge is crossed (planarize, and the
// outline of a dual) the sign is that of (x_b - x_a) . (f_b - f_a), the direction in the input.
//
// Units: s in model units, thresholds in mean edges. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

double signed_length(const TangentComplex& complex, const State& state, int panel_edge);

// Edges with s < -threshold mean edges. Measure: -s, mean edges. Ascending by panel edge.
std::vector<Finding> find_reversed_edges(const Subject& subject, double threshold);

}  // namespace planewright
