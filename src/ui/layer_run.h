// LayerRun: what is known of a layer besides its settings: the newest solve, what it was started from and
// came to, and what is shown of it.
//
// Threads: plain values of the window's.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/design/solve_session.h"
#include "core/edit/document.h"
#include "core/mesh/closest_point.h"
#include "ui/view_preparer.h"

namespace planewright::ui {

// How a layer stands.
enum class LayerStatus {
  Waiting,    // to be solved
  Saved,      // as the project had it, not solved since
  Solving,    // at present
  Done,       // converged, every demand met
  Planar,     // planar, but stopped before it converged
  Unmet,      // a demand is not met, or panels cross the mesh
  NotPlanar,  // no planar state
  Failed,     // refused, or broken down
};

// What a layer is solved from.
struct LayerInputs {
  std::shared_ptr<const PolygonMesh> mesh;
  LayerSettings settings;             // with what coplanar_with demands
  SharedClusters clusters;            // for panels of clusters; else null
  std::vector<Selection> selections;  // that the demands name
  std::shared_ptr<const ReferenceSurface> reference;
  std::shared_ptr<const Iterate> neighbour;
  bool operator==(const LayerInputs&) const = default;
  bool complete() const { return settings.mode != ComplexKind::Cluster || clusters; }
};
// What is known of a layer besides its settings.
struct LayerRun {
  std::uint64_t id = 0;
  Layer layer;                                   // as the document last had it
  std::optional<LayerInputs> started;            // of the newest solve; none: never, or it was superseded
  bool stale = true;                             // the present inputs are others
  std::uint64_t ticket = 0;                      // of the newest solve
  SolverKind asked = SolverKind::Tangent;        // for that solve; a polish asks for Auto
  std::shared_ptr<const ElementIds> ids;         // of the mesh of the newest solve
  std::shared_ptr<const Iterate> newest;         // that any solve delivered
  std::shared_ptr<const ElementIds> newest_ids;  // of its mesh
  bool newest_final = false;
  std::shared_ptr<const Iterate> finished;  // the newest outcome; what other layers are fitted to
  std::shared_ptr<const ElementIds> finished_ids;
  std::shared_ptr<const PreparedView> shown;
  std::shared_ptr<const PreparedFindings> findings;  // of that view, if their number is its
  std::uint64_t submitted = 0;                       // number of the newest job for the preparer
  double thickness = 0.0;                            // that job's
  std::shared_ptr<const Iterate> beams_to;
  std::vector<Iteration> history;
  std::uint64_t history_ticket = 0;
  double milliseconds_per_step = 0.0;
  std::optional<SolveReport> report;
  bool saved = false;                   // the newest state is as a project had it; there is no report
  std::optional<SolverKind> made_with;  // what was asked for when that result was made; none: no result
  bool polish_wanted = false;           // the designer has asked for it
  bool polish_declined = false;         // a polish of this result has come to nothing
  std::vector<SolveReport::Energy> energies;
  bool failed = false;          // the newest outcome had no state to show
  std::uint64_t complaint = 0;  // message about how the newest solve ended, 0: none
};

}  // namespace planewright::ui
