// The schedule below the model: a filter, one row per panel, and what the rows sum up to.
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/schedule_cells.h"
#include "ui/widget_text.h"

namespace planewright::ui {
namespace {

constexpr const char* kFilterHelp =
    "Words that all have to hold:\n"
    "C-1   in the panel's name\n"
    "to:C-17   beside that panel\n"
    "class:12   fails   passes\n"
    "area>2   edge<300   corners=6   planarity>=0.2\n"
    "also shortest, longest, angle, bevel, distance, weight, width, height";

// --- The line of tools -------------------------------------------------------------------------

void draw_filter(Desk& desk, float width) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  std::string& filter = desk.window.schedule.query.filter;
  const float height = ImGui::GetFrameHeight(), cross = ui.px(18);
  const ImVec2 min = ImGui::GetCursorScreenPos(), max(min.x + width, min.y + height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, p.raised, ImGui::GetStyle().FrameRounding);

  for (const ImGuiCol part : {ImGuiCol_FrameBg, ImGuiCol_Border})
    ImGui::PushStyleColor(part, IM_COL32(0, 0, 0, 0));
  ImGui::SetNextItemWidth(width - cross - ui.px(6));
  ImGui::InputTextWithHint("##filter", "Filter: area>2, fails, …", &filter);
  ImGui::PopStyleColor(2);
  const bool active = ImGui::IsItemActive();
  const bool escaped = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  ui.record_item("filter");
  if (!active) ui.tooltip_if_hovered(kFilterHelp);
  if (!filter.empty()) {
    ButtonLook look;
    look.small = look.quiet = look.has_icon = true;
    look.icon = Icon::Close;
    look.width = cross;
    look.tooltip = "Show all again  (Esc)";
    ImGui::SetCursorScreenPos(ImVec2(max.x - cross - ui.px(3), min.y + std::round(0.5f * (height - cross))));
    if (ui.button("clear filter", ui.theme().has_icons() ? "" : "x", look) || escaped) filter.clear();
  }
  const bool wrong = !desk.window.schedule.list().filter_error.empty();
  draw.AddRect(min, max, wrong ? p.warning : active ? p.accent : p.line, ImGui::GetStyle().FrameRounding);
}

bool draw_switch(Ui& ui, const char* name, const char* label, bool& on, ImU32 dot, const char* about) {
  // In the middle of the line, which is higher.
  const float height = ui.theme().small()->FontSize + ui.px(9);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + std::round(0.5f * (ImGui::GetFrameHeight() - height)));
  const bool pressed = ui.chip(name, label, on, dot, 1e9f, true);
  ui.tooltip_if_hovered(about);
  if (pressed) on = !on;
  return pressed;
}

void copy_rows(Desk& desk) {
  const ScheduleView& view = desk.window.schedule;
  ImGui::SetClipboardText(copied_text(view.schedule(), view.list()).c_str());
  desk.state.post(Message::Kind::Info,
                  format_count(view.list().size(), "row is", "rows are") + " on the clipboard");
}

// The filter takes the room that the others leave.
void draw_tools(Desk& desk, const Rect& line) {
  Ui& ui = desk.ui;
  ScheduleQuery& query = desk.window.schedule.query;
  ImFont* small = ui.theme().small();
  const float gap = ui.px(8);
  const auto chip_width = [&](const char* label) { return text_size(small, label).x + ui.px(28); };
  const float chips = chip_width("Failing") + chip_width("Selected") + ui.px(4) + 2 * gap;
  const bool in_words = !ui.theme().has_icons() || line.width() - chips > ui.px(300);
  const float copy = in_words ? ui.px(78) : ImGui::GetFrameHeight();
  const float others = chips + copy;
  const float filter = std::clamp(line.width() - others, ui.px(60), ui.px(300));

  ImGui::SetCursorScreenPos(line.min);
  draw_filter(desk, filter);
  float x = line.min.x + filter + gap;
  ImGui::SetCursorScreenPos(ImVec2(x, line.min.y));
  draw_switch(ui, "only failing", "Failing", query.only_failing, ui.colours().error,
              "Only panels that fail the tolerance sheet");
  x += chip_width("Failing") + ui.px(4);
  ImGui::SetCursorScreenPos(ImVec2(x, line.min.y));
  draw_switch(ui, "only selected", "Selected", query.only_selected, ui.colours().accent,
              "Only panels that are selected");
  ButtonLook look;
  look.has_icon = look.quiet = true;
  look.icon = Icon::Copy;
  look.width = copy;
  look.enabled = desk.window.schedule.list().size() > 0;
  look.tooltip = "Copy the rows that are listed, for a spreadsheet";
  ImGui::SetCursorScreenPos(ImVec2(line.max.x - copy, line.min.y));
  if (ui.button("copy", in_words ? "Copy" : "", look)) copy_rows(desk);
}

// --- The table ---------------------------------------------------------------------------------

void set_up_columns(Ui& ui, const Schedule& schedule, float width) {
  const float padding = 2 * cell_padding(ui);
  float left = width - ImGui::GetStyle().ScrollbarSize - padding - ui.px(4);  // and round the outside
  ImGui::TableSetupScrollFreeze(1, 1);
  for (int c = 0; c < kScheduleColumns; ++c) {
    const auto column = static_cast<ScheduleColumn>(c);
    const bool hidden = column == ScheduleColumn::Weight && !schedule.weights;
    float wanted = column_width(ui, column);
    // What is left goes to the words at the end.
    if (column == ScheduleColumn::Verdict) wanted = std::max(wanted, left - padding);
    if (!hidden) left -= wanted + padding;
    ImGui::TableSetupColumn(info(column).name.c_str(),
                            ImGuiTableColumnFlags_WidthFixed |
                                (hidden ? ImGuiTableColumnFlags_Disabled : ImGuiTableColumnFlags_None),
                            wanted);
  }
}

void draw_titles(Ui& ui, ScheduleQuery& query) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, title_height(ui));
  for (int c = 0; c < kScheduleColumns; ++c) {
    const auto column = static_cast<ScheduleColumn>(c);
    if (!ImGui::TableSetColumnIndex(c)) {  // scrolled out of sight
      const ImRect place = ImGui::TableGetCellBgRect(ImGui::GetCurrentTable(), c);
      ui.record("column " + info(column).name, place.Min, place.Max);
      continue;
    }
    const bool sorted = query.sort == column;
    if (!draw_column_title(ui, column, sorted, query.descending)) continue;
    query.descending = sorted && !query.descending;
    query.sort = column;
  }
}

// All that the sheet says of a panel, as a tooltip.
void explain_failures(const Ui& ui, const PreparedWorkshop& from, int panel) {
  std::string text;
  for (const ToleranceFailure& failure : from.verdicts.failures) {
    if (failure.panel != panel) continue;
    if (!text.empty()) text += '\n';
    text += describe(failure, *from.model);
  }
  ui.tooltip(text);
}

void draw_row(Desk& desk, int row, float height) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ScheduleView& view = desk.window.schedule;
  const int panel = view.list().panels[static_cast<std::size_t>(row)];
  const bool pointed_at = desk.state.selected_panel == panel;
  ImGui::TableNextRow(ImGuiTableRowFlags_None, height);
  bool hovered = false;
  for (int c = 0; c < kScheduleColumns; ++c) {
    if (!ImGui::TableSetColumnIndex(c)) continue;
    const ImVec2 min = ImGui::GetCursorScreenPos();
    const Rect cell{min, ImVec2(min.x + ImGui::GetContentRegionAvail().x, min.y + height)};
    const auto column = static_cast<ScheduleColumn>(c);
    if (c == 0) {
      ImGui::PushID(row);
      const bool pressed = ImGui::Selectable(
          "##row", false, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick,
          ImVec2(0, height));
      hovered = ImGui::IsItemHovered();
      ImGui::PopID();
      ui.record("row " + std::to_string(row), cell.min, cell.max);
      const ImGuiIO& io = ImGui::GetIO();
      if (pressed && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        desk.state.show_panel(panel);
      } else if (pressed) {
        view.click(desk.state, row, io.KeyCtrl, io.KeyShift);
      }
      if (pressed) desk.window.listed_panel = desk.state.selected_panel;  // it is in sight
      if (pointed_at)
        ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(min.x - cell_padding(ui), min.y),
                                                  ImVec2(min.x - cell_padding(ui) + ui.px(3), cell.max.y),
                                                  p.accent);
    }
    draw_cell(ui, view.schedule(), panel, column, cell);
    if (column == ScheduleColumn::Verdict && hovered && view.schedule().row(panel).failure >= 0 &&
        ImGui::IsMouseHoveringRect(cell.min, cell.max)) {
      explain_failures(ui, *view.schedule().from, panel);
    }
  }
  if (view.selected(panel) || pointed_at) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, p.accent_soft);
  } else if (hovered) {
    ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, p.hovered);
  }
}

// Another order is read from its beginning. The panel that is pointed at comes into sight when it becomes
// that.
void scroll_table(Desk& desk, float height) {
  if (desk.window.schedule.take_rearranged()) ImGui::SetScrollY(0);
  if (desk.state.selected_panel == desk.window.listed_panel) return;
  desk.window.listed_panel = desk.state.selected_panel;
  if (!desk.state.selected_panel) return;
  const auto row = desk.window.schedule.row_of(*desk.state.selected_panel);
  if (!row) return;
  const float top = height * static_cast<float>(*row);
  const float room = ImGui::GetWindowHeight() - title_height(desk.ui) - ImGui::GetStyle().ScrollbarSize;
  if (top < ImGui::GetScrollY() || top + height > ImGui::GetScrollY() + room)
    ImGui::SetScrollY(std::max(top - 0.5f * (room - height), 0.0f));
}

void draw_table(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  ScheduleView& view = desk.window.schedule;
  const float height = std::round(ImGui::GetTextLineHeight() + ui.px(6));
  ImGui::SetCursorScreenPos(place.min);
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(cell_padding(ui), 0));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleColor(ImGuiCol_TableBorderLight, to_vec4(with_alpha(ui.colours().line, 0.45f)));
  for (const ImGuiCol part : {ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive})
    ImGui::PushStyleColor(part, IM_COL32(0, 0, 0, 0));
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingFixedFit |
                                ImGuiTableFlags_BordersOuter | ImGuiTableFlags_BordersInnerH |
                                ImGuiTableFlags_NoBordersInBody | ImGuiTableFlags_NoSavedSettings;
  if (ImGui::BeginTable("panels", kScheduleColumns, flags, ImVec2(place.width(), place.height()))) {
    set_up_columns(ui, view.schedule(), place.width());
    draw_titles(ui, view.query);
    scroll_table(desk, height);
    ImGuiListClipper clipper;
    clipper.Begin(view.list().size(), height);
    while (clipper.Step())
      for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) draw_row(desk, row, height);
    ImGui::EndTable();
  }
  ImGui::PopStyleColor(5);
  ImGui::PopStyleVar(2);
}

// --- What else there is to say ---------------------------------------------------------------------

std::string why_no_row(const ScheduleView& view) {
  const ScheduleQuery& query = view.query;
  if (query.only_selected && query.filter.empty() && !query.only_failing) return "No panel is selected.";
  if (query.only_failing && query.filter.empty() && !query.only_selected)
    return "Every panel keeps the tolerance sheet.";
  return "No panel is like that.";
}

void draw_sum(Desk& desk, const Rect& line) {
  Ui& ui = desk.ui;
  const ScheduleView& view = desk.window.schedule;
  ImFont* font = ui.theme().small();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const std::string sum = sum_text(view.schedule(), view.list());
  const std::string& error = view.list().filter_error;
  float left = line.min.x;
  if (!error.empty()) {
    const std::string text = elided(font, error, line.width());
    draw_text_aligned(draw, font, line.min, line.max, 0.0f, ui.colours().warning, text);
    left += text_size(font, text).x + ui.px(24);
  }
  const float width = text_size(font, sum).x;
  if (left + width <= line.max.x || error.empty())
    draw_text_aligned(draw, font, ImVec2(left, line.min.y), line.max, error.empty() ? 0.0f : 1.0f,
                      ui.colours().ink_soft, elided(font, sum, line.max.x - left));
  ui.record("sum", line.min, line.max);
}

}  // namespace

void draw_schedule(Desk& desk, const Rect& head, const Rect& body) {
  Ui& ui = desk.ui;
  ScheduleView& view = desk.window.schedule;
  view.update(desk.state);
  Rect table = body;
  if (head.width() > ui.px(320)) {
    draw_tools(desk, head);
  } else {  // a line of their own
    const float bottom = body.min.y + ImGui::GetFrameHeight();
    draw_tools(desk, {body.min, ImVec2(body.max.x, bottom)});
    table.min.y = bottom + ui.px(4);
  }
  if (const std::string why = why_no_schedule(desk.state); !why.empty()) {
    const bool wrong = desk.state.workshop_error() && desk.state.shown();
    ImGui::SetCursorScreenPos(ImVec2(table.min.x, table.min.y + ui.px(8)));
    ui.wrapped(why, wrong ? ui.colours().warning : ui.colours().ink_soft);
    return;
  }
  const float sum = ui.theme().small()->FontSize + ui.px(4);
  const Rect line{ImVec2(table.min.x, table.max.y - sum + ui.px(2)),
                  ImVec2(table.max.x, table.max.y + ui.px(2))};
  table.max.y -= sum;
  if (table.height() < title_height(ui)) return;
  draw_table(desk, table);
  if (view.list().size() == 0) {
    const Rect middle{ImVec2(table.min.x, table.min.y + title_height(ui)), table.max};
    draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().regular(), middle.min, middle.max, 0.5f,
                      ui.colours().ink_soft,
                      elided(ui.theme().regular(), why_no_row(view), middle.width() - ui.px(20)));
  }
  draw_sum(desk, line);
}

}  // namespace planewright::ui
