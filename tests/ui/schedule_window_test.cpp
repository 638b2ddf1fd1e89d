// The schedule in the real window, driven by scripts with a mouse and keys.
#include "support/window_fixture.h"

namespace planewright {
namespace {

// A solved dome with its schedule open.
std::string schedule_of_dome(int panels) {
  return "sample dome " + std::to_string(panels) + R"(
    wait_loaded 20
    wait_solved 100
    key E
    wait_frames 3
    wait_solved 60
    wait_frames 3
)";
}

TEST_F(WindowTest, OpensTheScheduleBesideTheConvergence) {
  const Playback run = play(R"(
    sample dome 60
    wait_loaded 20
    wait_solved 100
    # Nothing of it is made while it is out of sight.
    expect schedule_rows == none
    click "Bottom/tab Schedule"
    wait_frames 3
    wait_solved 60
    wait_frames 3
    remember panels panels
    expect schedule_rows == $panels
    expect schedule_text == ""
    expect schedule_sort == "name ascending"
    screenshot PICTURES/schedule.png
    # The key closes it and opens it again; the menu knows both.
    key E
    wait_frames 3
    expect "ui:Schedule/filter" == absent
    key E
    wait_frames 3
    expect "ui:Schedule/filter" == enabled
    key V
    wait_frames 3
    expect "ui:Schedule/filter" == absent
    key V
    wait_frames 3
    click "Bottom/tab Schedule"
    wait_frames 3
    click "Bottom/toggle"
    wait_frames 3
    expect "ui:Schedule/filter" == absent
    click Menu/View
    wait_frames 3
    click Menu/View/schedule
    wait_frames 3
    expect "ui:Schedule/filter" == enabled
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  // It is there again at the next start.
  const Playback again = play(R"(
    sample dome 60
    wait_loaded 20
    wait_solved 100
    wait_frames 5
    expect "ui:Schedule/filter" == enabled
    remember panels panels
    expect schedule_rows == $panels
  )");
  EXPECT_EQ(again.status, 0) << again.output;
}

TEST_F(WindowTest, OrdersTheScheduleByAClickOnAColumn) {
  const Playback run = play(schedule_of_dome(60) + R"(
    expect schedule.0.name == A-01
    remember schedule_made made
    click "Schedule/column area"
    wait_frames 3
    expect schedule_sort == "area ascending"
    remember schedule.0.area smallest
    click "Schedule/column area"
    wait_frames 3
    expect schedule_sort == "area descending"
    expect schedule.0.area > $smallest
    remember schedule.0.area largest
    expect schedule.1.area <= $largest
    # The last column can be far to the right.
    click "Schedule/column verdict"
    wait_frames 3
    expect schedule_sort == "verdict ascending"
    # The list is made when something changes, not in every frame.
    remember schedule_made made
    wait_frames 20
    expect schedule_made == $made
  )",
                            "", 240, "1000x800");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, FiltersTheScheduleByTyping) {
  const Playback run = play(schedule_of_dome(60) + R"(
    remember schedule_rows all
    click "Schedule/filter"
    wait_frames 3
    type "a-0"
    wait_frames 3
    expect schedule_rows < $all
    expect schedule_rows > 0
    expect schedule.0.name contains "A-0"
    # The cross clears it.
    click "Schedule/clear filter"
    wait_frames 3
    expect schedule_rows == $all
    click "Schedule/filter"
    wait_frames 3
    type "edgy<3"
    wait_frames 3
    expect schedule_filter_error contains "'edgy<3': columns are "
    expect schedule_rows == $all
    screenshot PICTURES/schedule_not_understood.png
    # So does Escape.
    key Escape
    wait_frames 3
    expect schedule_filter_error == ""
    click "Schedule/filter"
    wait_frames 3
    type "corners=6"
    wait_frames 3
    expect schedule_rows < $all
    expect schedule.0.corners == 6
    # Also what was typed before the field was entered again.
    click "Schedule/row 0"
    wait_frames 3
    expect schedule_rows < $all
    click "Schedule/filter"
    wait_frames 3
    key Escape
    wait_frames 3
    expect schedule_rows == $all
    click "Schedule/only failing"
    wait_frames 3
    expect schedule_rows == 0
    screenshot PICTURES/schedule_none_fails.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, SelectsPanelsInTheScheduleAndTheModel) {
  const Playback run = play(schedule_of_dome(200) + R"(
    click "Schedule/column area"
    wait_frames 3
    # A click selects the row's panel and leaves the view alone.
    remember camera standard
    remember schedule.2.panel third
    click "Schedule/row 2"
    wait_frames 3
    expect selected_panel == $third
    expect selected == 1
    expect schedule.2.selected == 1
    expect schedule.1.selected == 0
    expect camera == $standard
    # Shift takes all up to there, ctrl one more, and one less.
    shift_click "Schedule/row 4"
    wait_frames 3
    expect selected == 3
    expect schedule.3.selected == 1
    ctrl_click "Schedule/row 0"
    wait_frames 3
    expect selected == 4
    ctrl_click "Schedule/row 3"
    wait_frames 3
    expect selected == 3
    expect schedule.3.selected == 0
    screenshot PICTURES/schedule_selected.png
    click "Schedule/only selected"
    wait_frames 3
    expect schedule_rows == 3
    click "Schedule/only selected"
    wait_frames 3
    # Two clicks look at it.
    double_click "Schedule/row 1"
    wait_frames 3
    expect camera != $standard
    expect selected == 1
    expect schedule_row == 1
    key Home
    wait_frames 20
    # A click in the model marks the row and brings it into sight.
    click_panel any
    wait_frames 3
    expect selected_panel == $panel
    expect schedule_row >= 0
    remember schedule_row row
    expect "ui:Schedule/row $row" == enabled
    screenshot PICTURES/schedule_follows.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, UndoesBesideTheScheduleWhileNothingIsTyped) {
  const Playback run = play(R"(
    sample dome 60
    wait_loaded 20
    wait_solved 100
    key E
    wait_frames 3
    click "Findings/tab Workshop"
    wait_frames 3
    drag_by "Findings/thickness" 60 0
    wait_frames 2
    drag_by "Findings/density" 100 0
    wait_frames 3
    wait_solved 60
    wait_frames 3
    expect schedule.0.weight > 0
    expect schedule_sum contains kg
    remember undo last
    # Typing is typing: keys that do something elsewhere do not.
    click "Schedule/filter"
    wait_frames 3
    type "area>0"
    wait_frames 3
    key Ctrl+Z
    key V
    wait_frames 3
    expect undo == $last
    expect "ui:Schedule/filter" == enabled
    click "Schedule/row 0"
    wait_frames 3
    key Ctrl+Z
    wait_frames 3
    wait_solved 60
    wait_frames 3
    expect undo != $last
    expect schedule.0.weight == "–"
    key Ctrl+Shift+Z
    wait_frames 3
    wait_solved 60
    wait_frames 3
    expect schedule.0.weight > 0
    key D
    wait_frames 3
    screenshot PICTURES/schedule_dark.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, CopiesTheScheduleForASpreadsheet) {
  const Playback run = play(schedule_of_dome(60) + R"(
    click "Schedule/filter"
    wait_frames 3
    type "A-01"
    wait_frames 3
    expect schedule_rows == 1
    click "Schedule/copy"
    wait_frames 3
    expect last_message contains "1 row is on the clipboard"
    print clipboard
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  const std::string header = printed(run, "clipboard");
  EXPECT_TRUE(header.starts_with("name\tcorners\tarea_m2\t")) << header;
  const auto row = run.output.find("\nA-01\t");
  ASSERT_NE(row, std::string::npos) << run.output;
  EXPECT_EQ(run.output.find("\nA-02\t"), std::string::npos);
}

TEST_F(WindowTest, SaysWhyTheScheduleIsEmpty) {
  const Playback run = play(R"(
    sample dome 2000
    wait_loaded 20
    key E
    wait_solving 20
    expect schedule_text contains "nown when"
    wait_frames 2
    screenshot PICTURES/schedule_waits.png
    wait_solved 100
    wait_frames 3
    expect schedule_text == ""
    expect schedule_rows > 1900
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
