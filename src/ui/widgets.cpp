#include "ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/widget_text.h"

namespace planewright::ui {

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
    const ImVec2 at = r.middle();
    const bool above_or_below = at.y < window->ClipRect.Min.y || at.y >= window->ClipRect.Max.y;
    // Of a table that is scrolled sideways; the column's own clip rectangle is empty then.
    const bool aside =
        window->ScrollMax.x > 0 && (at.x < window->ClipRect.Min.x || at.x >= window->ClipRect.Max.x);
    if (above_or_below || (!r.clickable && !aside)) ImGui::SetScrollFromPosY(at.y - window->Pos.y);
    if (aside) ImGui::SetScrollFromPosX(at.x - window->Pos.x);
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

bool Ui::chip(const std::string& name, const std::string& label, bool on, ImU32 dot, float right,
              bool first) {
  const Palette& p = colours();
  ImFont* font = theme_.small();
  const ImVec2 text = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, label.c_str());
  const ImVec2 size(text.x + px(28), font->FontSize + px(9));
  if (!first) {
    ImGui::SameLine(0, px(4));
    if (ImGui::GetCursorScreenPos().x + size.x > right) ImGui::NewLine();
  }
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + size.x, min.y + size.y);
  const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
  record_item(name);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float round = 0.5f * size.y;
  draw.AddRectFilled(min, max, hovered ? p.hovered : on ? p.raised : with_alpha(p.raised, 0.0f), round);
  draw.AddRect(min, max, p.line, round);
  const ImVec2 centre(min.x + px(12), 0.5f * (min.y + max.y));
  if (on) {
    draw.AddCircleFilled(centre, px(4), dot, 16);
  } else {
    draw.AddCircle(centre, px(3.5f), p.ink_faint, 16);
  }
  draw_text_aligned(draw, font, ImVec2(min.x + px(20), min.y), max, 0.0f, on ? p.ink : p.ink_faint, label);
  return pressed;
}

bool Ui::selectable(std::string_view name, std::string_view label, bool selected) {
  ImGui::PushID(name.data(), end_of(name));
  const bool pressed = ImGui::Selectable(std::string(label).c_str(), selected);
  ImGui::PopID();
  record_item(name);
  return pressed;
}

void bring_row_into_sight(int row, float row_height) {
  const float top = row_height * static_cast<float>(row);
  const float room = ImGui::GetWindowHeight() - 2 * row_height;
  if (top < ImGui::GetScrollY() || top > ImGui::GetScrollY() + room) ImGui::SetScrollY(top - 0.5f * room);
}

}  // namespace planewright::ui
