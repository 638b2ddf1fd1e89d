// The windows that the parts are drawn into, and the grips between them.
#include <imgui_internal.h>

#include <cmath>

#include "ui/panels.h"

namespace planewright::ui {

bool begin_part(const char* name, const Rect& place, ImVec2 padding, ImGuiWindowFlags flags) {
  if (place.width() < 2 || place.height() < 2) return false;
  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(place.width(), place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoSavedSettings | flags);
  ImGui::PopStyleVar();
  return true;
}

void end_part() {
  ImGui::End();
}

void draw_rim(Ui& ui, const Rect& place, Side side) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(place.min, place.max);
  const float x0 = place.min.x + 0.5f, x1 = place.max.x - 0.5f, y0 = place.min.y + 0.5f,
              y1 = place.max.y - 0.5f;
  const ImU32 line = ui.colours().line;
  switch (side) {
    case Side::Left:
      draw.AddLine({x0, y0}, {x0, y1}, line);
      break;
    case Side::Right:
      draw.AddLine({x1, y0}, {x1, y1}, line);
      break;
    case Side::Top:
      draw.AddLine({x0, y0}, {x1, y0}, line);
      break;
    case Side::Bottom:
      draw.AddLine({x0, y1}, {x1, y1}, line);
      break;
  }
  draw.PopClipRect();
}

namespace {

void splitter(Desk& desk, const char* name, const Rect& place, bool vertical, float& size, float direction) {
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32(0, 0, 0, 0));
  if (begin_part(name, place, ImVec2(0, 0), ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav)) {
    ImGui::InvisibleButton("grip", ImVec2(place.width(), place.height()));
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) {
      ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
      ImDrawList& draw = *ImGui::GetWindowDrawList();
      const float x = std::round(0.5f * (place.min.x + place.max.x)),
                  y = std::round(0.5f * (place.min.y + place.max.y));
      const float half = desk.ui.px(1);
      if (vertical) {
        draw.AddRectFilled({x - half, place.min.y}, {x + half, place.max.y}, desk.ui.colours().accent);
      } else {
        draw.AddRectFilled({place.min.x, y - half}, {place.max.x, y + half}, desk.ui.colours().accent);
      }
    }
    if (held) {
      const ImVec2 moved = ImGui::GetIO().MouseDelta;
      size += direction * (vertical ? moved.x : moved.y) / desk.ui.theme().scale();
    }
    const Ui::Scope scope(desk.ui, "Splitter");
    desk.ui.record(name + 2, place.min, place.max);
    end_part();
  }
  ImGui::PopStyleColor();
}

}  // namespace

void draw_splitters(Desk& desk, const Layout& layout) {
  UserSettings& settings = desk.window.settings;
  splitter(desk, "##left", layout.left_splitter, true, settings.left_width, 1);
  splitter(desk, "##right", layout.right_splitter, true, settings.right_width, -1);
  if (settings.convergence_open) {
    float& height = settings.schedule_tab ? settings.schedule_height : settings.bottom_height;
    splitter(desk, "##bottom", layout.bottom_splitter, false, height, -1);
  }
}

}  // namespace planewright::ui
