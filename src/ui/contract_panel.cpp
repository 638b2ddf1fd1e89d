// What panels are made to, in the right panel: the model's unit, what the panels are of, and how they are
// named.
#include <array>
#include <string>
#include <vector>

#include "ui/format.h"
#include "ui/panels.h"

namespace planewright::ui {

void set_unit(Desk& desk, LengthUnit unit) {
  desk.window.settings.unit = symbol(unit);
  desk.state.default_unit = unit;
  WorkshopContract contract = desk.state.contract();
  contract.unit = unit;
  desk.state.change_contract(contract, "Unit " + desk.window.settings.unit);
}

namespace {

// Names that have left on drawings stay, whatever style is chosen; unless they are given up.
void draw_kept_names(Desk& desk) {
  Ui& ui = desk.ui;
  const int kept = desk.state.kept_names();
  if (kept == 0) return;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.label_width(), at.y));
  ButtonLook look;
  look.width = -1;
  look.tooltip = format_count(kept, "name has", "names have") +
                 " left with an export and stay with their panels. This gives them up: drawings that are out "
                 "will no longer agree.";
  if (ui.button("name anew", "Name anew", look)) desk.state.forget_names();
}

}  // namespace

void draw_panel_terms(Desk& desk) {
  Ui& ui = desk.ui;
  WorkshopContract contract = desk.state.contract();
  const auto row = [&](const char* name, const char* label, double& value, const char* unit, double per_pixel,
                       const char* tooltip) {
    QuantityLook look;
    look.unit = unit;
    look.per_pixel = per_pixel;
    look.least = 0.0;
    look.tooltip = tooltip;
    const Edit edit = ui.quantity_row(name, label, value, look);
    if (edit.changed) desk.state.change_contract(contract, label, name);
    if (edit.finished) desk.state.end_merge();
  };
  row("thickness", "Thickness", contract.thickness, "mm", 0.1,
      "Of the panels, inwards from their outside. 0: sheets without thickness, cut square.");
  row("gap", "Joint gap", contract.gap, "mm", 0.1, "Between two neighbours; each gives way by half of it.");
  row("density", "Density", contract.density, "kg/m³", 10,
      "For weights; 0: unknown. Glass 2500, aluminium 2700.");
}

void draw_contract(Desk& desk) {
  Ui& ui = desk.ui;
  const std::vector<LengthUnit>& units = length_units();
  std::vector<std::string> symbols;
  int current = 0;
  for (const LengthUnit unit : units) {
    if (unit == desk.state.contract().unit) current = static_cast<int>(symbols.size());
    symbols.emplace_back(symbol(unit));
  }
  if (ui.choice(
          "unit", "Model unit", symbols, current,
          "What 1 means in the model's coordinates. It changes no coordinate: only what limits, names of "
          "lengths and exported files make of them."))
    set_unit(desk, units[static_cast<std::size_t>(current)]);

  draw_panel_terms(desk);

  WorkshopContract contract = desk.state.contract();
  static const std::array<std::string, 2> kStyles = {"C-17", "17"};
  static const std::array<std::string, 2> kAbout = {
      "Rows by height from below get letters, panels a number in their row",
      "Panels get their number in the design, plus 1"};
  int style = static_cast<int>(contract.names);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().regular(), at,
                    ImVec2(at.x + ui.label_width(), at.y + ImGui::GetFrameHeight()), 0.0f,
                    ui.colours().ink_soft, "Names");
  ImGui::SetCursorScreenPos(ImVec2(at.x + ui.label_width(), at.y));
  if (ui.segmented("names", kStyles, style, kAbout)) {
    contract.names = static_cast<NameStyle>(style);
    desk.state.change_contract(contract, "Names of panels");
  }
  draw_kept_names(desk);
}

}  // namespace planewright::ui
