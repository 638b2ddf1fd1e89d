#include "core/edit/document.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include "core/edit/remap.h"

namespace planewright {
namespace {

// Of a mesh that needs no repair: what is odd about it all the same.
HealthReport health_of(const PolygonMesh& mesh) {
  HealthReport health;
  health.vertices = mesh.vertex_count();
  health.faces = mesh.face_count();
  if (auto checked = check_and_repair(mesh.positions(), mesh.faces())) health = std::move(checked->health);
  health.repaired = false;
  return health;
}

}  // namespace

void Document::open(CheckedMesh mesh, std::string name, LayerSettings settings, WorkshopContract contract) {
  Design design;
  design.layers.front().settings = std::move(settings);
  Project project = new_project(std::move(name), std::move(mesh.mesh), std::move(design));
  project.contract = std::move(contract);
  begin(std::move(project), std::move(mesh.health));
}

void Document::open_project(Project project) {
  HealthReport health = health_of(project.mesh);
  begin(std::move(project), std::move(health));
}

void Document::begin(Project project, HealthReport health) {
  assert(!project.design.layers.empty());
  Moment opened;
  opened.mesh = std::make_shared<const PolygonMesh>(std::move(project.mesh));
  opened.ids = std::make_shared<const ElementIds>(std::move(project.names.ids));
  opened.design = std::move(project.design);
  opened.contract = project.contract;
  if (project.clusters)
    if (auto made = clusters_of(opened.mesh, *project.clusters)) opened.clusters = std::move(*made);
  numbering_ = project.names.numbering;
  panel_numbers_ = std::move(project.names.panels);
  given_names_ = std::move(project.given_names);
  health_ = std::move(health);
  name_ = std::move(project.name);
  active_layer_ = 0;
  history_.begin(std::move(opened));
  ++revision_;
}

Project Document::to_project() const {
  assert(!empty());
  Project project;
  project.name = name_;
  project.mesh = *mesh();
  project.design = design();
  project.contract = contract();
  project.names = {*ids(), numbering_, panel_numbers_};
  project.given_names = given_names_;
  if (clusters()) project.clusters = record_of(*clusters());
  project.solved.resize(design().layers.size());
  return project;
}

void Document::set_active_layer(int layer) {
  active_layer_ = std::clamp(layer, 0, static_cast<int>(design().layers.size()) - 1);
}

int Document::panel_number(int layer, int plane_origin) const {
  if (empty() || layer < 0 || layer >= static_cast<int>(design().layers.size())) return -1;
  const LayerSettings& settings = design().layers[static_cast<std::size_t>(layer)].settings;
  return panel_numbers_.number(settings.mode, settings.border, *ids(), plane_origin);
}

void Document::forget_names(int layer) {
  if (layer >= 0 && layer < static_cast<int>(design().layers.size()))
    given_names_.erase(panel_series(design().layers[static_cast<std::size_t>(layer)].settings));
}

Result<void> Document::keep_names(int layer, const std::map<int, std::string>& names) {
  if (layer < 0 || layer >= static_cast<int>(design().layers.size()))
    return fail(ErrorCode::Refused, "there is no layer " + std::to_string(layer));
  return add_names(given_names_, panel_series(design().layers[static_cast<std::size_t>(layer)].settings),
                   names);
}

Result<void> Document::may_edit(const MeshEdit& edit) const {
  if (empty()) return fail(ErrorCode::Refused, "there is no mesh yet", {}, "Open one first.");
  return may_apply(*mesh(), edit);
}

Result<std::vector<std::string>> Document::edit_mesh(const MeshEdit& edit, std::string merge_key) {
  if (auto allowed = may_edit(edit); !allowed) return tl::unexpected(allowed.error());
  return edit_mesh(std::vector{edit}, describe(edit), std::move(merge_key));
}

Result<std::vector<std::string>> Document::edit_mesh(const std::vector<MeshEdit>& edits, std::string what,
                                                     std::string merge_key) {
  if (empty()) return fail(ErrorCode::Refused, "there is no mesh yet", {}, "Open one first.");
  if (edits.empty()) return std::vector<std::string>{};
  EditedMesh edited;
  for (std::size_t i = 0; i < edits.size(); ++i) {
    auto next = apply(i == 0 ? *mesh() : edited.mesh, edits[i]);
    if (!next) {
      Error error = next.error();
      if (edits.size() > 1) {
        error.where =
            "edit " + std::to_string(i + 1) + " of " + std::to_string(edits.size()) + ", " + error.where;
      }
      return tl::unexpected(std::move(error));
    }
    edited = {std::move(next->mesh), i == 0 ? std::move(next->map) : composed(edited.map, next->map)};
  }
  Moment next = history_.present();
  next.mesh = std::make_shared<const PolygonMesh>(std::move(edited.mesh));
  std::optional<std::string> lost_clusters;
  if (next.clusters) {
    auto carried = carried_over(*next.clusters, next.mesh, edited.map.faces);
    if (!carried) lost_clusters = "the clusters (" + carried.error().what + ")";
    next.clusters = carried ? std::move(*carried) : nullptr;
  }
  RemappedDesign design =
      remapped(std::move(next.design), edited.map, *mesh(), *next.mesh, {clusters(), next.clusters});
  if (lost_clusters) design.dropped.push_back(*std::move(lost_clusters));
  next.design = std::move(design.design);
  ElementIds ids = numbering_.edited(*next.ids, edited.map);
  if (ids != *next.ids) next.ids = std::make_shared<const ElementIds>(std::move(ids));
  next.what = std::move(what);
  next.merge_key = std::move(merge_key);
  step(std::move(next));
  return std::move(design.dropped);
}

void Document::change_settings(LayerSettings settings, std::string what, std::string merge_key) {
  Design changed = design();
  changed.layers[static_cast<std::size_t>(active_layer_)].settings = std::move(settings);
  change_design(std::move(changed), std::move(what), std::move(merge_key));
}

void Document::change_design(Design changed, std::string what, std::string merge_key) {
  assert(!changed.layers.empty());
  if (changed == design()) return;
  Moment next = history_.present();
  next.design = std::move(changed);
  next.what = std::move(what);
  next.merge_key = std::move(merge_key);
  step(std::move(next));
}

void Document::change_contract(WorkshopContract changed, std::string what, std::string merge_key) {
  if (changed == contract()) return;
  Moment next = history_.present();
  next.contract = changed;
  next.what = std::move(what);
  next.merge_key = std::move(merge_key);
  step(std::move(next));
}

std::vector<std::string> Document::change_clusters(SharedClusters changed, std::string what,
                                                   std::string merge_key) {
  assert(changed && changed->mesh == mesh());
  if (changed == clusters()) return {};
  Moment next = history_.present();
  RemappedDesign design = with_clusters_changed(std::move(next.design), *mesh(), {clusters(), changed});
  next.design = std::move(design.design);
  next.clusters = std::move(changed);
  next.what = std::move(what);
  next.merge_key = std::move(merge_key);
  step(std::move(next));
  return std::move(design.dropped);
}

void Document::set_clusters(SharedClusters clusters) {
  assert(clusters && clusters->mesh == mesh());
  history_.set_clusters(std::move(clusters));
  ++revision_;
}

void Document::set_results(std::shared_ptr<const ShownResults> results) {
  history_.set_results(std::move(results));
}

// Mesh and design, and with them the revision, stay.
void Document::record_solve(std::shared_ptr<const ShownResults> results, std::string what) {
  if (history_.merging()) {
    set_results(std::move(results));
    return;
  }
  Moment next = history_.present();
  next.results = std::move(results);
  next.what = std::move(what);
  next.merge_key.clear();
  history_.step(std::move(next));
}

std::string Document::undo_name() const {
  return can_undo() ? history_.step_name(steps_done() - 1) : std::string();
}
std::string Document::redo_name() const {
  return can_redo() ? history_.step_name(steps_done()) : std::string();
}

std::vector<std::string> Document::history() const {
  std::vector<std::string> names;
  for (int step = 0; step < history_.steps(); ++step) names.push_back(history_.step_name(step));
  return names;
}

void Document::go_to(int steps) {
  const int before = steps_done();
  history_.go_to(steps);
  if (steps_done() == before) return;
  set_active_layer(active_layer_);
  ++revision_;
}

void Document::step(Moment next) {
  history_.step(std::move(next));
  set_active_layer(active_layer_);
  ++revision_;
}

}  // namespace planewright
