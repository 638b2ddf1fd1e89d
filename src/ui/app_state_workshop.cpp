// AppState's workshop: what the panels that are shown are to a workshop, and the way through what fails.
#include <map>

#include "core/base/atomic_file.h"
#include "core/workshop/length_unit.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

// Whether what is known of one state's panels can be told of another's: they are the same panels with the
// same corners, a step earlier or later. After a flip panels have the same vertices of the mesh and other
// corners.
bool same_panels(const TangentComplex& a, const TangentComplex& b) {
  return &a == &b || (a.kind == b.kind && a.plane_origin == b.plane_origin && a.panels == b.panels);
}

}  // namespace

const std::string& AppState::unit() const {
  static const auto symbols = [] {
    std::map<LengthUnit, std::string> of;
    for (const LengthUnit unit : length_units()) of[unit] = symbol(unit);
    return of;
  }();
  return symbols.at(document_.empty() ? default_unit : document_.contract().unit);
}

void AppState::change_contract(WorkshopContract changed, std::string what, std::string merge_key) {
  if (document_.empty()) return;
  document_.change_contract(std::move(changed), std::move(what), std::move(merge_key));
}

void AppState::load_tolerances(const std::filesystem::path& path) {
  if (sheet_task_.running()) return;
  sheet_design_ = opened_count_;
  sheet_task_.start(
      [path]() -> Result<SheetFile> {
        return read_file(path)
            .and_then([&](const std::string& text) { return read_tolerance_sheet(text, path.string()); })
            .map([&](ToleranceSheet&& sheet) {
              return SheetFile{path.filename().string(), sheet};
            });
      },
      wake_);
}

void AppState::save_tolerances(const std::filesystem::path& path) {
  if (sheet_task_.running()) return;
  sheet_task_.start(
      [path, text = to_json(contract().tolerances)]() -> Result<SheetFile> {
        return write_file_atomically(path, text).map([&] {
          return SheetFile{path.filename().string(), std::nullopt};
        });
      },
      wake_);
}

bool AppState::update_sheet() {
  auto file = sheet_task_.take();
  if (!file) return false;
  if (!*file) {
    post(file->error());
  } else if ((*file)->loaded) {
    if (sheet_design_ != opened_count_) return true;  // it was meant for the design before
    WorkshopContract changed = contract();
    changed.tolerances = *(*file)->loaded;
    change_contract(std::move(changed), "Tolerances of " + (*file)->name);
  } else {
    post(Message::Kind::Info, "Saved " + (*file)->name);
  }
  return true;
}

WorkshopJob AppState::workshop_job() const {
  const LayerRun& of = run(active_layer());
  WorkshopJob job;
  job.layer = of.id;
  job.iterate = of.shown->iterate;
  job.contract = document_.contract();
  job.title = std::filesystem::path(document_.name()).stem().string();
  job.mesh = document_.mesh();
  job.reference = reference_;
  job.thorough = of.shown->final;
  const TangentComplex& complex = *job.iterate->complex;
  const LayerSettings& settings = document_.settings();
  const auto& ids = of.shown->ids ? of.shown->ids : document_.ids();
  job.numbers.reserve(complex.plane_origin.size());
  for (const int origin : complex.plane_origin)
    job.numbers.push_back(document_.panel_number(complex.kind, settings.border, *ids, origin));
  PanelSeries series = panel_series(settings);
  series.kind = complex.kind;  // of what is shown, which a change of mode can be ahead of
  if (const auto given = document_.given_names().find(series); given != document_.given_names().end())
    job.given_names.assign(given->second.begin(), given->second.end());
  return job;
}

WorkshopKey AppState::workshop_key() const {
  const LayerRun& of = run(active_layer());
  return {of.id,      of.shown->iterate, of.shown->final, document_.contract(), document_.mesh(),
          reference_, names_given_};
}

bool AppState::workshop_known() const {
  return !workshop_in_sight || !shown() || workshop_watch_.asked_for(workshop_key());
}

bool AppState::update_workshop() {
  const bool changed = workshop_watch_.update();
  if (changed) follow_failure();
  if (!workshop_watch_.busy() && !workshop_known()) workshop_watch_.ask(workshop_key(), workshop_job());
  return changed;
}

std::shared_ptr<const PreparedWorkshop> AppState::workshop() const {
  const LayerRun& of = run(active_layer());
  const auto& newest = workshop_watch_.newest();
  const bool fits = newest && of.shown && newest->job.layer == of.id &&
                    same_panels(*newest->job.iterate->complex, *of.shown->iterate->complex);
  return fits ? newest : nullptr;
}

bool AppState::workshop_fits() const {
  return workshop() != nullptr && workshop_watch_.fits(workshop_key());
}

void AppState::keep_names(const WorkshopModel& model, int layer) {
  std::map<int, std::string> names;
  for (std::size_t p = 0; p < model.names.size(); ++p) names[model.numbers[p]] = model.names[p];
  if (const auto kept = document_.keep_names(layer, names); !kept) post(kept.error());
  ++names_given_;
}

int AppState::kept_names() const {
  if (document_.empty()) return 0;
  const GivenNames& given = document_.given_names();
  const auto names = given.find(panel_series(document_.settings()));
  return names == given.end() ? 0 : static_cast<int>(names->second.size());
}

void AppState::forget_names() {
  if (kept_names() == 0) return;
  document_.forget_names(active_layer());
  ++names_given_;
}

const FailureList& AppState::failure_list() const {
  const auto from = workshop();
  if (failure_list_.from != from || failure_list_.hidden != view_options.hidden_failures)
    failure_list_ = make_failure_list(from, view_options.hidden_failures);
  return failure_list_;
}

void AppState::follow_failure() {
  if (current_failure_ && !failure_list().find(*current_failure_)) current_failure_.reset();
}

std::optional<int> AppState::current_failure() const {
  return current_failure_ ? failure_list().find(*current_failure_) : std::nullopt;
}

void AppState::show_panel(int panel) {
  if (!shown() || panel < 0 || panel >= shown()->complex().plane_count()) return;
  show_element({ElementKind::Panel, panel});
  if (look_at_)
    look_at_->outside = newell_vector(shown()->points, shown()->complex().panels[panel]).normalized();
}

void AppState::show_failure(int row) {
  const FailureList& list = failure_list();
  if (row < 0 || row >= list.size()) return;
  const ToleranceFailure failure = list.failure(row);
  next_failure_ = row;
  show_panel(failure.panel);
  current_failure_ = failure;
  if (failure.side < 0 || !look_at_) return;
  const auto corners = shown()->complex().panels[failure.panel];
  const auto corner = static_cast<std::size_t>(failure.side);
  const Vector3d a = shown()->points.row(corners[corner]),
                 b = shown()->points.row(corners[(corner + 1) % corners.size()]);
  const bool at_corner =
      failure.kind == ToleranceKind::InteriorMin || failure.kind == ToleranceKind::InteriorMax;
  look_at_->point = at_corner ? a : Vector3d(0.5 * (a + b));
}

void AppState::walk_failures(int by) {
  const int count = failure_list().size();
  if (count == 0) return;
  int row =
      by > 0 ? next_failure_ : next_failure_ - 1;  // what has come into the place of one that passes now
  if (const auto current = current_failure()) row = *current + by;
  show_failure((row % count + count) % count);
}

}  // namespace planewright::ui
