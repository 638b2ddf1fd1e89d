// Menu bar and toolbar: every action of the window in words.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/sample_shapes.h"
#include "ui/format.h"
#include "ui/leaving.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

void item(Desk& desk, Action action) {
  const ActionInfo& what = info(action);
  const bool enabled = desk.actions.enabled(action);
  if (ImGui::MenuItem(desk.actions.label(action).c_str(), what.shortcut.c_str(),
                      is_toggle(action) && desk.actions.checked(action), enabled)) {
    desk.actions.request(action);
  }
  desk.ui.record_item(what.name, enabled);
}

// What the title says of the design: name, size, unit.
std::string design_line(const Desk& desk) {
  const Document& document = desk.state.document();
  if (document.empty()) return "no design";
  return (desk.state.modified() ? "• " : "") + desk.state.title() + "  ·  " +
         format_count(document.mesh()->vertex_count()) + " V  ·  " +
         format_count(document.mesh()->face_count()) + " F  ·  " + desk.state.unit();
}

bool begin_menu(Desk& desk, const char* label) {
  const bool open = ImGui::BeginMenu(label);
  desk.ui.record_item(label);
  return open;
}

}  // namespace

float draw_menu_bar(Desk& desk) {
  Ui& ui = desk.ui;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ui.px(8), ui.px(7)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(14), ui.px(8)));
  float height = 0;
  if (ImGui::BeginMainMenuBar()) {
    height = ImGui::GetWindowHeight();
    const Ui::Scope scope(ui, "Menu");
    if (begin_menu(desk, "File")) {
      const Ui::Scope inner(ui, "Menu/File");
      item(desk, Action::Open);
      if (begin_menu(desk, "Samples")) {
        const Ui::Scope samples_scope(ui, "Menu/File/Samples");
        for (const SampleInfo& sample : samples()) {
          const std::string name(sample.name);
          if (ImGui::MenuItem(name.c_str())) leave(desk.window, desk.state, {Leaving::What::Sample, name});
          ui.record_item(name);
          ui.tooltip_if_hovered(sample.description);
        }
        ImGui::EndMenu();
      }
      item(desk, Action::Save);
      item(desk, Action::SaveAs);
      ImGui::Separator();
      item(desk, Action::ExportWorkshop);
      item(desk, Action::Export);
      ImGui::Separator();
      item(desk, Action::Quit);
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "Edit")) {
      const Ui::Scope inner(ui, "Menu/Edit");
      item(desk, Action::Undo);
      item(desk, Action::Redo);
      if (begin_menu(desk, "History")) {
        draw_history(desk);
        ImGui::EndMenu();
      }
      ImGui::Separator();
      if (begin_menu(desk, "Mesh")) {
        const Ui::Scope mesh_scope(ui, "Menu/Edit/Mesh");
        draw_edit_choices(desk, target_of_selection(desk.state));
        ImGui::EndMenu();
      }
      item(desk, Action::ApplySuggestion);
      item(desk, Action::ApplyAllSuggestions);
      ImGui::Separator();
      for (const Action action : {Action::SelectBox, Action::SelectAll, Action::SelectBorder,
                                  Action::SelectInverse, Action::SelectMore, Action::SelectLess,
                                  Action::SelectConnected, Action::ClearSelection, Action::StoreSelection}) {
        item(desk, action);
      }
      ImGui::Separator();
      item(desk, Action::Pin);
      item(desk, Action::Unpin);
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "View")) {
      const Ui::Scope inner(ui, "Menu/View");
      item(desk, Action::Fit);
      item(desk, Action::ResetView);
      ImGui::Separator();
      item(desk, Action::Ghost);
      item(desk, Action::Markers);
      item(desk, Action::PanelNames);
      item(desk, Action::NextFinding);
      item(desk, Action::PreviousFinding);
      item(desk, Action::NextFailure);
      item(desk, Action::PreviousFailure);
      item(desk, Action::NextSuggestion);
      item(desk, Action::PreviousSuggestion);
      ImGui::Separator();
      item(desk, Action::ColourNone);
      item(desk, Action::ColourPlanarity);
      item(desk, Action::ColourDisplacement);
      item(desk, Action::ColourFindings);
      item(desk, Action::ColourTolerances);
      item(desk, Action::ColourCycle);
      item(desk, Action::LockRange);
      ImGui::Separator();
      item(desk, Action::Convergence);
      item(desk, Action::Schedule);
      item(desk, Action::DarkTheme);
      if (begin_menu(desk, "Unit")) {
        const Ui::Scope units_scope(ui, "Menu/View/Unit");
        for (const LengthUnit unit : length_units()) {
          const std::string text(symbol(unit));
          if (ImGui::MenuItem(text.c_str(), nullptr, desk.state.unit() == text)) set_unit(desk, unit);
          ui.record_item(text);
        }
        ImGui::EndMenu();
      }
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "Layer")) {
      const Ui::Scope inner(ui, "Menu/Layer");
      for (const Action action : {Action::AddLayer, Action::DuplicateLayer, Action::RemoveLayer,
                                  Action::NextLayer, Action::HideLayer}) {
        item(desk, action);
      }
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "Clusters")) {
      const Ui::Scope inner(ui, "Menu/Clusters");
      item(desk, Action::SplitRegion);
      item(desk, Action::MergeRegions);
      item(desk, Action::PaintRegions);
      ImGui::Separator();
      item(desk, Action::ClusterAnew);
      ImGui::Separator();
      for (const Action action : {Action::SightRegions, Action::SightBeside, Action::SightOver,
                                  Action::SightPanels, Action::NextSight}) {
        item(desk, action);
      }
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "Solve")) {
      const Ui::Scope inner(ui, "Menu/Solve");
      item(desk, Action::SolveOrStop);
      item(desk, Action::SolveAfresh);
      item(desk, Action::AutoSolve);
      ImGui::Separator();
      item(desk, Action::Polish);
      item(desk, Action::AutoPolish);
      ImGui::Separator();
      item(desk, Action::ModeDual);
      item(desk, Action::ModePlanarize);
      item(desk, Action::ModeCluster);
      ImGui::EndMenu();
    }
    if (begin_menu(desk, "Help")) {
      const Ui::Scope inner(ui, "Menu/Help");
      item(desk, Action::Keys);
      if (ImGui::MenuItem("What to try first", nullptr, desk.window.settings.show_hint)) {
        desk.window.settings.show_hint = !desk.window.settings.show_hint;
      }
      ui.record_item("hint");
      item(desk, Action::Timings);
      ImGui::Separator();
      item(desk, Action::About);
      ImGui::EndMenu();
    }
    const std::string line = design_line(desk);
    const ImVec2 bar_min = ImGui::GetWindowPos();
    const ImVec2 bar_max(bar_min.x + ImGui::GetWindowWidth(), bar_min.y + height);
    draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().small(), bar_min,
                      ImVec2(bar_max.x - ui.px(14), bar_max.y), 1.0f, ui.colours().ink_soft, line);
    draw_rim(ui, {bar_min, bar_max}, Side::Bottom);
    ImGui::EndMainMenuBar();
  }
  ImGui::PopStyleVar(3);
  return height;
}

void draw_toolbar(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  const float frame = ImGui::GetFrameHeight();
  const float inset = std::round(0.5f * (place.height() - frame));
  if (!begin_part("##toolbar", place, ImVec2(ui.px(12), inset), ImGuiWindowFlags_NoScrollbar)) return;
  const Ui::Scope scope(ui, "Toolbar");
  const auto button = [&](Action action, Icon icon, const char* text, bool word, bool toggle = false) {
    const ActionInfo& what = info(action);
    ButtonLook look;
    look.has_icon = true;
    look.icon = icon;
    look.enabled = desk.actions.enabled(action);
    look.active = toggle && desk.actions.checked(action);
    look.quiet = true;
    look.tooltip = desk.actions.label(action) + (what.shortcut.empty() ? "" : "  (" + what.shortcut + ")");
    if (ui.button(what.name, word || !ui.theme().has_icons() ? text : "", look)) desk.actions.request(action);
  };
  const auto divider = [&] {
    ImGui::SameLine(0, ui.px(9));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x, at.y + ui.px(5)), ImVec2(at.x, at.y + frame - ui.px(5)),
                                        ui.colours().line);
    ImGui::Dummy(ImVec2(1, frame));
    ImGui::SameLine(0, ui.px(9));
  };
  const float close = ui.px(3);

  button(Action::Open, Icon::Open, "Open", true);
  divider();
  button(Action::Undo, Icon::Undo, "Undo", true);
  ImGui::SameLine(0, close);
  button(Action::Redo, Icon::Redo, "Redo", true);
  divider();
  button(Action::Fit, Icon::Fit, "Fit", true);
  ImGui::SameLine(0, close);
  button(Action::Ghost, Icon::Ghost, "Ghost", true, true);
  divider();

  // The colour map, its choices side by side.
  static const std::array<std::string, 5> kMaps = {"Card", "Planarity", "Displacement", "Findings",
                                                   "Tolerances"};
  int current = static_cast<int>(desk.state.view_options.colours);
  const float export_width = ui.px(128);
  const float room = place.max.x - ImGui::GetCursorScreenPos().x - export_width - ui.px(24);
  const float width = std::clamp(room, 1.0f, ui.px(510));
  ImGui::BeginChild("maps", ImVec2(width, frame), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (ui.segmented("colours", kMaps, current))
    desk.state.view_options.colours = static_cast<ColourMap>(current);
  ImGui::EndChild();

  ButtonLook look;
  look.has_icon = true;
  look.icon = Icon::Export;
  look.enabled = desk.actions.enabled(Action::ExportWorkshop);
  look.width = export_width;
  look.tooltip = "Certified files for the workshop: sheets, schedules, solids  (Ctrl Shift E)";
  ImGui::SameLine(place.width() - look.width - ui.px(12));
  if (ui.button("export", "Export…", look)) desk.actions.request(Action::ExportWorkshop);
  draw_rim(ui, place, Side::Bottom);
  end_part();
}

}  // namespace planewright::ui
