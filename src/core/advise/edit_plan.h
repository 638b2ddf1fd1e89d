// EditPlan: suggestions that can be applied together, "all that gain": none lies close to another, so that
// what each was predicted to gain mostly holds when the others are done.
//
// Indices of the advised mesh. Threads: pure. Deterministic.
#pragma once

#include <vector>

#include "core/advise/advisor.h"

namespace planewright {

// Which of the ranked suggestions to apply, as indices into them: the best, then the best of those whose
// centres lie at least kApart edges from all that are chosen, and so on: farther than most of what an edit
// moves. O(#chosen patches).
inline constexpr int kApart = 4;
std::vector<int> choose_apart(const PolygonMesh& mesh, const std::vector<Suggestion>& ranked);

// The edits of suggestions one after another, each of the mesh that those before it have made. Some may be
// missing at the end: from the first that the mesh refuses on.
std::vector<MeshEdit> in_order(const PolygonMesh& mesh, const std::vector<MeshEdit>& edits);

}  // namespace planewright
