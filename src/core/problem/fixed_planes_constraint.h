// Fixed planes: where planes do not move ([Z] section 2.1), the incidences are linear in the points, and flat
// places make them dependent. Per point this keeps an orthonormal basis of the directions that its planes
// really determine (singular values of N_j above a tolerance) and demands  b . (x_j - x*) = 0  along each, x*
// the point nearest to f_j on its planes; the energies settle the rest. Linear; unit: edges.
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/constraint.h"
#include "core/problem/layout.h"

namespace planewright {

// complex: normalised, with the planes to keep (anchors, normals, offsets).
// Refused: points whose (more than three, or parallel) planes have no common point; the first is named.
Result<std::unique_ptr<Constraint>> make_fixed_planes_constraint(const TangentComplex& complex,
                                                                 const Layout& layout);

}  // namespace planewright
