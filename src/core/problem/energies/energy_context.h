// EnergyContext: what an energy is made of. Normalised units (layout.h). The complex must outlive the energy;
// everything else is there only while it is made.
#pragma once

#include "core/complex/tangent_complex.h"
#include "core/problem/layout.h"

namespace planewright {

// The least reference length that a residual is divided by; shorter edges have no direction. Mean edges.
inline constexpr double kLeastReferenceLength = 1e-3;

// The point of the reference surface closest to each point, frozen while a problem is solved.
struct FootPoints {
  Points foot;    // #X x 3, normalised
  Points normal;  // #X x 3, unit; signed distance of x_j: normal . (x_j - foot)
};

struct EnergyContext {
  const TangentComplex& complex;  // normalised
  const Layout& layout;
  const FootPoints* feet = nullptr;  // only where the energy named "closeness" is made, which needs them
};

}  // namespace planewright
