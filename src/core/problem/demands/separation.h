// Separation: half spaces that points have to stay in, because a panel of theirs crossed something in the
// round before (FrozenGeometry::separations). Linear; unit: edges.
#pragma once

#include <memory>
#include <vector>

#include "core/problem/constraint.h"
#include "core/problem/frozen_geometry.h"
#include "core/problem/layout.h"

namespace planewright {

// separations: model units; centre, scale: of the problem's normalised frame within the complex's.
std::unique_ptr<Constraint> make_separation_constraint(const Layout& layout,
                                                       const std::vector<Separation>& separations,
                                                       const Vector3d& centre, double scale);

}  // namespace planewright
