// The end that every solver shares: projects the best state onto its incidences, measures it again, and lets
// the status say no more than what was measured. Internal to solve/.
#pragma once

#include "core/problem/problem.h"
#include "core/solve/solver.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

// z, multipliers: normalised, of the best state. Fills state, residuals, energies and constraints of the
// report and corrects its status: planar or not decides the projection, stationary or not the first-order
// residual after it, with the better of the given multipliers and those estimated there. cache may be null.
void finish_solve(const Problem& problem, const Vector& z, const Vector& multipliers,
                  const SolveOptions& options, SolveReport& report, TangentCache* cache = nullptr);

}  // namespace planewright
