// Corner angle: panels without sharp corners and without edges too short to build (ours; [Z] section 4.2
// leaves both to the clustering).
//
// A corner x_p of a panel between its neighbours x_a and x_b, u = x_a - x_p, v = x_b - x_p:
//   c = u . v / sqrt((|u|^2 + s^2) (|v|^2 + s^2)),    r = ((c - c_0)_+ / (1 - c_0))^2,
// c_0 the cosine of kBluntDegrees: 0 where the corner is blunt, 1 where it is closed. s = kAngleLength makes
// c a smooth function where an edge has no length, and so no direction; it makes corners of edges that short
// look blunt. Shrinking an edge would therefore be a way out; hence, for each panel edge e = x_a - x_b,
//   r = ((1 - |e|^2 / l^2)_+)^2,    l = kShortLength.
// Both residuals are squares of hinges: their slopes are continuous, and the energy's second derivatives too.
//
// Angles are those of the geometry, from 0 to 180 degrees: a reflex corner of 340 is as sharp as one of 20. A
// corner that is closed altogether, and an edge of no length, are in equilibrium: the energy keeps corners
// from closing better than it opens those that are closed. A corner between edges whose directions the planes
// dictate (panels of clusters with flat ones beside them) yields only as far as these planes do.
//
// Degree: rational, no unit. One term per panel corner; a row for it, and one per panel edge.
#pragma once

#include <memory>

#include "core/problem/energies/energy_context.h"
#include "core/problem/energy.h"

namespace planewright {

// Corners from here on are blunt; well above what counts as acute (diagnose/panel_angles.h), because the
// energy begins as a fourth power.
inline constexpr double kBluntDegrees = 45.0;
inline constexpr double kAngleLength = 0.1;  // mean edges
inline constexpr double kShortLength = 0.3;  // mean edges

std::unique_ptr<Energy> make_corner_angle_energy(const EnergyContext& context);

}  // namespace planewright
