// Below the model: a head line with tabs, and what the open one of them shows.
#include <imgui_internal.h>

#include <array>
#include <string>

#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr float kTabs = 226;  // width at scale 1

// Opens and closes what the tabs show.
void draw_toggle(Desk& desk, ImVec2 at, float width, float height) {
  Ui& ui = desk.ui;
  const bool open = desk.window.settings.convergence_open;
  ImGui::SetCursorScreenPos(at);
  if (ImGui::InvisibleButton("toggle", ImVec2(width, height))) desk.window.settings.convergence_open = !open;
  ui.record_item("toggle");
  const ImU32 ink = ImGui::IsItemHovered() ? ui.colours().accent : ui.colours().ink_faint;
  draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().regular(), at,
                    ImVec2(at.x + width, at.y + height), 0.2f, ink,
                    ui.theme().has_icons() ? ui.theme().icon(open ? Icon::ChevronDown : Icon::ChevronRight)
                                           : (open ? "-" : "+"));
}

void draw_tabs(Desk& desk, ImVec2 at, float width, float height) {
  static const std::array<std::string, 2> kNames = {"Convergence", "Schedule"};
  static const std::array<std::string, 2> kAbout = {"How the solve goes, step by step  (V)",
                                                    "Every panel with its measures  (E)"};
  UserSettings& settings = desk.window.settings;
  // While nothing is open none is on, and a press on either opens it.
  int current = !settings.convergence_open ? -1 : settings.schedule_tab ? 1 : 0;
  ImGui::SetCursorScreenPos(at);
  ImGui::BeginChild("tabs", ImVec2(width, height), false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (desk.ui.segmented("tab", kNames, current, kAbout)) {
    settings.convergence_open = true;
    settings.schedule_tab = current == 1;
  }
  ImGui::EndChild();
}

}  // namespace

void draw_bottom_panel(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  if (!begin_part("##below", place, ImVec2(ui.px(14), ui.px(3)),
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse)) {
    return;
  }
  const ImVec2 head = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetFrameHeight(), toggle = ui.px(20);
  const float right = place.max.x - ui.px(14);
  {
    const Ui::Scope scope(ui, "Bottom");
    draw_toggle(desk, head, toggle, height);
    draw_tabs(desk, ImVec2(head.x + toggle, head.y), ui.px(kTabs), height);
  }
  if (desk.window.settings.convergence_open) {
    const Rect beside{{head.x + toggle + ui.px(kTabs + 14), head.y}, {right, head.y + height}};
    const Rect below{{head.x, head.y + height + ui.px(3)}, {right, place.max.y - ui.px(6)}};
    const bool schedule = desk.window.settings.schedule_tab;
    const Ui::Scope scope(ui, schedule ? "Schedule" : "Convergence");
    if (schedule) {
      draw_schedule(desk, beside, below);
    } else {
      draw_convergence(desk, beside, below);
    }
  }
  draw_rim(ui, place, Side::Top);
  end_part();
}

}  // namespace planewright::ui
