// Adopt: the state of an edited design that takes over what a trial found in the patch round the edit, so
// that the full solve afterwards has next to nothing left to do.
//
// Units: model units. Threads: pure.
#pragma once

#include "core/advise/patch_solver.h"

namespace planewright {

// edited: the whole complex after the edit; `map` leads from the advised mesh to its own. What neither the
// state before nor the trial knows starts where `edited` prefers it.
State adopt(const Advised& advised, const Trial& trial, const TangentComplex& edited, const ElementMap& map);

}  // namespace planewright
