// The actions of the window: what each is called, and its keys. Menus, buttons, the card of keys, keys and
// scripts all take them from here.
//
// Threads: plain values that never change.
#pragma once

#include <string>
#include <vector>

namespace planewright::ui {

enum class Action {
  Open,
  Save,
  SaveAs,
  Export,
  ExportWorkshop,
  Quit,
  Undo,
  Redo,
  ModeDual,
  ModePlanarize,
  ModeCluster,
  SolveOrStop,
  SolveAfresh,
  AutoSolve,
  Polish,
  AutoPolish,
  Fit,
  ResetView,
  Ghost,
  Markers,
  PanelNames,
  ColourCycle,
  ColourNone,
  ColourPlanarity,
  ColourDisplacement,
  ColourFindings,
  ColourTolerances,
  LockRange,
  Convergence,
  Schedule,
  DarkTheme,
  NextFinding,
  PreviousFinding,
  NextFailure,
  PreviousFailure,
  NextSuggestion,
  PreviousSuggestion,
  ApplySuggestion,
  ApplyAllSuggestions,
  ClearSelection,
  SelectBox,
  SelectAll,
  SelectBorder,
  SelectInverse,
  SelectMore,
  SelectLess,
  SelectConnected,
  StoreSelection,
  Pin,
  Unpin,
  AddLayer,
  DuplicateLayer,
  RemoveLayer,
  NextLayer,
  HideLayer,
  SplitRegion,
  MergeRegions,
  PaintRegions,
  ClusterAnew,
  SightRegions,
  SightBeside,
  SightOver,
  SightPanels,
  NextSight,
  Keys,
  Timings,
  About,
};

// A key as the layout of the keyboard names it (GLFW_KEY_*), pressed once.
struct KeyPress {
  int key = 0;
  bool ctrl = false, shift = false, alt = false;
  bool operator==(const KeyPress&) const = default;
};

struct ActionInfo {
  Action action;
  std::string name;      // "undo": in records, scripts
  std::string label;     // as a menu shows it
  std::string shortcut;  // "Ctrl Z"
  std::vector<KeyPress> keys;
};

const std::vector<ActionInfo>& action_list();
const ActionInfo& info(Action action);
// Whether a menu shows it with a tick: Actions::checked().
bool is_toggle(Action action);

}  // namespace planewright::ui
