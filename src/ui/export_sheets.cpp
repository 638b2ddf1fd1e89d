// The right half of the export dialog: the sheets as they will be written, and remarks on them.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ui/export_dialog.h"
#include "ui/export_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

struct Remark {
  std::string text;
  bool error = false;
};

// Checks that fail come first: there is nothing that matters more.
std::vector<Remark> remarks_of(const AppState& state) {
  std::vector<Remark> remarks;
  if (state.export_outcome())
    for (std::string& check : failed_checks(state.export_outcome()->certificate))
      remarks.push_back({std::move(check), true});
  if (const PreparedExport* prepared = state.export_preparation())
    for (const std::string& remark : prepared->made.remarks) remarks.push_back({capitalised(remark)});
  return remarks;
}

void show_sheet(ExportDialog& dialog, int sheet, int count) {
  sheet = std::clamp(sheet, 0, std::max(count - 1, 0));
  if (sheet == dialog.sheet) return;
  dialog.sheet = sheet;
  dialog.scroll_to_sheet = true;
  dialog.preview.fit();
}

// Arrows, and what the sheet is.
void draw_pages(Desk& desk, const PreparedExport* prepared, int count) {
  Ui& ui = desk.ui;
  ExportDialog& dialog = desk.window.export_dialog;
  const auto arrow = [&](const char* name, const char* text, int by, const char* tooltip) {
    ButtonLook look;
    look.enabled = dialog.sheet + by >= 0 && dialog.sheet + by < count;
    look.width = ImGui::GetFrameHeight();
    look.tooltip = tooltip;
    if (ui.button(name, text, look)) show_sheet(dialog, dialog.sheet + by, count);
    ImGui::SameLine(0, ui.px(4));
  };
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  arrow("previous sheet", "←", -1, "Previous sheet (Page up)");
  arrow("next sheet", "→", 1, "Next sheet (Page down)");
  ImGui::SameLine(0, ui.px(10));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(right, at.y + ImGui::GetFrameHeight());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (prepared != nullptr) {
    const std::string line = sheet_line(prepared->made, dialog.sheet);
    draw_text_aligned(draw, ui.theme().bold(), at, end, 0.0f, ui.colours().ink, line);
    if (prepared->made.nesting) {
      const std::string all =
          std::to_string(std::lround(100.0 * prepared->made.nesting->filled)) + " % of all sheets filled";
      const float taken =
          ui.theme().bold()->CalcTextSizeA(ui.theme().bold()->FontSize, 1e6f, 0, line.c_str()).x;
      if (at.x + taken + ui.px(140) < right)
        draw_text_aligned(draw, ui.theme().small(), at, end, 1.0f, ui.colours().ink_soft, all);
    }
  }
  ImGui::Dummy(ImVec2(1, ImGui::GetFrameHeight()));
}

// In the middle of the place, where there is nothing else to be seen.
void draw_words(Ui& ui, ImVec2 min, ImVec2 max, const std::string& what, const std::string& remedy,
                ImU32 colour) {
  const float width = std::min(ui.px(420), max.x - min.x - ui.px(24));
  const auto height_of = [&](ImFont* font, const std::string& text) {
    return text.empty() ? 0.0f : font->CalcTextSizeA(font->FontSize, 1e6f, width, text.c_str()).y;
  };
  const float high = height_of(ui.theme().bold(), what), low = height_of(ui.theme().regular(), remedy);
  float y = std::round(0.5f * (min.y + max.y - high - low - ui.px(6)));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto put = [&](ImFont* font, const std::string& text, ImU32 ink) {
    const float wide = std::min(width, font->CalcTextSizeA(font->FontSize, 1e6f, width, text.c_str()).x);
    draw.AddText(font, font->FontSize, ImVec2(std::round(0.5f * (min.x + max.x - wide)), y), ink,
                 text.c_str(), nullptr, width);
  };
  put(ui.theme().bold(), what, colour);
  y += high + ui.px(6);
  put(ui.theme().regular(), remedy, ui.colours().ink_soft);
}

// Over the corner of the preview while another is on the way.
void draw_preparing(Ui& ui, const AppState& state, ImVec2 min, ImVec2 max) {
  const ExportStage stage = state.export_stage();
  std::string text = stage_text(stage.name);
  if (stage.fraction > 0) text += "  " + std::to_string(std::lround(100 * stage.fraction)) + " %";
  ImFont* font = ui.theme().small();
  const float width = font->CalcTextSizeA(font->FontSize, 1e6f, 0, text.c_str()).x + ui.px(20);
  const ImVec2 a(max.x - width - ui.px(8), min.y + ui.px(8)), b(max.x - ui.px(8), a.y + ui.px(24));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(a, b, ui.colours().overlay, ui.px(4));
  draw.AddRect(a, b, ui.colours().line, ui.px(4));
  draw_text_aligned(draw, font, a, b, 0.5f, ui.colours().ink_soft, text);
  const float end = a.x + static_cast<float>(std::clamp(stage.fraction, 0.0, 1.0)) * (b.x - a.x);
  if (end > a.x) draw.AddRectFilled(ImVec2(a.x, b.y - ui.px(2)), ImVec2(end, b.y), ui.colours().accent);
}

void draw_preview(Desk& desk, const PreparedExport* prepared, ImVec2 min, ImVec2 max) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  ExportDialog& dialog = desk.window.export_dialog;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(min, max, ui.colours().ground, ui.px(4));
  const int count = prepared != nullptr ? static_cast<int>(prepared->made.drawings.size()) : 0;
  const auto why = state.why_no_export();
  if (!why && !state.export_refusal() && dialog.sheet < count) {
    const auto pointed = dialog.preview.draw(
        ui, prepared->made.drawings[static_cast<std::size_t>(dialog.sheet)],
        prepared->number * 1'000'000 + static_cast<std::uint64_t>(dialog.sheet), prepared->job.model->names,
        prepared->made.verdicts.pass, state.selected_panel, min, max);
    if (pointed.clicked) state.select_panel(*pointed.panel, Combine::Replace);
  } else if (why) {
    draw_words(ui, min, max, why->what, why->remedy, ui.colours().ink);
  } else if (state.export_refusal()) {
    const Error error = readable(*state.export_refusal());
    draw_words(ui, min, max, capitalised(error.what), capitalised(error.remedy), ui.colours().error);
  } else if (prepared != nullptr) {
    draw_words(ui, min, max, "No panel fits a sheet of this size",
               "Choose larger sheets, look at the model's unit, or export without sheets.",
               ui.colours().error);
  } else {
    draw_words(ui, min, max, stage_text(state.export_stage().name), "", ui.colours().ink_soft);
  }
  if (state.export_preparing() && prepared != nullptr) draw_preparing(ui, state, min, max);
  draw.AddRect(min, max, ui.colours().line, ui.px(4));
}

// All sheets in small, in a row that can be scrolled.
void draw_thumbnails(Desk& desk, const PreparedExport& prepared, float height) {
  Ui& ui = desk.ui;
  ExportDialog& dialog = desk.window.export_dialog;
  const int count = static_cast<int>(prepared.made.drawings.size());
  ImGui::BeginChild("thumbnails", ImVec2(0, height), false,
                    ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoScrollbar);
  const float high = height - ui.px(2);
  for (int i = 0; i < count; ++i) {
    const Drawing& drawing = prepared.made.drawings[static_cast<std::size_t>(i)];
    const float wide = std::clamp(static_cast<float>(high * drawing.width / std::max(drawing.height, 1e-6)),
                                  ui.px(18), 2 * high);
    if (i > 0) ImGui::SameLine(0, ui.px(6));
    ImGui::PushID(i);
    if (ImGui::InvisibleButton("thumbnail", ImVec2(wide, high))) show_sheet(dialog, i, count);
    ImGui::PopID();
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    if (i == dialog.sheet && (ImGui::IsWindowAppearing() || std::exchange(dialog.scroll_to_sheet, false)))
      ImGui::SetScrollHereX();
    if (!ImGui::IsRectVisible(min, max)) continue;
    ui.record("thumbnail " + std::to_string(i + 1), min, max);
    const bool current = i == dialog.sheet;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw_thumbnail(draw, drawing, min, max);
    draw.AddRect(min, max,
                 current                  ? ui.colours().accent
                 : ImGui::IsItemHovered() ? ui.colours().ink_soft
                                          : ui.colours().line,
                 0, 0, current ? ui.px(2) : 1.0f);
  }
  if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0)
    ImGui::SetScrollX(ImGui::GetScrollX() - ImGui::GetIO().MouseWheel * ui.px(60));
  ImGui::EndChild();
}

void draw_remarks(Ui& ui, const std::vector<Remark>& remarks, float height) {
  ImGui::BeginChild("remarks", ImVec2(0, height), false);
  for (std::size_t i = 0; i < remarks.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImU32 colour = remarks[i].error ? ui.colours().error : ui.colours().warning;
    ImGui::GetWindowDrawList()->AddCircleFilled(
        ImVec2(at.x + ui.px(5), at.y + 0.5f * ui.theme().small()->FontSize + 1), ui.px(3), colour, 12);
    ImGui::SetCursorScreenPos(ImVec2(at.x + ui.px(15), at.y));
    ImGui::BeginGroup();
    ui.wrapped(remarks[i].text, remarks[i].error ? ui.colours().error : 0, true);
    ImGui::EndGroup();
    ui.record_item("remark " + std::to_string(i));
  }
  ImGui::EndChild();
}

}  // namespace

void draw_export_sheets(Desk& desk) {
  Ui& ui = desk.ui;
  ExportDialog& dialog = desk.window.export_dialog;
  const PreparedExport* prepared = desk.state.export_preparation();
  const int count = prepared != nullptr ? static_cast<int>(prepared->made.drawings.size()) : 0;
  if (prepared != nullptr) show_sheet(dialog, dialog.sheet, count);
  if (!ImGui::GetIO().WantTextInput && !desk.window.browser.is_open()) {
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (pressed(ImGuiKey_PageUp) || pressed(ImGuiKey_LeftArrow)) show_sheet(dialog, dialog.sheet - 1, count);
    if (pressed(ImGuiKey_PageDown) || pressed(ImGuiKey_RightArrow))
      show_sheet(dialog, dialog.sheet + 1, count);
  }
  draw_pages(desk, prepared, count);

  // What lies below the preview takes its height first.
  const std::vector<Remark> remarks = remarks_of(desk.state);
  const float room = ImGui::GetContentRegionAvail().y, spacing = ImGui::GetStyle().ItemSpacing.y;
  const float line = ui.theme().small()->FontSize + spacing;
  const float title = remarks.empty() ? 0.0f : ImGui::GetFrameHeight() + ui.px(3) + 2 * spacing;
  const float list =
      remarks.empty()
          ? 0.0f
          : std::min(line * static_cast<float>(std::min<std::size_t>(remarks.size() + 1, 4)), 0.25f * room);
  float strip = count > 1 ? ui.px(68) : 0.0f;
  float below = title + list + (strip > 0 ? strip + spacing : 0.0f);
  if (room - below < ui.px(250) && strip > 0) {
    below -= strip + spacing;
    strip = 0;
  }
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x,
                   std::floor(min.y + std::max(room - below, ui.px(80))));
  draw_preview(desk, prepared, min, max);
  ImGui::SetCursorScreenPos(ImVec2(min.x, max.y + spacing));
  if (strip > 0) draw_thumbnails(desk, *prepared, strip);
  if (remarks.empty()) return;
  const auto errors = std::count_if(remarks.begin(), remarks.end(), [](const Remark& r) { return r.error; });
  ui.gap(3);
  ui.heading(errors > 0 ? format_count(errors, "check fails", "checks fail")
                        : format_count(static_cast<std::int64_t>(remarks.size()), "remark", "remarks"));
  draw_remarks(ui, remarks, 0);
}

}  // namespace planewright::ui
