// The list of what fails the tolerance sheet: switches for its kinds, and the places.
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <string>
#include <vector>

#include "ui/failure_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

// One switch per kind that fails; a click with ctrl leaves that kind alone on.
void draw_chips(Desk& desk) {
  Ui& ui = desk.ui;
  const FailureList& list = desk.state.failure_list();
  HiddenFailures hidden = list.hidden;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool first = true;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  for (std::size_t k = 0; k < kToleranceKinds; ++k) {
    if (list.count[k] == 0) continue;
    const std::string title = failure_title(static_cast<ToleranceKind>(k));
    if (ui.chip("kind " + std::to_string(k), title + "  " + format_count(list.count[k]), !hidden[k],
                ui.colours().error, right, first)) {
      if (ImGui::GetIO().KeyCtrl) {
        hidden.set();
        hidden.reset(k);
      } else {
        hidden.flip(k);
      }
    }
    ui.tooltip_if_hovered(hidden[k] ? "Click shows them, Ctrl click shows them alone."
                                    : "Click hides them, Ctrl click shows them alone.");
    first = false;
  }
  ImGui::PopStyleVar();
  desk.state.view_options.hidden_failures = hidden;
}

void draw_row(Desk& desk, const FailureList& list, int row, bool current, float height) {
  Ui& ui = desk.ui;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ToleranceFailure& failure = list.failure(row);
  const WorkshopModel& model = *list.from->model;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  ImGui::PushID(row);
  if (ImGui::Selectable("##failure", current, 0, ImVec2(0, height))) desk.state.show_failure(row);
  ui.record_item("failure " + std::to_string(row));
  ImGui::PopID();
  if (ImGui::IsItemHovered()) ui.tooltip(describe(failure, model));
  const ImVec2 max(ImGui::GetItemRectMax().x - ui.px(4), min.y + height);
  draw.AddCircleFilled(ImVec2(min.x + ui.px(10), 0.5f * (min.y + max.y)), ui.px(3.5f), p.error, 16);
  const std::string measure = failure_measure(failure);
  ImFont* font = ui.theme().regular();
  const float room =
      max.x - min.x - ui.px(22 + 10) - font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, measure.c_str()).x;
  draw_text_aligned(draw, font, ImVec2(min.x + ui.px(22), min.y), max, 0.0f, p.ink,
                    elided(font, failure_place(failure, model), room));
  draw_text_aligned(draw, font, min, max, 1.0f, p.ink_soft, measure);
}

}  // namespace

void draw_failures(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  if (!state.workshop()) {
    ui.small_text("Known as soon as there are panels.");
    return;
  }
  if (state.workshop()->verdicts.failures.empty()) {
    ui.wrapped("None: every panel keeps every limit.", ui.colours().good);
    return;
  }
  draw_chips(desk);
  ui.gap(4);
  const FailureList& list = state.failure_list();
  if (list.size() == 0) {
    ui.small_text("All kinds are hidden.");
    return;
  }
  const auto current = state.current_failure();
  const float height = ImGui::GetTextLineHeight() + ui.px(7);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(6), ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::BeginChild("failures",
                    ImVec2(0, std::min(height * static_cast<float>(list.size()) + ui.px(10), ui.px(240))),
                    true);
  if (current != desk.window.listed_failure) {
    desk.window.listed_failure = current;
    if (current) bring_row_into_sight(*current, height);
  }
  ImGuiListClipper clipper;
  clipper.Begin(list.size(), height);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      draw_row(desk, list, row, current == row, height);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  ui.gap(2);
  if (current) {
    ui.wrapped(describe(list.failure(*current), *list.from->model) + ".", ui.colours().ink_soft, true);
  } else {
    ui.wrapped("A click goes there; W goes to the next one.", 0, true);
  }
}

}  // namespace planewright::ui
