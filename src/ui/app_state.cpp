#include "ui/app_state.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/problem/energies/energy_catalogue.h"
#include "core/design/design.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

// While a slider is dragged, a solve is given this long, and one step, before the next value replaces it.
constexpr auto kRestartInterval = 100ms;

// The colour map never spans less than this, and a panel counts as planar below that; both in mean edges.
constexpr double kLeastRange = 1e-3;
constexpr double kPlanarityTolerance = 1e-4;

// 1, 2 or 5 times a power of ten, so that a legend has round numbers and does not flicker.
double round_up(double value) {
  if (!(value > 0)) return 0.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * power * (1 + 1e-9)) return step * power;
  }
  return 10.0 * power;
}

LayerSettings default_settings(const PolygonMesh& mesh) {
  LayerSettings settings;
  settings.mode = suggested_mode(mesh);
  settings.weights.clear();
  for (const EnergyInfo& energy : energy_catalogue()) settings.weights[energy.name] = energy.default_weight;
  return settings;
}

}  // namespace

const char* name(ColourMap map) {
  switch (map) {
    case ColourMap::None:
      return "none";
    case ColourMap::Planarity:
      return "planarity";
    case ColourMap::Displacement:
      return "displacement";
  }
  return "";
}

AppState::AppState(std::function<void()> wake) : wake_(std::move(wake)), preparer_(wake_), session_(wake_) {}
AppState::~AppState() = default;

// --- Files -----------------------------------------------------------------------------------

void AppState::open_file(const std::filesystem::path& path) {
  begin_load(path.filename().string(), [path]() -> Result<Loaded> {
    return load_mesh(path).map([&](CheckedMesh&& mesh) {
      return Loaded{std::move(mesh), path.filename().string()};
    });
  });
}

void AppState::open_sample(std::string sample, int panels) {
  begin_load(sample, [sample, panels]() -> Result<Loaded> {
    return make_sample(sample, panels).and_then([&](PolygonMesh&& mesh) -> Result<Loaded> {
      // Through the same check as a file, so that the report tells of borders and components too.
      return check_and_repair(mesh.positions(), mesh.faces()).map([&](CheckedMesh&& checked) {
        return Loaded{std::move(checked), sample};
      });
    });
  });
}

void AppState::begin_load(std::string name, std::function<Result<Loaded>()> load) {
  if (loader_.running()) {
    load_next_ = [this, name = std::move(name), load = std::move(load)] { begin_load(name, load); };
    return;
  }
  loading_name_ = std::move(name);
  loader_.start(std::move(load), wake_);
}

void AppState::adopt(Loaded loaded) {
  LayerSettings settings = default_settings(loaded.mesh.mesh);
  // The designer's weights and policies outlive the model; mode and offset belong to it.
  if (!document_.empty()) {
    settings.weights = document_.settings().weights;
    settings.border = document_.settings().border;
    settings.freedom = document_.settings().freedom;
  }
  document_.open(std::move(loaded.mesh), std::move(loaded.name), std::move(settings));
  ++opened_count_;

  newest_.reset();
  shown_.reset();
  ghost_.reset();
  history_.clear();
  history_ticket_ = 0;
  report_.reset();
  energies_.clear();
  selected_panel.reset();
  selected_point.reset();
  planarity_range_ = displacement_range_ = 0.0;
  iterates_before_end_ = 0;
  last_fingerprint_ = 0;
  merging_ = false;
  start_afresh_ = true;
  ignored_ticket_ = session_.current_ticket();
  session_.stop();

  const Points& positions = document_.mesh()->positions();
  scene_origin_ = 0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff()).transpose();
  refresh_mesh_view();
  solve_wanted_ = true;

  const HealthReport& health = document_.health();
  if (!health.healthy()) {
    post(Message::Kind::Warning, "the mesh has defects: " + health.summary(), document_.name(),
         "See Report on the right for every place.");
  }
}

bool AppState::can_export() const {
  return shown_ != nullptr && !exporter_.running();
}

void AppState::export_panels(const std::filesystem::path& path) {
  if (!shown_) {
    post(Message::Kind::Warning, "there are no panels to export yet", {}, "Solve first.");
    return;
  }
  if (exporter_.running()) {
    post(Message::Kind::Warning, "another export is still being written", {}, "Try again when it is done.");
    return;
  }
  exporter_.start(
      [iterate = shown_->iterate, path]() -> Result<std::string> {
        const Panels panels = panels_of(*iterate->complex, iterate->state);
        return save_mesh(path, panels.points, panels.polygons).map([&] { return path.string(); });
      },
      wake_);
}

// --- Edits -----------------------------------------------------------------------------------

void AppState::change_settings(LayerSettings settings, std::string what, std::string merge_key) {
  if (document_.empty()) return;
  const auto before = document_.revision();
  const bool drags = !merge_key.empty();
  document_.change_settings(std::move(settings), std::move(what), std::move(merge_key));
  if (document_.revision() == before) return;
  merging_ = drags;
  document_changed();
}

void AppState::end_merge() {
  document_.end_merge();
  merging_ = false;
}

bool AppState::flip_edge(int edge) {
  const Result<void> flipped = document_.flip_edge(edge);
  if (!flipped) {
    post(flipped.error());
    return false;
  }
  document_changed();
  return true;
}

void AppState::undo() {
  if (!document_.can_undo()) return;
  end_merge();
  document_.undo();
  document_changed();
}

void AppState::redo() {
  if (!document_.can_redo()) return;
  end_merge();
  document_.redo();
  document_changed();
}

void AppState::document_changed() {
  if (!mesh_view_ || mesh_view_->mesh != document_.mesh()) refresh_mesh_view();
  if (auto_solve_) solve_wanted_ = true;
}

void AppState::refresh_mesh_view() {
  mesh_view_ = std::make_shared<const MeshView>(make_mesh_view(document_.mesh(), scene_origin_));
  preparer_.submit(mesh_view_);
}

// --- Solving ---------------------------------------------------------------------------------

void AppState::solve(Start start) {
  if (document_.empty()) return;
  start_afresh_ = start_afresh_ || start == Start::Afresh;
  solve_wanted_ = true;
}

void AppState::stop() {
  solve_wanted_ = false;
  session_.stop();
}

bool AppState::may_start(Clock::time_point now) const {
  if (!solve_wanted_ || document_.empty()) return false;
  if (!merging_ || !session_.running()) return true;
  const bool stepped =
      history_ticket_ == session_.current_ticket() && !history_.empty() && history_.back().number >= 1;
  return stepped && now - last_start_ >= kRestartInterval;
}

void AppState::start_solve(Clock::time_point now) {
  SolveRequest request;
  request.mesh = document_.mesh();
  request.settings = document_.settings();
  if (!start_afresh_ && newest_ && newest_->complex->kind == request.settings.mode)
    request.warm_start = newest_;
  session_.start(std::move(request));
  solve_wanted_ = false;
  start_afresh_ = false;
  solved_revision_ = document_.revision();
  last_start_ = now;
  iterates_before_end_ = 0;
  last_fingerprint_ = 0;
  outcome_failed_ = false;
}

std::optional<Clock::time_point> AppState::next_deadline() const {
  if (solve_wanted_ && merging_) return last_start_ + kRestartInterval;
  return std::nullopt;
}

bool AppState::update(Clock::time_point now) {
  bool changed = false;
  if (auto loaded = loader_.take()) {
    changed = true;
    loading_name_.clear();
    if (*loaded) {
      adopt(std::move(**loaded));
    } else {
      post(loaded->error());
    }
    if (auto next = std::exchange(load_next_, nullptr)) next();
  }
  if (auto exported = exporter_.take()) {
    changed = true;
    if (*exported) {
      post(Message::Kind::Info, "Panels written to " + **exported);
    } else {
      post(exported->error());
    }
  }
  changed |= drain();
  if (may_start(now)) {
    start_solve(now);
    changed = true;
  }
  const auto old = std::remove_if(messages_.begin(), messages_.end(), [&](const Message& m) {
    return m.kind == Message::Kind::Info && now - m.posted > 8s;
  });
  changed |= old != messages_.end();
  messages_.erase(old, messages_.end());
  return changed;
}

bool AppState::drain() {
  const Stopwatch watch;
  bool changed = false;
  const bool ours = session_.current_ticket() > ignored_ticket_;  // not the design before
  if (auto iterate = session_.take_iterate(); iterate && ours) {
    newest_ = std::move(iterate);
    preparer_.submit({newest_, scene_origin_, false});
    changed = true;
  }
  drained_.clear();
  session_.drain_iterations(drained_);
  if (!drained_.empty() && ours) {
    if (history_ticket_ != session_.current_ticket()) {
      history_.clear();
      history_ticket_ = session_.current_ticket();
    }
    take_energies();
    history_.insert(history_.end(), std::make_move_iterator(drained_.begin()),
                    std::make_move_iterator(drained_.end()));
    changed = true;
  }
  if (auto outcome = session_.take_outcome(); outcome && ours) {
    take_outcome(std::move(*outcome));
    changed = true;
  }
  if (auto ghost = preparer_.take_ghost(); ghost && ghost->mesh == mesh_view_) {
    ghost_ = std::move(ghost);
    changed = true;
  }
  changed |= show_prepared();
  if (changed) timings.drain.add(watch.milliseconds());
  return changed;
}

// Of the newest step that knows them; the solver's restoration does not.
void AppState::take_energies() {
  for (auto step = drained_.rbegin(); step != drained_.rend(); ++step) {
    if (step->energies.empty()) continue;
    energies_.clear();
    for (const auto& share : step->energies) energies_.push_back({share.name, share.weight, share.value});
    return;
  }
}

void AppState::take_outcome(SolveOutcome outcome) {
  finished_ticket_ = outcome.ticket;
  if (!outcome.report) {
    outcome_failed_ = true;
    report_.reset();
    post(outcome.report.error());
    return;
  }
  report_ = std::move(*outcome.report);
  if (!report_->energies.empty()) energies_ = report_->energies;
  if (!outcome.complex || report_->state.x.rows() == 0) {
    outcome_failed_ = true;
    return;
  }
  auto iterate = std::make_shared<Iterate>();
  iterate->ticket = outcome.ticket;
  iterate->complex = std::move(outcome.complex);
  iterate->state = std::move(report_->state);
  if (history_ticket_ == outcome.ticket && !history_.empty()) iterate->iteration = history_.back();
  report_->state = State();
  newest_ = std::move(iterate);
  preparer_.submit({newest_, scene_origin_, true});
  if (report_->status == SolveStatus::Failed || report_->status == SolveStatus::Infeasible ||
      report_->status == SolveStatus::NotPlanar) {
    post(Message::Kind::Warning, std::string("the solve ended: ") + planewright::name(report_->status),
         document_.name(), report_->stop_reason);
  }
}

bool AppState::show_prepared() {
  auto next = preparer_.take();
  // Stale: its design has changed since.
  if (!next || next->ticket() != session_.current_ticket() || next->ticket() <= ignored_ticket_) return false;
  timings.prepare.add(next->milliseconds);

  const bool first_of_solve = !shown_ || shown_->ticket() != next->ticket();
  if (shown_ && (shown_->complex().kind != next->complex().kind ||
                 shown_->complex().plane_count() != next->complex().plane_count())) {
    selected_panel.reset();
  }
  if (shown_ && shown_->complex().point_count() != next->complex().point_count()) selected_point.reset();
  if (!next->final && finished_ticket_ != next->ticket() &&
      (first_of_solve || next->fingerprint != last_fingerprint_)) {
    ++iterates_before_end_;
  }
  last_fingerprint_ = next->fingerprint;
  if (!view_range_locked()) {
    const double floor = kLeastRange * next->complex().mean_edge;
    const double planarity = std::max(next->planarity.max, floor);
    const double displacement = std::max(next->displacement.max, floor);
    planarity_range_ = first_of_solve ? planarity : std::max(planarity_range_, planarity);
    displacement_range_ = first_of_solve ? displacement : std::max(displacement_range_, displacement);
  }
  shown_ = std::move(next);
  return true;
}

bool AppState::view_range_locked() const {
  return view_options.lock_range && planarity_range_ > 0;
}

// --- What is shown ---------------------------------------------------------------------------

bool AppState::settled() const {
  if (loading() || load_next_ || solve_wanted_ || session_.running()) return false;
  if (mesh_view_ && (!ghost_ || ghost_->mesh != mesh_view_)) return false;
  if (document_.empty() || session_.current_ticket() <= ignored_ticket_) return true;
  if (finished_ticket_ != session_.current_ticket()) return false;
  return outcome_failed_ || (shown_ && shown_->final && shown_->ticket() == finished_ticket_);
}

double AppState::milliseconds_per_step() const {
  if (history_.size() < 2) return 0.0;
  const Iteration& first = history_.front();
  const Iteration& last = history_.back();
  if (last.number <= first.number) return 0.0;
  return 1000.0 * (last.seconds - first.seconds) / (last.number - first.number);
}

double AppState::colour_range() const {
  switch (view_options.colours) {
    case ColourMap::None:
      return 0.0;
    case ColourMap::Planarity:
      return round_up(planarity_range_);
    case ColourMap::Displacement:
      return round_up(displacement_range_);
  }
  return 0.0;
}

double AppState::planarity_tolerance() const {
  return shown_ ? kPlanarityTolerance * shown_->complex().mean_edge : 0.0;
}

// --- Messages --------------------------------------------------------------------------------

void AppState::post(Message::Kind kind, std::string what, std::string where, std::string remedy) {
  what = capitalised(std::move(what));
  // The same message again replaces the old one instead of piling up.
  std::erase_if(messages_, [&](const Message& m) { return m.what == what && m.where == where; });
  messages_.push_back(
      {next_message_++, kind, std::move(what), std::move(where), std::move(remedy), Clock::now()});
  constexpr std::size_t kMost = 4;
  if (messages_.size() > kMost) messages_.erase(messages_.begin());
}

void AppState::post(const Error& error) {
  post(Message::Kind::Error, error.what, error.where, error.remedy);
}

void AppState::dismiss(std::uint64_t message) {
  std::erase_if(messages_, [&](const Message& m) { return m.id == message; });
}

}  // namespace planewright::ui
