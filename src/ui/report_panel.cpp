// The report: health of the input, how the solve ended, and how planar the panels are.
#include <cmath>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/solve_badge.h"

namespace planewright::ui {
namespace {

std::string places(const Defect& defect) {
  constexpr std::size_t kShown = 12;
  const bool edges =
      defect.kind == DefectKind::NonManifoldEdge || defect.kind == DefectKind::InconsistentOrientation;
  std::string text;
  const std::size_t step = edges ? 2 : 1;
  for (std::size_t i = 0; i + step <= defect.elements.size() && i < kShown * step; i += step) {
    text += (text.empty() ? "" : ", ") + std::to_string(defect.elements[i]);
    if (edges) text += "–" + std::to_string(defect.elements[i + 1]);
  }
  if (defect.count > static_cast<int>(kShown) && !text.empty()) text += ", …";
  return text;
}

void draw_health(Desk& desk) {
  Ui& ui = desk.ui;
  const HealthReport& health = desk.state.document().health();
  ui.value_row("Vertices", format_count(health.vertices));
  ui.value_row("Faces", format_count(health.faces));
  ui.value_row("Pieces", format_count(health.components));
  ui.value_row("Border", health.border_loops == 0
                             ? "closed"
                             : format_count(health.border_loops, "loop", "loops") + ", " +
                                   format_count(health.border_edges, "edge", "edges"));
  if (health.healthy()) {
    ui.value_row("Health", "healthy", ui.colours().good);
    return;
  }
  for (const Defect& defect : health.defects) {
    ui.gap(6);
    ui.wrapped(format_count(defect.count) + "  " + planewright::name(defect.kind) + ": " + defect.action,
               ui.colours().warning);
    const std::string where = places(defect);
    if (!where.empty()) ui.wrapped("at " + where, 0, true);
  }
}

void draw_solve_report(Desk& desk) {
  Ui& ui = desk.ui;
  const SolveReport* report = desk.state.report();
  if (report == nullptr) {
    ui.small_text(desk.state.solving()       ? "Solving…"
                  : desk.state.shows_saved() ? "As the project has it. Space solves it anew."
                                             : "No solve yet.");
    return;
  }
  ui.value_row("Result", planewright::name(report->status),
               report->status == SolveStatus::Converged ? ui.colours().good : ui.colours().warning);
  if (!report->stop_reason.empty()) ui.wrapped(report->stop_reason, 0, true);
  ui.gap(4);
  ui.value_row("Solver", solver_line(*report));
  ui.value_row("Steps", format_count(report->iterations));
  ui.value_row("Time", format_duration(report->seconds));
  ui.value_row("First-order residual", format_number(report->first_order_residual), 0,
               "Largest entry of the Lagrangian's gradient: how far from stationary");
  ui.value_row("Incidence residual", format_with_unit(report->incidence_residual, "edges"), 0,
               "Largest distance of a corner from one of its planes, in mean edges");
  for (const SolveReport::Constraint& constraint : report->constraints) {
    ui.value_row(capitalised(constraint.name), format_number(constraint.max_violation),
                 constraint.violated > 0 ? ui.colours().warning : 0,
                 format_count(constraint.violated, "row", "rows") + " beyond the tolerance");
  }
}

void draw_measures(Desk& desk) {
  Ui& ui = desk.ui;
  const auto& shown = desk.state.shown();
  const std::string unit = desk.state.unit();
  if (!shown) {
    ui.small_text("No panels yet.");
    return;
  }
  ui.value_row("Panels", format_count(shown->complex().plane_count()));
  ui.value_row("Corners", format_count(shown->complex().point_count()));
  ui.value_row("Mean edge", format_with_unit(shown->complex().mean_edge, unit));
  ui.value_row("Planarity, worst", format_with_unit(shown->planarity.max, unit), 0,
               "Greatest distance of a corner from the best plane of its panel");
  ui.value_row("Planarity, mean", format_with_unit(shown->planarity.mean, unit));
  ui.value_row("Moved, RMS", format_with_unit(shown->displacement.rms, unit), 0,
               "Distance of the corners from their wanted places");
  ui.value_row("Moved, most", format_with_unit(shown->displacement.max, unit));
}

}  // namespace

void draw_report(Desk& desk) {
  if (desk.state.document().empty()) {
    desk.ui.small_text("No design yet.");
    return;
  }
  const bool clusters = desk.state.document().settings().mode == ComplexKind::Cluster;
  if (clusters && desk.ui.section("clusters", "Panels of clusters")) draw_cluster_report(desk);
  if (desk.ui.section("panels", "Panels")) draw_measures(desk);
  if (desk.ui.section("solve", "Solve")) draw_solve_report(desk);
  if (desk.ui.section("energies", "Energies")) draw_energy_table(desk);
  if (desk.ui.section("health", "Input")) draw_health(desk);
}

}  // namespace planewright::ui
