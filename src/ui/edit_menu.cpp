// Edits of the mesh in menus: of what is selected or under the mouse, each with the reason where it is
// refused; and the steps that led here.
#include <imgui_internal.h>

#include <string>
#include <vector>

#include "ui/edit_choices.h"
#include "ui/panels.h"
#include "ui/suggestion_text.h"

namespace planewright::ui {
namespace {

constexpr const char* kContextMenu = "##edits of the mesh";

}  // namespace

void draw_edit_choices(Desk& desk, const EditTarget& target) {
  const SuggestionList& rated = desk.state.suggestion_list();
  for (const EditChoice& choice : edit_choices(desk.state.document(), target)) {
    const bool possible = choice.edit.has_value();
    std::string gain;
    if (const auto row = possible ? rated.row_of(*choice.edit) : std::nullopt)
      gain = "gains about " + gain_text(rated.at(*row).gain());
    const bool chosen = ImGui::MenuItem(choice.label.c_str(), gain.c_str(), false, possible);
    desk.ui.record_item(choice.name, possible);
    if (possible && ImGui::IsItemHovered()) desk.state.pointed_edit = choice.edit;
    if (chosen) {
      desk.state.edit_mesh(*choice.edit);
      return;  // the list of choices is of the mesh before
    }
    if (!possible && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
      desk.ui.tooltip(choice.refused);
  }
}

void open_context_menu(Desk& desk, const EditTarget& target) {
  if (!target.edge && !target.face && !target.vertex) return;
  desk.window.context_target = target;
  ImGui::OpenPopup(kContextMenu);
}

void draw_context_menu(Desk& desk) {
  Ui& ui = desk.ui;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(8), ui.px(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(14), ui.px(8)));
  if (ImGui::BeginPopup(kContextMenu)) {
    const Ui::Scope scope(ui, "Context");
    draw_edit_choices(desk, desk.window.context_target);
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

// The first line is the design as it was opened; the moment that is shown has the mark.
void draw_history(Desk& desk) {
  const Ui::Scope scope(desk.ui, "Menu/Edit/History");
  const Document& document = desk.state.document();
  const std::vector<std::string> names = document.history();
  const int done = document.steps_done();
  int wanted = done;
  for (int step = 0; step <= static_cast<int>(names.size()); ++step) {
    const std::string label =
        (step == 0 ? "Opened" : names[static_cast<std::size_t>(step) - 1]) + "##" + std::to_string(step);
    const bool undone = step > done;
    if (undone) ImGui::PushStyleColor(ImGuiCol_Text, to_vec4(desk.ui.colours().ink_faint));
    if (ImGui::MenuItem(label.c_str(), nullptr, step == done, !document.empty())) wanted = step;
    if (undone) ImGui::PopStyleColor();
    desk.ui.record_item("step " + std::to_string(step), !document.empty());
  }
  if (wanted != done) desk.state.go_to(wanted);
}

}  // namespace planewright::ui
