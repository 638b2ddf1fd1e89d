// AutoSolver: the tangent solver's speed with Ipopt as the referee. The tangent solver solves; Ipopt then
// starts at its state and multipliers and confirms that they are a solution, or goes on from there. Where the
// tangent solver failed or reached no planar state, Ipopt begins afresh; demands that it could not meet are
// the end, since Ipopt begins in the same way.
//
// The observer gets planar states alone: Ipopt's own iterates are told as numbers.
#pragma once

#include <memory>

#include "core/solve/solver.h"

namespace planewright {

std::unique_ptr<Solver> make_auto_solver();

}  // namespace planewright
