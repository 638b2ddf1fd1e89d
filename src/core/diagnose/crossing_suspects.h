// Which pairs of planar panels of one layer may cross at all: what is left for the exact test of crossings.h.
//
// Boxes that overlap are found by a sweep along the longest axis. Of such a pair the planes decide: a panel
// that lies on one side of the other's plane cannot cross it. Else two panels in different planes can meet
// but in a segment whose ends are corners of both or lie where an outline pierces the other panel, so that
// pairs without such a point are cleared. Panels in one plane are cleared where an outline's edge parts them.
// All tests err on the side of suspicion, by `slack`.
//
// Units: those of the points. Indices 0-based. Cost: about n^1.5 for n panels of a surface. Threads: pure.
#pragma once

#include <array>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

// points: #X x 3; panels over them, each in a plane with this unit normal (#P x 3). touch: depth up to which
// a crossing is none; slack: how far corners may lie from their planes. Ascending pairs, first < second;
// panels with a coordinate that is not finite are left out.
std::vector<std::array<int, 2>> crossing_suspects(const Points& points, const Polygons& panels,
                                                  const Points& normals, double touch, double slack);

}  // namespace planewright
