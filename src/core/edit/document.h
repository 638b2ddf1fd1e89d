// Document: one design as the designer edits it: mesh, layers with their settings, selections, name, and what
// can be undone.
//
// Every change goes through a member here, which records how to take it back. Consecutive changes of the same
// setting (a slider being dragged) are one step of undo: `merge_key` says which belong together, and
// `end_merge()` (the mouse button goes up) closes the step. The mesh is shared as const, so that a solve on
// another thread keeps the one it began with. Threads: one thread (the window's, or the command line's).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/design/layer_settings.h"
#include "core/mesh/health_report.h"
#include "core/mesh/polygon_mesh.h"

namespace planewright {

class Document {
 public:
  Document() = default;

  // Replaces everything; the undo history begins anew. `name`: shown in the title ("train-station.off").
  // Mode and weights start at `settings`.
  void open(CheckedMesh mesh, std::string name, LayerSettings settings);

  bool empty() const { return mesh_ == nullptr; }
  const std::shared_ptr<const PolygonMesh>& mesh() const { return mesh_; }
  const HealthReport& health() const { return health_; }
  const Design& design() const { return design_; }
  // The layer that edits of settings go to; which one it is is no step of undo.
  int active_layer() const { return active_layer_; }
  void set_active_layer(int layer);  // clamped to the layers there are
  const LayerSettings& settings() const {
    return design_.layers[static_cast<std::size_t>(active_layer_)].settings;
  }
  const std::string& name() const { return name_; }
  // Grows with every change of mesh or settings, undo and redo included: what is shown is stale if it was
  // solved for another revision.
  std::uint64_t revision() const { return revision_; }

  // Whether a mesh edge can be flipped; if not, the reason (border, not between two triangles, the new edge
  // exists already) as an error for the designer.
  Result<void> may_flip(int edge) const;
  // Flips a mesh edge. Refused, with nothing changed, for the reasons of may_flip().
  Result<void> flip_edge(int edge);
  // Changes the settings of the active layer; `what` names the step for the Edit menu ("Weight of fairing");
  // equal keys merge until end_merge(). No change, no step.
  void change_settings(LayerSettings settings, std::string what, std::string merge_key = {});
  // Changes layers or selections; the same rules. Precondition: at least one layer.
  void change_design(Design design, std::string what, std::string merge_key = {});
  void end_merge();

  bool can_undo() const;
  bool can_redo() const;
  std::string undo_name() const;  // "Flip edge 1042"; empty if there is none
  std::string redo_name() const;
  void undo();
  void redo();

 private:
  struct Step {
    std::string what;
    std::string merge_key;
    std::shared_ptr<const PolygonMesh> mesh_before, mesh_after;
    Design design_before, design_after;
  };
  void push(Step step);
  void apply(const std::shared_ptr<const PolygonMesh>& mesh, const Design& design);

  std::shared_ptr<const PolygonMesh> mesh_;
  HealthReport health_;
  Design design_;
  int active_layer_ = 0;
  std::string name_;
  std::uint64_t revision_ = 0;
  std::vector<Step> steps_;
  std::size_t done_ = 0;  // steps_[0 .. done_) are in force, the rest can be redone
  bool merging_ = false;
};

}  // namespace planewright
