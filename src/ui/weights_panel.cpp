// The weights in the left panel: every energy of the catalogue, in groups that a designer thinks in.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "core/design/presets.h"
#include "core/problem/energies/energy_catalogue.h"
#include "ui/format.h"
#include "ui/layer_edits.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

struct Group {
  const char* title;
  std::vector<std::string_view> energies;
};

const std::array<Group, 3>& groups() {
  static const std::array<Group, 3> all = {{
      {"Where panels are", {"position", "closeness", "offset"}},
      {"Shape", {"edge-length", "diagonal-length", "edge-direction", "corner-angle"}},
      {"Evenness", {"fairing", "normal-smoothness", "proxy-normal"}},
  }};
  return all;
}

// What an energy adds to the objective and the part of it that this makes up; < 0 where that is not known.
struct Contribution {
  double value = -1, share = -1;
};

Contribution contribution_of(const AppState& state, const std::string& energy) {
  double total = 0;
  Contribution own;
  for (const SolveReport::Energy& e : state.energies()) {
    total += std::abs(e.value);
    if (e.name == energy) own.value = std::abs(e.value);
  }
  if (own.value >= 0) own.share = total > 0 ? own.value / total : 0.0;
  return own;
}

void draw_weight(Desk& desk, const EnergyInfo& energy) {
  AppState& state = desk.state;
  LayerSettings settings = state.document().settings();
  double& weight = settings.weights[energy.name];
  const std::string about =
      energy.description + (energy.source.empty() ? "" : "  [Zimmer et al., " + energy.source + "]") +
      "\n\nWeight 1 means the same on every model; further right is stronger. Drag, turn "
      "the wheel, double click to reset, Ctrl click to type.";
  const Contribution part = contribution_of(state, energy.name);
  WeightLook look;
  look.reset_value = energy.default_weight;
  look.value = part.value;
  look.share = part.share;
  look.tooltip = about;
  const Edit edit = desk.ui.weight("weight " + energy.name, energy.label, weight, look);
  if (edit.changed) {
    state.change_settings(std::move(settings), "Weight of " + energy.name, "weight " + energy.name);
  }
  if (edit.finished) state.end_merge();
}

// The group's title, and above the first group what the two columns of numbers are.
void draw_group_title(Ui& ui, const char* title, bool first) {
  if (!first) ui.gap(9);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(17);
  const ImVec2 max(min.x + width, min.y + height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = ui.theme().small();
  draw_text_aligned(draw, font, min, max, 0.0f, ui.colours().ink_faint, title);
  if (first) {
    const float column = max.x - ui.weight_share_width() - ui.px(10);
    draw_text_aligned(draw, font, min, ImVec2(column - ui.px(2), max.y), 1.0f, ui.colours().ink_faint,
                      "weight");
    draw_text_aligned(draw, font, min, max, 1.0f, ui.colours().ink_faint, "adds");
  }
  ImGui::Dummy(ImVec2(width, height - ImGui::GetStyle().ItemSpacing.y));
}

}  // namespace

void draw_presets(Desk& desk) {
  const LayerSettings& present = desk.state.document().settings();
  const Preset* chosen = present_preset(present);
  std::vector<const Preset*> fitting;
  std::vector<std::string> items, about;
  int current = -1;
  for (const Preset& preset : presets()) {
    if (!preset.fits(present.mode)) continue;
    if (&preset == chosen) current = static_cast<int>(fitting.size());
    fitting.push_back(&preset);
    items.push_back(preset.label);
    about.push_back(preset.description);
  }
  if (current < 0) {
    current = static_cast<int>(items.size());
    items.push_back("custom");
    about.push_back("Your own weights and demands");
  }
  const std::string tip = (chosen != nullptr ? chosen->description + "\n\n" : std::string()) +
                          "A preset sets all weights, and switches on the demands that it needs.";
  if (!desk.ui.choice("preset", "Preset", items, current, tip, about)) return;
  if (current >= static_cast<int>(fitting.size())) return;
  const Preset& preset = *fitting[static_cast<std::size_t>(current)];
  LayerSettings settings = present;
  if (const Result<void> applied = apply(preset, settings); !applied) {
    desk.state.post(applied.error());
    return;
  }
  desk.state.change_settings(std::move(settings), "Preset " + preset.label);
}

void draw_weights(Desk& desk) {
  const auto& catalogue = energy_catalogue();
  std::vector<bool> drawn(catalogue.size(), false);
  bool first = true;
  const auto draw_group = [&](const char* title, const auto& belongs) {
    bool titled = false;
    for (std::size_t i = 0; i < catalogue.size(); ++i) {
      if (drawn[i] || !belongs(catalogue[i].name)) continue;
      if (!titled) draw_group_title(desk.ui, title, first);
      titled = true;
      first = false;
      drawn[i] = true;
      draw_weight(desk, catalogue[i]);
    }
  };
  for (const Group& group : groups()) {
    draw_group(group.title, [&](const std::string& name) {
      return std::find(group.energies.begin(), group.energies.end(), name) != group.energies.end();
    });
  }
  draw_group("More", [](const std::string&) { return true; });
  desk.ui.gap(4);
}

}  // namespace planewright::ui
