// ScheduleView: the schedule of what is shown, as the window has it: remade only when the panels, the
// selection or what is asked of it are others, so that a frame costs next to nothing.
//
// Threads: the window's.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ui/app_state.h"
#include "ui/schedule.h"

namespace planewright::ui {

// Why there is nothing to list, for the designer; empty: there are panels that are known.
std::string why_no_schedule(const AppState& state);

class ScheduleView {
 public:
  ScheduleQuery query;

  // Once a frame that shows it.
  void update(const AppState& state);

  const Schedule& schedule() const { return schedule_; }
  const ScheduleList& list() const { return list_; }
  bool selected(int panel) const {
    return static_cast<std::size_t>(panel) < selected_.size() && selected_[static_cast<std::size_t>(panel)];
  }
  // Where the panel stands in the list; none: it is not listed.
  std::optional<int> row_of(int panel) const;
  // True once after another order, filter or switch: what was in sight is elsewhere now.
  bool take_rearranged() { return std::exchange(rearranged_, false); }
  // How often the list was made.
  int made() const { return made_; }

  // A click on a row: alone; with ctrl, in or out of the selection; with shift, with all rows from the one
  // that was clicked last.
  void click(AppState& state, int row, bool ctrl, bool shift);

 private:
  using SelectionKey = std::pair<std::uint64_t, std::uint64_t>;  // changes of it, and of the document

  Schedule schedule_;
  std::vector<bool> selected_;
  ScheduleList list_;
  std::optional<ScheduleQuery> made_for_;
  std::optional<SelectionKey> selected_for_;
  std::weak_ptr<const PreparedView> selected_of_;
  std::optional<int> anchor_;  // panel
  bool rearranged_ = false;
  int made_ = 0;
};

}  // namespace planewright::ui
