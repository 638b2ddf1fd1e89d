// The parts of the window round the model, one file each. Every function draws its part into the given
// rectangle, changes the design through AppState, and asks for everything else through Actions.
//
// Threads: the window's, inside a Dear ImGui frame.
#pragma once

#include "ui/actions.h"
#include "ui/app_state.h"
#include "ui/layout.h"
#include "ui/widgets.h"
#include "ui/window_state.h"

namespace planewright::ui {

// What every part needs.
struct Desk {
  Ui& ui;
  AppState& state;
  WindowState& window;
  Actions& actions;
};

float draw_menu_bar(Desk& desk);  // returns its height
void draw_toolbar(Desk& desk, const Rect& place);
void draw_design_panel(Desk& desk, const Rect& place);    // left: mode, offset, weights, solve
void draw_findings_panel(Desk& desk, const Rect& place);  // right: findings, report, selection
void draw_bottom_panel(Desk& desk, const Rect& place);    // below the model: convergence, schedule
void draw_status_bar(Desk& desk, const Rect& place);
void draw_splitters(Desk& desk, const Layout& layout);

// Over the model.
void draw_solve_badge(Desk& desk, const Rect& viewport);  // how the solve stands, and the polish
void draw_hint(Desk& desk, const Rect& viewport);         // what to try at first
void draw_messages(Desk& desk, const Rect& viewport);     // errors and notices; they wait for nobody
void draw_leaving(Desk& desk);                            // what is to become of unsaved changes
void draw_help_cards(Desk& desk);                         // keys, timings, about

// Edits of the mesh, as lines of an open menu, and as a menu of their own at the mouse; all steps so far.
void draw_edit_choices(Desk& desk, const EditTarget& target);
void open_context_menu(Desk& desk, const EditTarget& target);
void draw_context_menu(Desk& desk);
void draw_history(Desk& desk);

// The tabs of the panel below the model: what stands in its head line, right of the tabs, and what below.
void draw_convergence(Desk& desk, const Rect& head, const Rect& body);
void draw_schedule(Desk& desk, const Rect& head, const Rect& body);

// The sections of the left panel, one file each.
void draw_presets(Desk& desk);
void draw_weights(Desk& desk);
void draw_demands(Desk& desk);
// One word on all demands, for the section's title.
struct DemandSummary {
  std::string text;
  ImU32 colour;
};
DemandSummary demand_summary(const Desk& desk);
// The clusters in the left panel, one line on them for the section's title, and what came of them for the
// report.
void draw_clusters(Desk& desk);
std::string clusters_summary(const Desk& desk);
void draw_cluster_report(Desk& desk);
// The workshop in the right panel, and its terms. A new design begins with the unit that was set last.
void draw_workshop(Desk& desk);
void draw_contract(Desk& desk);
void draw_panel_terms(Desk& desk);  // thickness, gap, density, each a step of undo
void draw_tolerances(Desk& desk);
std::string tolerances_summary(const Desk& desk);
void draw_failures(Desk& desk);
void set_unit(Desk& desk, LengthUnit unit);
// What a pixel of a drag changes a length by: about a thousandth of the model, as a round number.
double length_step(const Desk& desk);

// The suggestions, for the right panel, and how many there are, for the section's title; what one gains, as a
// tooltip, and as lines of one.
void draw_suggestions(Desk& desk);
std::string suggestions_summary(const Desk& desk);
void explain_suggestion(Ui& ui, const AppState& state, const Suggestion& suggestion);
void draw_gain_parts(Ui& ui, const Suggestion& suggestion);

// The list of findings, for the right panel; and the colour that stands for a severity.
void draw_finding_list(Desk& desk);
ImU32 severity_colour(const Ui& ui, double severity);
// From which measure on a place is a finding, likewise.
void draw_limits(Desk& desk);
std::string limits_summary(const Desk& desk);
// The two halves of the right panel that other parts do not need to know.
void draw_energy_table(Desk& desk);
void draw_report(Desk& desk);
void draw_selection(Desk& desk);
void draw_pins(Desk& desk);
// The layers in the left panel, and one line on them for the section's title.
void draw_layers(Desk& desk);
std::string layers_summary(const Desk& desk);

// An opaque, fixed window in which a part is drawn; false if it is too small to bother.
bool begin_part(const char* name, const Rect& place, ImVec2 padding, ImGuiWindowFlags flags = 0);
void end_part();
// A thin line on one side of a part, drawn by its window.
enum class Side { Left, Right, Top, Bottom };
void draw_rim(Ui& ui, const Rect& place, Side side);

}  // namespace planewright::ui
