// Builder `planarize` ([Z] section 4.1): one plane per face (anchor: centroid, normal: Newell vector), one
// point per vertex, wanted where the vertex is. The panels are the mesh's own faces, of any valence.
#pragma once

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

struct PlanarizeOptions {
  double offset = 0.0;  // model units: moves the wanted points along the vertex normals, 0 to stay
};

// Isolated vertices get no point. A face without area takes the mean normal of its neighbours.
// Refused: no faces, an offset that is not finite.
Result<TangentComplex> build_planarize(const PolygonMesh& mesh, const PlanarizeOptions& options = {});

}  // namespace planewright
