// AppState's polish: Ipopt goes on from what the tangent solver finished, finishes it and confirms it.
//
// A polish is a solve of the same inputs from their own result. It takes long, so the result stays what is
// shown (and what other layers are fitted to) until the polish has something at least as good.
#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {

bool AppState::can_polish() const {
  return can_polish(run(active_layer()));
}

bool AppState::can_polish(const LayerRun& of) const {
  const bool solving = outcome_due_ && solving_run_ == of.id;
  return !solving && !of.stale && !of.failed && of.newest_final && of.made_with == SolverKind::Tangent;
}

void AppState::polish() {
  if (can_polish()) active_run().polish_wanted = true;
}

bool AppState::polishing() const {
  const auto layer = solving_layer();
  return layer && run(*layer).asked == SolverKind::Auto;
}

bool AppState::polished() const {
  const LayerRun& of = run(active_layer());
  return of.newest_final && of.made_with == SolverKind::Auto;
}

// Solves come first, and a polish would be in the way of the hand that drags.
int AppState::next_to_polish() const {
  if (merging_ || solve_wanted_ || document_.empty()) return -1;
  for (int i = 0; i < layer_count(); ++i) {
    const LayerRun& of = run(i);
    if (!can_polish(of)) continue;
    // By itself only what came to a good end, once, and not after the designer has said stop.
    const bool by_itself =
        polish_automatically_ && background_wanted_ && !of.polish_declined && of.report &&
        (of.report->status == SolveStatus::Converged || of.report->status == SolveStatus::Planar);
    if (of.polish_wanted || by_itself) return i;
  }
  return -1;
}

// A polish that was stopped or broke down has nothing over the result it began with.
bool AppState::takes_over(const LayerRun& of, const SolveOutcome& polish) {
  if (!polish.report || !polish.complex || polish.report->state.x.rows() == 0) return false;
  const SolveStatus status = polish.report->status;
  if (status == SolveStatus::Converged) return true;
  const bool planar = status == SolveStatus::Planar || status == SolveStatus::Infeasible;
  return planar && of.report && of.report->status != SolveStatus::Converged;
}

void AppState::decline_polish(LayerRun& of, const SolveOutcome& polish) {
  of.polish_declined = true;
  if (polish.report && polish.report->status == SolveStatus::Stopped) return;
  if (of.complaint != 0) dismiss(of.complaint);
  const std::string why = polish.report ? polish.report->stop_reason : polish.report.error().what;
  post(Message::Kind::Warning, "Ipopt could not confirm the panels, so they stay as they were",
       layer_count() > 1 ? document_.name() + ", " + of.layer.name : document_.name(),
       why.empty() ? why : capitalised(why) + ".");
  of.complaint = messages_posted();
}

}  // namespace planewright::ui
