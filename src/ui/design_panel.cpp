// The left panel: what the panels should be, and the solve.
#include <array>
#include <cmath>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

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

void draw_freedom(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  LayerSettings settings = state.document().settings();

  const Edit edit = ui.length("offset", "Offset", settings.offset, length_step(desk), desk.state.unit(),
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
  const bool solving = state.busy();
  ButtonLook look;
  look.has_icon = true;
  look.icon = solving ? Icon::Stop : Icon::Play;
  look.primary = !solving;
  const float restart = ui.theme().has_icons() ? ImGui::GetFrameHeight() : ui.px(80);
  look.width = ImGui::GetContentRegionAvail().x - restart - ImGui::GetStyle().ItemSpacing.x;
  look.tooltip = state.polishing() ? "Stops Ipopt and keeps the panels that are shown  (Space)"
                 : solving         ? "Stops within one step and keeps the best state  (Space)"
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

  // How the solve stands, in two lines whatever happens, so that nothing jumps.
  const SolveReport* report = state.report();
  const auto& history = state.history();
  if (solving) {
    const bool clusters = !state.solving();
    const bool stepped = !clusters && !history.empty();
    ui.value_row(clusters            ? "Clustering"
                 : state.polishing() ? "Polishing"
                                     : "Solving",
                 stepped ? "step " + format_count(history.back().number) : "…");
    ui.value_row("Time", stepped ? format_duration(history.back().seconds) : "…");
  } else if (report != nullptr) {
    const bool good = report->status == SolveStatus::Converged;
    ui.value_row("Result", name(report->status), good ? ui.colours().good : ui.colours().warning,
                 report->stop_reason);
    if (state.up_to_date()) {
      ui.value_row("Steps, time", format_count(report->iterations) + ", " + format_duration(report->seconds));
    } else {
      ui.value_row("What is shown", "is older than the design", ui.colours().warning);
    }
  } else {
    ui.value_row("Result", state.shows_saved() ? "as saved" : "–", state.shows_saved() ? ui.colours().good : 0);
    ui.value_row("Steps, time", "–");
  }
}

float solve_height(const Ui& ui) {
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  return 2 * (ImGui::GetFrameHeight() + spacing) + 2 * (ImGui::GetTextLineHeight() + ui.px(3)) + ui.px(14);
}

}  // namespace

double length_step(const Desk& desk) {
  if (!desk.state.mesh_view()) return 0.01;
  const double size = (desk.state.mesh_view()->high - desk.state.mesh_view()->low).norm();
  return size > 0 ? std::pow(10.0, std::floor(std::log10(size / 1000))) : 0.01;
}

void draw_design_panel(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  if (!begin_part("##design", place, ImVec2(ui.px(14), ui.px(10)),
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    return;
  }
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
    static const std::array<std::string, 3> kModes = {"Dual", "Planarize", "Cluster"};
    static const std::array<std::string, 3> kAbout = {
        "One planar panel for every vertex of the mesh: hexagons from triangles  (1)",
        "The mesh's own faces, made planar  (2)",
        "A few planar panels, each for a region of many faces  (3)"};
    static const std::array<Action, 3> kSwitch = {Action::ModeDual, Action::ModePlanarize,
                                                  Action::ModeCluster};
    int mode = static_cast<int>(state.document().settings().mode);
    if (ui.segmented("mode", kModes, mode, kAbout))
      desk.actions.request(kSwitch[static_cast<std::size_t>(mode)]);
    draw_presets(desk);
    // Everything scrolls but the solve, which is always at hand.
    const float solve = solve_height(ui);
    ImGui::BeginChild("sections", ImVec2(ImGui::GetContentRegionAvail().x + ui.px(10),
                                         std::max(ImGui::GetContentRegionAvail().y - solve, ui.px(80))));
    if (state.document().settings().mode == ComplexKind::Cluster &&
        ui.section("clusters", "Clusters", true, clusters_summary(desk),
                   state.cluster_error() ? ui.colours().error : 0)) {
      draw_clusters(desk);
    }
    if (ui.section("layers", "Layers", state.layer_count() > 1, layers_summary(desk))) draw_layers(desk);
    const HealthReport& health = state.document().health();
    const bool healthy = health.healthy();
    if (ui.section("input", "Input", false, healthy ? "healthy" : "repaired",
                   healthy ? ui.colours().good : ui.colours().warning)) {
      draw_input(desk);
    }
    if (ui.section("weights", "Weights")) draw_weights(desk);
    const DemandSummary summary = demand_summary(desk);
    if (ui.section("demands", "Demands", true, summary.text, summary.colour)) draw_demands(desk);
    if (ui.section("planes", "Planes")) draw_freedom(desk);
    ImGui::EndChild();
    const ImVec2 line = ImGui::GetCursorScreenPos();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(place.min, place.max);
    draw.AddLine(ImVec2(place.min.x, line.y + 0.5f), ImVec2(place.max.x, line.y + 0.5f), ui.colours().line);
    draw.PopClipRect();
    ui.gap(12);
    draw_solve(desk);
  }
  draw_rim(ui, place, Side::Right);
  end_part();
}

}  // namespace planewright::ui
