// The suggestions in the right panel: edits of the mesh, best first, what each gains and of what that is
// made, and the buttons that apply them.
#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/format.h"
#include "ui/panels.h"
#include "ui/suggestion_text.h"

namespace planewright::ui {
namespace {

constexpr float kRows = 5.5f;       // that are in sight; half a row says that there are more
constexpr float kNumberWidth = 46;  // pixels at scale 1
constexpr float kBarWidth = 34;

float text_width(ImFont* font, const std::string& text) {
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.c_str()).x;
}

// How far the rating is, between the list and the buttons, where there is room for it at any time.
void draw_progress(const Ui& ui, const Advice& advice, ImVec2 min, ImVec2 max) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float part = static_cast<float>(advice.tried) / static_cast<float>(std::max(advice.candidates, 1));
  const float top = max.y + ui.px(2), bottom = top + ui.px(3);
  draw.AddRectFilled(ImVec2(min.x, top), ImVec2(max.x, bottom), ui.colours().hovered, bottom - top);
  draw.AddRectFilled(ImVec2(min.x, top), ImVec2(min.x + part * (max.x - min.x), bottom), ui.colours().accent,
                     bottom - top);
}

// Those that the mode mostly has, so that nothing moves when the first of a kind comes.
bool is_offered(const AppState& state, EditKind kind) {
  if (state.document().empty() || state.document().settings().mode == ComplexKind::Dual)
    return kind == EditKind::Flip || kind == EditKind::Join;
  return kind == EditKind::Collapse || kind == EditKind::MoveVertex;
}

void draw_kinds(Desk& desk, const SuggestionList& list) {
  Ui& ui = desk.ui;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  HiddenEdits hidden = list.hidden;
  bool first = true;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(4), ui.px(4)));
  for (std::size_t k = 0; k < list.count.size(); ++k) {
    if (list.count[k] == 0 && !is_offered(desk.state, static_cast<EditKind>(k))) continue;
    const std::string word = kind_word(static_cast<EditKind>(k));
    const bool on = !hidden[k];
    const ImU32 dot = list.count[k] > 0 ? ui.colours().accent : ui.colours().ink_faint;
    if (ui.chip("edits " + word, word + "  " + format_count(list.count[k]), on, dot, right, first)) {
      if (ImGui::GetIO().KeyCtrl) {
        hidden.set();
        hidden.reset(k);
      } else {
        hidden.flip(k);
      }
    }
    ui.tooltip_if_hovered(capitalised(word) + (on ? ": click leaves them out, " : ": click lists them, ") +
                          "Ctrl click lists them alone.");
    first = false;
  }
  ImGui::PopStyleVar();
  ui.gap(2);
  desk.state.view_options.hidden_edits = hidden;
}

void draw_row(Desk& desk, const SuggestionList& list, int row, std::optional<int> current, bool fits,
              float height) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const Palette& p = ui.colours();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Suggestion& suggestion = list.at(row);
  const MeshEdit edit = suggestion.candidate.edit;
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float list_left = ImGui::GetWindowPos().x;
  ImGui::PushID(row);
  const bool pressed = ImGui::Selectable("##suggestion", current == row,
                                         ImGuiSelectableFlags_AllowDoubleClick, ImVec2(0, height));
  ImGui::PopID();
  ui.record_item("suggestion " + std::to_string(row));
  const ImVec2 max(ImGui::GetItemRectMax().x - ui.px(4), min.y + height);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered) {
    state.pointed_edit = edit;
    // Beside the panel: the rows below stay in sight.
    ImGui::SetNextWindowPos(ImVec2(list_left - ui.px(14), min.y), ImGuiCond_Always, ImVec2(1, 0));
    explain_suggestion(ui, state, suggestion);
  }
  if (pressed) {
    // The list may have moved under the mouse between the two clicks: the second is for what the first chose.
    if (!ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      desk.window.suggestion_wanted = edit;
    } else if (current == row) {
      desk.actions.request(Action::ApplySuggestion);
    }
  }

  const float alpha = fits ? 1.0f : 0.55f;
  const double best = std::max(list.from->ranked.front().gain(), 1e-12);
  const double gain = suggestion.gain();
  ImFont *font = ui.theme().regular(), *small = ui.theme().small();
  const float number_left = max.x - ui.px(kNumberWidth), bar_left = number_left - ui.px(kBarWidth);
  const std::string name = edit_label(state, edit);
  const float name_right = min.x + ui.px(6) + text_width(font, name);
  draw_text_aligned(draw, font, ImVec2(min.x + ui.px(6), min.y), max, 0.0f, with_alpha(p.ink, alpha),
                    elided(font, name, bar_left - min.x - ui.px(12)));
  const std::string panels = panels_at(state, suggestion.candidate);
  const float room = bar_left - name_right - ui.px(18);
  if (!panels.empty() && room > text_width(small, panels)) {
    draw_text_aligned(draw, small, ImVec2(name_right + ui.px(9), min.y), max, 0.0f,
                      with_alpha(p.ink_faint, alpha), panels);
  }
  const float y = std::round(0.5f * (min.y + max.y)), half = ui.px(2.5f);
  const float length = std::max(static_cast<float>(gain / best) * ui.px(kBarWidth), ui.px(2));
  draw.AddRectFilled(ImVec2(bar_left, y - half), ImVec2(bar_left + ui.px(kBarWidth), y + half), p.hovered,
                     half);
  draw.AddRectFilled(ImVec2(bar_left, y - half), ImVec2(bar_left + length, y + half),
                     with_alpha(suggestion.met ? p.accent : p.ink_faint, alpha), half);
  draw_text_aligned(draw, font, min, max, 1.0f, with_alpha(suggestion.met ? p.ink : p.ink_faint, alpha),
                    gain_text(gain));
}

// Always of the same height: what stands below must not move while suggestions come and go.
void draw_rows(Desk& desk, const SuggestionList& list, const std::string& why) {
  Ui& ui = desk.ui;
  const bool fits = desk.state.advice_fits();
  const auto current = desk.state.current_suggestion();
  const float height = ImGui::GetTextLineHeight() + ui.px(7);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(6), ui.px(4)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::BeginChild("suggestions", ImVec2(0, height * kRows + ui.px(10)), true);
  if (list.size() == 0) {
    ui.gap(4);
    ui.wrapped(!why.empty()                              ? why
               : list.from && !list.from->ranked.empty() ? "All kinds are left out."
               : list.from && list.from->listed          ? "Rating edits near findings…"
                                                         : "Looking for edits…",
               ui.colours().ink_soft, true);
  }
  // The current one comes into sight when it becomes that.
  if (current != desk.window.listed_suggestion) {
    desk.window.listed_suggestion = current;
    if (current) bring_row_into_sight(*current, height);
  }
  ImGuiListClipper clipper;
  clipper.Begin(list.size(), height);
  while (clipper.Step()) {
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row)
      draw_row(desk, list, row, current, fits, height);
  }
  ImGui::EndChild();
  if (desk.state.rating()) draw_progress(ui, *list.from, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

void draw_buttons(Desk& desk, const SuggestionList& list) {
  Ui& ui = desk.ui;
  ui.gap(2);
  ButtonLook one;
  one.enabled = desk.actions.enabled(Action::ApplySuggestion);
  one.width = ui.px(72);
  one.tooltip = one.enabled ? desk.actions.label(Action::ApplySuggestion) + ", and solve again  (Enter)"
                            : "Choose a suggestion first: a click, or S";
  if (ui.button("apply", "Apply", one)) desk.actions.request(Action::ApplySuggestion);
  if (one.enabled && ImGui::IsItemHovered()) {
    if (const Suggestion* at_hand = desk.state.suggestion_at_hand())
      desk.state.pointed_edit = at_hand->candidate.edit;
  }
  ImGui::SameLine(0, ui.px(6));
  const auto count = static_cast<std::int64_t>(list.together.size());
  ButtonLook all;
  all.enabled = desk.actions.enabled(Action::ApplyAllSuggestions);
  all.width = -1;
  all.primary = all.enabled;
  double gain = 0.0;
  for (const int i : list.together) gain += list.from->ranked[static_cast<std::size_t>(i)].gain();
  all.tooltip = count == 0 ? "Nothing to apply"
                           : format_count(count, "edit", "edits") + " as one step, about " + gain_text(gain) +
                                 " together: the best of those that lie so far apart that none spoils what "
                                 "another gains. More may follow once that is solved.  (Ctrl Enter)";
  if (ui.button("apply all",
                count > 0 ? "Apply all that gain  (" + format_count(count) + ")" : "Apply all that gain",
                all))
    desk.actions.request(Action::ApplyAllSuggestions);
  if (all.enabled && ImGui::IsItemHovered()) desk.state.pointed_all = true;
}

}  // namespace

void explain_suggestion(Ui& ui, const AppState& state, const Suggestion& suggestion) {
  const Palette& p = ui.colours();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(7)));
  ImGui::BeginTooltip();
  ui.text(edit_label(state, suggestion.candidate.edit), p.accent);
  ImGui::SameLine();
  ui.text("gains about " + gain_text(suggestion.gain()));
  if (const std::string panels = panels_at(state, suggestion.candidate); !panels.empty())
    ui.small_text("At " + panels);
  draw_gain_parts(ui, suggestion);
  if (!suggestion.met)
    ui.small_text("Solved alone, this place did not meet all demands: a guess.", p.warning);
  ui.small_text("Click: go there   Double click, Enter: apply", p.ink_faint);
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void draw_gain_parts(Ui& ui, const Suggestion& suggestion) {
  const Palette& p = ui.colours();
  ImFont* small = ui.theme().small();
  const float row = small->FontSize + ui.px(4);
  const float change_right = ui.px(214), width = ui.px(268);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ui.gap(2);
  for (const GainPart& part : gain_parts(suggestion)) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float bottom = at.y + row;
    draw_text_aligned(draw, small, at, ImVec2(at.x + width, bottom), 0.0f, p.ink_soft, part.what);
    draw_text_aligned(draw, small, at, ImVec2(at.x + change_right, bottom), 1.0f, p.ink_faint, part.change);
    draw_text_aligned(draw, small, at, ImVec2(at.x + width, bottom), 1.0f, part.gain < 0 ? p.warning : p.ink,
                      part.gain > 0 ? std::string("+").append(gain_text(part.gain)) : gain_text(part.gain));
    ImGui::Dummy(ImVec2(width, row - ImGui::GetStyle().ItemSpacing.y));
  }
  ui.gap(2);
  ui.small_text("In mean panel edges squared; about, until it is solved.", p.ink_faint);
}

std::string suggestions_summary(const Desk& desk) {
  const auto advice = desk.state.advice();
  if (!advice) return "";
  if (desk.state.rating() && advice->listed)
    return "rated " + format_count(advice->tried) + " of " + format_count(advice->candidates);
  if (!desk.state.advice_fits()) return "of the result before";
  return advice->ranked.empty() ? "" : format_count(static_cast<std::int64_t>(advice->ranked.size()));
}

void draw_suggestions(Desk& desk) {
  AppState& state = desk.state;
  draw_kinds(desk, state.suggestion_list());
  const SuggestionList& list = state.suggestion_list();
  draw_rows(desk, list, why_no_suggestions(state));
  draw_buttons(desk, list);
  if (const auto wanted = std::exchange(desk.window.suggestion_wanted, std::nullopt)) {
    if (const auto row = list.row_of(*wanted)) state.show_suggestion(*row);
  }
}

}  // namespace planewright::ui
