#include "ui/name_field.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

namespace planewright::ui {

void begin_typing_name(NameTyping& typing, std::string_view field, const std::string& name) {
  typing.field = field;
  typing.text = name;
  typing.begins = true;
}

bool typing_name(Ui& ui, NameTyping& typing, std::string_view field, std::string& name, float width) {
  if (typing.field != field) return false;
  ImGui::PushID(field.data(), field.data() + field.size());
  if (typing.begins) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(width);
  const bool entered = ImGui::InputText(
      "##name", &typing.text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  const bool left = !typing.begins && ImGui::IsItemDeactivated();
  ui.record_item(field);
  ImGui::PopID();
  typing.begins = false;
  if (!entered && !left) return false;
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (!escaped && !typing.text.empty()) name = typing.text;
  typing.field.clear();
  return true;
}

}  // namespace planewright::ui
