#include "ui/leaving.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/panels.h"

namespace planewright::ui {
namespace {

void go(WindowState& window, AppState& state, const Leaving& leaving) {
  window.leaving.reset();
  switch (leaving.what) {
    case Leaving::What::Quit:
      window.quit = true;
      break;
    case Leaving::What::Open:
      state.open_file(leaving.where);
      break;
    case Leaving::What::Sample:
      state.open_sample(leaving.where.string());
      break;
  }
}

std::string reason(const Leaving& leaving) {
  switch (leaving.what) {
    case Leaving::What::Quit:
      break;
    case Leaving::What::Open:
      return "before " + leaving.where.filename().string() + " is opened?";
    case Leaving::What::Sample:
      return "before " + leaving.where.string() + " is opened?";
  }
  return "before Planewright closes?";
}

// It waits until the file is written; if that fails, or the name is not given, nothing is left.
void follow_saving(Desk& desk) {
  WindowState& window = desk.window;
  const Leaving leaving = *window.leaving;
  if (desk.state.saving() || window.browser.is_open()) return;
  if (desk.state.modified()) {
    window.leaving.reset();
  } else {
    go(window, desk.state, leaving);
  }
}

}  // namespace

void leave(WindowState& window, AppState& state, Leaving leaving) {
  if (state.modified()) {
    window.leaving = std::move(leaving);
  } else {
    go(window, state, leaving);
  }
}

void draw_leaving(Desk& desk) {
  WindowState& window = desk.window;
  if (!window.leaving) return;
  if (window.leaving->once_saved) {
    follow_saving(desk);
    return;
  }
  Ui& ui = desk.ui;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0.5f * screen.x, 0.42f * screen.y), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(ui.px(440), screen.x - ui.px(24)), 0));
  ImGui::SetNextWindowFocus();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(18), ui.px(16)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, to_vec4(ui.colours().overlay));
  ImGui::Begin("##leaving", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  {
    const Ui::Scope scope(ui, "Leaving");
    ui.heading("Save the changes of " + desk.state.title());
    ui.text(reason(*window.leaving), ui.colours().ink_soft);
    ui.gap(10);
    ButtonLook look;
    look.width = ui.px(126);
    ButtonLook primary = look;
    primary.primary = true;
    if (ui.button("save", "Save", primary)) {
      window.leaving->once_saved = true;
      desk.actions.request(Action::Save);
    }
    ImGui::SameLine();
    const bool discard = ui.button("discard", "Don't save", look);
    ImGui::SameLine();
    const bool stay =
        ui.button("stay", "Cancel", look) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (discard) {
      const Leaving leaving = *window.leaving;
      go(window, desk.state, leaving);
    } else if (stay) {
      window.leaving.reset();
    }
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(3);
}

}  // namespace planewright::ui
