// PatchSolver: what an edit of the mesh would do to the panels, found by solving its neighbourhood with and
// without it while everything else is held.
//
// The patch is built, edited and solved like a whole design: same builder, energies, demands, weights;
// unknowns outside keep their place (Layout::outside), so the outside stays exact. Free are the planes within
// radius - 1 edges of the edit's centre and every point on one of them. Projection and Newton steps from the
// current state, as a full re-solve from nearby would do them: other ways (an augmented Lagrangian, a second
// start from where the builder begins) find other minima than that does, and predict it worse. A point whose
// planes changed starts where they meet, or where it is wanted if that is more than an edge off. Where the
// current state is no minimum, the patch without the edit gets the same steps, so that only the edit makes a
// difference.
//
// Factorisations are Eigen's: a trial never waits for the main solver (mumps_gate.h). Units: mean edges of
// the whole design. Threads: const members may be called by several threads at once. Deterministic.
#pragma once

#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "core/advise/patch.h"
#include "core/advise/score.h"
#include "core/base/result.h"
#include "core/design/layer_settings.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_edits.h"

namespace planewright {

// A solved layer that advice is asked about.
struct Advised {
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const TangentComplex> complex;
  State state;  // planar
  LayerSettings settings;
  std::vector<Selection> selections = {};
  std::shared_ptr<const ReferenceSurface> reference = {};  // null: the mesh itself
  bool converged = false;  // SolveStatus::Converged: patches need no solve to tell how they are
};

// One solve of a patch.
struct Trial {
  bool met = false;  // every row at the end
  Score score;       // of the free region
  std::shared_ptr<const TangentComplex> complex;
  State state;
  ElementMap from_whole;                       // old: of the whole mesh, new: of the (edited) patch
  std::vector<char> free_planes, free_points;  // which of the complex's were not held
};

class PatchSolver {
 public:
  // Fails as build_problem() does.
  static Result<PatchSolver> create(Advised advised);

  // A patch round an edit, solved as it is, for edits of the same centre.
  struct Ground {
    Patch patch;
    std::shared_ptr<const TangentComplex> complex;
    State state;
    Trial as_it_is;
  };
  // centre: vertices of the mesh. Fails where the rings are no manifold mesh by themselves.
  Result<Ground> prepare(const std::vector<int>& centre, int radius, std::stop_token stop = {}) const;
  // edit: of the whole mesh, within the centre. Fails as apply() and the builders do.
  Result<Trial> attempt(const Ground& ground, const MeshEdit& edit, std::stop_token stop = {}) const;

  const Advised& advised() const { return advised_; }

 private:
  PatchSolver() = default;
  Result<Trial> solve(std::shared_ptr<const TangentComplex> complex, State state, const PolygonMesh& mesh,
                      const ElementMap& from_whole, const std::vector<char>& free_planes, bool steps,
                      const std::stop_token& stop) const;
  State state_on(const TangentComplex& patch, const ElementMap& from_whole) const;

  Advised advised_;
  bool remaps_ = false;  // settings name elements
  std::map<std::string, double> factors_;
  std::vector<int> plane_of_origin_, point_of_face_, point_of_edge_, point_of_vertex_;
};

}  // namespace planewright
