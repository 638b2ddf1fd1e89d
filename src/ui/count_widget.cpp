// Ui::count of widgets.h: a number of things, as a slider with its number.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/count_scale.h"
#include "ui/format.h"
#include "ui/widget_text.h"
#include "ui/widgets.h"

namespace planewright::ui {

Edit Ui::count(std::string_view name, std::string_view label, int& value, const CountLook& look) {
  Edit edit;
  const int before = value;
  const Palette& p = colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  // Two lines: label and number, under them the slider.
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float available = ImGui::GetContentRegionAvail().x;
  const float text_height = px(22), track_height = px(15), height = text_height + track_height + px(3);
  const float knob = knob_radius(), number_width = px(72);
  const ImVec2 number_min(origin.x + available - number_width, origin.y),
      number_max(origin.x + available, origin.y + text_height);
  const ImVec2 track_min(origin.x, origin.y + height - track_height),
      track_max(origin.x + available, origin.y + height);
  const float left = track_min.x + knob, right = track_max.x - knob;

  ImGui::PushID(name.data(), end_of(name));
  const ImGuiID id = ImGui::GetID("count");
  draw_text_aligned(draw, theme_.regular(), origin, ImVec2(number_min.x, number_max.y), 0.0f, p.ink, label);
  const float label_width_here = text_size(theme_.regular(), label).x;
  ImGui::SetCursorScreenPos(origin);
  ImGui::InvisibleButton("label", ImVec2(label_width_here + px(18), text_height));
  draw_help(ImVec2(origin.x + label_width_here + px(11), origin.y + 0.5f * text_height + px(0.5f)),
            ImGui::IsItemHovered());
  tooltip_if_hovered(look.tooltip);

  ImGui::SetCursorScreenPos(track_min);
  ImGui::InvisibleButton("count", ImVec2(track_max.x - track_min.x, track_height));
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  const auto knob_at = [&] {
    return left + static_cast<float>(fraction_of_count(value, look.least, look.most)) * (right - left);
  };
  record(name, track_min, track_max, true, left, right, knob_at());
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated() && io.KeyCtrl) {
    begin_typing(id, value);
    ImGui::ClearActiveID();
  } else if (held && (ImGui::IsItemActivated() || io.MouseDelta.x != 0)) {
    value = count_at(static_cast<double>((io.MousePos.x - left) / (right - left)), look.least, look.most);
  }
  if (ImGui::IsItemDeactivated()) edit.finished = true;
  if (const double notches = wheel_notches(id, hovered, edit); notches != 0)
    value = count_step(value, notches, look.least, look.most);

  // The number: a click types, and what is typed may lie outside the slider's range.
  if (typing(id)) {
    double typed = value;
    bool changed = false;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), px(2)));
    if (typing_field("##typed", number_min, number_width, typed, changed)) edit.finished = true;
    ImGui::PopStyleVar();
    record(std::string(name) + " number", number_min, number_max);
    constexpr double kMost = std::numeric_limits<int>::max();
    if (changed && typed >= 1) value = static_cast<int>(std::lround(std::min(typed, kMost)));
  } else {
    ImGui::SetCursorScreenPos(number_min);
    if (ImGui::InvisibleButton("number", ImVec2(number_width, text_height))) begin_typing(id, value);
    const bool over = ImGui::IsItemHovered();
    record(std::string(name) + " number", number_min, number_max);
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    const float rounding = ImGui::GetStyle().FrameRounding;
    draw.AddRectFilled(number_min, number_max, over ? p.hovered : p.raised, rounding);
    draw.AddRect(number_min, number_max, p.line, rounding);
    draw_text_aligned(draw, theme_.regular(), number_min, ImVec2(number_max.x - px(8), number_max.y), 1.0f,
                      p.ink, format_count(value));
  }
  ImGui::PopID();
  edit.changed = value != before;

  draw_slider(left, right, std::round(0.5f * (track_min.y + track_max.y)), knob_at(), true, held,
              held || hovered ? p.accent : p.ink_soft);
  ImGui::SetCursorScreenPos(origin);
  ImGui::Dummy(ImVec2(available, height));
  return edit;
}

}  // namespace planewright::ui
