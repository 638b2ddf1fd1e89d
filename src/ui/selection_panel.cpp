// The selection in the right panel: tools that select, what is selected, what is stored under a name, and
// pins.
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>

#include "core/edit/design_edits.h"
#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

// What was found of an element.
void draw_findings_of(Desk& desk, const ElementRef& element) {
  Ui& ui = desk.ui;
  const auto findings = desk.state.findings();
  if (!findings) return;
  for (const Finding& finding : findings->diagnosis.findings) {
    if (finding.element != element && finding.second != element) continue;
    ui.value_row(capitalised(kind_name(finding.kind)),
                 measure_text(finding.measure, finding.unit, desk.state.shown()->complex().mean_edge,
                              desk.state.unit()),
                 severity_colour(ui, finding.severity),
                 capitalised(finding.cause) + ". " + capitalised(limit_text(finding)) + ".");
  }
}

// "12 panels, 3 corners"
std::string summary(const AppState& state, const Selection& selection) {
  const ComplexKind kind = state.document().settings().mode;
  const auto named =
      static_cast<int>(kind == ComplexKind::Dual ? selection.vertices.size() : selection.faces.size());
  const int corners = element_count(selection) - named;
  // Panels of clusters are named by all faces of their regions.
  const auto panels =
      kind == ComplexKind::Cluster ? static_cast<int>(state.selected_regions().size()) : named;
  std::string text;
  if (panels > 0) text = format_count(panels, "panel", "panels");
  if (corners > 0) text += (text.empty() ? "" : ", ") + format_count(corners, "corner", "corners");
  return text.empty() ? "nothing" : text;
}

void draw_tools(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  static const std::array<std::string, 2> kWhat = {"Panels", "Corners"};
  static const std::array<std::string, 2> kAbout = {
      "Boxes, loops and the border select panels. A click takes what is under it.",
      "Boxes, loops and the border select corners. A click takes what is under it."};
  int what = static_cast<int>(state.select_what);
  if (ui.segmented("what", kWhat, what, kAbout)) state.select_what = static_cast<SelectWhat>(what);
  const float spacing = ui.px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2 * spacing) / 3);
  const auto button = [&](Action action, const char* text, bool last = false) {
    const ActionInfo& of = info(action);
    ButtonLook look;
    look.width = width;
    look.enabled = desk.actions.enabled(action);
    look.active = action == Action::SelectBox && desk.actions.checked(action);
    look.tooltip = of.label + (of.shortcut.empty() ? "" : "  (" + of.shortcut + ")");
    if (ui.button(of.name, text, look)) desk.actions.request(action);
    if (!last) ImGui::SameLine(0, spacing);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(spacing, spacing));
  button(Action::SelectBox, "Box");
  button(Action::SelectBorder, "Border");
  button(Action::SelectInverse, "Invert", true);
  button(Action::SelectMore, "Grow");
  button(Action::SelectLess, "Shrink");
  button(Action::ClearSelection, "None", true);
  ImGui::PopStyleVar();
}

void draw_corner(Desk& desk, int point) {
  Ui& ui = desk.ui;
  const AppState& state = desk.state;
  const PreparedView& shown = *state.shown();
  const TangentComplex& complex = shown.complex();
  const std::string unit = desk.state.unit();
  ui.heading(element_name(state.document(), state.active_layer(), shown, {ElementKind::Point, point}));
  ui.value_row("Planes through it", format_count(complex.planes_of_point.valence(point)));
  draw_findings_of(desk, {ElementKind::Point, point});
  ui.value_row("Moved by", format_with_unit(shown.displacement.per_point[point], unit));
  const Vector3d at = shown.points.row(point).transpose() + state.scene_origin();
  ui.value_row("x", format_with_unit(at.x(), unit));
  ui.value_row("y", format_with_unit(at.y(), unit));
  ui.value_row("z", format_with_unit(at.z(), unit));
}

void draw_panel(Desk& desk, int panel) {
  Ui& ui = desk.ui;
  const PreparedView& shown = *desk.state.shown();
  const std::string unit = desk.state.unit();
  const auto corners = shown.complex().panels[panel];
  double shortest = 1e300, longest = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double length =
        (shown.points.row(corners[k]) - shown.points.row(corners[(k + 1) % corners.size()])).norm();
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
  }
  const double area = 0.5 * newell_vector(shown.points, corners).norm();
  ui.heading(
      element_name(desk.state.document(), desk.state.active_layer(), shown, {ElementKind::Panel, panel}));
  ui.value_row("Corners", format_count(static_cast<std::int64_t>(corners.size())));
  ui.value_row("Area", format_with_unit(area, unit + "²"));
  ui.value_row("Edges",
               corners.empty() ? "–" : format_number(shortest) + " to " + format_with_unit(longest, unit));
  ui.value_row("Off its plane", format_with_unit(shown.planarity.per_panel[panel], unit));
  draw_findings_of(desk, {ElementKind::Panel, panel});
}

void draw_edge(Desk& desk, int index) {
  Ui& ui = desk.ui;
  const PreparedView& shown = *desk.state.shown();
  const PanelEdge& edge = shown.complex().panel_edges[static_cast<std::size_t>(index)];
  const ElementRef element{ElementKind::PanelEdge, index};
  ui.heading(element_name(desk.state.document(), desk.state.active_layer(), shown, element));
  ui.value_row("Length", format_with_unit((shown.points.row(edge.a) - shown.points.row(edge.b)).norm(),
                                          desk.state.unit()));
  draw_findings_of(desk, element);
}

// A row of a list with a name left, a count right, and a small cross; what of it was pressed.
enum class RowPress { None, Row, Twice, Remove };
RowPress list_row(Ui& ui, const std::string& record, const std::string& name, const std::string& value,
                  bool current, const std::string& tooltip) {
  const Palette& p = ui.colours();
  const float height = ImGui::GetTextLineHeight() + ui.px(7), cross = ui.px(24);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const ImVec2 max(min.x + ImGui::GetContentRegionAvail().x, min.y + height);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  RowPress press = RowPress::None;
  ImGui::PushID(record.c_str());
  if (ImGui::InvisibleButton("row", ImVec2(max.x - min.x - cross, height))) press = RowPress::Row;
  ui.record_item(record);
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) press = RowPress::Twice;
  ui.tooltip_if_hovered(tooltip);
  if (current || hovered) draw.AddRectFilled(min, max, current ? p.accent_soft : p.hovered, ui.px(3));
  ImGui::SameLine(0, 0);
  if (ImGui::InvisibleButton("remove", ImVec2(cross, height))) press = RowPress::Remove;
  ui.record_item(record + " remove");
  ui.tooltip_if_hovered("Remove");
  const char* icon = ui.theme().icon(Icon::Close);
  draw_text_aligned(draw, ui.theme().small(), ImVec2(max.x - cross, min.y), max, 0.5f,
                    ImGui::IsItemHovered() ? p.error : p.ink_faint, *icon != '\0' ? icon : "x");
  ImGui::PopID();
  const float room =
      max.x - min.x - cross - ui.px(10) -
      ui.theme().small()->CalcTextSizeA(ui.theme().small()->FontSize, FLT_MAX, 0, value.c_str()).x;
  draw_text_aligned(draw, ui.theme().regular(), ImVec2(min.x + ui.px(6), min.y), max, 0.0f, p.ink,
                    elided(ui.theme().regular(), name, room - ui.px(6)));
  draw_text_aligned(draw, ui.theme().small(), min, ImVec2(max.x - cross - ui.px(2), max.y), 1.0f, p.ink_soft,
                    value);
  return press;
}

void draw_stored(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const std::vector<Selection> stored = state.document().design().selections;
  if (stored.empty()) return;
  ui.gap(4);
  ui.small_text("Stored", ui.colours().ink_faint);
  ui.gap(1);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  for (const Selection& selection : stored) {
    const std::string record = "stored " + selection.name;
    if (desk.window.typing.field == record + " name") {
      std::string name = selection.name;
      if (typing_name(ui, desk.window.typing, record + " name", name, ImGui::GetContentRegionAvail().x) &&
          name != selection.name) {
        state.rename_selection(selection.name, name);
      }
      continue;
    }
    Selection current = state.selection();
    current.name = selection.name;
    const int demands = demands_on(state.document().design(), selection.name);
    std::string tooltip = "Click to select it, double click to rename it.";
    if (demands > 0) {
      tooltip.append(" ")
          .append(format_count(demands, "demand refers", "demands refer"))
          .append(" to it and would go with it.");
    }
    switch (list_row(ui, record, selection.name, format_count(element_count(selection)), current == selection,
                     tooltip)) {
      case RowPress::Row: {
        Selection recalled = selection;
        recalled.name.clear();
        state.clear_selection();
        state.select(std::move(recalled), ImGui::GetIO().KeyShift ? Combine::Add : Combine::Replace);
        break;
      }
      case RowPress::Twice:
        begin_typing_name(desk.window.typing, record + " name", selection.name);
        break;
      case RowPress::Remove:
        state.remove_selection(selection.name);
        break;
      case RowPress::None:
        break;
    }
  }
  ImGui::PopStyleVar();
  ui.gap(2);
}

// The three coordinates of a pin: each held or free, with its value.
void draw_coordinates(Desk& desk, int index, const Pin& pin) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  static constexpr const char* kAxes[] = {"x", "y", "z"};
  const std::string record = "pin " + std::to_string(index);
  const auto place = state.pin_place(pin);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool held = pin.at[axis].has_value();
    const std::string of_axis = record + " " + kAxes[axis];
    const auto line = static_cast<Eigen::Index>(axis);
    const double now = pin.at[axis].value_or(place ? (*place)[line] + state.scene_origin()[line] : 0.0);
    ImGui::Indent(ui.px(6));
    if (ui.checkbox(of_axis + " held", kAxes[axis], held, "Hold this coordinate")) {
      Pin changed = pin;
      changed.at[axis] = held ? std::optional(now) : std::nullopt;
      state.change_pin(index, changed, held ? "Hold a coordinate" : "Free a coordinate");
    }
    ImGui::SameLine(ui.px(64));
    if (held) {
      double value = now;
      QuantityLook look;
      look.unit = desk.state.unit();
      look.per_pixel = length_step(desk);
      look.reset_value = now;
      look.tooltip = "Drag, turn the wheel, or Ctrl click to type";
      const Edit edit = ui.quantity(of_axis, value, look);
      if (edit.changed) {
        Pin changed = pin;
        changed.at[axis] = value;
        state.change_pin(index, changed, "Move pin", "pin " + of_axis);
      }
      if (edit.finished) state.end_merge();
    } else {
      ImGui::AlignTextToFramePadding();
      ui.small_text("free", ui.colours().ink_faint);
    }
    ImGui::Unindent(ui.px(6));
  }
}

}  // namespace

void draw_selection(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const auto& shown = state.shown();
  if (!shown) {
    ui.small_text("There are no panels yet.");
    return;
  }
  draw_tools(desk);
  const bool something = !state.selection().empty() || state.selected_point;
  ui.gap(2);
  if (!something && !state.selected_edge && !state.selected_panel) {
    ui.wrapped("Click a panel or a corner. Shift adds, Ctrl removes, Alt takes the loop through an edge.",
               ui.colours().ink_faint, true);
  } else {
    if (!state.selection().empty()) {
      ui.value_row("Selected", summary(state, state.selection()), ui.colours().accent);
    }
    const TangentComplex& complex = shown->complex();
    if (state.selected_point && *state.selected_point < complex.point_count()) {
      draw_corner(desk, *state.selected_point);
    } else if (state.selected_edge && *state.selected_edge < static_cast<int>(complex.panel_edges.size())) {
      draw_edge(desk, *state.selected_edge);
    } else if (state.selected_panel && *state.selected_panel < complex.panels.size()) {
      draw_panel(desk, *state.selected_panel);
    }
  }
  if (something) {
    ui.gap(2);
    const float width = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - ui.px(4)));
    const auto button = [&](Action action, Icon icon, const char* text) {
      ButtonLook look;
      look.has_icon = true;
      look.icon = icon;
      look.width = width;
      look.enabled = desk.actions.enabled(action);
      look.tooltip =
          info(action).label + (info(action).shortcut.empty() ? "" : "  (" + info(action).shortcut + ")");
      if (ui.button(info(action).name, text, look)) desk.actions.request(action);
    };
    button(Action::Pin, Icon::Pin, "Pin");
    ImGui::SameLine(0, ui.px(4));
    button(Action::StoreSelection, Icon::Add, "Store");
  }
  draw_stored(desk);
}

void draw_pins(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const Demands demands = state.document().settings().demands;
  if (demands.pins.empty() && demands.plane_pins.empty()) {
    ui.wrapped("Nothing is held. Select corners or panels and press P; drag a pin to move it.",
               ui.colours().ink_faint, true);
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(1)));
  for (std::size_t i = 0; i < demands.pins.size(); ++i) {
    const Pin& pin = demands.pins[i];
    const auto index = static_cast<int>(i);
    const auto point = state.shown_point(pin.point);
    const bool current = point && state.selected_point == point;
    std::string axes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!pin.at[axis]) continue;
      if (!axes.empty()) axes += ' ';
      axes += static_cast<char>('x' + axis);
    }
    switch (list_row(
        ui, "pin " + std::to_string(index), corner_name(pin.point, state.document().ids().get()), axes,
        current,
        point ? "Click to see it and to edit its coordinates" : "The shown panels do not have this point")) {
      case RowPress::Row:
      case RowPress::Twice:
        if (point) state.show_element({ElementKind::Point, *point});
        break;
      case RowPress::Remove:
        state.remove_pin(index);
        ImGui::PopStyleVar();
        return;
      case RowPress::None:
        break;
    }
    if (current) draw_coordinates(desk, index, pin);
  }
  for (std::size_t i = 0; i < demands.plane_pins.size(); ++i) {
    const PlanePin& pin = demands.plane_pins[i];
    const auto index = static_cast<int>(i);
    const auto panel = state.shown_panel(pin.panel_origin);
    const std::string number =
        panel ? format_count(*panel) : std::string("of element ").append(format_count(pin.panel_origin));
    switch (list_row(ui, "plane pin " + std::to_string(index), "Panel " + number, "plane",
                     panel && state.selected_panel == panel, "Held in its plane. Click to see it.")) {
      case RowPress::Row:
      case RowPress::Twice:
        if (panel) state.show_element({ElementKind::Panel, *panel});
        break;
      case RowPress::Remove:
        state.remove_plane_pin(index);
        ImGui::PopStyleVar();
        return;
      case RowPress::None:
        break;
    }
  }
  ImGui::PopStyleVar();
}

}  // namespace planewright::ui
