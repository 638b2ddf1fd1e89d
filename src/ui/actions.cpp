#include "ui/actions.h"

#include <algorithm>
#include <utility>

#include "core/edit/project_file.h"
#include "ui/format.h"
#include "ui/layer_edits.h"
#include "ui/leaving.h"

namespace planewright::ui {

// The dialog lies over the model: its keys rest, but for what concerns the dialog too.
bool Actions::rests(Action action) const {
  return window_.export_dialog.open && action != Action::Undo && action != Action::Redo &&
         action != Action::ClearSelection && action != Action::ExportWorkshop &&
         action != Action::DarkTheme && action != Action::Save && action != Action::Quit;
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
