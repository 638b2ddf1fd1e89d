#include "ui/solve_badge.h"

#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

using Tone = SolveBadge::Tone;

// Where a result is planar but not at rest, the badge's next words say the former.
std::string state_of(const SolveStanding& standing) {
  if (standing.outdated) return "older than the design";
  switch (standing.report->status) {
    case SolveStatus::Converged:
      return standing.polished ? "confirmed" : "converged";
    case SolveStatus::Planar:
      return "not converged";
    case SolveStatus::Stopped:
    case SolveStatus::NotPlanar:
    case SolveStatus::Infeasible:
    case SolveStatus::Failed:
      return planewright::name(standing.report->status);
  }
  return {};
}

void describe_running(const SolveStanding& standing, SolveBadge& badge) {
  const bool elsewhere = !standing.other_layer.empty();
  badge.tone = Tone::Busy;
  if (elsewhere) {
    badge.headline = (standing.polishing ? "Polishing " : "Solving ") + standing.other_layer;
    return;
  }
  if (standing.polishing) {
    badge.headline = "Polishing with Ipopt";
    badge.explanation = "The panels of the tangent solver stay as they are until Ipopt has confirmed them.";
  } else {
    badge.headline = standing.made_by.empty() ? "Solving" : last_solver(standing.made_by) + ", live";
  }
  // The pace outlives a solve: while a control is dragged each is but a step or two.
  if (!standing.polishing && standing.milliseconds_per_step > 0)
    badge.pace = format_duration(standing.milliseconds_per_step / 1000) + "/step";
  const Iteration* at = standing.newest;
  if (at == nullptr) return;
  if (standing.polishing)
    badge.pace = "step " + format_count(at->number) + ", " + format_duration(at->seconds);
  badge.details = {{"First-order residual", format_number(at->first_order)},
                   {"Steps", format_count(at->number)},
                   {"Time", format_duration(at->seconds)}};
}

void describe_result(const SolveStanding& standing, SolveBadge& badge) {
  const SolveReport& report = *standing.report;
  const bool good = report.status == SolveStatus::Converged && !standing.outdated;
  const bool confirmed = good && standing.polished;
  badge.tone = confirmed ? Tone::Confirmed : good ? Tone::Good : Tone::Warning;
  const std::string solver = last_solver(report.solver);
  badge.headline = solver.empty() ? capitalised(state_of(standing)) : solver + ", " + state_of(standing);
  badge.pace = format_count(report.iterations, "step", "steps") + ", " + format_duration(report.seconds);
  badge.details = {{"First-order residual", format_number(report.first_order_residual)},
                   {"Steps", format_count(report.iterations)},
                   {"Time", format_duration(report.seconds)}};
  if (confirmed) {
    badge.explanation = "Ipopt, the general solver, has gone over these panels and confirms them.";
  } else if (standing.outdated) {
    badge.explanation = "The design has been changed since; Space solves it.";
  } else if (!report.stop_reason.empty()) {
    badge.explanation = capitalised(report.stop_reason) + ".";
  }
}

}  // namespace

SolveStanding standing_of(const AppState& state) {
  SolveStanding standing;
  standing.opening = state.loading_name();
  if (state.document().empty()) return standing;
  standing.solving = state.solving();
  standing.polishing = state.polishing();
  standing.polished = state.polished();
  standing.outdated = !state.up_to_date();
  standing.report = state.report();
  standing.saved = state.shows_saved();
  if (const auto at = state.solving_layer(); at && *at != state.active_layer()) {
    standing.other_layer = state.document().design().layers[static_cast<std::size_t>(*at)].name;
  }
  standing.newest = state.newest_step();
  standing.milliseconds_per_step = state.milliseconds_per_step();
  if (const auto& shown = state.shown()) {
    standing.made_by = shown->final && standing.report != nullptr ? standing.report->solver
                                                                  : shown->iterate->iteration.solver;
    standing.planarity = shown->planarity.max;
    standing.planarity_tolerance = state.planarity_tolerance();
  }
  return standing;
}

SolveBadge solve_badge(const SolveStanding& standing, const std::string& unit) {
  SolveBadge badge;
  if (!standing.opening.empty()) {
    badge.tone = Tone::Busy;
    badge.headline = "Opening " + standing.opening;
    return badge;
  }
  if (standing.solving) {
    describe_running(standing, badge);
  } else if (standing.report != nullptr) {
    describe_result(standing, badge);
  } else if (standing.saved) {
    badge.tone = standing.outdated ? Tone::Warning : Tone::Good;
    badge.headline = standing.outdated ? "As saved, older than the design" : "As saved";
    badge.explanation = standing.outdated
                            ? "The design has been changed since; Space solves it."
                            : "These are the panels that the project holds; Space solves it anew.";
  } else if (standing.planarity) {
    badge.tone = Tone::Warning;  // the newest solve was refused; what is shown is of one before
    badge.headline = "Not solved";
  } else {
    return badge;
  }
  if (standing.planarity) {
    const std::string value = format_with_unit(*standing.planarity, unit);
    badge.planarity =
        (*standing.planarity <= standing.planarity_tolerance ? "planar to " : "planarity ") + value;
    badge.details.insert(badge.details.begin(), {"Planarity, worst", value});
  }
  return badge;
}

std::string last_solver(const std::string& solvers) {
  const std::size_t comma = solvers.rfind(", ");
  return capitalised(comma == std::string::npos ? solvers : solvers.substr(comma + 2));
}

std::string solver_line(const SolveReport& report) {
  const std::size_t comma = report.solver.find(", ");
  if (comma == std::string::npos) return capitalised(report.solver);
  const bool confirmed = report.status == SolveStatus::Converged;
  return capitalised(report.solver.substr(0, comma)) + (confirmed ? ", confirmed by " : ", then ") +
         last_solver(report.solver);
}

}  // namespace planewright::ui
