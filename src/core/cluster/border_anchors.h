// Extra corners on the mesh's border, so that its outline survives. Internal to this folder.
#pragma once

#include <vector>

#include "core/cluster/face_graph.h"

namespace planewright {

// chain: vertices along the border, from one corner to the next, both included; the same at both ends for a
// closed loop (whose first vertex then need not be a corner). Adds to `anchors` those inner ones that are
// needed so that no vertex is farther than `tolerance` from the chord of its piece, and where there are fewer
// than `least`, those farthest off. Units: of the graph. O(#chain log #chain) on average.
void add_border_anchors(const FaceGraph& graph, const std::vector<int>& chain, double tolerance, int least,
                        std::vector<int>& anchors);

}  // namespace planewright
