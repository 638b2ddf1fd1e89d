// Document: one design as the designer edits it: mesh, layers with their settings, clusters of the mesh,
// selections, what the workshop asks for, name, and what can be undone.
//
// Every change goes through a member here and is a step of the history. Consecutive changes of the same
// setting (a slider being dragged) are one step: `merge_key` says which belong together, and `end_merge()`
// (the mouse button goes up) closes the step. The mesh is shared as const, so that a solve on another thread
// keeps the one it began with. Threads: one thread (the window's, or the command line's).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/design/layer_settings.h"
#include "core/edit/element_names.h"
#include "core/edit/given_names.h"
#include "core/edit/history.h"
#include "core/edit/project.h"
#include "core/mesh/health_report.h"
#include "core/mesh/mesh_edits.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

class Document {
 public:
  Document() = default;

  // Replaces everything; the history begins anew. `name`: shown in the title ("train-station.off").
  // Mode and weights start at `settings`.
  void open(CheckedMesh mesh, std::string name, LayerSettings settings, WorkshopContract contract = {});

  // The same for a project. What is solved of it is not the document's business, but whoever's shows results.
  void open_project(Project project);
  // All that open_project() needs to go on from the present moment; nothing solved, which whoever shows
  // results may add. Precondition: not empty.
  Project to_project() const;

  bool empty() const { return mesh() == nullptr; }
  const std::shared_ptr<const PolygonMesh>& mesh() const { return history_.present().mesh; }
  const HealthReport& health() const { return health_; }
  const Design& design() const { return history_.present().design; }
  // The layer that edits of settings go to; which one it is is no step of undo.
  int active_layer() const { return active_layer_; }
  void set_active_layer(int layer);  // clamped to the layers there are
  const LayerSettings& settings() const {
    return design().layers[static_cast<std::size_t>(active_layer_)].settings;
  }
  // Unit, tolerances and what else the workshop asks for.
  const WorkshopContract& contract() const { return history_.present().contract; }
  const std::string& name() const { return name_; }
  // Grows with every change of mesh or settings, undo and redo included: what is shown is stale if it was
  // solved for another revision.
  std::uint64_t revision() const { return revision_; }

  // Tells what the design is now from what it was at any other time: another number after every change, the
  // same one again after undo and redo. Results count only where a step of their own recorded them.
  std::uint64_t moment() const { return history_.present().number; }

  // The number of each element of the mesh, which it keeps through edits, undo and redo; null if empty.
  const std::shared_ptr<const ElementIds>& ids() const { return history_.present().ids; }
  // What a panel of a layer is called (panel_name()), by its TangentComplex::plane_origin in the present
  // mesh.
  int panel_number(int layer, int plane_origin) const;
  // The same for panels of another moment's mesh, which `ids` numbers.
  int panel_number(ComplexKind kind, BorderPolicy border, const ElementIds& ids, int plane_origin) const {
    return panel_numbers_.number(kind, border, ids, plane_origin);
  }

  // What panels were called when they left for the workshop, by panel number. Kept whatever is undone.
  const GivenNames& given_names() const { return given_names_; }
  // Adds names of a layer's panels, by panel_number(), over earlier ones; no step. Refused, with nothing
  // changed, as add_names() says, or if there is no such layer.
  Result<void> keep_names(int layer, const std::map<int, std::string>& names);
  // Panels of the layer's kind are named by the rules again; no step.
  void forget_names(int layer);

  // Why an edit of the present mesh is refused, as an error for the designer. Cheap.
  Result<void> may_edit(const MeshEdit& edit) const;
  // Edits the mesh. Selections, pins and waivers go on to name what they named, and clusters are carried
  // over; returns what of them went with elements that are gone, each a line for the designer, mostly
  // nothing. Refused, with nothing changed, for the reasons of may_edit().
  Result<std::vector<std::string>> edit_mesh(const MeshEdit& edit, std::string merge_key = {});
  // Several as one step, `what`; each names elements of the mesh that those before have made. Refused, with
  // nothing changed, if one is; the error names it. No edits, no step.
  Result<std::vector<std::string>> edit_mesh(const std::vector<MeshEdit>& edits, std::string what,
                                             std::string merge_key = {});
  // Changes the settings of the active layer; `what` names the step for the Edit menu ("Weight of fairing");
  // equal keys merge until end_merge(). No change, no step.
  void change_settings(LayerSettings settings, std::string what, std::string merge_key = {});
  // Changes layers or selections; the same rules. Precondition: at least one layer.
  void change_design(Design changed, std::string what, std::string merge_key = {});
  // Changes unit, tolerances and the like; the same rules.
  void change_contract(WorkshopContract changed, std::string what, std::string merge_key = {});
  void end_merge() { history_.end_merge(); }
  bool merging() const { return history_.merging(); }  // the newest step is still open

  // The regions that panels of clusters are made of; shared by all layers. Null: not known.
  const SharedClusters& clusters() const { return history_.present().clusters; }
  // As a step, by the rules of change_settings(). What names panels by their region goes on to name those
  // that are still there; returns what went with the others, each a line for the designer. Precondition:
  // clusters of the present mesh.
  std::vector<std::string> change_clusters(SharedClusters clusters, std::string what,
                                           std::string merge_key = {});
  // Those that the newest step needs: part of that step. The same precondition.
  void set_clusters(SharedClusters clusters);

  // What is shown now. A step begins with what was shown before it; null until the first are set.
  const std::shared_ptr<const ShownResults>& results() const { return history_.present().results; }
  // A solve that followed by itself from the newest step is complete: part of that step.
  void set_results(std::shared_ptr<const ShownResults> results);
  // A solve that the designer asked for is complete: a step of its own. While changes merge (a slider is
  // being dragged), part of theirs.
  void record_solve(std::shared_ptr<const ShownResults> results, std::string what = "Solve");

  bool can_undo() const { return steps_done() > 0; }
  bool can_redo() const { return steps_done() < history_.steps(); }
  std::string undo_name() const;  // "Flip edge 1042"; empty if there is none
  std::string redo_name() const;
  void undo() { go_to(steps_done() - 1); }
  void redo() { go_to(steps_done() + 1); }

  // The names of all steps, first to last; steps 0 .. steps_done()-1 are in force, the rest can be redone.
  std::vector<std::string> history() const;
  int steps_done() const { return history_.done(); }
  // Undoes or redoes until `steps` of them are in force; 0: as it was opened. Clamped.
  void go_to(int steps);

 private:
  void begin(Project project, HealthReport health);
  void step(Moment next);

  HealthReport health_;
  int active_layer_ = 0;
  std::string name_;
  std::uint64_t revision_ = 0;
  History history_;
  ElementNumbering numbering_;
  PanelNumbers panel_numbers_;
  GivenNames given_names_;
};

}  // namespace planewright
