// Adopt: the state of an edited design that takes over what trials found in the patches round the edits, so
// that the full solve afterwards has next to nothing left to do.
//
// Units: model units. Threads: pure.
#pragma once

#include "core/advise/patch_solver.h"

namespace planewright {

// edited: the whole complex after the edits; `map` leads from the advised mesh to its own. trials: of edits
// that lie apart (edit_plan.h); where what they moved overlaps, the first one counts. What neither the state
// before nor a trial knows starts where `edited` prefers it.
State adopt(const Advised& advised, const std::vector<Trial>& trials, const TangentComplex& edited,
            const ElementMap& map);

}  // namespace planewright
