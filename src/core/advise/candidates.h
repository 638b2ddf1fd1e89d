// Candidates: edits of the mesh that may better the panels, before anything is solved.
//
// At an edge that a finding points to (a flagged one): its flip, those of the other four edges of its two
// triangles, and its join. Planarized quads that collapsed: the collapse of the quad's shortest edge, and
// each corner that is no regular one (inner, valence not 4) moved to the middle of its neighbours. Left out:
// what the mesh refuses (may_apply), panels of fewer than four corners, folds (a new face tilted by more than
// 72 degrees), and edits that change the design: diagonals further apart than 0.35 edges.
//
// Units: mean panel edges. Indices of the mesh. Threads: pure.
#pragma once

#include <vector>

#include "core/advise/patch_solver.h"
#include "core/diagnose/finding.h"

namespace planewright {

struct Candidate {
  MeshEdit edit;
  int mesh_edge = -1;       // where it is shown; MoveVertex: an edge of the vertex
  std::vector<int> centre;  // vertices
  double deviation = 0.0;   // mean panel edges: distance between the lines of the two diagonals
  double urgency =
      0.0;  // |signed length| of the panel edge that crosses mesh_edge, mean edges: small ones first
};

// Flips and joins alone of one mesh edge, if allowed; for a benchmark that draws edges at random.
std::vector<Candidate> candidates_at(const Advised& advised, int mesh_edge, bool joins);
// By rising urgency, ties by edge and kind. findings: of the advised state.
std::vector<Candidate> find_candidates(const Advised& advised, const std::vector<Finding>& findings);

}  // namespace planewright
