// The workshop in the right panel: how many panels can be built, to which terms and limits, what fails, and
// the passport of the panel that is pointed at.
#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/workshop/tolerance_share.h"
#include "ui/failure_text.h"
#include "ui/format.h"
#include "ui/panels.h"
#include "ui/schedule.h"

namespace planewright::ui {
namespace {

// "346 of 360 panels pass", over a bar of the two.
void draw_verdict(Desk& desk) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  const auto workshop = desk.state.workshop();
  if (const auto& error = desk.state.workshop_error()) {
    ui.wrapped(capitalised(error->what) + (error->where.empty() ? "." : " (" + error->where + ")."), p.error);
    if (!error->remedy.empty()) ui.wrapped(error->remedy + ".", p.ink_soft, true);
    return;
  }
  if (!workshop) {
    ui.small_text(desk.state.shown() ? "Measuring the panels …" : "No panels yet.");
    return;
  }
  const ToleranceVerdicts& verdicts = workshop->verdicts;
  const auto all = static_cast<std::int64_t>(verdicts.pass.size());
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight() + ui.px(4);
  const float bar = ui.px(6);
  ImGui::Dummy(ImVec2(width, line + bar));
  ui.record("verdict", at, ImVec2(at.x + width, at.y + line + bar));
  const bool fine = verdicts.failed == 0;
  draw_text_aligned(draw, ui.theme().bold(), at, ImVec2(at.x + width, at.y + line), 0.0f,
                    fine ? p.good : p.ink,
                    fine ? "All " + format_count(all, "panel passes", "panels pass")
                         : format_count(verdicts.passed) + " of " + format_count(all) + " panels pass");
  if (!fine)
    draw_text_aligned(draw, ui.theme().bold(), at, ImVec2(at.x + width, at.y + line), 1.0f, p.error,
                      format_count(verdicts.failed, "fails", "fail"));
  const ImVec2 min(at.x, at.y + line), max(at.x + width, at.y + line + bar);
  const float kept = all > 0 ? static_cast<float>(verdicts.passed) / static_cast<float>(all) : 1.0f;
  draw.AddRectFilled(min, max, fine ? p.good : p.error, ui.px(3));
  if (!fine && verdicts.passed > 0)
    draw.AddRectFilled(min, ImVec2(min.x + std::min(kept * width, width - ui.px(4)), max.y), p.good, ui.px(3),
                       ImDrawFlags_RoundCornersLeft);
  ui.gap(6);
}

// What the colours are about, and whether names stand on the panels.
void draw_sight(Desk& desk) {
  Ui& ui = desk.ui;
  ViewOptions& view = desk.state.view_options;
  const std::vector<ToleranceKind> kinds = limited_kinds(desk.state.contract().tolerances);
  std::vector<std::string> items = {"off", "all limits"};
  int current = view.colours != ColourMap::Tolerances ? 0 : 1;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    items.push_back(failure_title(kinds[k]));
    if (current > 0 && view.tolerance == kinds[k]) current = static_cast<int>(k) + 2;
  }
  if (ui.choice(
          "colour by", "Colour by", items, current,
          "Colours break at the limit: cool keeps it, amber to red fails. Dark is close to the limit.")) {
    view.colours = current > 0 ? ColourMap::Tolerances : ColourMap::None;
    view.tolerance.reset();
    if (current > 1) view.tolerance = kinds[static_cast<std::size_t>(current - 2)];
  }
  ui.checkbox("names", "Names on the panels", view.names,
              "Of panels that are in sight and large enough  (Y)");
}

void draw_sides(Desk& desk, const PreparedWorkshop& workshop, const PanelPassport& passport) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float width = ImGui::GetContentRegionAvail().x, row = ImGui::GetTextLineHeight() + ui.px(3);
  const auto line = [&](const std::string& side, const std::string& to, const std::string& length,
                        const std::string& corner, const std::string& fold, const std::string& bevel,
                        ImU32 ink, ImFont* font) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto cell = [&](float from, float until, float align, const std::string& text, ImU32 colour) {
      draw_text_aligned(draw, font, ImVec2(at.x + from * width, at.y),
                        ImVec2(at.x + until * width, at.y + row), align, colour, text);
    };
    cell(0.0f, 0.07f, 0.0f, side, p.ink_faint);
    cell(0.09f, 0.34f, 0.0f, elided(font, to, 0.25f * width), ink);
    cell(0.30f, 0.53f, 1.0f, length, ink);
    cell(0.53f, 0.70f, 1.0f, corner, ink);
    cell(0.70f, 0.86f, 1.0f, fold, ink);
    cell(0.86f, 1.0f, 1.0f, bevel, ink);
    ImGui::Dummy(ImVec2(0, row - ImGui::GetStyle().ItemSpacing.y + ui.px(2)));
  };
  line("", "to", "mm", "corner °", "fold °", "bevel", p.ink_faint, ui.theme().small());
  for (std::size_t k = 0; k < passport.sides.size(); ++k) {
    const SidePassport& side = passport.sides[k];
    const bool border = side.neighbour < 0;
    line(std::to_string(k + 1),
         border ? "border" : workshop.model->names[static_cast<std::size_t>(side.neighbour)],
         format_number(side.length), format_number(side.interior),
         border ? "–" : format_number(side.dihedral), border ? "–" : format_number(side.bevel),
         border ? p.ink_faint : p.ink, ui.theme().regular());
  }
}

void draw_passport(Desk& desk) {
  Ui& ui = desk.ui;
  const auto workshop = desk.state.workshop();
  const auto panel = desk.state.selected_panel;
  if (!workshop || !panel || *panel >= workshop->model->panel_count()) {
    ui.small_text(workshop ? "Click a panel." : "No panels yet.");
    return;
  }
  const auto index = static_cast<std::size_t>(*panel);
  const PanelPassport& passport = workshop->passports[index];
  const bool pass = workshop->verdicts.pass[index];
  ui.value_row(workshop->model->names[index], pass ? "passes" : "fails",
               pass ? ui.colours().good : ui.colours().error);
  for (const ToleranceFailure& failure : workshop->verdicts.failures) {
    if (failure.panel == *panel)
      ui.wrapped(describe(failure, *workshop->model) + ".", ui.colours().error, true);
  }
  ui.value_row("Area", format_with_unit(1e-6 * passport.area, "m²"));
  ui.value_row("Perimeter", format_with_unit(passport.perimeter, "mm"));
  ui.value_row("Smallest rectangle",
               format_number(passport.width) + " × " + format_with_unit(passport.height, "mm"));
  ui.value_row("Planarity", format_with_unit(passport.planarity, "mm"));
  if (passport.distance) ui.value_row("Distance to reference", format_with_unit(*passport.distance, "mm"));
  if (passport.weight) ui.value_row("Weight", format_with_unit(*passport.weight, "kg"));
  if (!workshop->class_of_panel.empty() && workshop->class_of_panel[index] >= 0) {
    const int of_class = workshop->class_of_panel[index];
    const auto members =
        static_cast<std::int64_t>(workshop->classes[static_cast<std::size_t>(of_class)].members.size());
    ui.value_row("Class",
                 class_label(of_class) +
                     (members > 1 ? ", with " + format_count(members - 1, "other", "others") : ", alone"));
  }
  ui.gap(4);
  draw_sides(desk, *workshop, passport);
}

}  // namespace

void draw_workshop(Desk& desk) {
  Ui& ui = desk.ui;
  if (desk.state.document().empty()) {
    ui.small_text("No design yet.");
    return;
  }
  ui.gap(2);
  draw_verdict(desk);
  draw_sight(desk);
  if (ui.section("terms", "Terms")) draw_contract(desk);
  const auto workshop = desk.state.workshop();
  const auto failures = workshop ? static_cast<std::int64_t>(workshop->verdicts.failures.size()) : 0;
  if (ui.section("failures", "Failures", true, failures > 0 ? format_count(failures) : "",
                 ui.colours().error))
    draw_failures(desk);
  if (ui.section("tolerances", "Tolerances", true, tolerances_summary(desk))) draw_tolerances(desk);
  if (ui.section("passport", "Passport")) draw_passport(desk);
}

}  // namespace planewright::ui
