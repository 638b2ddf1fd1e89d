#include "ui/schedule_cells.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"
#include "ui/widget_text.h"

namespace planewright::ui {
namespace {

// What a column has room for at first.
const char* widest_text(ScheduleColumn column) {
  switch (column) {
    case ScheduleColumn::Name:
      return "AA-123";
    case ScheduleColumn::Size:
      return "8,888 × 8,888";
    case ScheduleColumn::Area:
      return "0.888";
    case ScheduleColumn::Corners:
    case ScheduleColumn::InteriorMin:
    case ScheduleColumn::BevelMax:
      return "88.8";
    case ScheduleColumn::Class:
      return "888 ×88";
    case ScheduleColumn::Verdict:
      return "planarity …";
    default:
      return "8,888";
  }
}

// Verdicts have a dot before them.
float indent(const Ui& ui, ScheduleColumn column) {
  return column == ScheduleColumn::Verdict ? ui.px(14) : 0.0f;
}

}  // namespace

float cell_padding(const Ui& ui) {
  return ui.px(5);
}

float column_width(const Ui& ui, ScheduleColumn column) {
  return std::ceil(std::max(text_size(ui.theme().small(), info(column).title).x + ui.px(2),
                            text_size(ui.theme().regular(), widest_text(column)).x)) +
         indent(ui, column);
}

float title_height(const Ui& ui) {
  return 2 * ui.theme().small()->FontSize + ui.px(8);
}

bool draw_column_title(Ui& ui, ScheduleColumn column, bool sorted, bool descending) {
  const ScheduleColumnInfo& what = info(column);
  const Palette& p = ui.colours();
  ImFont* font = ui.theme().small();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0f), title_height(ui));
  const ImVec2 max(min.x + size.x, min.y + size.y);
  const bool pressed = ImGui::InvisibleButton(what.name.c_str(), size);
  ui.record_item("column " + what.name);
  const bool hovered = ImGui::IsItemHovered();
  ui.tooltip_if_hovered(what.tooltip);

  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float align = is_number(column) ? 1.0f : 0.0f;
  const float middle = min.y + ui.px(4) + font->FontSize;
  const float left = min.x + indent(ui, column);
  const ImU32 ink = hovered ? p.accent : sorted ? p.ink : p.ink_soft;
  draw_text_aligned(draw, font, ImVec2(left, min.y + ui.px(3)), ImVec2(max.x, middle), align, ink,
                    elided(font, what.title, max.x - left));
  // The arrow stands in the line of the unit, so that titles stay where they are.
  const ImVec2 below_min(left, middle), below_max(max.x, max.y - ui.px(3));
  draw_text_aligned(draw, font, below_min, below_max, align, p.ink_faint, what.unit);
  if (sorted) {
    const float unit = what.unit.empty() ? 0.0f : text_size(font, what.unit).x + ui.px(4);
    draw_text_aligned(draw, font, below_min, ImVec2(below_max.x - align * unit, below_max.y), align, p.accent,
                      descending ? "↓" : "↑");
  }
  return pressed;
}

void draw_cell(const Ui& ui, const Schedule& schedule, int panel, ScheduleColumn column, const Rect& cell) {
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = ui.theme().regular();
  const ScheduleRow& row = schedule.row(panel);
  ImVec2 min = cell.min;
  const ImVec2 max = cell.max;
  if (column == ScheduleColumn::Class && row.class_index >= 0) {
    const std::string label = class_label(row.class_index);
    draw_text_aligned(draw, font, min, max, 0.0f, p.ink, label);
    min.x += text_size(font, label).x + ui.px(5);
    draw_text_aligned(draw, ui.theme().small(), min, max, 0.0f, p.ink_faint,
                      "×" + format_count(row.class_size));
    return;
  }
  const std::string text = cell_text(schedule, panel, column);
  ImU32 ink = text == "–" ? p.ink_faint : p.ink;
  if (column == ScheduleColumn::Verdict) {
    const bool fails = row.failure >= 0;
    ink = fails ? p.error : p.ink_soft;
    const ImVec2 centre(min.x + ui.px(4), std::round(0.5f * (min.y + max.y)));
    if (fails) draw.AddCircleFilled(centre, ui.px(3.5f), p.error, 16);
    min.x += indent(ui, column);
  }
  draw_text_aligned(draw, font, min, max, is_number(column) ? 1.0f : 0.0f, ink,
                    elided(font, text, max.x - min.x));
}

}  // namespace planewright::ui
