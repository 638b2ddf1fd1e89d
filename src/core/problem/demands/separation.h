// Separation: half spaces that points have to stay in, because a panel of theirs crossed something in the
// round before (FrozenGeometry::separations). Linear; unit: edges.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/problem/constraint.h"
#include "core/problem/frozen_geometry.h"
#include "core/problem/layout.h"

namespace planewright {

// What its rows are called: the demand that a designer knows it by.
inline constexpr std::string_view kSeparationName = "no-penetration";

// separations: model units; centre, scale: of the problem's normalised frame within the complex's.
std::unique_ptr<Constraint> make_separation_constraint(const Layout& layout,
                                                       const std::vector<Separation>& separations,
                                                       const Vector3d& centre, double scale);

}  // namespace planewright
