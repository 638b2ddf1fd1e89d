// Findings and elements of the shown panels in words: what they are called, and what was measured in the unit
// that the designer chose.
//
// Units: model units; `unit` is their name. Threads: pure functions.
#pragma once

#include <string>

#include "core/edit/document.h"
#include "ui/view_preparer.h"

namespace planewright::ui {

class AppState;

// What decides whether there can be a list of findings.
struct FindingsStanding {
  bool panels = false;                     // any are shown
  bool solving = false, finished = false;  // a solve runs; one of this design has ended
  const Diagnosis* diagnosis = nullptr;    // of the panels that are shown; null: not known yet
  double mean_edge = 0.0;
};
FindingsStanding findings_standing(const AppState& state);
// Why there is none, a sentence or two; empty: there is one.
std::string why_no_findings(const FindingsStanding& standing, const std::string& unit);

// "Panel 17", "Corner in face 12", "Edge of panels 3, 4": by numbers that outlive edits of the mesh.
// layer: of the document, whose panels are shown.
std::string element_name(const Document& document, int layer, const PreparedView& shown,
                         const ElementRef& element);
// "Corner in face 12"; ids: of the mesh that `origin` is of, null: its indices are taken.
std::string corner_name(const PointOrigin& origin, const ElementIds* ids);
// Of a finding, short: its element, and the second one; of an edge its panels: "Panels 3, 4".
std::string place_name(const Document& document, int layer, const PreparedView& shown,
                       const Finding& finding);
// The number alone; -1: there is none.
int panel_number(const Document& document, int layer, const PreparedView& shown, int panel);

// "0.35 m", "2.1 m/°", "not held", "12°", "8 %": lengths in model units.
std::string measure_text(double measure, const std::string& finding_unit, double mean_edge,
                         const std::string& unit);
// "0.12 edges, the limit is 0.15 edges": as it was measured.
std::string limit_text(const Finding& finding);
// "blemish", "hard to build", "not to be built as it is"
const char* severity_word(double severity);
inline constexpr double kHardToBuild = 0.3, kNotToBeBuilt = 0.7;
// "Reversed edges": all of a kind.
std::string kind_title(FindingKind kind);
// "reversed edge": one. The window calls points corners.
std::string kind_name(FindingKind kind);

}  // namespace planewright::ui
