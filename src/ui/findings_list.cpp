// The list of findings in the right panel: which kinds there are, switches for them, the places, and why the
// current one is bad.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <optional>
#include <string>
#include <vector>

#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr float kDot = 4;  // radius at scale 1

// One switch per kind that there is; a click with ctrl leaves that kind alone on.
void draw_chips(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const FindingList& list = state.finding_list();
  std::array<double, kFindingKinds> worst{};
  for (const Finding& finding : list.from->diagnosis.findings) {
    double& of = worst[static_cast<std::size_t>(finding.kind)];
    of = std::max(of, finding.severity);
  }
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  HiddenFindings hidden = list.hidden;
  bool first = true;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  for (const FindingKind kind : all_finding_kinds()) {
    const auto k = static_cast<std::size_t>(kind);
    if (list.count[k] == 0) continue;
    std::string label = info(kind).name;
    std::replace(label.begin(), label.end(), '-', ' ');
    label += "  " + format_count(list.count[k]);
    const bool on = !hidden[k];
    if (ui.chip(std::string("kind ") + info(kind).name, label, on, severity_colour(ui, worst[k]), right,
                first)) {
      if (ImGui::GetIO().KeyCtrl) {
        hidden.set();
        hidden.reset(k);
      } else {
        hidden.flip(k);
      }
    }
    ui.tooltip_if_hovered(kind_title(kind) + (on ? ": click hides them, " : ": click shows them, ") +
                          "Ctrl click shows them alone.");
    first = false;
  }
  ImGui::PopStyleVar();
  state.view_options.hidden_findings = hidden;
}

// A line of the list: the title of a kind (row < 0), or a finding.
struct Line {
  FindingKind kind;
  int row;
};

std::vector<Line> lines_of(const FindingList& list) {
  std::vector<Line> lines;
  for (int row = 0; row < list.size(); ++row) {
    const FindingKind kind = list.finding(row).kind;
    if (lines.empty() || lines.back().kind != kind) lines.push_back({kind, -1});
    lines.push_back({kind, row});
  }
  return lines;
}

void draw_line(Desk& desk, const FindingList& list, const Line& line, std::optional<int> current,
               float height) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float right = min.x + ImGui::GetContentRegionAvail().x;
  if (line.row < 0) {
    const int count = list.count[static_cast<std::size_t>(line.kind)];
    const ImVec2 max(right - ui.px(4), min.y + height);
    ImGui::Dummy(ImVec2(1, height));
    draw_text_aligned(draw, ui.theme().small(), ImVec2(min.x + ui.px(4), min.y), max, 0.0f, p.ink_soft,
                      kind_title(line.kind));
    draw_text_aligned(draw, ui.theme().small(), min, max, 1.0f, p.ink_faint, format_count(count));
    return;
  }
  AppState& state = desk.state;
  const Finding& finding = list.finding(line.row);
  const PreparedView& shown = *state.shown();
  ImGui::PushID(line.row);
  if (ImGui::Selectable("##finding", current == line.row, 0, ImVec2(0, height))) {
    state.show_finding(line.row);
  }
  ui.record_item("finding " + std::to_string(line.row));
  ImGui::PopID();
  const ImVec2 max(ImGui::GetItemRectMax().x - ui.px(4), min.y + height);
  if (ImGui::IsItemHovered()) {
    ui.tooltip(capitalised(finding.cause) + ".\n" + capitalised(severity_word(finding.severity)) + ": " +
               limit_text(finding) + ".");
  }
  draw.AddCircleFilled(ImVec2(min.x + ui.px(10), 0.5f * (min.y + max.y)), ui.px(kDot),
                       severity_colour(ui, finding.severity), 16);
  ImFont* font = ui.theme().regular();
  const std::string measure =
      measure_text(finding.measure, finding.unit, shown.complex().mean_edge, desk.state.unit());
  const float room =
      max.x - min.x - ui.px(22 + 10) - font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, measure.c_str()).x;
  draw_text_aligned(draw, font, ImVec2(min.x + ui.px(22), min.y), max, 0.0f, p.ink,
                    elided(font, place_name(state.document(), state.active_layer(), shown, finding), room));
  draw_text_aligned(draw, font, min, max, 1.0f, p.ink_soft, measure);
}

// What the current finding is, and what can be done.
void draw_reason(Desk& desk, const FindingList& list, std::optional<int> current) {
  Ui& ui = desk.ui;
  const AppState& state = desk.state;
  if (!current) {
    const bool triangles = state.shown()->complex().kind == ComplexKind::Dual;
    const std::string edits = triangles ? "A click on a thick amber edge flips it."
                                        : "A right click on a thick amber edge offers edits.";
    ui.wrapped("N goes to the next one. " +
                   (list.too_many_flagged() ? "Its edges are marked then. " + edits : edits),
               0, true);
    return;
  }
  const Finding& finding = list.finding(*current);
  ui.wrapped(capitalised(kind_name(finding.kind)) + ", " + severity_word(finding.severity) + ": " +
                 finding.cause + ".",
             ui.colours().ink_soft, true);
  ui.wrapped(limit_text(finding), ui.colours().ink_faint, true);
}

}  // namespace

ImU32 severity_colour(const Ui& ui, double severity) {
  const Palette& p = ui.colours();
  return severity >= kNotToBeBuilt  ? p.error
         : severity >= kHardToBuild ? p.warning
                                    : with_alpha(p.warning, 0.5f);
}

void draw_finding_list(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  if (const std::string why = why_no_findings(findings_standing(state), desk.state.unit()); !why.empty()) {
    const bool judged = state.findings() != nullptr;
    ui.wrapped(why, judged && !state.solving() ? ui.colours().warning : ui.colours().ink_soft);
    return;
  }
  if (state.finding_list().from->diagnosis.findings.empty()) {
    ui.wrapped("None: nothing crosses, folds or is badly held.", ui.colours().good);
    return;
  }
  draw_chips(desk);
  ui.gap(4);
  const FindingList& list = state.finding_list();
  if (list.size() == 0) {
    ui.small_text("All kinds are hidden.");
    return;
  }
  const std::vector<Line> lines = lines_of(list);
  const auto current = state.current_finding();
  const float height = ImGui::GetTextLineHeight() + ui.px(7);
  const float most = std::max(ui.px(150), ImGui::GetContentRegionAvail().y * 0.5f);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(6), ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::BeginChild("list", ImVec2(0, std::min(height * static_cast<float>(lines.size()) + ui.px(10), most)),
                    true);
  // The current one comes into sight when it becomes that.
  if (current != desk.window.listed_finding) {
    desk.window.listed_finding = current;
    const auto at = std::find_if(lines.begin(), lines.end(),
                                 [&](const Line& line) { return current && line.row == *current; });
    if (at != lines.end()) bring_row_into_sight(static_cast<int>(at - lines.begin()), height);
  }
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(lines.size()), height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      draw_line(desk, list, lines[static_cast<std::size_t>(i)], current, height);
    }
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  ui.gap(2);
  draw_reason(desk, state.finding_list(), state.current_finding());
}

}  // namespace planewright::ui
