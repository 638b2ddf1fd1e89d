// Multipliers of a problem's rows at a state: completed for the rows that a tangent solver leaves out, and
// estimated anew where a projection has moved the state. Internal to solve/. Units: as
// Problem::first_order_residual wants them (weights as the problem has them), so that every solver's are
// judged by the same function.
#pragma once

#include "core/problem/problem.h"
#include "core/solve/tangent_equations.h"

namespace planewright {

// Sets those of the unit-normal rows: what is left of each normal's slope along the normal itself.
void complete_unit_normals(const Problem& problem, const Vector& z, Vector& multipliers);

// The multipliers y nearest to `guess` (#rows) that make the slope of f + y.c least, by one regularised least
// squares solve over equations and those inequalities whose guess is not 0; complete. Or the guess,
// completed, where that leaves a smaller residual.
Vector estimate_multipliers(const Problem& problem, const Vector& z, const Vector& guess,
                            TangentCache* cache);

}  // namespace planewright
