// The left half of the export dialog: what is written, of what, onto which sheets.
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ui/export_dialog.h"
#include "ui/export_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

struct FormatChip {
  ExportFormat format;
  const char* label;
  const char* tooltip;
};
struct FormatGroup {
  const char* title;
  std::vector<FormatChip> chips;
};

const std::vector<FormatGroup>& format_groups() {
  static const std::vector<FormatGroup> groups{
      {"Sheets",
       {{ExportFormat::Dxf, "DXF", "One file per sheet, 1:1 in mm: layers CUT, ENGRAVE, TEXT, SHEET."},
        {ExportFormat::Svg, "SVG", "One file per sheet, 1:1 in mm, a group per layer and panel."},
        {ExportFormat::Pdf, "PDF", "All sheets to scale on pages with title block, index and scale bar."}}},
      {"Schedules",
       {{ExportFormat::Csv, "CSV", "Panels and edges as tables: lengths, angles, areas, verdicts."},
        {ExportFormat::Json, "JSON", "The same and more for programs; keeps names for later exports."}}},
      {"Panels and solids",
       {{ExportFormat::Obj, "OBJ", "The panels as a surface; with a thickness the solids as well."},
        {ExportFormat::Ply, "PLY", "The panels as a surface; with a thickness the solids as well."},
        {ExportFormat::Stl, "STL", "The panels as a surface; with a thickness the solids as well."},
        {ExportFormat::ThreeMf, "3MF", "Solids in millimetres, each by its name. Needs a thickness."},
        {ExportFormat::Gltf, "glTF", "For viewers; with a thickness the solids as well."}}}};
  return groups;
}

constexpr std::array<SheetSize, 4> kStock{
    {{3210.0, 6000.0}, {2550.0, 3210.0}, {1500.0, 3000.0}, {1250.0, 2500.0}}};

std::string size_text(const SheetSize& size) {
  return format_count(static_cast<std::int64_t>(size.width)) + " × " +
         format_count(static_cast<std::int64_t>(size.height)) + " mm";
}

void label(Ui& ui, const char* text) {
  ImGui::AlignTextToFramePadding();
  ui.text(text, ui.colours().ink_soft);
  ImGui::SameLine(ui.label_width());
}

// Leaves the cursor at the line's beginning, where the segments alone leave it under themselves.
bool segmented_row(Ui& ui, const char* name, const char* text, std::span<const std::string> labels,
                   int& current, std::span<const std::string> tooltips = {}) {
  const float left = ImGui::GetCursorPosX();
  label(ui, text);
  const bool changed = ui.segmented(name, labels, current, tooltips);
  ImGui::SetCursorPosX(left);
  return changed;
}

void text_row(Ui& ui, const char* name, const char* text, std::string& value, const std::string& hint) {
  label(ui, text);
  ImGui::SetNextItemWidth(-FLT_MIN);
  ImGui::PushID(name);
  ImGui::InputTextWithHint("##text", hint.c_str(), &value);
  ImGui::PopID();
  ui.record_item(name);
}

void draw_formats(Desk& desk, ExportChoice& choice) {
  Ui& ui = desk.ui;
  bool lacking = false;
  for (const FormatGroup& group : format_groups()) {
    ui.small_text(group.title);
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (const FormatChip& chip : group.chips) {
      const bool on = choice.formats.contains(chip.format);
      const bool lacks = lacks_thickness(chip.format, desk.state.contract());
      lacking |= on && lacks;
      if (ui.chip("format " + std::string(name_of(chip.format)), chip.label, on,
                  lacks ? ui.colours().warning : ui.colours().accent, right, std::exchange(first, false))) {
        if (on) {
          choice.formats.erase(chip.format);
        } else {
          choice.formats.insert(chip.format);
        }
      }
      ui.tooltip_if_hovered(chip.tooltip);
    }
    ui.gap(2);
  }
  if (lacking) ui.wrapped("3MF is left out: it needs panels with a thickness.", ui.colours().warning, true);
  if (choice.formats.contains(ExportFormat::Dxf)) {
    static const std::array<std::string, 2> kVersions = {"R12", "2000"};
    static const std::array<std::string, 2> kAbout = {"For old machines: polylines of their own kind",
                                                      "What every CAD program of today reads"};
    int version = choice.dxf == DxfVersion::R12 ? 0 : 1;
    if (segmented_row(ui, "dxf", "DXF version", kVersions, version, kAbout))
      choice.dxf = version == 0 ? DxfVersion::R12 : DxfVersion::R2000;
  }
}

void length_row(Ui& ui, const char* name, const char* text, double& value, double per_pixel, double least,
                double reset, const char* tooltip) {
  QuantityLook look;
  look.unit = "mm";
  look.per_pixel = per_pixel;
  look.least = least;
  look.reset_value = reset;
  look.tooltip = tooltip;
  ui.quantity_row(name, text, value, look);
}

void draw_sheet_size(Ui& ui, SheetSize& sheet) {
  std::vector<std::string> names;
  int current = static_cast<int>(kStock.size());
  for (std::size_t i = 0; i < kStock.size(); ++i) {
    names.push_back(size_text(kStock[i]));
    if (kStock[i] == sheet) current = static_cast<int>(i);
  }
  names.emplace_back("another size");
  if (ui.choice("stock", "Stock", names, current, "The sheets that parts are cut from.") &&
      current < static_cast<int>(kStock.size()))
    sheet = kStock[static_cast<std::size_t>(current)];

  label(ui, "Size");
  const float between = ui.px(20), room = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  QuantityLook look;
  look.unit = "mm";
  look.per_pixel = 10;
  look.least = 1;
  look.width = std::floor(0.5f * (room - between));
  look.reset_value = kStock[0].width;
  look.tooltip = "Width of a sheet. Drag, or ctrl-click and type.";
  ui.quantity("sheet width", sheet.width, look);
  draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().regular(), ImVec2(at.x + look.width, at.y),
                    ImVec2(at.x + look.width + between, at.y + ImGui::GetFrameHeight()), 0.5f,
                    ui.colours().ink_faint, "×");
  ImGui::SetCursorScreenPos(ImVec2(at.x + look.width + between, at.y));
  look.reset_value = kStock[0].height;
  look.tooltip = "Height of a sheet. Drag, or ctrl-click and type.";
  ui.quantity("sheet height", sheet.height, look);
}

void draw_sheets(Ui& ui, ExportLayout& layout) {
  ui.checkbox("sheets", "Lay parts on stock sheets", layout.sheets,
              "Off: all parts in rows on one drawing, to be laid by another program.");
  if (!layout.sheets) return;
  draw_sheet_size(ui, layout.sheet);
  length_row(ui, "spacing", "Spacing", layout.spacing, 0.5, 0, 10, "Between parts on a sheet.");
  length_row(ui, "margin", "Margin", layout.margin, 0.5, 0, 10, "Along the border of a sheet.");
  ui.checkbox("rotate", "Parts may be turned", layout.rotate,
              "Off: what is up on the panel stays up on the sheet, for grain, coating or print.");
}

void draw_labels(Ui& ui, ExportLayout& layout) {
  length_row(ui, "text height", "Text height", layout.text_height, 0.5, 1, 12,
             "Of panel names at most; smaller where a part has less room.");
  ui.checkbox("edge names", "Neighbours' names along the edges", layout.edge_names);
  ui.checkbox("engrave names", "Names as strokes to engrave", layout.engrave_names,
              "As single strokes on the layer ENGRAVE, besides the text on the layer TEXT.");
}

void draw_page(Desk& desk, ExportChoice& choice) {
  Ui& ui = desk.ui;
  std::vector<std::string> names;
  for (const PageMeasure& page : kPages) names.emplace_back(page.name);
  int page = static_cast<int>(choice.page);
  if (segmented_row(ui, "page", "Page", names, page)) choice.page = static_cast<PageSize>(page);
  text_row(ui, "project", "Project", choice.project,
           std::filesystem::path(desk.state.document().name()).stem().string());
  text_row(ui, "drawn by", "Drawn by", choice.drawn_by, "name");
  text_row(ui, "note", "Note", choice.note, "");
}

void draw_failing(Desk& desk, ExportChoice& choice, const ToleranceVerdicts* verdicts) {
  Ui& ui = desk.ui;
  static const std::array<std::string, 2> kWays = {"Mark them", "Refuse"};
  static const std::array<std::string, 2> kAbout = {
      "Everything is written; panels that fail are marked in drawings, schedules and certificate",
      "Nothing is written as long as a panel fails"};
  int way = choice.on_failure == OnFailure::Mark ? 0 : 1;
  if (ui.segmented("failing", kWays, way, kAbout))
    choice.on_failure = way == 0 ? OnFailure::Mark : OnFailure::Refuse;
  if (verdicts == nullptr) return;
  ui.small_text(verdict_line(*verdicts), verdicts->failed > 0 ? ui.colours().warning : ui.colours().good);
}

}  // namespace

void draw_export_form(Desk& desk) {
  Ui& ui = desk.ui;
  ExportChoice& choice = desk.window.settings.workshop_export;
  const PreparedExport* prepared = desk.state.export_preparation();
  const ToleranceVerdicts* verdicts = prepared != nullptr ? &prepared->made.verdicts : nullptr;
  const int chosen = static_cast<int>(choice.formats.size());
  if (ui.section("formats", "Formats", true, format_count(chosen, "chosen", "chosen"),
                 chosen == 0 ? ui.colours().warning : 0))
    draw_formats(desk, choice);
  const double thickness = desk.state.contract().thickness;
  if (ui.section("panels", "Panels", true,
                 thickness > 0 ? format_with_unit(thickness, "mm") : "no thickness"))
    draw_panel_terms(desk);
  if (ui.section("nesting", "Sheets", true, choice.layout.sheets ? size_text(choice.layout.sheet) : "none"))
    draw_sheets(ui, choice.layout);
  if (ui.section("if panels fail", "If panels fail", true,
                 verdicts != nullptr && verdicts->failed > 0 ? format_count(verdicts->failed) + " fail" : "",
                 ui.colours().warning))
    draw_failing(desk, choice, verdicts);
  if (ui.section("labels", "Labels", false, format_with_unit(choice.layout.text_height, "mm")))
    draw_labels(ui, choice.layout);
  if (ui.section("title", "Page of the PDF", false, kPages[static_cast<std::size_t>(choice.page)].name))
    draw_page(desk, choice);
}

}  // namespace planewright::ui
