// Anchor polygons: the classic approximation by the same regions (Cohen-Steiner et al. 2004, section 4): each
// corner at the mean of its mesh vertex's projections onto the proxies of its regions, panels not planar.
// What planar panels are measured against.
#pragma once

#include "core/cluster/regions.h"

namespace planewright {

// Corners of regions.corners_of_region (#C x 3), model units, absolute. mesh: that of the regions.
Points anchor_points(const PolygonMesh& mesh, const Regions& regions);

}  // namespace planewright
