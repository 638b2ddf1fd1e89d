// The demands in the left panel: what the panels must obey, how far they are from it, and where.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/problem/demands/demand_catalogue.h"
#include "ui/format.h"
#include "ui/layer_edits.h"
#include "ui/panels.h"

namespace planewright::ui {
namespace {

constexpr double kMet = 1e-9;  // a demand that is missed by less counts as met

const SolveReport::Constraint* reported(const AppState& state, const std::string& name) {
  if (state.report() == nullptr) return nullptr;
  for (const SolveReport::Constraint& c : state.report()->constraints) {
    if (c.name == name) return &c;
  }
  return nullptr;
}

bool met(const SolveReport::Constraint& c) {
  return c.max_violation <= kMet;
}

// "0.021 m": reports count lengths in mean edges, people in model units.
std::string amount(const Desk& desk, const SolveReport::Constraint& c) {
  const auto& shown = desk.state.shown();
  if (c.unit == "edges" && shown) {
    return format_with_unit(c.max_violation * shown->complex().mean_edge, desk.state.unit());
  }
  return format_with_unit(c.max_violation, c.unit);
}

std::string label_of(const std::string& demand) {
  for (const DemandInfo& info : demand_catalogue()) {
    if (info.name == demand) return info.label;
  }
  return capitalised(demand);
}

// A square button at the right edge of the panel that flies to an element; the line of the one before.
void show_where(Desk& desk, const std::string& name, const ElementRef& element, float line_height) {
  Ui& ui = desk.ui;
  const float size = ui.px(20);
  const ImVec2 back = ImGui::GetCursorScreenPos();
  ImGui::SameLine();
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.x = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - size;
  at.y += std::round(0.5f * (line_height - ui.px(18)));
  ImGui::SetCursorScreenPos(at);
  ButtonLook look;
  look.small = look.quiet = look.has_icon = true;
  look.icon = Icon::Target;
  look.width = size;
  look.tooltip = "Show where: " + text(element);
  if (ui.button(name, ui.theme().has_icons() ? "" : "→", look)) {
    show_element(desk.state, desk.window, element);
  }
  ImGui::SetCursorScreenPos(back);
}

// At the right end of the line that begins at `line`; beside_button: left of the place of show_where().
void draw_status(Desk& desk, ImVec2 line, const std::string& text, ImU32 colour, const std::string& about,
                 bool beside_button = false) {
  Ui& ui = desk.ui;
  const float right =
      ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - (beside_button ? ui.px(25) : 0.0f);
  const ImVec2 max(right, line.y + ImGui::GetFrameHeight());
  const float width =
      ui.theme().small()->CalcTextSizeA(ui.theme().small()->FontSize, FLT_MAX, 0, text.c_str()).x;
  const ImVec2 min(right - width, line.y);
  draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().small(), min, max, 1.0f, colour, text);
  if (!about.empty() && ImGui::IsMouseHoveringRect(min, max) && ImGui::IsWindowHovered()) ui.tooltip(about);
}

// How far a demand is from being met, and the way there.
void draw_violation(Desk& desk, ImVec2 line, const std::string& name) {
  const Palette& p = desk.ui.colours();
  const SolveReport::Constraint* found = reported(desk.state, name);
  if (found == nullptr) {
    draw_status(desk, line, desk.state.solving() ? "…" : "–", p.ink_faint, "Known after a solve");
    return;
  }
  if (met(*found)) {
    draw_status(desk, line, "met", p.good, format_count(found->rows, "place, all met", "places, all met"));
    return;
  }
  const std::string count = found->violated > 0 ? format_count(found->violated) + "  ·  " : "";
  std::string about = format_count(found->violated) + " of " + format_count(found->rows, "place", "places") +
                      " not met. The worst misses by " + amount(desk, *found);
  if (found->unit == "edges") about += " (" + format_number(found->max_violation) + " mean edges)";
  draw_status(desk, line, count + amount(desk, *found), p.warning, about + ", at " + text(found->worst) + ".",
              true);
  show_where(desk, "show " + name, found->worst, ImGui::GetFrameHeight());
}

void change_demands(Desk& desk, Demands demands, std::string what, std::string merge_key = {}) {
  LayerSettings settings = desk.state.document().settings();
  settings.demands = std::move(demands);
  desk.state.change_settings(std::move(settings), std::move(what), std::move(merge_key));
}

// --- One demand ------------------------------------------------------------------------------

std::string unit_of(const Desk& desk, DemandUnit unit) {
  switch (unit) {
    case DemandUnit::Length:
    case DemandUnit::CoordinateX:
    case DemandUnit::CoordinateY:
    case DemandUnit::CoordinateZ:
      return desk.state.unit();
    case DemandUnit::Edges:
      return "edges";
    case DemandUnit::None:
      return {};
  }
  return {};
}

// The fields of a demand's parameters, two in a line.
void draw_parameters(Desk& desk, const DemandInfo& info, std::size_t entry, const std::string& path) {
  Ui& ui = desk.ui;
  const float space = ui.px(6);
  const float half = std::floor(0.5f * (ImGui::GetContentRegionAvail().x - space));
  for (std::size_t k = 0; k < info.parameters.size(); ++k) {
    const DemandParameter& about = info.parameters[k];
    Demands demands = desk.state.document().settings().demands;
    if (entry >= demands.list.size()) return;
    Demand& demand = demands.list[entry];
    double value = parameter(info, demand, k);
    const std::string unit = unit_of(desk, about.unit);
    QuantityLook look;
    look.prefix = about.label;
    look.unit = unit;
    look.per_pixel =
        about.unit == DemandUnit::Edges || about.unit == DemandUnit::None ? 0.01 : length_step(desk);
    look.reset_value = about.default_value;
    look.none = none_of(info, k);
    look.width = info.parameters.size() == 1 ? 0 : half;
    const std::string tip = "Drag, turn the wheel, double click to reset, Ctrl click to type." +
                            std::string(look.none != 0 ? " Left empty: no limit on this side." : "");
    look.tooltip = tip;
    if (k % 2 == 1) ImGui::SameLine(0, space);
    const Edit edit = ui.quantity(path + " " + about.name, value, look);
    if (edit.changed) {
      set_parameter(info, demand, k, value);
      change_demands(desk, std::move(demands), info.label + " " + about.label, path + " " + about.name);
    }
    if (edit.finished) desk.state.end_merge();
  }
}

// Which part of the model a demand is for.
void draw_place(Desk& desk, const DemandInfo& info, std::size_t entry, const std::string& path) {
  const std::vector<Selection>& selections = desk.state.document().design().selections;
  Demands demands = desk.state.document().settings().demands;
  if (entry >= demands.list.size()) return;
  const std::string chosen = demands.list[entry].selection;
  const std::vector<std::size_t> entries = entries_of(demands, info.name);
  if (selections.empty() && chosen.empty() && entries.size() < 2) return;

  std::vector<std::string> items = {"whole model"};
  for (const Selection& selection : selections) items.push_back(selection.name);
  int current = 0;
  if (!chosen.empty()) {
    const auto found = std::find(items.begin() + 1, items.end(), chosen);
    current = static_cast<int>(found - items.begin());
    if (found == items.end()) items.push_back("missing: " + chosen);
  }
  const int places = static_cast<int>(items.size());
  // A demand may hold at several places, with parameters of their own.
  const bool several = !selections.empty();
  if (several) items.push_back("+ another place");
  if (entries.size() > 1) items.push_back("remove this place");
  if (!desk.ui.choice(path + " where", "", items, current, "Where this is demanded")) return;
  if (current < places) {
    demands.list[entry].selection = current == 0 ? std::string() : items[static_cast<std::size_t>(current)];
    change_demands(desk, std::move(demands), info.label + ": where");
  } else if (several && current == places) {
    Demand other = demands.list[entry];
    for (const Selection& selection : selections) {
      const bool used = std::any_of(entries.begin(), entries.end(), [&](std::size_t i) {
        return demands.list[i].selection == selection.name;
      });
      if (!used) {
        other.selection = selection.name;
        break;
      }
    }
    demands.list.insert(demands.list.begin() + static_cast<std::ptrdiff_t>(entries.back()) + 1,
                        std::move(other));
    change_demands(desk, std::move(demands), info.label + " at another place");
  } else {
    demands.list.erase(demands.list.begin() + static_cast<std::ptrdiff_t>(entry));
    change_demands(desk, std::move(demands), info.label + " at one place less");
  }
}

void draw_demand(Desk& desk, const DemandInfo& info) {
  Ui& ui = desk.ui;
  const std::string path = "demand " + info.name;
  const ImVec2 line = ImGui::GetCursorScreenPos();
  bool on = is_on(desk.state.document().settings().demands, info.name);
  if (ui.checkbox(path, info.label, on)) {
    Demands demands = desk.state.document().settings().demands;
    const auto entries = entries_of(demands, info.name);
    for (const std::size_t i : entries) demands.list[i].on = on;
    if (entries.empty()) demands.list.push_back({info.name, on, {}, {}});
    change_demands(desk, std::move(demands), info.label + (on ? " on" : " off"));
  }
  ImGui::SameLine(0, ui.px(4));
  ui.help(path + " help",
          info.description + (info.source.empty() ? "" : "  [Zimmer et al., " + info.source + "]"));
  if (!on) return;
  draw_violation(desk, line, info.name);

  const float inset = ui.px(25);
  const std::size_t count = entries_of(desk.state.document().settings().demands, info.name).size();
  ImGui::Indent(inset);
  for (std::size_t n = 0; n < count; ++n) {
    // Edits above may have changed the list.
    const auto entries = entries_of(desk.state.document().settings().demands, info.name);
    if (n >= entries.size()) break;
    const std::string own = n == 0 ? path : path + " " + std::to_string(n + 1);
    draw_place(desk, info, entries[n], own);
    const auto now = entries_of(desk.state.document().settings().demands, info.name);
    if (n < now.size()) draw_parameters(desk, info, now[n], own);
  }
  ImGui::Unindent(inset);
  if (count > 1 || !info.parameters.empty()) ui.gap(5);
}

// --- Never touch the mesh --------------------------------------------------------------------

void draw_never_touch(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const ImVec2 line = ImGui::GetCursorScreenPos();
  const Switch now = never_touch(state.document().settings());
  bool on = now == Switch::On;
  if (ui.checkbox_mixed("never touch", "Never touch the mesh", on, now == Switch::Mixed)) {
    LayerSettings settings = state.document().settings();
    set_never_touch(settings, on);
    state.change_settings(std::move(settings), on ? "Never touch the mesh" : "Allow to touch the mesh");
  }
  ImGui::SameLine(0, ui.px(4));
  ui.help("never touch help",
          "The three demands below everywhere, and after the solve a geometric test that counts panels that "
          "still cross the mesh; they are pushed apart and solved again until there are none.  [Zimmer et "
          "al., 3]");
  if (!state.document().settings().no_penetration || state.report() == nullptr) return;
  const int crossings = state.report()->crossings;
  if (crossings < 0) {
    draw_status(desk, line, "not counted", ui.colours().ink_faint, "This solve did not test for crossings");
  } else if (crossings == 0) {
    draw_status(desk, line, "0 crossings", ui.colours().good, "No panel crosses a face of the mesh");
  } else {
    draw_status(desk, line, format_count(crossings, "crossing", "crossings"), ui.colours().warning,
                "Pairs of a panel and a mesh face that cross");
  }
}

// --- What cannot be met together -------------------------------------------------------------

void draw_conflicts(Desk& desk) {
  Ui& ui = desk.ui;
  AppState& state = desk.state;
  const SolveReport* report = state.report();
  Demands demands = state.document().settings().demands;
  if (report != nullptr && report->status == SolveStatus::Infeasible && !report->conflicts.empty()) {
    const std::vector<Waiver>& conflicts = report->conflicts;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    ImGui::Indent(ui.px(12));
    ui.wrapped("These demands cannot be met together:", ui.colours().warning);
    constexpr std::size_t kListed = 5;
    const float row = ImGui::GetTextLineHeight() + ui.px(4);
    for (std::size_t i = 0; i < std::min(conflicts.size(), kListed); ++i) {
      const std::string what = label_of(conflicts[i].demand) + ", " + text(conflicts[i].element);
      const ImVec2 min = ImGui::GetCursorScreenPos();
      const float room = ImGui::GetContentRegionAvail().x - ui.px(26);
      ImGui::Dummy(ImVec2(room, row - ImGui::GetStyle().ItemSpacing.y));
      draw_text_aligned(*ImGui::GetWindowDrawList(), ui.theme().regular(), min,
                        ImVec2(min.x + room, min.y + row), 0.0f, ui.colours().ink,
                        elided(ui.theme().regular(), what, room));
      show_where(desk, "show conflict " + std::to_string(i), conflicts[i].element, row);
    }
    if (conflicts.size() > kListed) {
      ui.small_text("and " + format_count(static_cast<std::int64_t>(conflicts.size() - kListed)) + " more");
    }
    ui.gap(4);
    ButtonLook look;
    look.tooltip = "The other demands are met; what is shown is that result. Can be undone.";
    if (ui.button("give up", "Give these up", look)) {
      give_up(demands, conflicts);
      change_demands(
          desk, demands,
          "Give up " + format_count(static_cast<std::int64_t>(conflicts.size()), "demand", "demands"));
    }
    ImGui::Unindent(ui.px(12));
    const float bottom = ImGui::GetCursorScreenPos().y - ImGui::GetStyle().ItemSpacing.y;
    ImGui::GetWindowDrawList()->AddRectFilled(top, ImVec2(top.x + ui.px(3), bottom), ui.colours().warning,
                                              ui.px(2));
    ui.gap(8);
  }
  if (!demands.waived.empty()) {
    const ImVec2 line = ImGui::GetCursorScreenPos();
    ImGui::AlignTextToFramePadding();
    ui.text(
        "Given up at " + format_count(static_cast<std::int64_t>(demands.waived.size()), "place", "places"),
        ui.colours().ink_soft);
    ImGui::SameLine();
    ButtonLook look;
    look.tooltip = "Demand it everywhere again";
    look.width = ui.px(82);
    ImGui::SetCursorScreenPos(
        ImVec2(ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - look.width, line.y));
    if (ui.button("take back", "Take back", look)) {
      demands.waived.clear();
      change_demands(desk, demands, "Demand again what was given up");
    }
  }
}

// --- Pins and what comes by itself -----------------------------------------------------------

// Rows of the report that no switch stands for: pins, planes held apart.
void draw_other_rows(Desk& desk) {
  const SolveReport* report = desk.state.report();
  if (report == nullptr) return;
  for (const SolveReport::Constraint& c : report->constraints) {
    const bool listed = std::any_of(demand_catalogue().begin(), demand_catalogue().end(),
                                    [&](const DemandInfo& info) { return info.name == c.name; });
    if (listed || c.rows == 0 || c.name == "incidence" || c.name == "unit normal" || c.name == "fixed planes")
      continue;
    const ImVec2 line = ImGui::GetCursorScreenPos();
    const ImVec2 max(line.x + ImGui::GetContentRegionAvail().x, line.y + ImGui::GetFrameHeight());
    ImGui::Dummy(ImVec2(0, ImGui::GetFrameHeight()));
    draw_text_aligned(*ImGui::GetWindowDrawList(), desk.ui.theme().regular(), line, max, 0.0f,
                      desk.ui.colours().ink, capitalised(c.name));
    draw_violation(desk, line, c.name);
  }
}

void draw_margin_and_side(Desk& desk) {
  Ui& ui = desk.ui;
  LayerSettings settings = desk.state.document().settings();
  double margin = settings.demands.margin;
  const Edit edit = ui.length("margin", "Margin", margin, 1e-5, "edges",
                              "How far inside its limit every demand is to be met, in mean edges, so that "
                              "nothing touches.");
  margin = std::max(margin, 0.0);
  if (edit.changed && margin != settings.demands.margin) {
    settings.demands.margin = margin;
    desk.state.change_settings(settings, "Margin of the demands", "margin");
  }
  if (edit.finished) desk.state.end_merge();
  if (settings.mode != ComplexKind::Dual) return;
  static const std::array<std::string, 3> kSides = {"as the offset says", "outside", "inside"};
  int side = static_cast<int>(settings.side);
  if (ui.choice("side", "In front is", kSides, side, "On which side of the mesh the panels have to stay.")) {
    settings.side = static_cast<planewright::Side>(side);
    desk.state.change_settings(settings, "Side of the mesh");
  }
}

}  // namespace

DemandSummary demand_summary(const Desk& desk) {
  const Palette& p = desk.ui.colours();
  const SolveReport* report = desk.state.report();
  if (report != nullptr && report->status == SolveStatus::Infeasible) return {"cannot all be met", p.warning};
  int on = 0, reported_rows = 0, missed = 0;
  for (const DemandInfo& info : demand_catalogue()) {
    if (!is_on(desk.state.document().settings().demands, info.name)) continue;
    ++on;
    if (const auto* found = reported(desk.state, info.name)) {
      ++reported_rows;
      missed += met(*found) ? 0 : 1;
    }
  }
  if (on == 0) return {"none", p.ink_faint};
  if (missed > 0) return {format_count(missed) + " of " + format_count(on) + " not met", p.warning};
  if (reported_rows < on) return {format_count(on) + " on", p.ink_soft};
  return {format_count(on) + " met", p.good};
}

void draw_demands(Desk& desk) {
  Ui& ui = desk.ui;
  const ComplexKind mode = desk.state.document().settings().mode;
  draw_conflicts(desk);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ImGui::GetStyle().ItemSpacing.x, ui.px(1)));
  const auto& in_front = never_touch_demands();
  const auto is_in_front = [&](const DemandInfo& info) {
    return std::find(in_front.begin(), in_front.end(), info.name) != in_front.end();
  };
  if (mode == ComplexKind::Dual) {
    draw_never_touch(desk);
    ImGui::Indent(ui.px(25));
    for (const DemandInfo& info : demand_catalogue()) {
      if (is_in_front(info) && is_defined_for(info, mode)) draw_demand(desk, info);
    }
    ImGui::Unindent(ui.px(25));
    ui.gap(6);
  }
  bool any = false;
  for (const DemandInfo& info : demand_catalogue()) {
    if (!is_defined_for(info, mode) || (mode == ComplexKind::Dual && is_in_front(info))) continue;
    draw_demand(desk, info);
    any = true;
  }
  draw_other_rows(desk);
  ImGui::PopStyleVar();
  if (!any && mode != ComplexKind::Dual) ui.small_text("There is no demand for this mode.");
  ui.gap(4);
  draw_margin_and_side(desk);
}

}  // namespace planewright::ui
