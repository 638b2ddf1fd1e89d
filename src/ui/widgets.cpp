#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/problem/constraint.h"
#include "ui/format.h"
#include "ui/weight_scale.h"

namespace planewright::ui {
namespace {

constexpr double kWheelPause = 0.5;  // seconds without a notch after which the wheel's gesture is over

const char* end_of(std::string_view text) {
  return text.data() + text.size();
}

ImVec2 text_size(ImFont* font, std::string_view text) {
  if (text.empty()) return {0.0f, font->FontSize};  // a null pointer would be read as a C string
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0.0f, text.data(), end_of(text));
}

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

void draw_text_aligned(ImDrawList& draw, ImFont* font, ImVec2 min, ImVec2 max, float align, ImU32 colour,
                       std::string_view text) {
  if (text.empty()) return;
  const ImVec2 size = text_size(font, text);
  const ImVec2 at(std::round(min.x + align * (max.x - min.x - size.x)),
                  std::round(0.5f * (min.y + max.y - size.y)));
  draw.AddText(font, font->FontSize, at, colour, text.data(), end_of(text));
}

std::string elided(ImFont* font, std::string_view text, float width) {
  if (text_size(font, text).x <= width) return std::string(text);
  std::string shorter(text);
  while (!shorter.empty()) {
    shorter.pop_back();
    while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xC0) == 0x80)
      shorter.pop_back();
    if (!shorter.empty() && static_cast<unsigned char>(shorter.back()) >= 0xC0) shorter.pop_back();
    if (text_size(font, shorter + "…").x <= width) break;
  }
  return shorter + "…";
}

std::string elided_left(ImFont* font, std::string_view text, float width) {
  if (text_size(font, text).x <= width) return std::string(text);
  while (!text.empty()) {
    text.remove_prefix(1);
    while (!text.empty() && (static_cast<unsigned char>(text.front()) & 0xC0) == 0x80) text.remove_prefix(1);
    if (text_size(font, "…" + std::string(text)).x <= width) break;
  }
  return "…" + std::string(text);
}

// --- Frames and records ----------------------------------------------------------------------

void Ui::begin_frame(int frame) {
  frame_ = frame;
  // What was not drawn for a while is gone; a frame of grace keeps popups findable while they appear.
  std::erase_if(records_, [&](const auto& entry) { return entry.second.frame < frame - 2; });
}

const UiRecord* Ui::find(std::string_view path) const {
  const auto found = records_.find(path);
  return found == records_.end() || found->second.frame < frame_ - 1 ? nullptr : &found->second;
}

void Ui::record(std::string_view name, ImVec2 min, ImVec2 max, bool enabled, float travel_left,
                float travel_right, float knob) {
  UiRecord& r = records_[prefix_ + std::string(name)];
  r = {min, max, travel_left, travel_right, knob, false, enabled, frame_};
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  // A card that measures itself is not where it will be.
  const bool placed = window->HiddenFramesCanSkipItems == 0 && window->HiddenFramesCannotSkipItems == 0;
  r.clickable = placed && window->ClipRect.Contains(r.middle()) && !window->SkipItems;
  if (wanted_ == prefix_ + std::string(name)) {
    if (!r.clickable) ImGui::SetScrollFromPosY(r.middle().y - window->Pos.y);
    wanted_.clear();
  }
}

void Ui::record_item(std::string_view name, bool enabled) {
  record(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), enabled);
}

// --- Controls --------------------------------------------------------------------------------

bool Ui::button(std::string_view name, std::string_view label, const ButtonLook& look) {
  const std::string icon = look.has_icon ? theme_.icon(look.icon) : "";
  const float height = look.small ? px(18) : ImGui::GetFrameHeight();
  const ImVec2 padding = look.small ? ImVec2(0, 0) : ImGui::GetStyle().FramePadding;
  const float icon_width = icon.empty() ? 0.0f : ImGui::CalcTextSize(icon.c_str()).x;
  const float label_width = label.empty() ? 0.0f : ImGui::CalcTextSize(label.data(), end_of(label)).x;
  const float between = icon.empty() || label.empty() ? 0.0f : px(6);
  const float content = icon_width + between + label_width;
  float width = look.width;
  if (width == 0) width = std::max(content + 2 * padding.x, height);
  if (width < 0) width = ImGui::GetContentRegionAvail().x;

  if (!look.enabled) ImGui::BeginDisabled();
  ImGui::PushID(name.data(), end_of(name));
  const bool pressed = ImGui::InvisibleButton("button", ImVec2(width, height));
  ImGui::PopID();
  const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
  if (!look.enabled) ImGui::EndDisabled();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  record(name, min, max, look.enabled);

  const Palette& p = colours();
  ImU32 fill = p.raised, ink = p.ink, line = p.line;
  if (look.primary) {
    fill = p.accent;
    ink = p.on_accent;
    line = p.accent;
    if (hovered) fill = with_alpha(p.accent, 0.88f);
    if (held) fill = with_alpha(p.accent, 0.76f);
  } else {
    if (look.active) {
      fill = p.accent_soft;
      line = p.accent;
    }
    if (look.quiet && !look.active) {
      fill = IM_COL32(0, 0, 0, 0);
      line = IM_COL32(0, 0, 0, 0);
    }
    if (hovered && !look.active) fill = p.hovered;
    if (held) fill = p.pressed;
    if (look.small && !hovered) ink = p.ink_faint;
  }
  if (!look.enabled) {
    ink = p.ink_faint;
    if (look.primary) {
      fill = p.hovered;
      line = p.line;
    }
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(min, max, fill, rounding);
  draw.AddRect(min, max, line, rounding);
  const float x = std::round(0.5f * (min.x + max.x - content));
  ImFont* font = ImGui::GetFont();
  draw_text_aligned(draw, font, ImVec2(x, min.y), ImVec2(x + icon_width, max.y), 0.0f, ink, icon);
  draw_text_aligned(draw, font, ImVec2(x + icon_width + between, min.y), max, 0.0f, ink, label);
  if (!look.tooltip.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
    tooltip_if_hovered(look.tooltip);
  }
  return pressed && look.enabled;
}

bool Ui::segmented(std::string_view name, std::span<const std::string> labels, int& current,
                   std::span<const std::string> tooltips) {
  bool changed = false;
  const float height = ImGui::GetFrameHeight();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = colours();
  const float rounding = ImGui::GetStyle().FrameRounding;
  draw.AddRectFilled(origin, ImVec2(origin.x + width, origin.y + height), p.hovered, rounding);
  draw.AddRect(origin, ImVec2(origin.x + width, origin.y + height), p.line, rounding);
  ImGui::PushID(name.data(), end_of(name));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto n = static_cast<float>(labels.size());
    const float x0 = std::round(origin.x + static_cast<float>(i) * width / n);
    const float x1 = std::round(origin.x + static_cast<float>(i + 1) * width / n);
    ImGui::SetCursorScreenPos(ImVec2(x0, origin.y));
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::InvisibleButton("segment", ImVec2(x1 - x0, height)) && current != static_cast<int>(i)) {
      current = static_cast<int>(i);
      changed = true;
    }
    ImGui::PopID();
    record(std::string(name) + " " + labels[i], ImVec2(x0, origin.y), ImVec2(x1, origin.y + height));
    const bool on = current == static_cast<int>(i);
    const float inset = px(2);
    const ImVec2 min(x0 + inset, origin.y + inset), max(x1 - inset, origin.y + height - inset);
    if (on) {
      draw.AddRectFilled(min, max, p.raised, rounding);
      draw.AddRect(min, max, p.line, rounding);
    }
    const ImU32 ink = on ? p.ink : ImGui::IsItemHovered() ? p.ink : p.ink_soft;
    ImFont* font = on ? theme_.bold() : theme_.regular();
    draw_text_aligned(draw, font, min, max, 0.5f, ink, elided(font, labels[i], max.x - min.x - px(4)));
    if (i < tooltips.size()) tooltip_if_hovered(tooltips[i]);
  }
  ImGui::PopID();
  ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + height + ImGui::GetStyle().ItemSpacing.y));
  ImGui::Dummy(ImVec2(0, 0));
  ImGui::SetCursorScreenPos(ImVec2(origin.x, origin.y + height + ImGui::GetStyle().ItemSpacing.y));
  return changed;
}

bool Ui::checkbox(std::string_view name, std::string_view label, bool& value, std::string_view tooltip) {
  const bool pressed = checkbox_mixed(name, label, value, false);
  if (!tooltip.empty()) tooltip_if_hovered(tooltip);
  return pressed;
}

bool Ui::checkbox_mixed(std::string_view name, std::string_view label, bool& value, bool mixed) {
  const float height = ImGui::GetFrameHeight();
  const float box = std::round(px(17));
  const float width = box + px(8) + ImGui::CalcTextSize(label.data(), end_of(label)).x;
  ImGui::PushID(name.data(), end_of(name));
  const bool pressed = ImGui::InvisibleButton("checkbox", ImVec2(width, height));
  ImGui::PopID();
  if (pressed) value = mixed || !value;
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  record(name, min, max);
  const Palette& p = colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 a(min.x, std::round(0.5f * (min.y + max.y - box)));
  const ImVec2 b(a.x + box, a.y + box);
  const float rounding = px(3);
  const bool filled = value && !mixed;
  draw.AddRectFilled(a, b, filled ? p.accent : ImGui::IsItemHovered() ? p.hovered : p.raised, rounding);
  draw.AddRect(a, b, filled || mixed ? p.accent : p.ink_faint, rounding);
  if (filled) {
    ImGui::RenderCheckMark(&draw, ImVec2(a.x + px(3.5f), a.y + px(3.5f)), p.on_accent, box - px(7));
  } else if (mixed) {
    const float y = std::round(0.5f * (a.y + b.y));
    draw.AddRectFilled(ImVec2(a.x + px(4), y - px(1)), ImVec2(b.x - px(4), y + px(1)), p.accent);
  }
  draw_text_aligned(draw, theme_.regular(), ImVec2(b.x + px(8), min.y), max, 0.0f, p.ink, label);
  return pressed;
}

void Ui::help(std::string_view name, std::string_view text) {
  const float size = px(15), height = ImGui::GetFrameHeight();
  ImGui::PushID(name.data(), end_of(name));
  ImGui::InvisibleButton("help", ImVec2(size, height));
  ImGui::PopID();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  record(name, min, max);
  const bool hovered = ImGui::IsItemHovered();
  draw_help(ImVec2(0.5f * (min.x + max.x), 0.5f * (min.y + max.y)), hovered);
  tooltip_if_hovered(text);
}

void Ui::draw_help(ImVec2 middle, bool hovered) const {
  const float radius = px(6);
  const ImVec2 at(std::round(middle.x), std::round(middle.y));
  const ImU32 ink = hovered ? colours().accent : colours().ink_faint;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddCircle(ImVec2(at.x, at.y), radius, with_alpha(ink, hovered ? 1.0f : 0.55f), 20);
  ImFont* font = theme_.small();
  const float small = std::round(px(10.5f));
  const ImVec2 size = font->CalcTextSizeA(small, FLT_MAX, 0.0f, "?");
  draw.AddText(font, small, ImVec2(at.x - 0.5f * size.x + px(0.5f), at.y - 0.5f * size.y), ink, "?");
}

void Ui::label_cell(std::string_view label, std::string_view tooltip) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 max(at.x + label_width(), at.y + ImGui::GetFrameHeight());
  draw_text_aligned(*ImGui::GetWindowDrawList(), theme_.regular(), at, max, 0.0f, colours().ink_soft, label);
  if (!tooltip.empty() && ImGui::IsMouseHoveringRect(at, max) && ImGui::IsWindowHovered())
    this->tooltip(tooltip);
}

bool Ui::choice(std::string_view name, std::string_view label, std::span<const std::string> items,
                int& current, std::string_view tooltip, std::span<const std::string> item_tooltips) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  if (!label.empty()) {
    label_cell(label, tooltip);
    ImGui::SetCursorScreenPos(ImVec2(origin.x + label_width(), origin.y));
  }
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushID(name.data(), end_of(name));
  bool changed = false;
  const std::string& preview =
      items[static_cast<std::size_t>(std::clamp(current, 0, static_cast<int>(items.size()) - 1))];
  const ImVec2 frame_min = ImGui::GetCursorScreenPos();
  const float frame_width = ImGui::GetContentRegionAvail().x;
  const bool open = ImGui::BeginCombo("##combo", preview.c_str());
  if (open) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const bool selected = current == static_cast<int>(i);
      if (ImGui::Selectable(items[i].c_str(), selected) && !selected) {
        current = static_cast<int>(i);
        changed = true;
      }
      record_item(std::string(name) + "/" + items[i]);
      if (i < item_tooltips.size()) tooltip_if_hovered(item_tooltips[i]);
      if (selected && ImGui::IsWindowAppearing()) ImGui::SetItemDefaultFocus();
    }
    ImGui::EndCombo();
  }
  ImGui::PopID();
  record(name, frame_min, ImVec2(frame_min.x + frame_width, frame_min.y + ImGui::GetFrameHeight()));
  return changed;
}

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

void Ui::finish_wheel(ImGuiID id, bool hovered, Edit& edit) {
  if (wheel_id_ != id) return;
  if (!hovered || ImGui::GetTime() - wheel_time_ > kWheelPause) {
    wheel_id_ = 0;
    edit.finished = true;
  }
}

Edit Ui::length(std::string_view name, std::string_view label, double& value, double per_pixel,
                std::string_view unit, std::string_view tooltip) {
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  label_cell(label, tooltip);
  ImGui::SetCursorScreenPos(ImVec2(origin.x + label_width(), origin.y));
  QuantityLook look;
  look.unit = unit;
  look.per_pixel = per_pixel;
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
  if (ImGui::IsItemActivated()) drag_carry_ = unlimited ? 0.0 : value;
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
  if (hovered) {
    ImGui::SetItemUsingMouseWheel();
    if (io.MouseWheel != 0) {
      value = kept((unlimited ? 0.0 : value) + static_cast<double>(io.MouseWheel) * 5 * look.per_pixel);
      wheel_id_ = id;
      wheel_time_ = ImGui::GetTime();
    }
  }
  edit.changed = value != before;
  finish_wheel(id, hovered, edit);
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
  const float knob = px(5), number_width = px(48), reset_width = px(18);
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
  if (hovered) {
    ImGui::SetItemUsingMouseWheel();
    if (io.MouseWheel != 0) {
      value = weight_step(value, static_cast<double>(io.MouseWheel));
      wheel_id_ = id;
      wheel_time_ = ImGui::GetTime();
    }
  }
  finish_wheel(id, hovered, edit);

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
  const float thickness = px(2);
  draw.AddRectFilled(ImVec2(left, y - 0.5f * thickness), ImVec2(right, y + 0.5f * thickness), p.line,
                     thickness);
  // A tick where 1 stands, the weight that means the same on every model.
  const float one = std::round(left + static_cast<float>(fraction_of_weight(1.0)) * (right - left));
  draw.AddRectFilled(ImVec2(one, y - px(3)), ImVec2(one + 1, y + px(3)), p.line);
  if (value > 0) {
    draw.AddRectFilled(ImVec2(left, y - 0.5f * thickness), ImVec2(x, y + 0.5f * thickness),
                       held ? p.accent : p.ink_soft, thickness);
  }
  draw.AddCircleFilled(ImVec2(x, y + px(1)), knob, p.shadow, 20);
  draw.AddCircleFilled(ImVec2(x, y), knob, held ? p.accent : p.raised, 20);
  draw.AddCircle(ImVec2(x, y), knob, held || hovered ? p.accent : value > 0 ? p.ink_soft : p.ink_faint, 20);

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

bool Ui::section(std::string_view name, std::string_view title, bool open_at_first, std::string_view summary,
                 ImU32 summary_colour) {
  gap(3);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetFrameHeight();
  ImGui::PushID(name.data(), end_of(name));
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID id = ImGui::GetID("open");
  bool open = storage->GetBool(id, open_at_first);
  if (ImGui::InvisibleButton("section", ImVec2(width, height))) {
    open = !open;
    storage->SetBool(id, open);
  }
  ImGui::PopID();
  const ImVec2 max(min.x + width, min.y + height);
  record(name, min, max);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::IsItemHovered() ? colours().accent : colours().ink;
  const float arrow = px(16);
  if (theme_.has_icons()) {
    draw_text_aligned(draw, theme_.regular(), min, ImVec2(min.x + arrow, max.y), 0.2f, colours().ink_faint,
                      theme_.icon(open ? Icon::ChevronDown : Icon::ChevronRight));
  } else {
    ImGui::RenderArrow(&draw, ImVec2(min.x, min.y + px(6)), colours().ink_faint,
                       open ? ImGuiDir_Down : ImGuiDir_Right, 0.8f);
  }
  draw_text_aligned(draw, theme_.bold(), ImVec2(min.x + arrow, min.y), max, 0.0f, ink, title);
  const float line_x = min.x + arrow + text_size(theme_.bold(), title).x + px(10);
  const float line_y = std::round(0.5f * (min.y + max.y)) + 0.5f;
  float line_end = max.x;
  if (!summary.empty()) {
    draw_text_aligned(draw, theme_.small(), min, max, 1.0f,
                      summary_colour == 0 ? colours().ink_soft : summary_colour, summary);
    line_end -= text_size(theme_.small(), summary).x + px(10);
  }
  if (line_x < line_end) draw.AddLine(ImVec2(line_x, line_y), ImVec2(line_end, line_y), colours().line);
  return open;
}

bool Ui::selectable(std::string_view name, std::string_view label, bool selected) {
  ImGui::PushID(name.data(), end_of(name));
  const bool pressed = ImGui::Selectable(std::string(label).c_str(), selected);
  ImGui::PopID();
  record_item(name);
  return pressed;
}

// --- Texts -----------------------------------------------------------------------------------

void Ui::text(std::string_view text, ImU32 colour) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour == 0 ? colours().ink : colour);
  ImGui::TextUnformatted(text.data(), end_of(text));
  ImGui::PopStyleColor();
}

void Ui::small_text(std::string_view text, ImU32 colour) {
  ImGui::PushFont(theme_.small());
  this->text(text, colour == 0 ? colours().ink_soft : colour);
  ImGui::PopFont();
}

void Ui::wrapped(std::string_view text, ImU32 colour, bool small) {
  ImGui::PushFont(small ? theme_.small() : theme_.regular());
  ImGui::PushTextWrapPos(0.0f);
  this->text(text, colour == 0 ? (small ? colours().ink_soft : colours().ink) : colour);
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
}

void Ui::heading(std::string_view text) {
  ImGui::PushFont(theme_.bold());
  this->text(text);
  ImGui::PopFont();
}

void Ui::value_row(std::string_view label, std::string_view value, ImU32 value_colour,
                   std::string_view tooltip) {
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const float height = ImGui::GetTextLineHeight() + px(5);
  ImGui::Dummy(ImVec2(width, height));
  const ImVec2 max(min.x + width, min.y + height - ImGui::GetStyle().ItemSpacing.y + px(3));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_text_aligned(draw, theme_.regular(), min, max, 0.0f, colours().ink_soft, label);
  const float room = width - text_size(theme_.regular(), label).x - px(10);
  draw_text_aligned(draw, theme_.regular(), min, max, 1.0f, value_colour == 0 ? colours().ink : value_colour,
                    elided(theme_.regular(), value, room));
  ImGui::SetCursorScreenPos(ImVec2(min.x, min.y + height - px(2)));
  if (!tooltip.empty()) tooltip_if_hovered(tooltip);
}

void Ui::separator() {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::GetWindowDrawList()->AddLine(ImVec2(at.x, at.y + px(2)), ImVec2(at.x + width, at.y + px(2)),
                                      colours().line);
  ImGui::Dummy(ImVec2(width, px(5)));
}

void Ui::gap(float at_scale_one) {
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  ImGui::Dummy(ImVec2(0, std::max(px(at_scale_one) - spacing, 0.0f)));
}

void Ui::tooltip_if_hovered(std::string_view text) const {
  if (!text.empty() && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) tooltip(text);
}

void Ui::tooltip(std::string_view text) const {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(10), px(7)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(300));
  ImGui::TextUnformatted(text.data(), end_of(text));
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace planewright::ui
