// The right panel: findings, the energies, and what is selected.
#include <imgui_internal.h>

#include <array>
#include <cstdio>
#include <string>

#include "core/problem/energies/energy_catalogue.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
void draw_energy_table(Desk& desk) {
  Ui& ui = desk.ui;
  const std::vector<SolveReport::Energy>& energies = desk.state.energies();
  if (energies.empty()) {
    ui.small_text("Known after the first step of a solve.");
    return;
  }
  double total = 0;
  for (const SolveReport::Energy& energy : energies) total += energy.value;
  const float width = ImGui::GetContentRegionAvail().x;
  const float columns[] = {0, 0.52f * width, 0.78f * width, width};
  const float row = ImGui::GetTextLineHeight() + ui.px(4);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto line = [&](const std::string& label, const std::string& weight, const std::string& value,
                        const std::string& share, ImFont* font, ImU32 ink) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const auto cell = [&](float from, float to, float align, const std::string& text) {
      draw_text_aligned(draw, font, ImVec2(at.x + from, at.y), ImVec2(at.x + to, at.y + row), align, ink,
                        text);
    };
    cell(columns[0], columns[1], 0.0f, label);
    cell(columns[0], columns[1], 1.0f, weight);
    cell(columns[1], columns[2], 1.0f, value);
    cell(columns[2], columns[3], 1.0f, share);
    ImGui::Dummy(ImVec2(0, row - ImGui::GetStyle().ItemSpacing.y + ui.px(2)));
  };
  line("energy", "weight", "value", "share", ui.theme().small(), ui.colours().ink_faint);
  for (const SolveReport::Energy& energy : energies) {
    std::string label = energy.name;
    for (const EnergyInfo& known : energy_catalogue()) {
      if (known.name == energy.name) label = known.label;
    }
    char share[32] = "–";
    if (total > 0) std::snprintf(share, sizeof share, "%.0f %%", 100 * energy.value / total);
    line(label, format_number(energy.weight), format_number(energy.value), share, ui.theme().regular(),
         energy.weight > 0 ? ui.colours().ink : ui.colours().ink_faint);
  }
  ui.separator();
  line("Objective", "", format_number(total), "", ui.theme().bold(), ui.colours().ink);
}

void draw_findings_panel(Desk& desk, const Rect& place) {
  Ui& ui = desk.ui;
  if (!begin_part("##findings", place, ImVec2(ui.px(14), ui.px(10)))) return;
  const Ui::Scope scope(ui, "Findings");
  const std::array<std::string, 3> tabs = {"Findings", "Report", "Workshop"};
  ui.segmented("tab", tabs, desk.window.right_tab);
  desk.state.pointed_edit.reset();
  desk.state.pointed_all = false;
  if (desk.window.right_tab == 0) {
    // What to click comes before why.
    if (ui.section("suggestions", "Suggestions", true, suggestions_summary(desk))) draw_suggestions(desk);
    const auto findings = desk.state.findings();
    const auto count = findings ? findings->diagnosis.findings.size() : 0;
    const std::string summary = count > 0 ? format_count(static_cast<std::int64_t>(count)) : "";
    if (ui.section("findings", "Findings", true, summary)) draw_finding_list(desk);
    if (ui.section("limits", "Limits of findings", false, limits_summary(desk))) draw_limits(desk);
    if (ui.section("selection", "Selection")) draw_selection(desk);
    const Demands& demands = desk.state.document().settings().demands;
    const auto pins = static_cast<std::int64_t>(demands.pins.size() + demands.plane_pins.size());
    if (ui.section("pins", "Pins", true, pins > 0 ? format_count(pins) : "")) draw_pins(desk);
    if (ui.section("energies", "Energies")) draw_energy_table(desk);
  } else if (desk.window.right_tab == 1) {
    draw_report(desk);
  } else {
    draw_workshop(desk);
  }
  draw_rim(ui, place, Side::Left);
  end_part();
}

}  // namespace planewright::ui
