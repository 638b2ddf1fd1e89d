// The layers in the left panel: which there are, how each stands, and how thick and how joined they are.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr int kListed = 60;

struct Standing {
  std::string text;
  ImU32 colour;
};

Standing standing(const Desk& desk, int layer) {
  const AppState& state = desk.state;
  const Palette& p = desk.ui.colours();
  const SolveReport* report = state.report(layer);
  switch (state.layer_status(layer)) {
    case LayerStatus::Waiting:
      return {state.solving() ? "waits for its turn" : "not solved yet", p.ink_faint};
    case LayerStatus::Saved:
      return {"as saved", p.good};
    case LayerStatus::Solving:
      return {"solving", p.accent};
    case LayerStatus::Done: {
      const bool demands =
          report != nullptr &&
          std::any_of(report->constraints.begin(), report->constraints.end(), [](const auto& c) {
            return c.rows > 0 && c.name != "incidence" && c.name != "unit normal";
          });
      return {demands ? "converged, demands met" : "converged", p.good};
    }
    case LayerStatus::Planar:
      return {report != nullptr ? planewright::name(report->status) : "planar", p.warning};
    case LayerStatus::Unmet: {
      const int unmet = std::max(1, state.unmet_demands(layer));
      return {format_count(unmet, "demand", "demands") + " not met", p.warning};
    }
    case LayerStatus::NotPlanar:
      return {"not planar", p.error};
    case LayerStatus::Failed:
      return {"failed", p.error};
  }
  return {"", p.ink_faint};
}

// One line of the list: eye, name, offset, how it stands. A click makes it the active one, a double click
// renames it.
void draw_row(Desk& desk, int index, float height) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const Palette& p = ui.colours();
  Layer layer = state.document().design().layers[static_cast<std::size_t>(index)];
  const std::string record = "layer " + std::to_string(index);
  const bool active = index == state.active_layer();
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x, min.y + height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImGui::PushID(index);

  const float eye = ui.px(28);
  if (ImGui::InvisibleButton("eye", ImVec2(eye, height))) {
    layer.visible = !layer.visible;
    state.change_layer(index, layer, (layer.visible ? "Show " : "Hide ") + layer.name);
  }
  ui.record_item(record + " eye");
  const bool on_eye = ImGui::IsItemHovered();
  ui.tooltip_if_hovered(layer.visible ? "Hide this layer" : "Show this layer");
  ImGui::SameLine(0, 0);

  const float dot = ui.px(22), offset = ui.px(86);
  const float name_width = std::max(max.x - min.x - eye - dot - offset, ui.px(40));
  NameTyping& typing = desk.window.typing;
  if (typing.field == record + " name") {
    ImGui::SetCursorScreenPos(
        ImVec2(min.x + eye, min.y + std::round(0.5f * (height - ImGui::GetFrameHeight()))));
    const std::string before = layer.name;
    if (typing_name(ui, typing, record + " name", layer.name, name_width) && layer.name != before) {
      state.change_layer(index, layer, "Rename " + before);
    }
    ImGui::SetCursorScreenPos(ImVec2(min.x + eye + name_width, min.y));
    ImGui::Dummy(ImVec2(1, height));
  } else {
    const bool pressed = ImGui::InvisibleButton("row", ImVec2(max.x - min.x - eye, height));
    ui.record_item(record);
    const Standing how = standing(desk, index);
    if (active) {
      draw.AddRectFilled(min, max, p.accent_soft, ui.px(3));
    } else if (ImGui::IsItemHovered()) {
      draw.AddRectFilled(min, max, p.hovered, ui.px(3));
    }
    ui.tooltip_if_hovered(capitalised(how.text) + ". Click to work on it, double click to rename it.");
    if (pressed) state.set_active_layer(index);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      begin_typing_name(typing, record + " name", layer.name);
    }
    const ImU32 ink = layer.visible ? p.ink : p.ink_faint;
    ImFont* font = active ? ui.theme().bold() : ui.theme().regular();
    draw_text_aligned(draw, font, ImVec2(min.x + eye, min.y), max, 0.0f, ink,
                      elided(font, layer.name, name_width - ui.px(4)));
    draw_text_aligned(draw, ui.theme().regular(), ImVec2(max.x - dot - offset, min.y),
                      ImVec2(max.x - dot, max.y), 1.0f, layer.visible ? p.ink_soft : p.ink_faint,
                      format_with_unit(layer.settings.offset, desk.state.unit()));
    const ImVec2 at(max.x - 0.5f * dot, 0.5f * (min.y + max.y));
    if (state.layer_status(index) == LayerStatus::Solving) {
      const auto angle = static_cast<float>(std::fmod(ImGui::GetTime() * 4.0, 2 * std::numbers::pi));
      draw.PathArcTo(at, ui.px(4.5f), angle, angle + 4.2f, 16);
      draw.PathStroke(p.accent, 0, ui.px(1.8f));
    } else if (state.layer_status(index) == LayerStatus::Waiting) {
      draw.AddCircle(at, ui.px(4), p.ink_faint, 16, ui.px(1.2f));
    } else {
      draw.AddCircleFilled(at, ui.px(4), how.colour, 16);
    }
  }
  const char* icon = ui.theme().icon(layer.visible ? Icon::Ghost : Icon::Hidden);
  draw_text_aligned(draw, ui.theme().small(), min, ImVec2(min.x + eye, max.y), 0.5f,
                    on_eye          ? p.ink
                    : layer.visible ? p.ink_soft
                                    : p.ink_faint,
                    *icon != '\0'   ? icon
                    : layer.visible ? "on"
                                    : "off");
  ImGui::PopID();
}

void draw_buttons(Desk& desk) {
  Ui& ui = desk.ui;
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * spacing) / 3);
  const auto button = [&](Action action, Icon icon, const char* text, bool last = false) {
    ButtonLook look;
    look.has_icon = true;
    look.icon = icon;
    look.width = width;
    look.enabled = desk.actions.enabled(action);
    look.tooltip = info(action).label;
    if (ui.button(info(action).name, text, look)) desk.actions.request(action);
    if (!last) ImGui::SameLine();
  };
  button(Action::AddLayer, Icon::Add, "Add");
  button(Action::DuplicateLayer, Icon::Copy, "Copy");
  button(Action::RemoveLayer, Icon::Remove, "Remove", true);
}

// Which layers beams can lead to: earlier ones with the same panels.
void draw_beams_choice(Desk& desk, const Layer& layer) {
  const AppState& state = desk.state;
  const auto& layers = state.document().design().layers;
  std::vector<std::string> items{"none"};
  std::vector<int> targets{-1};
  for (int k = 0; k < state.active_layer(); ++k) {
    const LayerSettings& other = layers[static_cast<std::size_t>(k)].settings;
    if (other.mode != layer.settings.mode || other.border != layer.settings.border) continue;
    items.push_back(layers[static_cast<std::size_t>(k)].name);
    targets.push_back(k);
  }
  if (targets.size() == 1 && layer.coplanar_with < 0) return;
  int current = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i] == layer.coplanar_with) current = static_cast<int>(i);
  }
  if (!desk.ui.choice(
          "beams", "Beams to", items, current,
          "Straight, flat beams from each panel edge to the same edge of another layer; this layer is "
          "solved so that both edges lie in one plane.")) {
    return;
  }
  Layer changed = layer;
  changed.coplanar_with = targets[static_cast<std::size_t>(current)];
  desk.state.change_layer(state.active_layer(), changed,
                          current == 0 ? "No beams" : "Beams to " + items[static_cast<std::size_t>(current)]);
}

std::string degrees(double radians) {
  constexpr double kParallel = 1e-8;  // radians: rounding
  return radians < kParallel ? "none" : format_number(radians * 180 / std::numbers::pi) + "°";
}

void draw_beams_result(Desk& desk, const char* label, const PreparedBeams& beams, const std::string& record) {
  Ui& ui = desk.ui;
  if (!beams.refused.empty()) {
    ui.wrapped("No beams: " + beams.refused + ".", ui.colours().warning, true);
    return;
  }
  ui.value_row(
      label, format_count(beams.count) + ", flat to " + format_with_unit(beams.planarity, desk.state.unit()),
      0, "One per panel edge; the greatest distance of a corner from the plane of its beam");
  const ImVec2 line = ImGui::GetCursorScreenPos();
  ui.value_row("Largest twist", degrees(beams.twist), 0,
               "Angle between the two edges that a beam joins. Click to see where.");
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(line);
  if (ImGui::InvisibleButton(record.c_str(),
                             ImVec2(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight())) &&
      beams.most_twisted >= 0) {
    desk.state.show_element({ElementKind::PanelEdge, beams.most_twisted});
  }
  ui.record_item(record);
  ImGui::SetCursorScreenPos(after);
}

void draw_blunted(Desk& desk, const std::vector<ParallelOffset::Blunted>& blunted, double thickness) {
  Ui& ui = desk.ui;
  if (blunted.empty()) {
    ui.value_row("Blunted corners", "none", ui.colours().good,
                 "Corners whose planes are so nearly parallel that they would move more than 3 thicknesses");
    return;
  }
  ui.value_row(
      "Blunted corners", format_count(static_cast<int>(blunted.size())), ui.colours().warning,
      "Their planes are nearly parallel, so they would move more than 3 thicknesses; they are cut back "
      "to 3, and the panels are not exactly planar there.");
  const float row = ImGui::GetTextLineHeight() + ui.px(4);
  const int listed = std::min(static_cast<int>(blunted.size()), kListed);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(6), ui.px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(6), 0));
  ImGui::BeginChild("blunted", ImVec2(0, row * static_cast<float>(std::min(listed, 4)) + ui.px(8)), true);
  for (int i = 0; i < listed; ++i) {
    const ParallelOffset::Blunted& corner = blunted[static_cast<std::size_t>(i)];
    ImGui::PushID(i);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##corner", desk.state.selected_point == corner.point, 0, ImVec2(0, row))) {
      desk.state.show_element({ElementKind::Point, corner.point});
    }
    ui.record_item("blunted " + std::to_string(i));
    const ImVec2 max = ImGui::GetItemRectMax();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw_text_aligned(draw, ui.theme().small(), min, max, 0.0f, ui.colours().ink,
                      "corner " + format_count(corner.point));
    draw_text_aligned(draw, ui.theme().small(), min, ImVec2(max.x - ui.px(4), max.y), 1.0f,
                      ui.colours().ink_soft,
                      format_number(std::abs(corner.wanted_move / thickness)) + " thicknesses");
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

}  // namespace

std::string layers_summary(const Desk& desk) {
  const int count = desk.state.layer_count();
  if (count == 1) return "one";
  const auto& layers = desk.state.document().design().layers;
  return format_count(count) + ", on " + layers[static_cast<std::size_t>(desk.state.active_layer())].name;
}

void draw_layers(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const float row = ImGui::GetTextLineHeight() + ui.px(9);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_vec4(ui.colours().raised));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(3), ui.px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  const auto rows = static_cast<float>(std::min(state.layer_count(), 6));
  ImGui::BeginChild("layers", ImVec2(0, row * rows + ui.px(8)), true);
  const int count = state.layer_count();
  for (int i = 0; i < count && i < state.layer_count(); ++i) draw_row(desk, i, row);
  ImGui::EndChild();
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
  ui.gap(3);
  draw_buttons(desk);
  ui.gap(2);

  const Layer layer = state.document().design().layers[static_cast<std::size_t>(state.active_layer())];
  const Standing how = standing(desk, state.active_layer());
  ui.value_row("State", how.text, how.colour);
  Layer thicker = layer;
  const Edit edit =
      ui.length("thickness", "Thickness", thicker.thickness, length_step(desk), desk.state.unit(),
                "Thickness of the panels, along their normals (negative: to the inside). Shows their "
                "other side, which keeps every edge parallel. Double click for none.");
  if (edit.changed) {
    state.change_layer(state.active_layer(), thicker, "Thickness of " + layer.name,
                       "thickness " + std::to_string(state.active_layer()));
  }
  if (edit.finished) state.end_merge();
  draw_beams_choice(desk, layer);

  const auto& view = state.shown();
  if (!view) return;
  if (view->thickness) {
    draw_blunted(desk, view->thickness->blunted, view->thickness_wanted);
    if (!view->thickness->residuals.empty()) {
      ui.value_row("Corners off planes",
                   format_count(static_cast<int>(view->thickness->residuals.size())) + ", by up to " +
                       format_with_unit(view->thickness->largest_residual, desk.state.unit()),
                   ui.colours().warning,
                   "Where more than three panels meet, the offset planes need not have a common point.");
    }
    draw_beams_result(desk, "Sides", view->thickness->sides, "twist of sides");
  }
  if (view->beams) draw_beams_result(desk, "Beams", *view->beams, "twist");
}

}  // namespace planewright::ui
