#include "ui/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "core/edit/project_file.h"
#include "ui/format.h"
#include "ui/layer_edits.h"
#include "ui/leaving.h"

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

bool Actions::enabled(Action action) const {
  const bool has_design = !state_.document().empty();
  const bool has_clusters = has_design && state_.document().settings().mode == ComplexKind::Cluster;
  const bool has_findings = state_.finding_list().size() > 0;
  switch (action) {
    case Action::Save:
    case Action::SaveAs:
      return has_design && !state_.saving();
    case Action::Export:
      return state_.can_export();
    case Action::Undo:
      return state_.document().can_undo();
    case Action::Redo:
      return state_.document().can_redo();
    case Action::ModeDual:
    case Action::ModePlanarize:
    case Action::ModeCluster:
    case Action::SolveOrStop:
    case Action::SolveAfresh:
    case Action::Fit:
    case Action::ResetView:
      return has_design;
    case Action::Polish:
      return state_.can_polish();
    case Action::NextFinding:
    case Action::PreviousFinding:
      return has_findings;
    case Action::NextSuggestion:
    case Action::PreviousSuggestion:
      return state_.suggestion_list().size() > 0;
    case Action::ApplySuggestion:
      return state_.suggestion_at_hand() != nullptr;
    case Action::ApplyAllSuggestions:
      return !state_.suggestion_list().together.empty();
    case Action::LockRange:
      return state_.view_options.colours == ColourMap::Planarity ||
             state_.view_options.colours == ColourMap::Displacement;
    case Action::SelectBox:
    case Action::SelectAll:
    case Action::SelectBorder:
    case Action::SelectInverse:
      return has_design && state_.shown() != nullptr;
    case Action::SelectMore:
    case Action::SelectLess:
    case Action::SelectConnected:
    case Action::StoreSelection:
      return has_design && !state_.selection().empty();
    case Action::Pin:
    case Action::Unpin:
      return has_design && state_.shown() != nullptr &&
             (!state_.selection().empty() || state_.selected_point.has_value());
    case Action::AddLayer:
    case Action::DuplicateLayer:
    case Action::HideLayer:
      return has_design;
    case Action::SplitRegion:
    case Action::MergeRegions:
    case Action::PaintRegions:
      return has_clusters && state_.clusters() != nullptr;
    case Action::ClusterAnew:
    case Action::SightRegions:
    case Action::SightBeside:
    case Action::SightOver:
    case Action::SightPanels:
    case Action::NextSight:
      return has_clusters;
    case Action::RemoveLayer:
    case Action::NextLayer:
      return state_.layer_count() > 1;
    case Action::ClearSelection:
      return true;
    default:
      return true;
  }
}

bool Actions::checked(Action action) const {
  const ViewOptions& view = state_.view_options;
  switch (action) {
    case Action::ModeDual:
      return state_.document().settings().mode == ComplexKind::Dual;
    case Action::ModePlanarize:
      return state_.document().settings().mode == ComplexKind::Planarize;
    case Action::ModeCluster:
      return state_.document().settings().mode == ComplexKind::Cluster;
    case Action::SplitRegion:
      return state_.tool == Tool::Split;
    case Action::MergeRegions:
      return state_.tool == Tool::Merge;
    case Action::PaintRegions:
      return state_.tool == Tool::Paint;
    case Action::SightRegions:
      return view.cluster_sight == ClusterSight::Regions;
    case Action::SightBeside:
      return view.cluster_sight == ClusterSight::Beside;
    case Action::SightOver:
      return view.cluster_sight == ClusterSight::Over;
    case Action::SightPanels:
      return view.cluster_sight == ClusterSight::Panels;
    case Action::AutoSolve:
      return state_.auto_solve();
    case Action::AutoPolish:
      return state_.polish_automatically();
    case Action::Ghost:
      return view.ghost;
    case Action::Markers:
      return view.markers;
    case Action::PanelNames:
      return view.names;
    case Action::ColourNone:
      return view.colours == ColourMap::None;
    case Action::ColourPlanarity:
      return view.colours == ColourMap::Planarity;
    case Action::ColourDisplacement:
      return view.colours == ColourMap::Displacement;
    case Action::ColourTolerances:
      return view.colours == ColourMap::Tolerances;
    case Action::ColourFindings:
      return view.colours == ColourMap::Findings;
    case Action::LockRange:
      return view.lock_range;
    case Action::SelectBox:
      return state_.tool == Tool::Box;
    case Action::HideLayer:
      return state_.document().design().layers[static_cast<std::size_t>(state_.active_layer())].visible;
    case Action::Convergence:
      return window_.settings.convergence_open && !window_.settings.schedule_tab;
    case Action::Schedule:
      return window_.settings.convergence_open && window_.settings.schedule_tab;
    case Action::DarkTheme:
      return window_.settings.dark;
    case Action::Keys:
      return window_.show_keys;
    case Action::Timings:
      return window_.show_timings;
    default:
      return false;
  }
}

std::string Actions::label(Action action) const {
  const auto with_step = [&](const std::string& verb, std::string step) {
    if (step.empty()) return verb;
    step[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(step[0])));
    return verb + " " + step;
  };
  switch (action) {
    case Action::Undo:
      return with_step("Undo", state_.document().undo_name());
    case Action::Redo:
      return with_step("Redo", state_.document().redo_name());
    case Action::SolveOrStop:
      return state_.busy() ? "Stop" : "Solve";
    case Action::ApplySuggestion:
      if (const Suggestion* at_hand = state_.suggestion_at_hand())
        return state_.edit_name(at_hand->candidate.edit);
      return info(action).label;
    case Action::ApplyAllSuggestions: {
      const auto count = static_cast<std::int64_t>(state_.suggestion_list().together.size());
      return info(action).label + (count > 0 ? " (" + format_count(count) + ")" : "");
    }
    default:
      return info(action).label;
  }
}

// The dialog lies over the model: its keys rest, but for what concerns the dialog too.
bool Actions::rests(Action action) const {
  return window_.export_dialog.open && action != Action::Undo && action != Action::Redo &&
         action != Action::ClearSelection && action != Action::ExportWorkshop &&
         action != Action::DarkTheme && action != Action::Quit;
}

bool Actions::press(const KeyPress& key) {
  for (const ActionInfo& candidate : action_list()) {
    if (std::find(candidate.keys.begin(), candidate.keys.end(), key) == candidate.keys.end()) continue;
    if (enabled(candidate.action) && !rests(candidate.action)) request(candidate.action);
    return true;
  }
  return false;
}

void Actions::apply_requested() {
  for (const Action action : std::exchange(requested_, {})) {
    if (enabled(action)) run(action);
  }
}

// A preset of the mode before that means nothing in this one gives way to this one's own; weights that the
// designer set himself stay.
void Actions::set_mode(ComplexKind mode) {
  LayerSettings settings = state_.document().settings();
  const bool had_preset = present_preset(settings) != nullptr;
  const bool clusters = mode == ComplexKind::Cluster, had_clusters = settings.mode == ComplexKind::Cluster;
  settings.mode = mode;
  if (clusters != had_clusters && had_preset) {
    const auto preset = find_preset(clusters ? "proxy-planes" : "close-to-design");
    const Result<void> applied = preset ? planewright::apply(**preset, settings) : Result<void>();
    if (!preset || !applied) state_.post(preset ? applied.error() : preset.error());
  }
  const int off = switch_off_undefined(settings);
  if (off > 0) {
    state_.post(Message::Kind::Info, format_count(off, "demand means", "demands mean") +
                                         " nothing in this mode and " + (off == 1 ? "is" : "are") + " off");
  }
  state_.change_settings(std::move(settings), mode == ComplexKind::Dual        ? "Mode dual"
                                              : mode == ComplexKind::Planarize ? "Mode planarize"
                                                                               : "Mode cluster");
}

// Once more puts it away. Tools that change regions need these in sight.
void Actions::take_tool(Tool tool) {
  state_.tool = state_.tool == tool ? Tool::Look : tool;
  ClusterSight& sight = state_.view_options.cluster_sight;
  if (changes_regions(state_.tool) && sight == ClusterSight::Panels) sight = ClusterSight::Beside;
}

void Actions::change_selection(Action action) {
  const PolygonMesh& mesh = *state_.document().mesh();
  const ComplexKind kind = state_.shown()->complex().kind;
  const SelectWhat what = state_.select_what;
  Selection next;
  switch (action) {
    case Action::SelectAll:
      next = everything(mesh, kind, what);
      break;
    case Action::SelectBorder:
      next = along_border(mesh, kind, what, border_edges(mesh));
      if (next.empty()) {
        state_.post(Message::Kind::Info, "this design has no border");
        return;
      }
      break;
    case Action::SelectInverse:
      next = inverted(mesh, kind, what, state_.selection());
      break;
    case Action::SelectMore:
      next = grown(mesh, state_.selection());
      break;
    case Action::SelectLess:
      next = shrunk(mesh, state_.selection());
      break;
    default:
      next = whole_components(mesh, state_.selection());
      break;
  }
  state_.clear_selection();
  state_.select(std::move(next), Combine::Replace);
}

void Actions::run(Action action) {
  ViewOptions& view = state_.view_options;
  switch (action) {
    case Action::Open:
      window_.browser.open(FileBrowser::Purpose::Open, window_.settings.last_folder);
      break;
    case Action::Save:
      if (!state_.project_path().empty()) {
        state_.save_project(state_.project_path());
        break;
      }
      [[fallthrough]];
    case Action::SaveAs: {
      const std::filesystem::path& path = state_.project_path();
      const std::string stem =
          (path.empty() ? std::filesystem::path(state_.document().name()) : path).stem().string();
      window_.browser.open(
          FileBrowser::Purpose::SaveProject,
          path.empty() ? std::filesystem::path(window_.settings.last_folder) : path.parent_path(),
          stem + std::string(kProjectEnding));
      break;
    }
    case Action::Export: {
      std::string stem = std::filesystem::path(state_.document().name()).stem().string();
      window_.browser.open(FileBrowser::Purpose::ExportPanels, window_.settings.last_folder,
                           stem + "-panels.obj");
      break;
    }
    case Action::ExportWorkshop:
      window_.export_dialog_wanted = true;
      break;
    case Action::Quit:
      leave(window_, state_, {Leaving::What::Quit, {}});
      break;
    case Action::Undo:
      state_.undo();
      break;
    case Action::Redo:
      state_.redo();
      break;
    case Action::ModeDual:
      set_mode(ComplexKind::Dual);
      break;
    case Action::ModePlanarize:
      set_mode(ComplexKind::Planarize);
      break;
    case Action::ModeCluster:
      set_mode(ComplexKind::Cluster);
      break;
    case Action::SolveOrStop:
      if (state_.busy()) {
        state_.stop();
      } else {
        state_.solve();
      }
      break;
    case Action::SolveAfresh:
      state_.solve(AppState::Start::Afresh);
      break;
    case Action::AutoSolve:
      state_.set_auto_solve(!state_.auto_solve());
      window_.settings.auto_solve = state_.auto_solve();
      break;
    case Action::Polish:
      state_.polish();
      break;
    case Action::AutoPolish:
      state_.set_polish_automatically(!state_.polish_automatically());
      window_.settings.polish_automatically = state_.polish_automatically();
      break;
    case Action::Fit:
      window_.fit_wanted = true;
      break;
    case Action::ResetView:
      window_.reset_view_wanted = true;
      break;
    case Action::Ghost:
      view.ghost = !view.ghost;
      window_.settings.show_ghost = view.ghost;
      break;
    case Action::Markers:
      view.markers = !view.markers;
      break;
    case Action::PanelNames:
      view.names = !view.names;
      break;
    case Action::ColourCycle:
      view.colours = view.colours == ColourMap::None           ? ColourMap::Planarity
                     : view.colours == ColourMap::Planarity    ? ColourMap::Displacement
                     : view.colours == ColourMap::Displacement ? ColourMap::Findings
                     : view.colours == ColourMap::Findings     ? ColourMap::Tolerances
                                                               : ColourMap::None;
      break;
    case Action::ColourNone:
      view.colours = ColourMap::None;
      break;
    case Action::ColourPlanarity:
      view.colours = ColourMap::Planarity;
      break;
    case Action::ColourDisplacement:
      view.colours = ColourMap::Displacement;
      break;
    case Action::ColourFindings:
      view.colours = ColourMap::Findings;
      break;
    case Action::ColourTolerances:
      view.colours = ColourMap::Tolerances;
      break;
    case Action::LockRange:
      view.lock_range = !view.lock_range;
      break;
    case Action::Convergence:
    case Action::Schedule: {  // what is open closes, else it comes to the front
      const bool was_open = checked(action);
      window_.settings.convergence_open = !was_open;
      window_.settings.schedule_tab = action == Action::Schedule;
      break;
    }
    case Action::DarkTheme:
      window_.settings.dark = !window_.settings.dark;
      break;
    case Action::NextFailure:
    case Action::PreviousFailure:
      // What fails is known once the workshop is in sight.
      state_.walk_failures(action == Action::NextFailure ? 1 : -1);
      window_.right_tab = 2;
      break;
    case Action::NextFinding:
      state_.walk_findings(1);
      window_.right_tab = 0;
      break;
    case Action::PreviousFinding:
      state_.walk_findings(-1);
      window_.right_tab = 0;
      break;
    case Action::NextSuggestion:
      state_.walk_suggestions(1);
      window_.right_tab = 0;
      break;
    case Action::PreviousSuggestion:
      state_.walk_suggestions(-1);
      window_.right_tab = 0;
      break;
    case Action::ApplySuggestion:
      state_.apply_suggestion(*state_.suggestion_at_hand());
      break;
    case Action::ApplyAllSuggestions:
      state_.apply_all_suggestions();
      break;
    case Action::ClearSelection:
      if (window_.show_keys || window_.show_about) {
        window_.show_keys = window_.show_about = false;
      } else if (window_.export_dialog.open) {
        window_.export_dialog.open = false;
      } else if (state_.tool != Tool::Look) {
        state_.tool = Tool::Look;
      } else {
        state_.clear_selection();
      }
      break;
    case Action::SelectBox:
      take_tool(Tool::Box);
      break;
    case Action::SplitRegion:
      take_tool(Tool::Split);
      break;
    case Action::MergeRegions:
      take_tool(Tool::Merge);
      break;
    case Action::PaintRegions:
      take_tool(Tool::Paint);
      break;
    case Action::ClusterAnew:
      state_.cluster_anew();
      break;
    case Action::SightRegions:
      view.cluster_sight = ClusterSight::Regions;
      break;
    case Action::SightBeside:
      view.cluster_sight = ClusterSight::Beside;
      break;
    case Action::SightOver:
      view.cluster_sight = ClusterSight::Over;
      break;
    case Action::SightPanels:
      view.cluster_sight = ClusterSight::Panels;
      break;
    case Action::NextSight:
      view.cluster_sight = view.cluster_sight == ClusterSight::Regions  ? ClusterSight::Beside
                           : view.cluster_sight == ClusterSight::Beside ? ClusterSight::Over
                           : view.cluster_sight == ClusterSight::Over   ? ClusterSight::Panels
                                                                        : ClusterSight::Regions;
      break;
    case Action::SelectAll:
    case Action::SelectBorder:
    case Action::SelectInverse:
    case Action::SelectMore:
    case Action::SelectLess:
    case Action::SelectConnected:
      change_selection(action);
      break;
    case Action::StoreSelection:
      state_.store_selection();
      break;
    case Action::Pin:
      state_.pin_selection();
      break;
    case Action::Unpin:
      state_.unpin_selection();
      break;
    case Action::AddLayer:
      state_.add_layer();
      break;
    case Action::DuplicateLayer:
      state_.duplicate_layer(state_.active_layer());
      break;
    case Action::RemoveLayer:
      state_.remove_layer(state_.active_layer());
      break;
    case Action::NextLayer:
      state_.set_active_layer((state_.active_layer() + 1) % state_.layer_count());
      break;
    case Action::HideLayer: {
      Layer layer = state_.document().design().layers[static_cast<std::size_t>(state_.active_layer())];
      layer.visible = !layer.visible;
      std::string what = (layer.visible ? "Show " : "Hide ") + layer.name;
      state_.change_layer(state_.active_layer(), std::move(layer), std::move(what));
      break;
    }
    case Action::Keys:
      window_.show_keys = !window_.show_keys;
      break;
    case Action::Timings:
      window_.show_timings = !window_.show_timings;
      break;
    case Action::About:
      window_.show_about = !window_.show_about;
      break;
  }
}

void show_element(AppState& state, WindowState& window, const ElementRef& element) {
  state.show_element(element);
  window.right_tab = 0;
}

}  // namespace planewright::ui
