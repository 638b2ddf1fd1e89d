// Builder `cluster` ([Z] section 4.2): one plane per region of a clustered mesh (its proxy), one point per
// corner of the regions. As planes are unknowns, corners where many planes or nearly parallel ones meet are
// no special case; the position energy keeps them near the surface.
//
// An inner corner is wanted where the proxies of its regions nearly meet, close to its mesh vertex
// (meeting_point.h): the surface's own vertices would draw planes, which lie amid the bulge of their regions,
// to the hollow side of it. One on the border is wanted at its vertex, so that panels reach the outline.
//
// Corners on the mesh's border lie on the one or two planes of their regions; anchors there
// (cluster/regions.h) are such corners too, so that the outline of the design survives.
#pragma once

#include "core/base/result.h"
#include "core/cluster/regions.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct ClusterPanelOptions {
  double offset = 0.0;  // model units: moves planes along their normals, points along the vertex normals
};

// regions: those of the mesh, as make_regions() makes them. Refused: an offset that is not finite, regions of
// another mesh.
Result<TangentComplex> build_cluster(const PolygonMesh& mesh, const Regions& regions,
                                     const ClusterPanelOptions& options = {});

}  // namespace planewright
