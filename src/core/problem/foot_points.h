// Foot points: where the reference surface is closest to each point of a state, and the direction in which
// the signed distance from it grows there; what the closeness energy holds still while a problem is solved.
// Beyond an open border the surface goes on as its tangent plane (closest_point.h), so that closeness neither
// draws the outline onto the reference's border nor turns over there.
#pragma once

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/mesh/closest_point.h"
#include "core/problem/energies/energy_context.h"

namespace planewright {

// x: #X x 3, model units relative to the complex's origin, and so are the feet. reference null: the mesh that
// the complex was built from. Refused: a mesh without area, coordinates that are not finite.
Result<FootPoints> foot_points(const TangentComplex& complex, const Points& x,
                               const ReferenceSurface* reference);

}  // namespace planewright
