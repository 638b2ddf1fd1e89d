// AppState's layers: which of them has to be solved, with what, and how it stands.
#include <algorithm>
#include <iterator>

#include "core/design/reference_file.h"
#include "core/edit/design_edits.h"
#include "core/mesh/closest_point.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

constexpr const char* kCoplanarDemand = "coplanar-beams";

}  // namespace

const LayerRun& AppState::run(int layer) const {
  return runs_[static_cast<std::size_t>(std::clamp(layer, 0, static_cast<int>(runs_.size()) - 1))];
}

LayerRun* AppState::find_run(std::uint64_t id) {
  if (id == 0) return nullptr;
  const auto found = std::find_if(runs_.begin(), runs_.end(), [&](const LayerRun& r) { return r.id == id; });
  return found == runs_.end() ? nullptr : &*found;
}

// Layers have no identity of their own in a design. As long as their number stays, the place tells them
// apart; when one comes or goes (undo included), the others are still what they were.
void AppState::match_runs() {
  const std::vector<Layer>& layers = document_.design().layers;
  if (runs_.size() != layers.size()) {
    std::vector<LayerRun> before = std::exchange(runs_, {});
    runs_.resize(layers.size());
    std::vector<char> matched(before.size(), 0);
    const auto match = [&](auto same) {
      for (std::size_t i = 0; i < layers.size(); ++i) {
        for (std::size_t k = 0; k < before.size() && runs_[i].id == 0; ++k) {
          if (matched[k] || !same(before[k].layer, layers[i])) continue;
          runs_[i] = std::move(before[k]);
          matched[k] = 1;
        }
      }
    };
    match([](const Layer& a, const Layer& b) { return a.name == b.name && a.settings == b.settings; });
    match([](const Layer& a, const Layer& b) { return a.name == b.name; });
    match([](const Layer& a, const Layer& b) { return a.settings.offset == b.settings.offset; });
    // A new layer comes last, and may have changed the first (a name, an offset) on coming.
    for (std::size_t i = 0; i < std::min(before.size(), runs_.size()); ++i) {
      if (runs_[i].id == 0 && !matched[i]) runs_[i] = std::move(before[i]);
    }
    for (LayerRun& fresh : runs_) {
      if (fresh.id == 0) fresh.id = next_run_++;
    }
    if (find_run(solving_run_) == nullptr && outcome_due_) {  // its layer is gone
      solving_run_ = 0;
      outcome_due_ = false;
      session_.stop();
    }
  }
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (runs_[i].id == 0) runs_[i].id = next_run_++;
    runs_[i].layer = layers[i];
  }
}

std::shared_ptr<const Iterate> AppState::finished(int layer,
                                                  const std::shared_ptr<const ElementIds>& ids) const {
  const LayerRun& of = run(layer);
  const bool same = of.finished_ids == ids || (of.finished_ids && ids && *of.finished_ids == *ids);
  return same ? of.finished : nullptr;
}

LayerInputs AppState::inputs_of(int layer) const {
  const Design& design = document_.design();
  const Layer& of = design.layers[static_cast<std::size_t>(layer)];
  LayerInputs inputs;
  inputs.mesh = document_.mesh();
  inputs.settings = of.settings;
  if (of.settings.mode == ComplexKind::Cluster) inputs.clusters = document_.clusters();
  inputs.reference = reference_;
  std::vector<Demand>& demands = inputs.settings.demands.list;
  if (of.coplanar_with >= 0 && of.coplanar_with < layer) {
    // Before that layer has a result this one is solved without; and again when it is there.
    inputs.neighbour = finished(of.coplanar_with, document_.ids());
    const bool there = std::any_of(demands.begin(), demands.end(),
                                   [](const Demand& d) { return d.name == kCoplanarDemand; });
    if (inputs.neighbour && !there) demands.push_back({kCoplanarDemand, true, {}, {}});
  }
  for (const Selection& selection : design.selections) {
    const bool named = std::any_of(demands.begin(), demands.end(),
                                   [&](const Demand& d) { return d.on && d.selection == selection.name; });
    if (named) inputs.selections.push_back(selection);
  }
  return inputs;
}

void AppState::refresh_stale() {
  if (document_.empty()) return;
  for (int i = 0; i < layer_count(); ++i) {
    LayerRun& of = runs_[static_cast<std::size_t>(i)];
    of.stale = reference_missing() || !of.started || *of.started != inputs_of(i);
  }
}

int AppState::next_waiting() const {
  if (!background_wanted_ || document_.empty() || !reference_ready() || reference_missing()) return -1;
  for (int i = 0; i < layer_count(); ++i) {
    if (run(i).stale && inputs_of(i).complete()) return i;
  }
  return -1;
}

// Thickness and the layer that beams lead to need no solve, only another view of the same state.
void AppState::show_settings_of_views() {
  const std::vector<Layer>& layers = document_.design().layers;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    LayerRun& of = runs_[i];
    if (!of.newest) continue;
    const int k = layers[i].coplanar_with;
    const auto beams_to =
        k >= 0 && k < static_cast<int>(i) ? finished(k, of.newest_ids) : std::shared_ptr<const Iterate>();
    if (of.thickness != layers[i].thickness || of.beams_to != beams_to) submit(of);
  }
}

void AppState::submit(LayerRun& of) {
  const auto index = static_cast<int>(&of - runs_.data());
  const int k = of.layer.coplanar_with;
  of.thickness = of.layer.thickness;
  of.beams_to = k >= 0 && k < index ? finished(k, of.newest_ids) : nullptr;
  of.submitted = next_job_++;
  PrepareJob job;
  job.iterate = of.newest;
  job.ids = of.newest_ids;
  job.scene_origin = scene_origin_;
  job.final = of.newest_final;
  job.layer = of.id;
  job.number = of.submitted;
  job.thickness = of.thickness;
  job.neighbour = of.beams_to;
  job.thresholds = finding_settings_;
  preparer_.submit(std::move(job));
}

bool AppState::reference_ready() const {
  return !reference_loader_.running() && document_.design().reference == reference_path_;
}

bool AppState::reference_missing() const {
  return reference_error_ && document_.design().reference == reference_path_;
}

// Going on against the mesh itself would show panels of another design than the one that is asked for.
void AppState::hold_without_reference() {
  solve_wanted_ = false;
  if (reference_complaint_ != 0) dismiss(reference_complaint_);
  post(Message::Kind::Error,
       "nothing is solved until the reference is changed or removed: " + reference_error_->what,
       reference_error_->where, reference_error_->remedy);
  reference_complaint_ = messages_posted();
}

void AppState::set_reference(std::string path, Result<std::shared_ptr<const ReferenceSurface>> read) {
  reference_path_ = std::move(path);
  reference_.reset();
  reference_error_.reset();
  if (read) {
    reference_ = std::move(*read);
  } else {
    reference_error_ = read.error();
    if (reference_missing()) hold_without_reference();
  }
}

bool AppState::take_reference() {
  bool changed = false;
  if (auto loaded = reference_loader_.take()) {
    // What was asked for before another design was opened is nothing to this one.
    changed = loaded->first == document_.design().reference;
    if (changed) set_reference(std::move(loaded->first), std::move(loaded->second));
  }
  const std::string& wanted = document_.design().reference;
  if (wanted != reference_path_ && !reference_loader_.running()) {
    if (wanted.empty()) {
      reference_path_.clear();
      reference_.reset();
      reference_error_.reset();
      changed = true;
    } else if (!document_.empty()) {
      reference_loader_.start(
          [wanted, mesh = document_.mesh()] {
            return LoadedReference{wanted, load_reference(wanted, *mesh)};
          },
          wake_);
    }
  }
  if (reference_complaint_ != 0 && !reference_missing()) dismiss(std::exchange(reference_complaint_, 0));
  if (changed) {
    refresh_stale();
    if (auto_solve_ && !document_.empty() && active_run().stale) solve_wanted_ = true;
  }
  return changed;
}

// --- What a designer does with them ----------------------------------------------------------

void AppState::set_active_layer(int layer) {
  if (layer == active_layer() || layer < 0 || layer >= layer_count()) return;
  end_merge();
  end_advice();
  document_.set_active_layer(layer);
  selected_panel.reset();
  selected_point.reset();
  selected_edge.reset();
  current_finding_.reset();
  current_suggestion_.reset();
  walked_.reset();
  next_row_ = 0;
  last_fingerprint_ = 0;
  iterates_before_end_ = 0;
  if (const auto& view = shown(); view && !view_range_locked()) {
    planarity_range_ = view->planarity.max;
    displacement_range_ = view->displacement.max;
  }
  if (auto_solve_ && active_run().stale) solve_wanted_ = true;
}

void AppState::add_layer() {
  if (document_.empty()) return;
  change_design(with_layer_added(document_.design(), active_layer(), mean_edge()), "Add layer");
  set_active_layer(layer_count() - 1);
}

void AppState::duplicate_layer(int layer) {
  if (document_.empty() || layer < 0 || layer >= layer_count()) return;
  change_design(with_layer_duplicated(document_.design(), layer), "Duplicate layer");
  set_active_layer(layer_count() - 1);
}

void AppState::remove_layer(int layer) {
  if (layer_count() < 2 || layer < 0 || layer >= layer_count()) return;
  const int active = active_layer();
  const std::string name = document_.design().layers[static_cast<std::size_t>(layer)].name;
  change_design(with_layer_removed(document_.design(), layer), "Remove layer " + name);
  if (active > layer) document_.set_active_layer(active - 1);
  clear_selection();
}

void AppState::change_layer(int layer, Layer changed, std::string what, std::string merge_key) {
  if (layer < 0 || layer >= layer_count()) return;
  Design design = document_.design();
  design.layers[static_cast<std::size_t>(layer)] = std::move(changed);
  change_design(std::move(design), std::move(what), std::move(merge_key));
}

int AppState::unmet_demands(int layer) const {
  const SolveReport* of = report(layer);
  if (of == nullptr) return 0;
  int unmet = of->crossings > 0 ? 1 : 0;
  for (const SolveReport::Constraint& constraint : of->constraints) {
    const bool basic = constraint.name == "incidence" || constraint.name == "unit normal";
    if (!basic && constraint.violated > 0) ++unmet;
  }
  return std::max(unmet, of->conflicts.empty() ? 0 : 1);
}

LayerStatus AppState::layer_status(int layer) const {
  const LayerRun& of = run(layer);
  if (outcome_due_ && solving_run_ == of.id) return LayerStatus::Solving;
  if (of.failed) return LayerStatus::Failed;
  if (of.saved && !of.stale) return LayerStatus::Saved;
  if (!of.report || of.stale) return LayerStatus::Waiting;
  switch (of.report->status) {
    case SolveStatus::Failed:
      return LayerStatus::Failed;
    case SolveStatus::NotPlanar:
      return LayerStatus::NotPlanar;
    case SolveStatus::Infeasible:
      return LayerStatus::Unmet;
    case SolveStatus::Converged:
    case SolveStatus::Planar:
    case SolveStatus::Stopped:
      break;
  }
  if (unmet_demands(layer) > 0) return LayerStatus::Unmet;
  return of.report->status == SolveStatus::Converged ? LayerStatus::Done : LayerStatus::Planar;
}

std::optional<int> AppState::solving_layer() const {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (outcome_due_ && runs_[i].id == solving_run_) return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace planewright::ui
