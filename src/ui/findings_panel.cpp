// The right panel: what needs the designer's eye (ill-determined points), the energies, and what is selected.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/problem/energies/energy_catalogue.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr int kListed = 300;

void draw_ill_determined(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const auto& shown = state.shown();
  if (!shown) {
    ui.small_text("Known after the first step of a solve.");
    return;
  }
  const auto& points = shown->ill_determined;
  if (points.empty()) {
    ui.text("None: every corner is well held.", ui.colours().good);
    return;
  }
  ui.wrapped(
      "The planes through these corners are nearly parallel. Fairing, or flipping an edge there, helps.", 0,
      true);
  ui.gap(2);

  const float row = ImGui::GetTextLineHeight() + ui.px(7);
  const int listed = std::min(static_cast<int>(points.size()), kListed);
  const float most = std::max(ui.px(120), ImGui::GetContentRegionAvail().y * 0.45f);
  const float header = ui.theme().small()->FontSize + ui.px(6);
  const ImVec2 head_min = ImGui::GetCursorScreenPos();
  const ImVec2 head_max(head_min.x + ImGui::GetContentRegionAvail().x, head_min.y + header);
  ImDrawList& head = *ImGui::GetWindowDrawList();
  draw_text_aligned(head, ui.theme().small(), ImVec2(head_min.x + ui.px(28), head_min.y), head_max, 0.0f,
                    ui.colours().ink_faint, "corner");
  draw_text_aligned(head, ui.theme().small(), head_min, ImVec2(head_max.x - ui.px(16), head_max.y), 1.0f,
                    ui.colours().ink_faint, "singular value of N");
  ImGui::Dummy(ImVec2(0, header - ImGui::GetStyle().ItemSpacing.y));

  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(6), ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::BeginChild("ill", ImVec2(0, std::min(row * static_cast<float>(listed) + ui.px(10), most)), true);
  ImGuiListClipper clipper;
  clipper.Begin(listed, row);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const IllDetermined& finding = points[static_cast<std::size_t>(i)];
      ImGui::PushID(i);
      const ImVec2 min = ImGui::GetCursorScreenPos();
      const bool selected = state.selected_point == finding.point;
      if (ImGui::Selectable("##finding", selected, 0, ImVec2(0, row)))
        show_finding(state, desk.window, finding.point);
      ui.record_item("finding " + std::to_string(i));
      const ImVec2 max = ImGui::GetItemRectMax();
      ImDrawList& draw = *ImGui::GetWindowDrawList();
      const bool bad = finding.singular_value < 0.01;
      draw.AddCircleFilled(ImVec2(min.x + ui.px(9), 0.5f * (min.y + max.y)), ui.px(4),
                           bad ? ui.colours().error : ui.colours().warning, 16);
      draw_text_aligned(draw, ui.theme().regular(), ImVec2(min.x + ui.px(22), min.y), max, 0.0f,
                        ui.colours().ink, format_count(finding.point));
      draw_text_aligned(draw, ui.theme().regular(), min, ImVec2(max.x - ui.px(4), max.y), 1.0f,
                        ui.colours().ink, format_number(finding.singular_value));
      ImGui::PopID();
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  if (listed < static_cast<int>(points.size())) {
    ui.small_text("and " + format_count(static_cast<int>(points.size()) - listed) + " milder ones");
  }
}

}  // namespace

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
  const std::size_t count = desk.state.shown() ? desk.state.shown()->ill_determined.size() : 0;
  const std::array<std::string, 2> tabs = {"Findings", "Report"};
  ui.segmented("tab", tabs, desk.window.right_tab);
  if (desk.window.right_tab == 0) {
    std::string title = "Ill-determined corners";
    if (count > 0) title += "  " + format_count(static_cast<std::int64_t>(count));
    if (ui.section("ill", title)) draw_ill_determined(desk);
    if (ui.section("selection", "Selection")) draw_selection(desk);
    const Demands& demands = desk.state.document().settings().demands;
    const auto pins = static_cast<std::int64_t>(demands.pins.size() + demands.plane_pins.size());
    if (ui.section("pins", "Pins", true, pins > 0 ? format_count(pins) : "")) draw_pins(desk);
    if (ui.section("energies", "Energies")) draw_energy_table(desk);
  } else {
    draw_report(desk);
  }
  draw_rim(ui, place, Side::Left);
  end_part();
}

}  // namespace planewright::ui
