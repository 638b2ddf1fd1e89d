// The left panel: what the panels should be, and the solve.
#include <array>
#include <cmath>

#include "core/problem/energies/energy_catalogue.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

// The part of the objective that an energy makes up; < 0 when that is not known.
double share_of(const AppState& state, const std::string& energy) {
  double total = 0, own = -1;
  for (const SolveReport::Energy& e : state.energies()) {
    total += std::abs(e.value);
    if (e.name == energy) own = std::abs(e.value);
  }
  return own < 0 ? -1 : total > 0 ? own / total : 0;
}

void draw_input(Desk& desk) {
  Ui& ui = desk.ui;
  const Document& document = desk.state.document();
  const HealthReport& health = document.health();
  ui.value_row("Model", document.name());
  if (health.healthy()) {
    ui.value_row("Health", "healthy", ui.colours().good);
  } else {
    int places = 0;
    for (const Defect& defect : health.defects) places += defect.count;
    ui.value_row("Health", format_count(places, "place repaired or kept", "places repaired or kept"),
                 ui.colours().warning, "See Report on the right");
  }
  ui.value_row("Vertices, faces", format_count(document.mesh()->vertex_count()) + ", " +
                                      format_count(document.mesh()->face_count()));
}

void draw_weights(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  for (const EnergyInfo& energy : energy_catalogue()) {
    LayerSettings settings = state.document().settings();
    double& weight = settings.weights[energy.name];
    const std::string about = energy.description +
                              " Weight 1 means the same on every model; right of it stronger. "
                              "Drag, turn the wheel, double click to reset, Ctrl click to type.";
    const Edit edit = ui.weight("weight " + energy.name, energy.label, weight, energy.default_weight,
                                share_of(state, energy.name), about);
    if (edit.changed) {
      std::string what = "Weight of " + energy.name;
      state.change_settings(std::move(settings), std::move(what), "weight " + energy.name);
    }
    if (edit.finished) state.end_merge();
  }
}

void draw_freedom(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  LayerSettings settings = state.document().settings();

  double step = 0.01;
  if (state.mesh_view()) {
    // One pixel is about a thousandth of the model, as a round number.
    const double size = (state.mesh_view()->high - state.mesh_view()->low).norm();
    if (size > 0) step = std::pow(10.0, std::floor(std::log10(size / 1000)));
  }
  const Edit edit = ui.length("offset", "Offset", settings.offset, step, desk.window.settings.unit,
                              "Wanted distance of the panels from the design, along its normals. "
                              "Drag, turn the wheel, double click for 0, Ctrl click to type.");
  if (edit.changed) state.change_settings(settings, "Offset", "offset");
  if (edit.finished) state.end_merge();

  if (settings.mode == ComplexKind::Dual) {
    static const std::array<std::string, 2> kBorders = {"closed: keep the outline", "interior panels alone"};
    int border = static_cast<int>(settings.border);
    if (ui.choice(
            "border", "Border", kBorders, border,
            "Closed: panels reach to the border of the design. Interior: panels for inner vertices alone.")) {
      settings.border = static_cast<BorderPolicy>(border);
      state.change_settings(settings, "Border policy");
    }
  }
  static const std::array<std::string, 3> kFreedom = {"fixed planes", "normals turn", "normals and offsets"};
  int freedom = static_cast<int>(settings.freedom);
  if (ui.choice("freedom", "Planes", kFreedom, freedom,
                "What the solver may change of each panel's plane: nothing (classic tangent plane "
                "intersection), its "
                "direction, or direction and distance.")) {
    settings.freedom = static_cast<Freedom>(freedom);
    state.change_settings(settings, "Freedom of the planes");
  }
}

void draw_solve(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const bool solving = state.solving();
  ButtonLook look;
  look.has_icon = true;
  look.icon = solving ? Icon::Stop : Icon::Play;
  look.primary = !solving;
  const float restart = ui.theme().has_icons() ? ImGui::GetFrameHeight() : ui.px(80);
  look.width = ImGui::GetContentRegionAvail().x - restart - ImGui::GetStyle().ItemSpacing.x;
  look.tooltip = solving ? "Stops within one step and keeps the best state  (Space)"
                         : "Solve from the present state  (Space)";
  if (ui.button(solving ? "Stop" : "Solve", solving ? "Stop" : "Solve", look))
    desk.actions.request(Action::SolveOrStop);
  ImGui::SameLine();
  ButtonLook again;
  again.has_icon = true;
  again.icon = Icon::Restart;
  again.width = restart;
  again.tooltip = "Solve from the beginning, not from the present state  (Shift Space)";
  if (ui.button("Afresh", ui.theme().has_icons() ? "" : "Afresh", again))
    desk.actions.request(Action::SolveAfresh);

  bool automatic = state.auto_solve();
  if (ui.checkbox("auto", "Solve at every change", automatic)) desk.actions.request(Action::AutoSolve);

  ui.gap(4);
  const SolveReport* report = state.report();
  const auto& history = state.history();
  if (solving && !history.empty()) {
    ui.value_row("Step", format_count(history.back().number));
    ui.value_row("Time", format_duration(history.back().seconds));
  } else if (report != nullptr) {
    ui.value_row("Solver", capitalised(report->solver));
    ui.value_row("Result", name(report->status),
                 report->status == SolveStatus::Converged ? ui.colours().good : ui.colours().warning,
                 report->stop_reason);
    ui.value_row("Steps, time", format_count(report->iterations) + ", " + format_duration(report->seconds));
  }
  if (const double ms = state.milliseconds_per_step(); ms > 0)
    ui.value_row("Per step", format_duration(ms / 1000));
  if (const auto& shown = state.shown()) {
    const bool planar = shown->planarity.max <= state.planarity_tolerance();
    ui.value_row("Planarity", format_with_unit(shown->planarity.max, desk.window.settings.unit),
                 planar ? ui.colours().good : ui.colours().ink,
                 "The greatest distance of a corner from the plane of its panel");
  }
  if (!state.up_to_date() && !solving) {
    ui.wrapped("The design has changed since; what is shown is older.", ui.colours().warning, true);
  }
}

}  // namespace

void draw_design_panel(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  if (!begin_part("##design", place, ImVec2(ui.px(14), ui.px(10)))) return;
  const Ui::Scope scope(ui, "Design");
  AppState& state = desk.state;
  if (state.document().empty()) {
    ui.gap(8);
    if (state.loading()) {
      ui.wrapped("Opening " + state.loading_name() + " …");
    } else {
      ui.heading("No design yet");
      ui.wrapped("Drop a mesh on the window, or open one: OBJ, OFF, PLY or STL.");
      ui.gap(6);
      ButtonLook look;
      look.primary = true;
      look.width = -1;
      if (ui.button("Open", "Open…", look)) desk.actions.request(Action::Open);
    }
  } else {
    static const std::array<std::string, 2> kModes = {"Dual", "Planarize"};
    static const std::array<std::string, 2> kAbout = {
        "One planar panel for every vertex of the mesh: hexagons from triangles  (1)",
        "The mesh's own faces, made planar  (2)"};
    int mode = static_cast<int>(state.document().settings().mode);
    if (ui.segmented("mode", kModes, mode, kAbout)) {
      desk.actions.request(mode == 0 ? Action::ModeDual : Action::ModePlanarize);
    }
    if (ui.section("input", "Input")) draw_input(desk);
    if (ui.section("weights", "Weights")) draw_weights(desk);
    if (ui.section("planes", "Planes")) draw_freedom(desk);
    if (ui.section("solve", "Solve")) draw_solve(desk);
  }
  draw_rim(ui, place, Side::Right);
  end_part();
}

}  // namespace planewright::ui
