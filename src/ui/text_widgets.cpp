// Texts of widgets.h: drawn into rectangles, shortened, wrapped, and as tooltips.
#include <imgui_internal.h>

#include <cmath>

#include "ui/widget_text.h"
#include "ui/widgets.h"

namespace planewright::ui {

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
