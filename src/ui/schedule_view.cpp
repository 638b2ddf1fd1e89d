#include "ui/schedule_view.h"

#include <algorithm>

#include "ui/format.h"

namespace planewright::ui {

std::string why_no_schedule(const AppState& state) {
  if (state.document().empty()) return "No panels yet: open a mesh.";
  if (!state.shown())
    return state.busy() ? "Known when the solve has come to panels." : "No panels yet. Space solves.";
  if (const auto& error = state.workshop_error()) {
    std::string text = capitalised(error->what) + ".";
    if (!error->where.empty()) text = error->where + ": " + error->what + ".";
    return error->remedy.empty() ? text : text + " " + error->remedy;
  }
  if (!state.workshop()) return "Known when the panels are measured …";
  return {};
}

void ScheduleView::update(const AppState& state) {
  bool stale = made_for_ != query;
  if (const auto workshop = state.workshop(); workshop != schedule_.from) {
    schedule_ = make_schedule(workshop, &schedule_);
    stale = true;
  }
  const SelectionKey key(state.selection_changes(), state.document().revision());
  if (selected_for_ != key || selected_of_.lock() != state.shown()) {
    selected_for_ = key;
    selected_of_ = state.shown();
    std::vector<bool> selected;
    if (state.shown()) {
      const TangentComplex& complex = state.shown()->complex();
      selected.assign(static_cast<std::size_t>(complex.plane_count()), false);
      for (const int panel : panels_named(complex, state.of_shown(state.selection())))
        selected[static_cast<std::size_t>(panel)] = true;
    }
    stale = stale || (query.only_selected && selected != selected_);
    selected_ = std::move(selected);
  }
  if (!stale) return;
  rearranged_ = rearranged_ || made_for_ != query;
  made_for_ = query;
  list_ = make_schedule_list(schedule_, query, selected_);
  ++made_;
}

std::optional<int> ScheduleView::row_of(int panel) const {
  const auto found = std::find(list_.panels.begin(), list_.panels.end(), panel);
  return found == list_.panels.end() ? std::nullopt
                                     : std::optional(static_cast<int>(found - list_.panels.begin()));
}

void ScheduleView::click(AppState& state, int row, bool ctrl, bool shift) {
  if (row < 0 || row >= list_.size()) return;
  const int panel = list_.panels[static_cast<std::size_t>(row)];
  if (const auto from = shift && anchor_ ? row_of(*anchor_) : std::nullopt; from && state.shown()) {
    const auto first = list_.panels.begin() + std::min(*from, row);
    const auto last = list_.panels.begin() + std::max(*from, row) + 1;
    state.select_panel(panel, Combine::Add);  // what is pointed at
    state.select(state.of_present(named_panels(state.shown()->complex(), std::vector<int>(first, last))),
                 Combine::Add);
    return;
  }
  anchor_ = panel;
  const bool add = ctrl || shift;
  state.select_panel(panel, !add                      ? Combine::Replace
                            : ctrl && selected(panel) ? Combine::Remove
                                                      : Combine::Add);
}

}  // namespace planewright::ui
