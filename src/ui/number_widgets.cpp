// Numbers of widgets.h: entered by drag, wheel and typing, as a field or as a weight's slider.
#include <imgui_internal.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/problem/constraint.h"
#include "ui/format.h"
#include "ui/weight_scale.h"
#include "ui/widget_text.h"
#include "ui/widgets.h"

namespace planewright::ui {
namespace {

constexpr double kWheelPause = 0.5;  // seconds without a notch after which the wheel's gesture is over

bool parse_number(const char* text, double& value) {
  std::string_view view = text;
  while (!view.empty() && (view.front() == ' ' || view.front() == '+')) view.remove_prefix(1);
  while (!view.empty() && view.back() == ' ') view.remove_suffix(1);
  std::string plain(view);
  std::replace(plain.begin(), plain.end(), ',', '.');
  double parsed = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), parsed);
  if (error != std::errc() || end != plain.data() + plain.size() || !std::isfinite(parsed)) return false;
  value = parsed;
  return true;
}

// As a designer would type it: small numbers that have a short decimal form are written so.
std::string format_entry(double value) {
  const double size = std::abs(value);
  if (!(size >= 1e-5 && size < 1e-3)) return format_number(value);
  char text[32];
  std::snprintf(text, sizeof text, "%.7f", value);
  std::string shorter(text);
  shorter.erase(shorter.find_last_not_of('0') + 1);
  return shorter;
}

}  // namespace

void Ui::begin_typing(ImGuiID id, double value) {
  typing_id_ = id;
  typing_begins_ = true;
  std::fill(std::begin(typed_), std::end(typed_), '\0');
  if (std::abs(value) >= kNoLimit) return;
  std::to_chars(typed_, typed_ + sizeof typed_ - 1, value);
}

bool Ui::typing_field(const char* id_text, ImVec2 position, float width, double& value, bool& changed,
                      double none) {
  ImGui::SetCursorScreenPos(position);
  ImGui::SetNextItemWidth(width);
  if (typing_begins_) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText(id_text, typed_, sizeof typed_,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = !typing_begins_ && ImGui::IsItemDeactivated();
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  typing_begins_ = false;
  if (!entered && !left) return false;
  double parsed = value;
  const bool emptied = none != 0 && typed_[std::strspn(typed_, " ")] == '\0';
  if (emptied) parsed = none;
  if (!escaped && (emptied || parse_number(typed_, parsed)) && parsed != value) {
    value = parsed;
    changed = true;
  }
  typing_id_ = 0;
  return true;
}

double Ui::wheel_notches(ImGuiID id, bool hovered, Edit& edit) {
  double notches = 0.0;
  if (hovered) {
    ImGui::SetItemUsingMouseWheel();
    notches = static_cast<double>(ImGui::GetIO().MouseWheel);
    if (notches != 0) {
      wheel_id_ = id;
      wheel_time_ = ImGui::GetTime();
    }
  }
  if (wheel_id_ == id && (!hovered || ImGui::GetTime() - wheel_time_ > kWheelPause)) {
    wheel_id_ = 0;
    edit.finished = true;
  }
  return notches;
}

void Ui::draw_slider(float left, float right, float y, float at, bool filled, bool held, ImU32 rim) const {
  const Palette& p = colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float half = px(1);
  draw.AddRectFilled(ImVec2(left, y - half), ImVec2(right, y + half), p.line, px(2));
  if (filled)
    draw.AddRectFilled(ImVec2(left, y - half), ImVec2(at, y + half), held ? p.accent : p.ink_soft, px(2));
  draw.AddCircleFilled(ImVec2(at, y + px(1)), knob_radius(), p.shadow, 20);
  draw.AddCircleFilled(ImVec2(at, y), knob_radius(), held ? p.accent : p.raised, 20);
  draw.AddCircle(ImVec2(at, y), knob_radius(), rim, 20);
}

Edit Ui::length(std::string_view name, std::string_view label, double& value, double per_pixel,
                std::string_view unit, std::string_view tooltip) {
  QuantityLook look;
  look.unit = unit;
  look.per_pixel = per_pixel;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  label_cell(label, tooltip);
  ImGui::SetCursorScreenPos(ImVec2(origin.x + label_width(), origin.y));
  return quantity(name, value, look);
}

Edit Ui::quantity_row(std::string_view name, std::string_view label, double& value,
                      const QuantityLook& look) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  label_cell(label, look.tooltip);
  ImGui::SetCursorScreenPos(ImVec2(origin.x + label_width(), origin.y));
  return quantity(name, value, look);
}

Edit Ui::quantity(std::string_view name, double& value, const QuantityLook& look) {
  Edit edit;
  const double before = value;
  const float height = ImGui::GetFrameHeight();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = look.width > 0 ? look.width : ImGui::GetContentRegionAvail().x;
  const ImVec2 max(min.x + width, min.y + height);
  const auto kept = [&](double wanted) { return std::max(wanted, look.least); };
  ImGui::PushID(name.data(), end_of(name));
  const ImGuiID id = ImGui::GetID("quantity");
  if (typing(id)) {
    edit.finished = typing_field("##typed", min, width, value, edit.changed, look.none);
    value = kept(value);
    edit.changed = value != before;
    record(name, min, max);
    ImGui::PopID();
    return edit;
  }
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("quantity", ImVec2(width, height));
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  record(name, min, max, true, min.x, max.x, 0.5f * (min.x + max.x));
  if (!look.tooltip.empty() && !held) tooltip_if_hovered(look.tooltip);
  if (hovered || held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const ImGuiIO& io = ImGui::GetIO();
  const bool unlimited = std::abs(value) >= kNoLimit;
  if (ImGui::IsItemActivated()) drag_carry_ = unlimited ? look.from_none : value;
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    value = drag_carry_ = look.reset_value;
    edit.finished = true;
  } else if (ImGui::IsItemActivated() && io.KeyCtrl) {
    begin_typing(id, value);
    ImGui::ClearActiveID();
  } else if (held && io.MouseDelta.x != 0 && !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    drag_carry_ += static_cast<double>(io.MouseDelta.x) * look.per_pixel;
    const double rounded = std::round(drag_carry_ / look.per_pixel) * look.per_pixel;
    value = kept(rounded == 0 ? 0.0 : rounded);  // no -0
  }
  if (ImGui::IsItemDeactivated()) edit.finished = true;
  if (const double notches = wheel_notches(id, hovered, edit); notches != 0)
    value = kept((unlimited ? look.from_none : value) + notches * 5 * look.per_pixel);
  edit.changed = value != before;
  ImGui::PopID();

  const Palette& p = colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(min, max, held ? p.pressed : hovered ? p.hovered : p.raised, rounding);
  draw.AddRect(min, max, p.line, rounding);
  const bool none = std::abs(value) >= kNoLimit;
  const std::string_view unit = none ? std::string_view() : look.unit;
  const float unit_width = unit.empty() ? 0 : text_size(theme_.small(), unit).x + px(5);
  const ImVec2 left(min.x + px(8), min.y), right(max.x - px(8), max.y);
  draw_text_aligned(draw, theme_.small(), left, right, 0.0f, p.ink_faint, look.prefix);
  draw_text_aligned(draw, theme_.small(), left, right, 1.0f, p.ink_faint, unit);
  draw_text_aligned(draw, theme_.regular(), left, ImVec2(right.x - unit_width, right.y), 1.0f,
                    none ? p.ink_faint : p.ink, none ? "none" : format_entry(value));
  return edit;
}

Edit Ui::weight(std::string_view name, std::string_view label, double& value, const WeightLook& look) {
  Edit edit;
  const double before = value;
  const Palette& p = colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  // Two lines: label and numbers, under them the slider and the bar of the share.
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const float available = ImGui::GetContentRegionAvail().x;
  const float text_height = px(19), track_height = px(13), height = px(32);
  const float knob = knob_radius(), number_width = px(48), reset_width = px(18);
  const float column = available - weight_share_width() - px(10);
  const float text_bottom = origin.y + text_height;
  const ImVec2 number_min(origin.x + column - number_width, origin.y),
      number_max(origin.x + column, text_bottom);
  const ImVec2 track_min(origin.x, origin.y + height - track_height - px(1)),
      track_max(origin.x + column, origin.y + height - px(1));
  const float left = track_min.x + knob, right = track_max.x - knob;

  ImGui::PushID(name.data(), end_of(name));
  const ImGuiID id = ImGui::GetID("weight");

  // The label, and a "?" that explains it.
  const float help_width = px(18);
  const float room = number_min.x - reset_width - help_width - origin.x;
  const std::string read = elided(theme_.regular(), label, room);
  const float label_width_here = text_size(theme_.regular(), read).x;
  draw_text_aligned(draw, theme_.regular(), origin, ImVec2(origin.x + room, text_bottom), 0.0f,
                    value > 0 ? p.ink : p.ink_soft, read);
  ImGui::SetCursorScreenPos(origin);
  ImGui::InvisibleButton("label", ImVec2(label_width_here + help_width, text_height));
  draw_help(ImVec2(origin.x + label_width_here + px(11), 0.5f * (origin.y + text_bottom) + px(0.5f)),
            ImGui::IsItemHovered());
  record(std::string(name) + " help", ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  tooltip_if_hovered(look.tooltip);

  // Back to where it began; only there when it is elsewhere.
  if (value != look.reset_value) {
    ImGui::SetCursorScreenPos(ImVec2(number_min.x - reset_width, origin.y + px(0.5f)));
    ButtonLook reset;
    reset.small = reset.quiet = reset.has_icon = true;
    reset.icon = Icon::Undo;
    reset.width = reset_width;
    reset.tooltip = "Back to " + format_number(look.reset_value);
    if (button(std::string(name) + " reset", theme_.has_icons() ? "" : "0", reset)) {
      value = look.reset_value;
      edit.finished = true;
    }
  }

  // The slider.
  ImGui::SetCursorScreenPos(track_min);
  ImGui::InvisibleButton("weight", ImVec2(track_max.x - track_min.x, track_height));
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  record(name, track_min, track_max, true, left, right,
         left + static_cast<float>(fraction_of_weight(value)) * (right - left));
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    value = look.reset_value;
    ImGui::ClearActiveID();
    edit.finished = true;
  } else if (ImGui::IsItemActivated() && io.KeyCtrl) {
    begin_typing(id, value);
    ImGui::ClearActiveID();
  } else if (held && (ImGui::IsItemActivated() || io.MouseDelta.x != 0)) {
    value = weight_at(static_cast<double>((io.MousePos.x - left) / (right - left)));
  }
  if (ImGui::IsItemDeactivated()) edit.finished = true;
  if (const double notches = wheel_notches(id, hovered, edit); notches != 0)
    value = weight_step(value, notches);

  // The number: a click types.
  if (typing(id)) {
    double typed = value;
    bool changed = false;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(4), px(1)));
    if (typing_field("##typed", number_min, number_width, typed, changed)) edit.finished = true;
    ImGui::PopStyleVar();
    if (changed && typed >= 0) value = typed;
  } else {
    ImGui::SetCursorScreenPos(number_min);
    if (ImGui::InvisibleButton("number", ImVec2(number_width, text_height))) begin_typing(id, value);
    const bool over = ImGui::IsItemHovered();
    record(std::string(name) + " number", number_min, number_max);
    if (over) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
      draw.AddRectFilled(number_min, number_max, p.hovered, ImGui::GetStyle().FrameRounding);
    }
    draw_text_aligned(draw, theme_.regular(), number_min, ImVec2(number_max.x - px(2), number_max.y), 1.0f,
                      value > 0 ? p.ink : p.ink_faint, format_number(value));
  }
  ImGui::PopID();
  edit.changed = value != before;

  const float y = std::round(0.5f * (track_min.y + track_max.y));
  const float x = left + static_cast<float>(fraction_of_weight(value)) * (right - left);
  // A tick where 1 stands, the weight that means the same on every model.
  const float one = std::round(left + static_cast<float>(fraction_of_weight(1.0)) * (right - left));
  draw.AddRectFilled(ImVec2(one, y - px(3)), ImVec2(one + 1, y + px(3)), p.line);
  draw_slider(left, right, y, x, value > 0, held,
              held || hovered ? p.accent : value > 0 ? p.ink_soft : p.ink_faint);

  // What it adds to the objective, over the bar of its share.
  const ImVec2 share_min(origin.x + available - weight_share_width(), origin.y),
      share_max(origin.x + available, origin.y + height);
  if (look.value >= 0 && value > 0) {
    draw_text_aligned(draw, theme_.regular(), share_min, ImVec2(share_max.x, text_bottom), 1.0f, p.ink_soft,
                      format_number(look.value));
  }
  const ImVec2 bar_min(share_min.x, y - px(2)), bar_max(share_max.x, y + px(2));
  draw.AddRectFilled(bar_min, bar_max, p.hovered, px(2));
  if (look.share > 0 && value > 0) {
    const float length =
        std::max(static_cast<float>(std::min(look.share, 1.0)) * (bar_max.x - bar_min.x), px(1));
    draw.AddRectFilled(bar_min, ImVec2(bar_min.x + length, bar_max.y), p.ink_soft, px(2));
  }
  if (ImGui::IsMouseHoveringRect(share_min, share_max) && ImGui::IsWindowHovered()) {
    char text[96] = "Share of the objective: known after a solve";
    if (value <= 0) {
      std::snprintf(text, sizeof text, "Weight 0: no part of the objective");
    } else if (look.share >= 0) {
      std::snprintf(text, sizeof text, "%.1f %% of the objective", 100 * look.share);
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(7)));
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(text);
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
  }
  ImGui::SetCursorScreenPos(origin);
  // The rows follow each other closely.
  ImGui::Dummy(ImVec2(available, height - ImGui::GetStyle().ItemSpacing.y));
  return edit;
}

}  // namespace planewright::ui
