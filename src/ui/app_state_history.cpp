// AppState's way through the history: edits of the mesh, undo and redo, with the panels that each moment had.
#include "core/edit/remap.h"
#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {

struct AppState::ShownLayers final : ShownResults {
  std::vector<LayerRun> runs;
};

bool AppState::edit_mesh(const MeshEdit& edit, std::string merge_key) {
  const auto revision = document_.revision();
  const bool drags = !merge_key.empty();
  return mesh_edited(document_.edit_mesh(edit, std::move(merge_key)), revision, drags);
}

bool AppState::edit_mesh(const std::vector<MeshEdit>& edits, std::string what, std::string merge_key) {
  const auto revision = document_.revision();
  const bool drags = !merge_key.empty();
  return mesh_edited(document_.edit_mesh(edits, std::move(what), std::move(merge_key)), revision, drags);
}

bool AppState::mesh_edited(const Result<std::vector<std::string>>& edited, std::uint64_t revision,
                           bool drags) {
  if (!edited) {
    post(edited.error());
    return false;
  }
  if (document_.revision() == revision) return true;
  // What was asked for of the mesh before; should its clusters be lost, they are made anew as they were.
  const ClusterOptions options = cluster_options();
  drop_cluster_wishes();
  if (!clusters() && clusters_wanted()) cluster_asked_ = options;
  merging_ = drags;
  document_changed();
  // The next solve supersedes the one that runs; where none follows, that one ends with what it has.
  if (outcome_due_ && !solve_wanted_) session_.stop();
  tell_of_dropped(*edited);
  return true;
}

void AppState::tell_of_dropped(const std::vector<std::string>& dropped) {
  if (dropped.empty()) return;
  std::string lost;
  for (const std::string& what : dropped) lost += (lost.empty() ? "" : ", ") + what;
  post(Message::Kind::Info, lost + " went with it (Ctrl Z brings all back)");
}

void AppState::go_to(int steps) {
  const auto revision = document_.revision();
  drop_cluster_wishes();
  end_merge();
  const int done = document_.steps_done();
  const auto mesh = document_.mesh();
  const auto clusters = document_.clusters();
  const Design design = document_.design();
  const WorkshopContract contract = document_.contract();
  document_.go_to(steps);
  if (document_.revision() == revision) return;
  // A step that changed what the workshop asks for and nothing else has nothing to do with the panels: those
  // that are there stay, and so does the solve that is under way.
  const bool of_the_workshop = std::abs(document_.steps_done() - done) == 1 &&
                               contract != document_.contract() && mesh == document_.mesh() &&
                               clusters == document_.clusters() && design == document_.design();
  if (of_the_workshop) {
    if (active_run().newest_final && !outcome_due_) document_.set_results(results_now());
    return;
  }
  restore_results();
  document_changed();
}

void AppState::follow_elements() {
  const auto& ids = document_.ids();
  if (selection_ids_ == ids) return;
  if (selection_ids_ && *selection_ids_ != *ids) {
    selection_ = remapped(selection_, map_between(*selection_ids_, *ids));
    ++selection_changes_;
  }
  selection_ids_ = ids;
}

std::optional<ElementMap> AppState::since_shown() const {
  const auto& view = shown();
  const auto& ids = document_.ids();
  if (!view || !view->ids || !ids || view->ids == ids || *view->ids == *ids) return std::nullopt;
  return map_between(*view->ids, *ids);
}

Selection AppState::of_present(Selection shown_names) const {
  const auto map = since_shown();
  return map ? remapped(shown_names, *map) : shown_names;
}

Selection AppState::of_shown(Selection names) const {
  const auto map = since_shown();
  return map ? remapped(names, inverse(*map)) : names;
}

// A solve that the designer asked for is a step; one that followed by itself is part of the step it followed,
// and a polish of what it polished.
std::shared_ptr<const ShownResults> AppState::results_now() const {
  auto shown = std::make_shared<ShownLayers>();
  shown->runs = runs_;
  for (LayerRun& of : shown->runs) {
    of.shown.reset();  // views are large; they are prepared again
    of.findings.reset();
    of.beams_to.reset();
    of.complaint = 0;
    of.polish_wanted = false;
  }
  return shown;
}

void AppState::remember_results() {
  auto shown = results_now();
  const bool is_step = solve_is_step_ && run(active_layer()).ticket == session_.current_ticket() &&
                       active_run().asked != SolverKind::Auto;
  if (is_step) {
    solve_is_step_ = false;
    document_.record_solve(std::move(shown));
  } else {
    document_.set_results(std::move(shown));
  }
}

void AppState::restore_results() {
  const auto* shown = dynamic_cast<const ShownLayers*>(document_.results().get());
  if (shown == nullptr) return;
  if (outcome_due_) {  // what the session still delivers is nobody's
    solving_run_ = 0;
    outcome_due_ = false;
    session_.stop();
  }
  solve_wanted_ = start_afresh_ = false;
  std::vector<LayerRun> before = std::exchange(runs_, shown->runs);
  for (LayerRun& of : runs_) {
    if (!of.newest) of.submitted = 0;
    for (LayerRun& was : before) {
      if (was.id != of.id || !of.newest) continue;
      of.shown = std::move(was.shown);
      of.findings = std::move(was.findings);
    }
  }
  for (const LayerRun& was : before) {
    if (was.complaint != 0) dismiss(was.complaint);
  }
  for (LayerRun& of : runs_) {
    if (of.newest) submit(of);
  }
}

}  // namespace planewright::ui
