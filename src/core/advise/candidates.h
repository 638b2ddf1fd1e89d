// Candidates: edits of the mesh that may better the panels, before anything is solved.
//
// At an edge that a finding points to (a flagged one): its flip, those of the other four edges of its two
// triangles, and its join. Planarized quads that collapsed: the collapse of the quad's shortest edge, and
// each corner that is no regular one (inner, valence not 4) moved to the middle of its neighbours. Left out:
// what the mesh refuses (may_apply), panels of fewer than four corners, folds (a new face tilted by more than
// 72 degrees), and edits that change the design: a surface that moves by more than 0.35 edges.
//
// Units: mean panel edges. Indices of the mesh. Threads: pure.
#pragma once

#include <string>
#include <vector>

#include "core/advise/patch_solver.h"
#include "core/diagnose/finding.h"

namespace planewright {

struct Candidate {
  MeshEdit edit;
  int mesh_edge = -1;       // where it is shown; MoveVertex: an edge of the vertex
  std::vector<int> centre;  // vertices
  // How far the mesh's surface moves, mean panel edges: of a flip the distance between the lines of the two
  // diagonals, of a collapse how far the ends leave their tangent planes.
  double deviation = 0.0;
  // Corners and panels of the design that it gives up or adds: 1 for a join (a corner of three panels goes)
  // and a split, 2 for a collapse (a panel goes), else 0.
  double given_up = 0.0;
  // |signed length| of the panel edge that crosses mesh_edge, mean edges: small ones first
  double urgency = 0.0;
};

// Flips and joins alone of one mesh edge, if allowed; for a benchmark that draws edges at random.
std::vector<Candidate> candidates_at(const Advised& advised, int mesh_edge, bool joins);
// By rising urgency, ties by edge and kind. findings: of the advised state.
std::vector<Candidate> find_candidates(const Advised& advised, const std::vector<Finding>& findings);

// Everything that could be done about one finding, for where the candidates above do not help: each flip,
// join, split and collapse at its edges and at the other edges of their faces; by edge, then kind.
struct LastResorts {
  struct Refused {
    MeshEdit edit;
    std::string reason;
  };
  std::vector<Candidate> allowed;
  std::vector<Refused> refused;
};
LastResorts last_resorts(const Advised& advised, const Finding& finding);

}  // namespace planewright
