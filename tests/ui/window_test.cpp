// The real window, driven by scripts: each test starts the program, plays one, and looks at what came of it.
#include "core/diagnose/planarity.h"
#include "core/mesh/mesh_io.h"
#include "support/window_fixture.h"

namespace planewright {
namespace {

namespace fs = std::filesystem;

TEST_F(WindowTest, StartsOnASampleAndSolvesIt) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    expect document == dome
    expect status == converged
    expect panels > 100
    expect planarity_relative <= 1e-9
    expect messages == 0
    expect ui:Hint/close == enabled
    wait_frames 5
    screenshot PICTURES/start.png
    click Hint/close
    wait_frames 3
    expect ui:Hint/close == absent
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  EXPECT_GT(fs::file_size(pictures_ / "start.png"), 20'000u);
}

TEST_F(WindowTest, StreamsIteratesWhileAWeightIsDragged) {
  const Playback run = play(R"(
    sample torus 1000
    wait_loaded 20
    wait_solved 200
    remember fingerprint at_rest
    remember ticket first
    # The knob is held: the solver answers while the mouse button is still down.
    press "Design/weight fairing"
    move "Design/weight fairing" 0.45
    move "Design/weight fairing" 0.50
    wait_iterates 2 100
    expect iterates_before_end >= 2
    expect fingerprint != $at_rest
    expect ticket > $first
    screenshot PICTURES/dragging.png
    move "Design/weight fairing" 0.55
    release
    expect weight.fairing > 1
    expect undo == "Weight of fairing"
    wait_solved 200
    expect iterates_before_end >= 2
    expect planarity_relative <= 1e-9
    key Ctrl+Z
    wait_frames 2
    expect weight.fairing == 0
    expect can_undo == 0
    key Ctrl+Shift+Z
    wait_frames 2
    expect weight.fairing > 1
    key Space
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, PolishesByButtonAndByItself) {
  const Playback run = play(R"(
    sample torus 400
    wait_loaded 20
    wait_solved 100
    expect asked == tangent
    expect badge contains ", converged"
    expect polished == 0
    expect ui:Badge/polish == enabled
    hover Badge/badge
    wait_frames 4
    screenshot PICTURES/badge.png
    click Badge/polish
    wait_frames 3
    wait_solved 200
    expect asked == auto
    expect polished == 1
    expect badge == "Ipopt, confirmed"
    expect ui:Badge/polish == disabled
    expect planarity_relative <= 1e-9
    expect can_undo == 0
    screenshot PICTURES/polished.png
    # There is nothing to polish any more.
    remember ticket polished
    key I
    wait_frames 6
    expect ticket == $polished
    # A drag is the tangent solver's.
    drag "Design/weight fairing" 0.5
    wait_solved 200
    expect asked == tangent
    expect polished == 0
    key I
    wait_frames 3
    wait_solved 200
    expect polished == 1
    # By itself, but not while the knob is held.
    expect polish_automatically == 0
    click Menu/Solve
    wait_frames 3
    click "Menu/Solve/auto polish"
    wait_frames 3
    expect polish_automatically == 1
    press "Design/weight fairing"
    move "Design/weight fairing" 0.6
    move "Design/weight fairing" 0.62
    wait_solved 200
    wait_frames 10
    expect asked == tangent
    expect polished == 0
    release
    wait_frames 3
    wait_solved 200
    expect polished == 1
    expect undo == "Weight of fairing"
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  // The setting is there at the next start.
  const Playback again = play(R"(
    wait_loaded 20
    wait_solved 60
    expect polish_automatically == 1
    expect polished == 1
  )");
  EXPECT_EQ(again.status, 0) << again.output;
}

// The badge, its button and the small window: what has no room gives way.
TEST_F(WindowTest, TheBadgeFitsANarrowView) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    wait_frames 3
    expect badge contains ", converged"
    expect ui:Badge/badge == enabled
    expect ui:Badge/polish == absent
    screenshot PICTURES/narrow.png
    key I
    wait_frames 3
    wait_solved 60
    expect polished == 1
  )",
                            "", 240, "760x600");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, FlipsAnEdgeByAClickAndTakesItBack) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    hover_edge any
    expect hovered_edge == $edge
    wait_frames 3
    screenshot PICTURES/hover_edge.png
    remember edge.$edge before
    remember ticket first
    click_edge $edge
    wait_frames 3
    expect edge.$edge != $before
    expect undo contains "Flip edge"
    expect ticket > $first
    wait_solved 60
    expect planarity_relative <= 1e-9
    screenshot PICTURES/flipped.png
    key Ctrl+Z
    wait_frames 3
    expect edge.$edge == $before
    expect redo contains "Flip edge"
    wait_solved 60
    expect status == converged
    key Ctrl+Y
    wait_frames 3
    expect edge.$edge != $before
    wait_solved 60
    # From the menu, too.
    click Menu/Edit
    wait_frames 3
    click Menu/Edit/undo
    wait_frames 3
    expect edge.$edge == $before
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, StopsInTheMiddle) {
  const Playback run = play(R"(
    sample torus 20000
    wait_loaded 20
    wait_iterates 1 100
    expect solving == 1
    click Design/Stop
    wait_solved 60
    expect status == stopped
    expect panels > 4000
    expect ui:Design/Solve == enabled
    screenshot PICTURES/stopped.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ExportsPanelsThatStayPlanar) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    print panels
    # Through the file browser, by keyboard.
    key Ctrl+E
    wait_frames 4
    expect browser_open == 1
    type "FOLDER/panels.obj"
    wait_frames 3
    screenshot PICTURES/export.png
    key Enter
    wait_frames 30
    expect browser_open == 0
    expect last_message contains "panels.obj"
    # Once more: it asks before it replaces.
    key Ctrl+E
    wait_frames 4
    type "FOLDER/panels.obj"
    key Enter
    wait_frames 4
    expect browser_open == 1
    click Files/replace
    wait_frames 30
    expect browser_open == 0
    export "FOLDER/panels.off"
    export "FOLDER/panels.ply"
    export "FOLDER/panels.stl"
    expect messages_posted >= 4
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  const int panels = std::stoi(printed(run, "panels"));
  for (const char* name : {"panels.obj", "panels.off", "panels.ply"}) {
    const auto read = load_mesh(folder_ / name);
    ASSERT_TRUE(read.has_value()) << read.error().text();
    EXPECT_EQ(read->mesh.face_count(), panels) << name;
    EXPECT_LE(measure_planarity(read->mesh.positions(), read->mesh.faces()).max_relative_to_bbox, 1e-9)
        << name;
  }
  EXPECT_TRUE(load_mesh(folder_ / "panels.stl").has_value());
}

TEST_F(WindowTest, OpensByArgumentBrowserAndDrop) {
  ASSERT_EQ(play("wait_loaded 20\nwait_solved 60\nexport FOLDER/dome.ply\n").status, 0);
  const Playback run = play(R"(
    wait_loaded 20
    expect document == dome.ply
    expect mode == planarize      # hexagons: the mesh's own faces
    wait_solved 100
    expect planarity_relative <= 1e-9
    key Ctrl+O
    wait_frames 4
    type "FOLDER"
    key Enter
    wait_frames 4
    expect browser_open == 1
    expect ui:Files/dome.ply == enabled
    screenshot PICTURES/open.png
    click Files/dome.ply
    click Files/accept
    wait_loaded 20
    expect browser_open == 0
    expect document == dome.ply
    drop "FOLDER/dome.ply"
    wait_loaded 20
    expect messages == 0
  )",
                            (folder_ / "dome.ply").string());
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ABadFileIsExplainedAndLosesNothing) {
  std::ofstream(folder_ / "bad.obj") << "v 0 0 0\nv 1 0 0\nv one two three\nf 1 2 3\n";
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    remember fingerprint before
    drop "FOLDER/bad.obj"
    wait_loaded 20
    wait_frames 3
    expect messages == 1
    expect last_message contains "bad.obj:3"
    expect document == dome
    expect fingerprint == $before
    screenshot PICTURES/bad_file.png
    click "Message/close 1"
    wait_frames 3
    expect messages == 0
    open "FOLDER/not there.obj"
    wait_loaded 20
    expect last_message contains "not there.obj"
    expect fingerprint == $before
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ColourMapsGhostAndThemes) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    key C
    wait_frames 3
    expect colours == planarity
    expect range > 0
    screenshot PICTURES/planarity.png
    key C
    wait_frames 3
    expect colours == displacement
    screenshot PICTURES/displacement.png
    key C
    wait_frames 3
    expect colours == findings
    key C
    wait_frames 3
    expect colours == tolerances
    key C
    wait_frames 3
    expect colours == none
    click "Toolbar/colours Displacement"
    wait_frames 2
    expect colours == displacement
    expect ghost == 1
    key G
    wait_frames 2
    expect ghost == 0
    click Menu/View
    wait_frames 3
    screenshot PICTURES/menu.png
    click "Menu/View/dark theme"
    wait_frames 3
    expect dark == 1
    screenshot PICTURES/dark.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, SlidersTypeResetAndTurn) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    ctrl_click "Design/weight fairing"
    wait_frames 3
    type "0.25"
    key Enter
    wait_frames 3
    expect weight.fairing == 0.25
    wheel "Design/weight fairing" 3
    expect weight.fairing > 0.4
    expect weight.fairing < 0.6
    double_click "Design/weight fairing"
    wait_frames 2
    expect weight.fairing == 0
    drag "Design/weight position" 0
    expect weight.position == 0
    key Ctrl+Z
    wait_frames 2
    expect weight.position == 1
    click "Design/weight fairing number"
    wait_frames 3
    type "-4"
    key Enter
    wait_frames 3
    expect weight.fairing == 0      # no negative weights
    drag_by Design/offset 30 0
    expect offset > 0
    ctrl_click Design/offset
    wait_frames 3
    type "-0.5"
    key Enter
    wait_frames 3
    expect offset == -0.5
    double_click Design/offset
    wait_frames 2
    expect offset == 0
    wait_solved 100
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ModesKeysAndPlanarizeCannotFlip) {
  const Playback run = play(R"(
    sample twisted-roof 100
    wait_loaded 20
    wait_solved 100
    expect mode == planarize
    expect planarity_relative <= 1e-9
    remember revision before
    click_model 0.5 0.5
    wait_frames 2
    expect revision == $before          # quads do not flip
    screenshot PICTURES/planarize.png
    key 1
    wait_frames 2
    expect mode == dual
    wait_solved 100
    key 2
    wait_frames 2
    expect mode == planarize
    expect undo contains "Mode"
    key ?
    wait_frames 4
    expect ui:Keys/close == enabled
    screenshot PICTURES/keys.png
    key Escape
    wait_frames 4
    expect ui:Keys/close == absent
    key F1
    wait_frames 4
    wait_frames 30          # a card stays as it is
    click Keys/close
    wait_frames 3
    expect ui:Keys/close == absent
    key ?
    wait_frames 4
    click "Findings/tab Report"          # a card blocks nothing
    wait_frames 3
    expect ui:Findings/health == enabled
    key Escape
    wait_solved 100
    wait_frames 3
    screenshot PICTURES/report.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, TheCameraFollowsTheMouse) {
  const Playback run = play(R"(
    wait_loaded 20
    wait_solved 60
    key Home
    wait_frames 2
    remember camera at_first
    remember revision before
    orbit 150 40
    expect camera != $at_first
    remember camera orbited
    pan 60 -30
    expect camera != $orbited
    remember camera panned
    zoom 4
    expect camera != $panned
    expect revision == $before          # none of it was taken for a click on an edge
    key Home
    wait_frames 2
    expect camera == $at_first
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, RemembersItsSettings) {
  ASSERT_EQ(
      play("wait_loaded 20\nkey D\nclick Hint/close\nclick Menu/View\nwait_frames 3\nhover Menu/View/Unit\n"
           "wait_frames 3\nclick Menu/View/Unit/mm\nwait_frames 2\nexpect unit == mm\n")
          .status,
      0);
  const Playback run = play(
      "wait_loaded 20\nwait_frames 3\nexpect dark == 1\nexpect unit == mm\nexpect ui:Hint/close == absent\n");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AFailingExpectationFailsTheRun) {
  const Playback run = play("wait_loaded 20\nexpect document == palace\n");
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.output.find("script.txt:2"), std::string::npos) << run.output;
  EXPECT_EQ(play("click \"Design/no such thing\"\n").status, 1);
  EXPECT_EQ(play("dance\n").status, 2);
}

}  // namespace
}  // namespace planewright
