#include "ui/action_list.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace planewright::ui {

const std::vector<ActionInfo>& action_list() {
  const auto key = [](int k) { return KeyPress{k, false, false, false}; };
  const auto ctrl = [](int k, bool shift = false) { return KeyPress{k, true, shift, false}; };
  const auto shifted = [](int k) { return KeyPress{k, false, true, false}; };
  static const std::vector<ActionInfo> list = {
      {Action::Open, "open", "Open…", "Ctrl O", {ctrl(GLFW_KEY_O)}},
      {Action::Save, "save", "Save", "Ctrl S", {ctrl(GLFW_KEY_S)}},
      {Action::SaveAs, "save as", "Save as…", "Ctrl Shift S", {ctrl(GLFW_KEY_S, true)}},
      {Action::Export, "export", "Save panels as mesh…", "Ctrl E", {ctrl(GLFW_KEY_E)}},
      {Action::ExportWorkshop,
       "export workshop",
       "Export for the workshop…",
       "Ctrl Shift E",
       {ctrl(GLFW_KEY_E, true)}},
      {Action::Quit, "quit", "Quit", "Ctrl Q", {ctrl(GLFW_KEY_Q)}},
      {Action::Undo, "undo", "Undo", "Ctrl Z", {ctrl(GLFW_KEY_Z)}},
      {Action::Redo, "redo", "Redo", "Ctrl Shift Z", {ctrl(GLFW_KEY_Z, true), ctrl(GLFW_KEY_Y)}},
      {Action::ModeDual, "mode dual", "Dual", "1", {key(GLFW_KEY_1), key(GLFW_KEY_KP_1)}},
      {Action::ModePlanarize, "mode planarize", "Planarize", "2", {key(GLFW_KEY_2), key(GLFW_KEY_KP_2)}},
      {Action::ModeCluster, "mode cluster", "Cluster", "3", {key(GLFW_KEY_3), key(GLFW_KEY_KP_3)}},
      {Action::SolveOrStop, "solve or stop", "Solve", "Space", {key(GLFW_KEY_SPACE)}},
      {Action::SolveAfresh,
       "solve afresh",
       "Solve from the beginning",
       "Shift Space",
       {shifted(GLFW_KEY_SPACE)}},
      {Action::AutoSolve, "auto solve", "Solve at every change", "", {}},
      {Action::Polish, "polish", "Polish with Ipopt", "I", {key(GLFW_KEY_I)}},
      {Action::AutoPolish, "auto polish", "Polish automatically", "", {}},
      {Action::Fit, "fit", "Fit the model", "F", {key(GLFW_KEY_F)}},
      {Action::ResetView, "reset view", "Standard view", "Home", {key(GLFW_KEY_HOME)}},
      {Action::Ghost, "ghost", "Ghost of the input", "G", {key(GLFW_KEY_G)}},
      {Action::Markers, "markers", "Mark findings", "M", {key(GLFW_KEY_M)}},
      {Action::PanelNames, "panel names", "Names of the panels", "Y", {key(GLFW_KEY_Y)}},
      {Action::ColourCycle, "colour map", "Next colour map", "C", {key(GLFW_KEY_C)}},
      {Action::ColourNone, "colours none", "Plain card", "", {}},
      {Action::ColourPlanarity, "colours planarity", "Colour by planarity", "", {}},
      {Action::ColourDisplacement, "colours displacement", "Colour by displacement", "", {}},
      {Action::ColourFindings, "colours findings", "Colour by findings", "", {}},
      {Action::ColourTolerances, "colours tolerances", "Colour by tolerances", "", {}},
      {Action::LockRange, "lock range", "Lock the colours' range", "L", {key(GLFW_KEY_L)}},
      {Action::Convergence, "convergence", "Convergence plot", "V", {key(GLFW_KEY_V)}},
      {Action::Schedule, "schedule", "Schedule of the panels", "E", {key(GLFW_KEY_E)}},
      {Action::DarkTheme, "dark theme", "Dark theme", "D", {key(GLFW_KEY_D)}},
      {Action::NextFinding, "next finding", "Next finding", "N", {key(GLFW_KEY_N)}},
      {Action::PreviousFinding, "previous finding", "Previous finding", "Shift N", {shifted(GLFW_KEY_N)}},
      {Action::NextFailure, "next failure", "Next failure of a limit", "W", {key(GLFW_KEY_W)}},
      {Action::PreviousFailure,
       "previous failure",
       "Previous failure of a limit",
       "Shift W",
       {shifted(GLFW_KEY_W)}},
      {Action::NextSuggestion, "next suggestion", "Next suggestion", "S", {key(GLFW_KEY_S)}},
      {Action::PreviousSuggestion,
       "previous suggestion",
       "Previous suggestion",
       "Shift S",
       {shifted(GLFW_KEY_S)}},
      {Action::ApplySuggestion,
       "apply suggestion",
       "Apply the suggestion",
       "Enter",
       {key(GLFW_KEY_ENTER), key(GLFW_KEY_KP_ENTER)}},
      {Action::ApplyAllSuggestions,
       "apply all suggestions",
       "Apply all that gain",
       "Ctrl Enter",
       {ctrl(GLFW_KEY_ENTER), ctrl(GLFW_KEY_KP_ENTER)}},
      {Action::ClearSelection, "clear selection", "Clear the selection", "Esc", {key(GLFW_KEY_ESCAPE)}},
      {Action::SelectBox, "select box", "Select by a box", "B", {key(GLFW_KEY_B)}},
      {Action::SelectAll, "select all", "Select all", "Ctrl A", {ctrl(GLFW_KEY_A)}},
      {Action::SelectBorder, "select border", "Select the border", "Shift B", {shifted(GLFW_KEY_B)}},
      {Action::SelectInverse, "select inverse", "Invert the selection", "Ctrl I", {ctrl(GLFW_KEY_I)}},
      {Action::SelectMore,
       "select more",
       "Grow the selection",
       "+",
       {key(GLFW_KEY_EQUAL), key(GLFW_KEY_KP_ADD), shifted(GLFW_KEY_EQUAL), key(GLFW_KEY_RIGHT_BRACKET)}},
      {Action::SelectLess,
       "select less",
       "Shrink the selection",
       "−",
       {key(GLFW_KEY_MINUS), key(GLFW_KEY_KP_SUBTRACT), key(GLFW_KEY_SLASH)}},
      {Action::SelectConnected, "select connected", "Select all that is connected", "", {}},
      {Action::StoreSelection, "store selection", "Store the selection", "", {}},
      {Action::Pin, "pin", "Pin what is selected", "P", {key(GLFW_KEY_P)}},
      {Action::Unpin, "unpin", "Unpin what is selected", "Shift P", {shifted(GLFW_KEY_P)}},
      {Action::AddLayer, "add layer", "Add a layer", "", {}},
      {Action::DuplicateLayer, "duplicate layer", "Duplicate the layer", "", {}},
      {Action::RemoveLayer, "remove layer", "Remove the layer", "", {}},
      {Action::NextLayer, "next layer", "Next layer", "Tab", {key(GLFW_KEY_TAB)}},
      {Action::HideLayer, "hide layer", "Show or hide the layer", "H", {key(GLFW_KEY_H)}},
      {Action::SplitRegion, "split region", "Split a region", "X", {key(GLFW_KEY_X)}},
      {Action::MergeRegions, "merge regions", "Merge two regions", "J", {key(GLFW_KEY_J)}},
      {Action::PaintRegions, "paint regions", "Paint regions", "R", {key(GLFW_KEY_R)}},
      {Action::ClusterAnew, "cluster anew", "Cluster anew", "K", {key(GLFW_KEY_K)}},
      {Action::SightRegions, "sight regions", "The input in regions", "", {}},
      {Action::SightBeside, "sight beside", "Input and panels side by side", "", {}},
      {Action::SightOver, "sight over", "Panels over the input", "", {}},
      {Action::SightPanels, "sight panels", "The panels alone", "", {}},
      {Action::NextSight, "next sight", "Next view of the clusters", "T", {key(GLFW_KEY_T)}},
      {Action::Keys, "keys", "All keys", "? or F1", {key(GLFW_KEY_F1)}},
      {Action::Timings, "timings", "Timings", "", {}},
      {Action::About, "about", "About Planewright", "", {}},
  };
  return list;
}

const ActionInfo& info(Action action) {
  const auto& list = action_list();
  return *std::find_if(list.begin(), list.end(), [&](const ActionInfo& i) { return i.action == action; });
}

bool is_toggle(Action action) {
  switch (action) {
    case Action::AutoSolve:
    case Action::Ghost:
    case Action::Markers:
    case Action::LockRange:
    case Action::Convergence:
    case Action::Schedule:
    case Action::DarkTheme:
    case Action::HideLayer:
    case Action::SelectBox:
    case Action::ModeDual:
    case Action::ModePlanarize:
    case Action::ModeCluster:
    case Action::SplitRegion:
    case Action::MergeRegions:
    case Action::PaintRegions:
    case Action::SightRegions:
    case Action::SightBeside:
    case Action::SightOver:
    case Action::SightPanels:
    case Action::ColourNone:
    case Action::ColourPlanarity:
    case Action::ColourDisplacement:
    case Action::ColourFindings:
    case Action::ColourTolerances:
    case Action::PanelNames:
      return true;
    default:
      return false;
  }
}

}  // namespace planewright::ui
