// How the actions stand: whether each can be done now, is on, and what it is called now.
#include <cctype>

#include "ui/actions.h"
#include "ui/format.h"

namespace planewright::ui {

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

}  // namespace planewright::ui
