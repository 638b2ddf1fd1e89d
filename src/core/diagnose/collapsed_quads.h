// Quads that have become triangles: at the turning points of a strip that turns by a right angle or more, the
// planar panels concentrate the turn in single points ([Z 4.1], discussion).
//
// Measure: twice the smallest area of a corner's triangle (the corner and its two neighbours) over the area
// of the quad: 1 for a parallelogram, 0 for a triangle (two corners have met, or one lies on the line between
// its neighbours), below 0 for a quad that went past it. Unit-free. Threads: pure.
#pragma once

#include <vector>

#include "core/diagnose/finding.h"
#include "core/diagnose/subject.h"

namespace planewright {

// Quads of a planarized mesh below `threshold`, whatever they were in the mesh; ascending by panel.
// mesh_edges: the shortest one, which a collapse would take.
std::vector<Finding> find_collapsed_quads(const Subject& subject, double threshold);

}  // namespace planewright
