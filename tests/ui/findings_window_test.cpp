// Findings, edges to click, edits and the history in the real window, driven by scripts.
#include "support/window_fixture.h"

namespace planewright {
namespace {

TEST_F(WindowTest, ListsFindingsAndFliesToThem) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    expect findings == none
    expect findings_text contains "Not solved yet"
    wait_solved 100
    expect solved == 1
    expect findings_text == ""
    expect findings > 0
    expect flagged > 0
    remember camera standard
    screenshot PICTURES/findings.png
    click "Findings/finding 0"
    wait_frames 3
    expect finding == 0
    expect selected_edge >= 0
    expect camera != $standard
    screenshot PICTURES/finding.png
    # With the keys, round and back.
    key N
    wait_frames 2
    expect finding == 1
    key Shift+N
    wait_frames 2
    key Shift+N
    wait_frames 2
    expect finding > 1
    key N
    wait_frames 2
    expect finding == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, HidesKindsOfFindings) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    print findings
    remember findings all
    remember finding.0.kind first
    expect findings_listed == $all
    ctrl_click "Findings/kind reversed-edge"
    wait_frames 2
    expect finding.0.kind == reversed-edge
    expect findings == $all
    remember findings.reversed-edge few
    expect findings_listed == $few
    screenshot PICTURES/findings_filtered.png
    click "Findings/kind reversed-edge"
    wait_frames 2
    expect findings_listed == 0
    expect flagged == 0
    key N
    wait_frames 2
    expect finding == -1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, SetsAndRemembersLimitsOfFindings) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    remember findings.close-points few
    click Findings/limits
    wait_frames 3
    drag_by "Findings/limit close-points" 60 0
    wait_frames 2
    expect limit.close-points > 0.3
    wait_solved 100
    expect findings.close-points > $few
    expect can_undo == 0
    screenshot PICTURES/limits.png
    drag_by "Findings/limit self-crossing" 20 0
    wait_frames 2
    expect limit.self-crossing == 0.1
    click "Findings/limit self-crossing reset"
    wait_frames 2
    expect limit.self-crossing == 0
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  const Playback again = play(R"(
    wait_loaded 20
    wait_solved 100
    expect limit.close-points > 0.3
    click Findings/limits
    wait_frames 3
    double_click "Findings/limit close-points"
    wait_frames 2
    expect limit.close-points == 0.15
  )");
  EXPECT_EQ(again.status, 0) << again.output;
}

TEST_F(WindowTest, FlipsAFlaggedEdgeByAClick) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    click "Findings/finding 0"
    wait_frames 3
    hover_edge flagged
    expect hovered_edge == $edge
    wait_frames 3
    screenshot PICTURES/hover_flagged.png
    remember edge.$edge before
    remember ticket first
    remember selected_panel panel
    click_edge $edge
    wait_frames 3
    expect edge.$edge != $before
    expect undo contains "Flip edge"
    expect ticket > $first
    wait_solved 100
    expect solved == 1
    expect planarity_relative <= 1e-9
    screenshot PICTURES/flipped_flagged.png
    key Ctrl+Z
    wait_frames 3
    expect edge.$edge == $before
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, SaysWhyAnEdgeCannotBeFlipped) {
  const Playback run = play(R"(
    sample turning-strip
    wait_loaded 20
    wait_solved 100
    expect mode == planarize
    remember revision at_first
    remember messages_posted quiet
    click_edge stuck
    wait_frames 3
    expect revision == $at_first
    expect messages_posted > $quiet
    expect last_message contains "triangle"
    screenshot PICTURES/refused_flip.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, SaysWhyAnEdgeOfTheBorderCannotBeFlipped) {
  const Playback run = play(R"(
    sample dome 60
    wait_loaded 20
    wait_solved 100
    remember revision at_first
    remember messages_posted quiet
    hover_edge stuck
    wait_frames 3
    screenshot PICTURES/hover_border.png
    click_edge $edge
    wait_frames 3
    expect revision == $at_first
    expect messages_posted > $quiet
    expect last_message contains "border"
    # The corner in the middle of the edge is what is selected.
    expect selected_point >= 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, EditsTheMeshFromAMenuAndGoesThroughTheHistory) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    remember vertices opened
    context_edge any
    wait_frames 3
    expect "ui:Context/flip" == enabled
    expect "ui:Context/join" == enabled
    screenshot PICTURES/context_menu.png
    click Context/collapse
    wait_frames 3
    expect undo contains "Collapse"
    expect vertices < $opened
    wait_solved 100
    context_edge any
    wait_frames 3
    click "Context/split edge"
    wait_frames 3
    expect undo contains "Split"
    wait_solved 100
    expect history == 2
    # Nothing is selected: the menu says so by what it does not offer.
    key Escape
    wait_frames 2
    click Menu/Edit
    wait_frames 3
    click Menu/Edit/Mesh
    wait_frames 3
    expect "ui:Menu/Edit/Mesh/flip" == disabled
    expect "ui:Menu/Edit/Mesh/move vertex" == disabled
    hover Menu/Edit/History
    wait_frames 12
    screenshot PICTURES/history.png
    click "Menu/Edit/History/step 0"
    wait_frames 3
    expect steps_done == 0
    expect vertices == $opened
    expect redo contains "Collapse"
    wait_solved 100
    click Menu/Edit
    wait_frames 3
    click Menu/Edit/History
    wait_frames 3
    click "Menu/Edit/History/step 2"
    wait_frames 3
    expect steps_done == 2
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, MovesAVertexFromTheMenu) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    click_panel any
    wait_frames 2
    expect selected_vertices == 1
    click Menu/Edit
    wait_frames 3
    click Menu/Edit/Mesh
    wait_frames 3
    expect "ui:Menu/Edit/Mesh/move vertex" == enabled
    click "Menu/Edit/Mesh/move vertex"
    wait_frames 3
    expect undo contains "Move vertex"
    wait_solved 100
    expect solved == 1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ColoursPanelsByFindings) {
  const Playback run = play(R"(
    sample bad-saddle
    wait_loaded 20
    wait_solved 100
    click "Toolbar/colours Findings"
    wait_frames 3
    expect colours == findings
    screenshot PICTURES/colours_findings.png
    key D
    wait_frames 3
    screenshot PICTURES/colours_findings_dark.png
    click "Toolbar/colours Card"
    wait_frames 3
    screenshot PICTURES/findings_dark.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
