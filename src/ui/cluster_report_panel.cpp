// What panels of clusters are worth, in the report: their corners, how far they are from the design, which of
// them are hard to build, and what was repaired.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr std::size_t kRowsShown = 12;

// Label left, two numbers in columns at the right.
void two_columns(Ui& ui, const std::string& label, const std::string& first, const std::string& second,
                 ImFont* font, ImU32 ink) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, row = ImGui::GetTextLineHeight() + ui.px(4);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float middle = 0.72f * width;
  draw_text_aligned(draw, font, at, ImVec2(at.x + width, at.y + row), 0.0f, ink, label);
  draw_text_aligned(draw, font, at, ImVec2(at.x + middle, at.y + row), 1.0f, ink, first);
  draw_text_aligned(draw, font, at, ImVec2(at.x + width, at.y + row), 1.0f, ink, second);
  ImGui::Dummy(ImVec2(width, row - ImGui::GetStyle().ItemSpacing.y + ui.px(2)));
}

void draw_distances(Desk& desk, const TwoSidedDistance& distance) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ui.gap(6);
  two_columns(ui, "Distance, " + desk.state.unit(), "RMS", "most", ui.theme().small(), p.ink_faint);
  const auto line = [&](const char* label, double rms, double most) {
    two_columns(ui, label, format_number(rms), format_number(most), ui.theme().regular(), p.ink);
  };
  line("panels to input", distance.from_first.rms, distance.from_first.max);
  line("input to panels", distance.from_second.rms, distance.from_second.max);
  line("either way", distance.rms(), distance.max());
}

// A row that can be clicked: a panel's name left, what is wrong with it right.
bool draw_row(Desk& desk, const std::string& record, const std::string& name, const std::string& value,
              bool current) {
  Ui& ui = desk.ui;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float height = ImGui::GetTextLineHeight() + ui.px(7);
  ImGui::PushID(record.c_str());
  const bool pressed = ImGui::Selectable("##row", current, 0, ImVec2(0, height));
  ui.record_item(record);
  ImGui::PopID();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x - ui.px(2), min.y + height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_text_aligned(draw, ui.theme().regular(), ImVec2(min.x + ui.px(4), min.y), max, 0.0f, ui.colours().ink,
                    name);
  draw_text_aligned(draw, ui.theme().regular(), min, max, 1.0f, ui.colours().ink_soft, value);
  return pressed;
}

struct BadPanel {
  int panel;
  std::string value;
};

void draw_bad_panels(Desk& desk, const char* record, const char* title, const std::vector<BadPanel>& bad) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  ui.gap(6);
  ui.value_row(title, bad.empty() ? "none" : format_count(static_cast<std::int64_t>(bad.size())),
               bad.empty() ? ui.colours().good : ui.colours().warning);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, 0));
  for (std::size_t i = 0; i < std::min(bad.size(), kRowsShown); ++i) {
    const ElementRef element{ElementKind::Panel, bad[i].panel};
    const std::string name =
        capitalised(element_name(state.document(), state.active_layer(), *state.shown(), element));
    const bool current = state.selected_panel == bad[i].panel;
    if (draw_row(desk, std::string(record) + " " + std::to_string(i), name, bad[i].value, current))
      state.show_element(element);
  }
  ImGui::PopStyleVar();
  if (bad.size() > kRowsShown)
    ui.small_text("and " + format_count(static_cast<std::int64_t>(bad.size() - kRowsShown)) + " more");
}

std::vector<BadPanel> acute_panels(const ClusterReport& report, int panels) {
  std::vector<AcuteCorner> acute = report.acute;
  std::stable_sort(acute.begin(), acute.end(),
                   [](const AcuteCorner& a, const AcuteCorner& b) { return a.degrees < b.degrees; });
  std::vector<BadPanel> bad;
  for (const AcuteCorner& corner : acute) {
    if (corner.panel >= panels) continue;
    char degrees[32];
    std::snprintf(degrees, sizeof degrees, "%.1f°", corner.degrees);
    bad.push_back({corner.panel, degrees});
  }
  return bad;
}

std::vector<BadPanel> crossed_panels(const AppState& state) {
  std::vector<BadPanel> bad;
  for (const Finding& finding : state.findings()->diagnosis.findings) {
    if (finding.kind == FindingKind::SelfCrossing && finding.element.kind == ElementKind::Panel)
      bad.push_back({finding.element.index, severity_word(finding.severity)});
  }
  return bad;
}

void draw_repairs(Desk& desk, const std::vector<RegionRepair>& repairs) {
  Ui& ui = desk.ui;
  ui.gap(6);
  ui.value_row("Repairs",
               repairs.empty() ? "none needed" : format_count(static_cast<std::int64_t>(repairs.size())));
  for (std::size_t i = 0; i < std::min(repairs.size(), kRowsShown); ++i) {
    ui.wrapped(describe(repairs[i]) + ".", ui.colours().ink_soft, true);
    ui.record_item("repair " + std::to_string(i));
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsItemClicked()) desk.state.show_region(repairs[i].other);
  }
  if (repairs.size() > kRowsShown)
    ui.small_text("and " + format_count(static_cast<std::int64_t>(repairs.size() - kRowsShown)) + " more");
}

}  // namespace

void draw_cluster_report(Desk& desk) {
  Ui& ui = desk.ui;
  const AppState& state = desk.state;
  const auto report = state.cluster_report();
  if (!report || !state.shown()) {
    ui.small_text(state.solving() || state.clustering() ? "Known when the solve ends." : "Measuring…");
    return;
  }
  const int panels = state.shown()->complex().plane_count();
  ui.value_row("Panels", format_count(panels), 0, "Regions after the repairs");
  if (report->clusters != panels) ui.value_row("Regions before repairs", format_count(report->clusters));
  ui.value_row(
      "L2,1 error", format_number(report->l21), 0,
      "The integral of |n − N|² over the input, as a share of its area: n its normal, N its panel's");
  int corners = 0;
  for (const auto& [valence, count] : report->corners_by_valence) corners += count;
  ui.value_row("Corners", format_count(corners));
  for (const auto& [valence, count] : report->corners_by_valence) {
    ui.value_row("    of " + format_count(valence, "panel", "panels"), format_count(count), 0,
                 "Corners where so many panels meet; fewer than three only on the border");
  }
  if (report->euler_before != report->euler_after) {
    ui.value_row("Euler characteristic",
                 std::to_string(report->euler_before) + " → " + std::to_string(report->euler_after),
                 ui.colours().warning, "Of the input, and of the panels");
  }
  if (report->panels_to_mesh) draw_distances(desk, *report->panels_to_mesh);
  draw_bad_panels(desk, "acute", "Panels with acute corners", acute_panels(*report, panels));
  if (state.findings()) draw_bad_panels(desk, "crossed", "Self-crossing panels", crossed_panels(state));
  draw_repairs(desk, report->repairs);
}

}  // namespace planewright::ui
