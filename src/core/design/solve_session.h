// SolveSession: solves on one worker thread while the window, or the command line, goes on.
//
// Only planar states are handed out (Iteration::planar): what a view shows are panels, in every frame.
//
// A caller starts a request and gets a ticket; every later request supersedes the one before (its solve is
// asked to stop and whatever it still produces is dropped). Complex and problem are built on the worker too,
// so that start() returns at once. The newest iterate waits in a mailbox that holds one; scalars queue up,
// none is lost. Iterates of an earlier ticket are never handed out.
//
// Threads: all public members may be called from one controlling thread (the window's). None of them waits
// for a solver: the only lock is held for moving pointers, never across an evaluation, a copy of a state or a
// factorisation. The destructor asks the worker to stop and joins it (at most one factorisation).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/design/clustered_mesh.h"
#include "core/design/layer_settings.h"
#include "core/mesh/polygon_mesh.h"
#include "core/problem/frozen_geometry.h"
#include "core/solve/iteration.h"
#include "core/solve/solve_report.h"
#include "core/solve/solver_choice.h"

namespace planewright {

// A state with the complex that gives it meaning.
struct Iterate {
  std::uint64_t ticket = 0;
  std::shared_ptr<const TangentComplex> complex;
  State state;
  Iteration iteration;
};

struct SolveRequest {
  std::shared_ptr<const PolygonMesh> mesh;
  LayerSettings settings;
  SharedClusters clusters = {};                            // of that mesh, for ComplexKind::Cluster
  std::vector<Selection> selections = {};                  // that the settings' demands name
  std::shared_ptr<const ReferenceSurface> reference = {};  // null: the mesh itself
  std::shared_ptr<const NeighbourLayer> neighbour = {};    // null: none
  // Where to start: null for the builder's own start, else a state, transferred if its complex is another
  // one.
  std::shared_ptr<const Iterate> warm_start = {};
  std::shared_ptr<const ElementMap> edited = {};  // from its mesh to `mesh`; null: the same elements
  SolverKind solver = SolverKind::Tangent;
};

struct SolveOutcome {
  std::uint64_t ticket = 0;
  std::shared_ptr<const TangentComplex> complex;  // null if it could not be built
  // The report, or why nothing could be solved (settings refused, no panels, ...).
  Result<SolveReport> report;
};

class SolveSession {
 public:
  // `wake`: called on the worker whenever there is something new to drain (to post an empty event to a window
  // that sleeps); may be empty.
  explicit SolveSession(std::function<void()> wake = {});
  ~SolveSession();
  SolveSession(const SolveSession&) = delete;
  SolveSession& operator=(const SolveSession&) = delete;

  std::uint64_t start(SolveRequest request);
  void stop();  // the running solve ends within one factorisation and reports its best state

  bool running() const;                  // a request waits or is being solved
  std::uint64_t current_ticket() const;  // 0 before the first start

  // The newest iterate of the current ticket that was not taken yet, or null.
  std::shared_ptr<const Iterate> take_iterate();
  // All scalars since the last call, in order, appended to `out`.
  void drain_iterations(std::vector<Iteration>& out);
  // The outcome of the current ticket, once, when it is there.
  std::optional<SolveOutcome> take_outcome();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace planewright
