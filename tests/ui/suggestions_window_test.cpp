// Suggestions in the real window, driven by scripts: the list, its keys and buttons, and the ghosts of edits.
#include "support/window_fixture.h"

namespace planewright {
namespace {

TEST_F(WindowTest, ListsSuggestionsAndAppliesOne) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    expect suggestions == none
    expect suggestions_text contains "rated"
    wait_solved 100
    wait_rated 100
    expect rating == 0
    expect suggestions > 2
    expect suggestions_text == ""
    remember suggestion.0.gain best
    expect suggestion.1.gain <= $best
    remember suggestion.0.edit name
    remember camera standard
    hover "Findings/suggestion 0"
    wait_frames 20
    screenshot PICTURES/suggestion_hovered.png
    expect camera == $standard
    click "Findings/suggestion 0"
    wait_frames 3
    expect suggestion == 0
    expect camera != $standard
    screenshot PICTURES/suggestion.png
    click Findings/apply
    wait_frames 3
    expect undo == $name
    expect history == 1
    wait_solved 100
    expect solved == 1
    expect planarity_relative <= 1e-9
    wait_rated 100
    key Ctrl+Z
    wait_frames 2
    wait_solved 100
    wait_rated 100
    expect suggestion.0.gain == $best
    expect history == 1
    expect steps_done == 0
    double_click "Findings/suggestion 0"
    wait_frames 3
    expect steps_done == 1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AppliesAllThatGainAsOneStep) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    wait_rated 100
    remember suggestions_together count
    remember findings before
    expect suggestions_together > 1
    hover "Findings/apply all"
    wait_frames 5
    screenshot PICTURES/apply_all.png
    click "Findings/apply all"
    wait_frames 3
    expect history == 1
    expect undo contains "Apply"
    expect undo contains "suggestions"
    wait_solved 100
    expect findings < $before
    key Ctrl+Z
    wait_frames 2
    wait_solved 100
    expect steps_done == 0
    expect findings == $before
    wait_rated 100
    expect suggestions_together == $count
    # By the keyboard alone.
    key Ctrl+Enter
    wait_frames 3
    expect history == 1
    expect undo contains "suggestions"
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, WalksSuggestionsByKeys) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    wait_rated 100
    key S
    wait_frames 2
    expect suggestion == 0
    key S
    wait_frames 2
    expect suggestion == 1
    key Shift+S
    wait_frames 2
    key Shift+S
    wait_frames 2
    expect suggestion > 1
    key Escape
    wait_frames 2
    expect suggestion == -1
    expect "ui:Findings/apply" == disabled
    # Enter applies what is best at the finding that the designer is at.
    key N
    wait_frames 2
    expect finding == 0
    expect suggestion == -1
    expect "ui:Findings/apply" == enabled
    key Enter
    wait_frames 2
    expect history == 1
    wait_solved 100
    expect solved == 1
    key ?
    wait_frames 3
    screenshot PICTURES/keys.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, LeavesKindsOfEditsOut) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    wait_rated 100
    remember suggestions all
    expect suggestions_listed == $all
    click "Findings/edits flip"
    wait_frames 2
    expect suggestions_listed < $all
    expect suggestion.0.edit contains "Join"
    click "Findings/edits join"
    wait_frames 2
    expect suggestions_listed == 0
    expect "ui:Findings/apply all" == disabled
    key S
    wait_frames 2
    expect suggestion == -1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ShowsTheGainOfAHoveredEdgeAndInTheMenu) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    wait_rated 100
    click "Findings/suggestion 0"
    wait_frames 3
    key Escape
    remember suggestion.0.edge best
    hover_edge $best
    wait_frames 30
    screenshot PICTURES/hover_gain.png
    context_edge $best
    wait_frames 3
    hover Context/join
    wait_frames 3
    screenshot PICTURES/context_gain.png
    click Context/flip
    wait_frames 3
    expect undo contains "Flip"
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AppliesASuggestionWhileASolveRuns) {
  const Playback run = play(R"(
    sample bad-saddle 3000
    wait_loaded 20
    wait_solved 100
    wait_rated 200
    expect suggestions > 0
    click "Findings/suggestion 0"
    wait_frames 2
    drag "Design/weight fairing" 0.5
    wait_solving 20
    expect suggestions > 0
    key Enter
    wait_frames 2
    expect solving == 1
    expect suggestions == none
    expect undo contains "edge"
    wait_solved 100
    expect solved == 1
    expect history == 2
    expect planarity_relative <= 1e-9
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
