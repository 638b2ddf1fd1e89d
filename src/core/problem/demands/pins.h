// Pins: points held at given coordinates, one linear row per coordinate, and panels held in a given plane: two
// rows that keep the normal's direction and one for the offset. Unit: edges (the normal's rows: unit-free).
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/complex/tangent_complex.h"
#include "core/problem/constraint.h"
#include "core/problem/demand.h"
#include "core/problem/layout.h"

namespace planewright {

// From model coordinates to normalised ones: (x - centre) / scale.
struct PinFrame {
  Vector3d centre;
  double scale;
};

// complex: normalised. Both fail with ErrorCode::Usage where a pin names a point or a panel that the complex
// does not have, or holds no coordinate; with ErrorCode::Infeasible where two pins hold one element
// differently, naming both.
Result<std::unique_ptr<Constraint>> make_pin_constraint(const TangentComplex& complex, const Layout& layout,
                                                        const Demands& demands, const PinFrame& frame);
Result<std::unique_ptr<Constraint>> make_plane_pin_constraint(const TangentComplex& complex,
                                                              const Layout& layout, const Demands& demands,
                                                              const PinFrame& frame);

}  // namespace planewright
