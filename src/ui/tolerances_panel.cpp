// The tolerance sheet in the right panel: its limits, what the panels have now, and how many fail.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <optional>
#include <string>

#include "core/problem/constraint.h"
#include "core/workshop/tolerance_share.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr double kSquareMetres = 1e-6;  // per mm^2

// One line of the sheet: a measure with a limit on one side or both.
struct LimitLine {
  const char* name;
  const char* label;
  const char* unit;
  double per_pixel;                              // of a drag
  double greatest;                               // that a limit can be
  std::optional<double> ToleranceSheet::*least;  // null: only the other
  std::optional<double> ToleranceSheet::*most;
  ToleranceKind least_kind, most_kind;
  const char* about;
};

using Kind = ToleranceKind;
constexpr std::array<LimitLine, 6> kLines{{
    {"planarity", "Planarity", "mm", 0.01, 1e9, nullptr, &ToleranceSheet::planarity, Kind::Planarity,
     Kind::Planarity, "Greatest distance of a corner from the plane of its panel"},
    {"distance", "Distance to reference", "mm", 1, 1e9, nullptr, &ToleranceSheet::distance, Kind::Distance,
     Kind::Distance, "Greatest distance of a corner from the surface that the panels were made for"},
    {"edge", "Edge length", "mm", 1, 1e9, &ToleranceSheet::edge_min, &ToleranceSheet::edge_max, Kind::EdgeMin,
     Kind::EdgeMax, "Of each side of a panel"},
    {"area", "Area", "m²", 0.01, 1e9, &ToleranceSheet::area_min, &ToleranceSheet::area_max, Kind::AreaMin,
     Kind::AreaMax, "Of each panel"},
    {"interior", "Interior angle", "°", 0.5, 360, &ToleranceSheet::interior_min,
     &ToleranceSheet::interior_max, Kind::InteriorMin, Kind::InteriorMax,
     "At each corner of a panel, in its plane"},
    {"dihedral", "Dihedral angle", "°", 0.5, 360, &ToleranceSheet::dihedral_min,
     &ToleranceSheet::dihedral_max, Kind::DihedralMin, Kind::DihedralMax,
     "Between two neighbours, seen from outside: 180 is flat, less a valley, more a ridge"},
}};

// The least and the greatest of a measure that the panels have now; nothing where none is measured.
std::optional<std::pair<double, double>> measured(const std::vector<PanelPassport>& passports, Kind kind) {
  double least = DBL_MAX, most = -DBL_MAX;
  const auto take = [&](double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  };
  for (const PanelPassport& passport : passports) {
    if (kind == Kind::Planarity) take(passport.planarity);
    if (kind == Kind::Distance && passport.distance) take(*passport.distance);
    if (kind == Kind::AreaMax) take(kSquareMetres * passport.area);
    for (const SidePassport& side : passport.sides) {
      if (kind == Kind::EdgeMax) take(side.length);
      if (kind == Kind::InteriorMax) take(side.interior);
      if (kind == Kind::DihedralMax && side.neighbour >= 0) take(side.dihedral);
    }
  }
  if (least > most) return std::nullopt;
  return std::pair(least, most);
}

int failing(const FailureList& list, Kind kind) {
  return list.count[static_cast<std::size_t>(kind)];
}

void change_sheet(Desk& desk, const ToleranceSheet& sheet, const std::string& what,
                  const std::string& merge_key) {
  WorkshopContract contract = desk.state.contract();
  contract.tolerances = sheet;
  desk.state.change_contract(std::move(contract), what, merge_key);
}

// The label, and at the line's end how many fail, or what there is now.
void draw_line_head(Desk& desk, const char* label, const char* about, int fail, const std::string& now) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight() + ui.px(3);
  ImGui::Dummy(ImVec2(width, height - ImGui::GetStyle().ItemSpacing.y + ui.px(2)));
  ui.tooltip_if_hovered(about);
  const ImVec2 max(at.x + width, at.y + height);
  draw_text_aligned(draw, ui.theme().regular(), at, max, 0.0f, p.ink, label);
  draw_text_aligned(draw, ui.theme().small(), at, max, 1.0f, fail > 0 ? p.error : p.ink_faint,
                    fail > 0 ? format_count(fail, "place fails", "places fail") : now);
}

void draw_limit(Desk& desk, const LimitLine& line, std::optional<double> ToleranceSheet::*limit,
                bool is_least, float width, double now) {
  ToleranceSheet sheet = desk.state.contract().tolerances;
  const std::optional<double> before = sheet.*limit;
  double value = before.value_or(kNoLimit);
  QuantityLook look;
  look.prefix = is_least ? "at least" : "at most";
  look.unit = line.unit;
  look.per_pixel = line.per_pixel;
  look.reset_value = (ToleranceSheet().*limit).value_or(kNoLimit);
  look.least = 0.0;
  look.none = kNoLimit;
  look.from_none = std::round(now / line.per_pixel) * line.per_pixel;
  look.width = width;
  look.tooltip =
      "Drag, turn the wheel, Ctrl click to type; left empty: no limit; double clicked: as at first.";
  const std::string name = std::string(line.name) + (is_least ? " min" : " max");
  const Edit edit = desk.ui.quantity(name, value, look);
  if (edit.changed) {
    const auto other = is_least ? line.most : line.least;
    if (std::abs(value) >= kNoLimit) {
      (sheet.*limit).reset();
    } else {
      value = std::clamp(value, 0.0, line.greatest);
      // A sheet with its limits the wrong way round can be kept by nothing.
      if (other != nullptr && sheet.*other)
        value = is_least ? std::min(value, *(sheet.*other)) : std::max(value, *(sheet.*other));
      sheet.*limit = value;
    }
    change_sheet(desk, sheet, std::string("Limit of ") + line.label, name);
  }
  if (edit.finished) desk.state.end_merge();
}

void draw_limit_line(Desk& desk, const LimitLine& line) {
  Ui& ui = desk.ui;
  const auto workshop = desk.state.workshop();
  const FailureList& list = desk.state.failure_list();
  const auto range = workshop ? measured(workshop->passports, line.most_kind) : std::nullopt;
  std::string now;
  if (range) {
    now = line.least != nullptr ? format_number(range->first) + " to " + format_number(range->second)
                                : "up to " + format_number(range->second);
    now = "now " + now + (std::string_view(line.unit) == "°" ? "" : " ") + line.unit;
  }
  const int fail =
      failing(list, line.most_kind) + (line.least != nullptr ? failing(list, line.least_kind) : 0);
  draw_line_head(desk, line.label, line.about, fail, now);
  const float space = ui.px(6);
  const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - space));
  const double at_least = range ? range->first : 0.0, at_most = range ? range->second : 0.0;
  if (line.least != nullptr) {
    draw_limit(desk, line, line.least, true, half, at_least);
    ImGui::SameLine(0, space);
    draw_limit(desk, line, line.most, false, 0, at_most);
  } else {
    draw_limit(desk, line, line.most, false, 0, at_most);
  }
  ui.gap(4);
}

void draw_stock(Desk& desk) {
  Ui& ui = desk.ui;
  ToleranceSheet sheet = desk.state.contract().tolerances;
  const SheetSize usual{3210.0, 6000.0};
  const auto workshop = desk.state.workshop();
  std::string now;
  if (workshop) {
    double width = 0, height = 0;
    for (const PanelPassport& passport : workshop->passports) {
      width = std::max(width, passport.width);
      height = std::max(height, passport.height);
    }
    now = "now up to " + format_number(height) + " × " + format_number(width) + " mm";
  }
  draw_line_head(desk, "Stock sheet", "Each panel, turned as it likes, has to fit on it",
                 failing(desk.state.failure_list(), Kind::StockSize), now);
  const float space = ui.px(6);
  const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - space));
  bool changed = false, finished = false;
  const auto field = [&](const char* name, const char* prefix, double SheetSize::*side, float width) {
    double value = sheet.stock ? (*sheet.stock).*side : kNoLimit;
    QuantityLook look;
    look.prefix = prefix;
    look.unit = "mm";
    look.per_pixel = 10;
    look.reset_value = look.none = kNoLimit;
    look.from_none = usual.*side;
    look.least = 1.0;
    look.width = width;
    look.tooltip = "Drag, turn the wheel, Ctrl click to type; left empty or double clicked: no limit.";
    const Edit edit = ui.quantity(name, value, look);
    finished = finished || edit.finished;
    if (!edit.changed) return;
    changed = true;
    if (std::abs(value) >= kNoLimit) {
      sheet.stock.reset();
    } else {
      if (!sheet.stock) sheet.stock = usual;
      (*sheet.stock).*side = value;
    }
  };
  field("stock width", "width", &SheetSize::width, half);
  ImGui::SameLine(0, space);
  field("stock height", "height", &SheetSize::height, 0);
  if (changed) change_sheet(desk, sheet, "Limit of stock sheet", "stock");
  if (finished) desk.state.end_merge();
}

// A sheet is mostly the office's, for all its designs.
void draw_sheet_files(Desk& desk) {
  Ui& ui = desk.ui;
  const std::filesystem::path folder = desk.window.settings.last_folder;
  const float space = ui.px(6);
  ButtonLook look;
  look.width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - space));
  look.tooltip = "Limits from a file take the place of these";
  if (ui.button("load sheet", "Load…", look))
    desk.window.browser.open(FileBrowser::Purpose::OpenTolerances, folder);
  ImGui::SameLine(0, space);
  look.tooltip = "These limits to a file, for other designs and the command line";
  if (ui.button("save sheet", "Save…", look))
    desk.window.browser.open(FileBrowser::Purpose::SaveTolerances, folder, "tolerances.json");
}

}  // namespace

std::string tolerances_summary(const Desk& desk) {
  const auto limits = static_cast<std::int64_t>(limited_kinds(desk.state.contract().tolerances).size()) - 1;
  return limits > 0 ? format_count(limits, "limit", "limits") : "no limits";
}

void draw_tolerances(Desk& desk) {
  for (const LimitLine& line : kLines) draw_limit_line(desk, line);
  draw_stock(desk);
  desk.ui.gap(4);
  draw_sheet_files(desk);
}

}  // namespace planewright::ui
