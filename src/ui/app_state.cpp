#include "ui/app_state.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/design/design.h"
#include "core/edit/design_edits.h"
#include "core/edit/project_file.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "core/problem/energies/energy_catalogue.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;

// While a slider is dragged, a solve is given one step that is shown before the next value replaces it; small
// models take no new value more often than a screen shows frames.
constexpr auto kRestartInterval = 16ms;

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

}  // namespace

AppState::AppState(std::function<void()> wake)
    : wake_(std::move(wake)),
      preparer_(wake_),
      session_(wake_),
      advice_task_(wake_),
      export_work_(wake_),
      workshop_watch_(wake_) {}
AppState::~AppState() {
  cluster_stop_.request_stop();
}

// --- Edits -----------------------------------------------------------------------------------

void AppState::change_settings(LayerSettings settings, std::string what, std::string merge_key) {
  if (document_.empty()) return;
  Design design = document_.design();
  design.layers[static_cast<std::size_t>(active_layer())].settings = std::move(settings);
  change_design(std::move(design), std::move(what), std::move(merge_key));
}

void AppState::change_design(Design design, std::string what, std::string merge_key) {
  if (document_.empty()) return;
  const auto before = document_.revision();
  const bool drags = !merge_key.empty();
  document_.change_design(std::move(design), std::move(what), std::move(merge_key));
  if (document_.revision() == before) return;
  merging_ = drags;
  document_changed();
}

void AppState::end_merge() {
  // What is still being clustered belongs to the gesture that is over.
  merge_ends_late_ = clustering();
  if (merge_ends_late_) return;
  document_.end_merge();
  merging_ = false;
}

void AppState::document_changed() {
  solve_is_step_ = false;
  end_advice();
  follow_elements();
  if (!mesh_view_ || mesh_view_->mesh != document_.mesh()) refresh_mesh_view();
  match_runs();
  take_reference();
  refresh_stale();
  show_settings_of_views();
  background_wanted_ = auto_solve_;
  if (auto_solve_ && active_run().stale) solve_wanted_ = true;
  if (document_.settings().mode != ComplexKind::Cluster && changes_regions(tool)) tool = Tool::Look;
}

void AppState::refresh_mesh_view() {
  mesh_view_ = std::make_shared<const MeshView>(make_mesh_view(document_.mesh(), scene_origin_));
  preparer_.submit(mesh_view_);
}

// --- Solving ---------------------------------------------------------------------------------

void AppState::solve(Start start) {
  if (document_.empty()) return;
  if (reference_missing()) {
    hold_without_reference();
    return;
  }
  if (document_.settings().mode == ComplexKind::Cluster && !clusters() && cluster_error_) {
    post(*cluster_error_);
    return;
  }
  start_afresh_ = start_afresh_ || start == Start::Afresh;
  solve_wanted_ = true;
  solve_is_step_ = true;
  background_wanted_ = true;
}

void AppState::stop() {
  stop_clustering();
  solve_wanted_ = start_afresh_ = false;
  background_wanted_ = false;
  for (LayerRun& of : runs_) of.polish_wanted = false;
  session_.stop();
}

bool AppState::may_start(Clock::time_point now) const {
  if (!solve_wanted_ || document_.empty() || !reference_ready()) return false;
  if (!inputs_of(active_layer()).complete()) return false;
  const LayerRun& active = run(active_layer());
  if (!merging_ || !outcome_due_ || solving_run_ != active.id) return true;
  if (active.asked == SolverKind::Auto) return true;  // nothing of a polish is shown before its end
  return has_advanced(active) && now - last_start_ >= kRestartInterval;
}

// The newest solve has delivered a state beyond its start: one that is superseded before has been in vain,
// and a drag that only ever did that would show nothing.
bool AppState::has_advanced(const LayerRun& of) {
  return of.newest && of.newest->ticket == of.ticket && of.newest->iteration.number >= 1;
}

// Tangent: every state on the way is planar, and a step is no longer than a frame. Auto: a polish.
void AppState::start_solve(int layer, Clock::time_point now, SolverKind solver) {
  LayerRun& of = runs_[static_cast<std::size_t>(layer)];
  if (outcome_due_ && solving_run_ != of.id) {
    // It is superseded, and has to be solved another time; of a polish, the result stands.
    LayerRun* superseded = find_run(solving_run_);
    if (superseded != nullptr && superseded->asked != SolverKind::Auto) superseded->started.reset();
  }
  const bool afresh = start_afresh_ && layer == active_layer();
  LayerInputs inputs = inputs_of(layer);
  SolveRequest request;
  request.mesh = inputs.mesh;
  request.settings = inputs.settings;
  request.clusters = inputs.clusters;
  request.selections = inputs.selections;
  request.reference = inputs.reference;
  request.solver = solver;
  if (inputs.neighbour) {
    request.neighbour = std::make_shared<const NeighbourLayer>(
        NeighbourLayer{inputs.neighbour->complex, inputs.neighbour->state});
  }
  if (!afresh && of.newest && of.newest->complex->kind == request.settings.mode) {
    request.warm_start = of.newest;
    if (of.newest_ids && *of.newest_ids != *document_.ids()) {
      request.edited = std::make_shared<const ElementMap>(map_between(*of.newest_ids, *document_.ids()));
    }
  }
  of.ids = document_.ids();
  of.ticket = session_.start(std::move(request));
  of.started = std::move(inputs);
  of.asked = solver;
  of.polish_wanted = false;
  of.failed = false;
  solving_run_ = of.id;
  outcome_due_ = true;
  last_start_ = now;
  end_advice();
  if (layer == active_layer()) {
    solve_wanted_ = false;
    start_afresh_ = false;
    iterates_before_end_ = 0;
    last_fingerprint_ = 0;
  }
  refresh_stale();
}

std::optional<Clock::time_point> AppState::next_deadline() const {
  // A step that is still due calls by itself.
  if (solve_wanted_ && merging_ && has_advanced(run(active_layer()))) return last_start_ + kRestartInterval;
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
  changed |= update_saving();
  changed |= update_clusters();
  changed |= take_reference();
  if (reference_missing()) solve_wanted_ = false;
  changed |= drain();
  if (may_start(now)) {
    start_solve(active_layer(), now);
    changed = true;
  } else if (!outcome_due_ && !solve_wanted_) {
    if (const int next = next_waiting(); next >= 0) {
      start_solve(next, now);
      changed = true;
    } else if (const int rough = next_to_polish(); rough >= 0) {
      start_solve(rough, now, SolverKind::Auto);
      changed = true;
    }
  }
  changed |= update_sheet();
  changed |= update_workshop();
  changed |= update_export();
  changed |= update_advice();
  const auto old = std::remove_if(messages_.begin(), messages_.end(), [&](const Message& m) {
    return m.kind <= Message::Kind::Refused && now - m.posted > 8s;
  });
  changed |= old != messages_.end();
  messages_.erase(old, messages_.end());
  return changed;
}

bool AppState::drain() {
  const Stopwatch watch;
  bool changed = false;
  LayerRun* const of = find_run(solving_run_);  // null: what comes belongs to a design or layer that is gone
  // Ipopt's states on the way are not planar: the result that it polishes stays what is shown.
  const bool polishes = polishing();
  if (auto iterate = session_.take_iterate(); iterate && of != nullptr && !polishes) {
    of->newest = std::move(iterate);
    of->newest_ids = of->ids;
    of->newest_final = false;
    submit(*of);
    changed = true;
  }
  drained_.clear();
  session_.drain_iterations(drained_);
  if (!drained_.empty() && of != nullptr) {
    if (of->history_ticket != of->ticket) {
      of->history.clear();
      of->history_ticket = of->ticket;
    }
    if (!polishes) take_energies(*of);
    of->history.insert(of->history.end(), std::make_move_iterator(drained_.begin()),
                       std::make_move_iterator(drained_.end()));
    take_pace(*of);
    changed = true;
  }
  if (auto outcome = session_.take_outcome()) {
    if (of != nullptr) {
      outcome_due_ = false;
      take_outcome(*of, std::move(*outcome));
      refresh_stale();
      show_settings_of_views();
      if (of->newest_final && !of->failed && !of->stale) remember_results();
      changed = true;
    }
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
void AppState::take_energies(LayerRun& of) {
  for (auto step = drained_.rbegin(); step != drained_.rend(); ++step) {
    if (step->energies.empty()) continue;
    of.energies.clear();
    for (const auto& share : step->energies) of.energies.push_back({share.name, share.weight, share.value});
    return;
  }
}

// Kept until there is another one: while a slider is dragged every solve is short, and the first steps tell
// nothing.
void AppState::take_pace(LayerRun& of) {
  const Iteration &first = of.history.front(), &last = of.history.back();
  if (last.number <= first.number) return;
  of.milliseconds_per_step = 1000.0 * (last.seconds - first.seconds) / (last.number - first.number);
}

void AppState::take_outcome(LayerRun& of, SolveOutcome outcome) {
  if (of.asked == SolverKind::Auto && !takes_over(of, outcome)) {
    decline_polish(of, outcome);
    return;
  }
  // Whatever was wrong with the solve before is no longer shown.
  if (of.complaint != 0) dismiss(std::exchange(of.complaint, 0));
  const std::string where = layer_count() > 1 ? document_.name() + ", " + of.layer.name : document_.name();
  of.made_with.reset();
  of.saved = false;
  of.polish_declined = false;
  if (!outcome.report) {
    of.failed = true;
    of.report.reset();
    post(outcome.report.error());
    of.complaint = messages_posted();
    return;
  }
  of.report = std::move(*outcome.report);
  SolveReport& report = *of.report;
  if (!report.energies.empty()) of.energies = report.energies;
  if (!outcome.complex || report.state.x.rows() == 0) {
    of.failed = true;
    return;
  }
  auto iterate = std::make_shared<Iterate>();
  iterate->ticket = outcome.ticket;
  iterate->complex = std::move(outcome.complex);
  iterate->state = std::move(report.state);
  if (of.history_ticket == outcome.ticket && !of.history.empty()) iterate->iteration = of.history.back();
  report.state = State();
  of.newest = std::move(iterate);
  of.newest_ids = of.ids;
  of.newest_final = true;
  of.made_with = of.asked;
  of.finished = of.newest;
  of.finished_ids = of.newest_ids;
  submit(of);
  if (report.status == SolveStatus::Failed || report.status == SolveStatus::Infeasible ||
      report.status == SolveStatus::NotPlanar) {
    post(Message::Kind::Warning, std::string("the solve ended: ") + planewright::name(report.status), where,
         capitalised(report.stop_reason) + ".");
    of.complaint = messages_posted();
  }
}

bool AppState::show_prepared() {
  bool changed = false;
  while (auto next = preparer_.take()) {
    LayerRun* const of = find_run(next->layer);
    if (of == nullptr) continue;  // its design or layer is gone
    // Also of a solve that has been superseded meanwhile: in a drag that is every one, and they come in
    // order.
    timings.prepare.add(next->milliseconds);
    show_view(*of, std::move(next));
    changed = true;
  }
  while (auto next = preparer_.take_findings()) {
    LayerRun* const of = find_run(next->layer);
    if (of == nullptr) continue;
    of->findings = std::move(next);
    changed = true;
  }
  if (changed) follow_finding();
  return changed;
}

void AppState::show_view(LayerRun& of, std::shared_ptr<const PreparedView> next) {
  if (&of == &active_run()) {
    const auto& before = of.shown;
    const bool first_of_solve = !before || before->ticket() != next->ticket();
    if (before) follow_pointed_at(*before, *next);
    const bool of_running = outcome_due_ && solving_run_ == of.id && next->ticket() == of.ticket;
    if (!next->final && of_running && (first_of_solve || next->fingerprint != last_fingerprint_)) {
      ++iterates_before_end_;
    }
    last_fingerprint_ = next->fingerprint;
    if (!view_range_locked()) {
      const double floor = kLeastRange * next->complex().mean_edge;
      const double planarity = std::max(next->planarity.max, floor);
      const double displacement = std::max(next->displacement.max, floor);
      // The solves of one drag are one for the legend, or it would flicker.
      const bool anew = first_of_solve && !merging_;
      planarity_range_ = anew ? planarity : std::max(planarity_range_, planarity);
      displacement_range_ = anew ? displacement : std::max(displacement_range_, displacement);
    }
  }
  of.shown = std::move(next);
}

bool AppState::view_range_locked() const {
  return view_options.lock_range && planarity_range_ > 0;
}

// --- What is shown ---------------------------------------------------------------------------

bool AppState::settled() const {
  if (loading() || load_next_ || solving() || !reference_ready() || clustering()) return false;
  if (clusters_wanted() && clusters() && !(region_view_ && region_view_->clusters == clusters()))
    return false;
  if (!workshop_known() || workshop_watch_.busy()) return false;
  if (mesh_view_ && (!ghost_ || ghost_->mesh != mesh_view_)) return false;
  return std::all_of(runs_.begin(), runs_.end(), [this](const LayerRun& of) {
    return of.failed || (of.submitted == (of.shown ? of.shown->number : 0) && findings_known(of));
  });
}

const Iteration* AppState::newest_step() const {
  const LayerRun& of = run(active_layer());
  return of.history_ticket == of.ticket && !of.history.empty() ? &of.history.back() : nullptr;
}

double AppState::colour_range() const {
  switch (view_options.colours) {
    case ColourMap::None:
      return 0.0;
    case ColourMap::Planarity:
      return round_up(planarity_range_);
    case ColourMap::Displacement:
      return round_up(displacement_range_);
    case ColourMap::Findings:
      return 1.0;  // severities
    case ColourMap::Tolerances:
      return 2.0;  // of the limit
  }
  return 0.0;
}

double AppState::planarity_tolerance() const {
  return shown() ? kPlanarityTolerance * shown()->complex().mean_edge : 0.0;
}

double AppState::mean_edge() const {
  if (shown()) return shown()->complex().mean_edge;
  if (document_.empty()) return 0.0;
  const PolygonMesh& mesh = *document_.mesh();
  double sum = 0.0;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    sum += (mesh.positions().row(edge.a) - mesh.positions().row(edge.b)).norm();
  }
  return mesh.edge_count() > 0 ? sum / mesh.edge_count() : 0.0;
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
