// Builder `dual` ([Z] sections 2 and 4.3): one plane per primal vertex, one point per primal face, so that
// the panels are the faces of the dual mesh: hexagon-dominant for a triangle mesh. Primal faces may have any
// valence.
//
// Open borders. Policy `Closed` (default): each border edge gives a point on the two planes of its ends,
// wanted at the edge's midpoint; each border vertex gives a corner on its own plane, wanted at the vertex; so
// the outline of the design survives. Policy `Interior`: planes and panels for inner vertices alone.
#pragma once

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

enum class BorderPolicy { Closed, Interior };

struct DualOptions {
  double offset = 0.0;  // model units, along the normals: wanted distance of the points from the primal
  BorderPolicy border = BorderPolicy::Closed;
};

// Isolated vertices get no plane. Planes start tangent: area-weighted vertex normals, h = offset. Where the
// faces round a vertex cancel out (a fold), the normal of its largest face is taken. Refused: no panel
// results (Interior without inner vertices), an offset that is not finite.
Result<TangentComplex> build_dual(const PolygonMesh& primal, const DualOptions& options = {});

}  // namespace planewright
