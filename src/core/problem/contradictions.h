// Contradictions that need no solver: demands on one point or one offset that cannot be met together whatever
// the panels do, found among the linear rows alone:
//
//   - equations that hold a point or an offset in two places (two pins, a pin off its curve);
//   - a row whose unknowns the equations leave no freedom, outside its bounds (a pin outside its band);
//   - two rows in one direction whose ranges do not meet (a band inside against panels in front).
//
// Planes that are pinned hold the points of their panels: n . x = n . v + h is linear there. Offsets and
// normals that the stage keeps fixed hold like pins. Rows that are not linear and separations (which ask for
// another round of solves, not for another design) are left to the solver.
#pragma once

#include "core/base/result.h"
#include "core/problem/problem.h"

namespace planewright {

// Fails with ErrorCode::Infeasible, naming the first such pair of demands and the element.
Result<void> check_contradictions(const Problem& problem);

}  // namespace planewright
