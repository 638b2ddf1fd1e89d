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
    sample torus 6000
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

TEST_F(WindowTest, SelectsByClicksBoxesLoopsAndTheBorder) {
  const Playback run = play(R"(
    sample twisted-roof 100
    wait_loaded 20
    wait_solved 60
    key F
    wait_frames 2
    click_panel any
    wait_frames 2
    expect selected_faces == 1
    expect selected_panel == $panel
    remember selected_panel first
    key +
    wait_frames 2
    expect selected_faces >= 3
    key -
    wait_frames 2
    expect selected_faces == 1
    click_model 0.98 0.04              # beside the model: nothing
    wait_frames 2
    expect selected == 0
    click_panel $first
    click_corner any "Shift"
    wait_frames 2
    expect selected_faces == 1
    expect selected_vertices == 1
    click_panel $first "Ctrl"
    wait_frames 2
    expect selected_faces == 0
    expect selected_vertices == 1
    key Escape
    wait_frames 2
    expect selected == 0
    click_panel any "Alt"              # a strip, or the border's loop
    wait_frames 2
    expect selected_faces >= 6
    key Shift+B
    wait_frames 2
    expect selected_faces >= 30
    remember selected_faces border
    screenshot PICTURES/selected_border.png
    click "Findings/what Corners"
    wait_frames 2
    click "Findings/select border"
    wait_frames 2
    expect selected_faces == 0
    expect selected_vertices > $border
    click "Findings/what Panels"
    key B
    wait_frames 2
    expect tool == box
    drag_box 0.01 0.02 0.99 0.98
    wait_frames 2
    expect tool == look
    expect selected_faces == 102       # all there are
    key B
    wait_frames 2
    drag_box 0.01 0.02 0.99 0.98 "Alt"
    wait_frames 2
    expect selected_faces < 102        # the far side is not in sight
    expect selected_faces > 30
    remember selected_faces seen
    key Ctrl+I
    wait_frames 2
    expect selected_faces != $seen
    key B
    wait_frames 2
    key Escape
    wait_frames 2
    expect tool == look
    expect selected_faces > 0          # Escape put the tool away first
    # Under a name, and back.
    click "Findings/store selection"
    wait_frames 3
    expect stored == 1
    expect undo contains "Store"
    double_click "Findings/stored selection 1"
    wait_frames 4
    type "eaves"
    key Enter
    wait_frames 4
    expect stored.0 == eaves
    key Escape
    wait_frames 2
    expect selected == 0
    click "Findings/stored eaves"
    wait_frames 2
    expect selected_faces > 0
    click "Findings/stored eaves remove"
    wait_frames 3
    expect stored == 0
    key Ctrl+Z
    wait_frames 3
    expect stored == 1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, PinsWhatIsSelectedAndDragsAPin) {
  const Playback run = play(R"(
    sample dome 150
    wait_loaded 20
    wait_solved 60
    click_corner any
    wait_frames 2
    expect selected_point == $corner
    key P
    wait_frames 3
    expect pins == 1
    expect undo contains "Pin 1 point"
    wait_solved 60
    remember pin.0.z before
    remember ticket first
    remember camera camera
    drag_pin 0 0 -25
    wait_frames 2
    expect camera == $camera            # the pin moved, not the view
    expect pin.0.z > $before
    expect undo == "Move pin"
    wait_solved 60
    expect ticket > $first
    expect pin.0.off < 1e-6
    expect planarity_relative <= 1e-9
    screenshot PICTURES/pinned.png
    key Ctrl+Z
    wait_frames 2
    expect pin.0.z == $before           # the drag was one step
    wait_solved 60
    expect pin.0.off < 1e-6
    # A coordinate of it is set free in the list.
    click "Findings/pin 0"
    wait_frames 3
    click "Findings/pin 0 x held"
    wait_frames 3
    expect pin.0.x == free
    expect pin.0.y != free
    wait_solved 60
    click "Findings/pin 0 remove"
    wait_frames 3
    expect pins == 0
    click_panel any
    key P
    wait_frames 3
    expect plane_pins == 1
    wait_solved 60
    key Shift+P
    wait_frames 3
    expect plane_pins == 0
    wait_solved 60
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, LayersAreAddedHiddenJoinedAndRemoved) {
  const Playback run = play(R"(
    sample vault 120
    wait_loaded 20
    wait_solved 60
    click Design/layers
    wait_frames 3
    click "Design/add layer"
    wait_frames 3
    expect layers == 2
    expect active_layer == 1
    expect layer.0.name == outer
    expect layer.1.name == inner
    expect layer.1.offset < 0
    wait_solved 100
    expect layer.0.status == converged
    expect layer.1.status == converged
    expect layer.1.planarity_relative <= 1e-9
    click "Design/layer 0 eye"
    wait_frames 3
    expect layer.0.visible == 0
    expect active_layer == 1
    key Ctrl+Z
    wait_frames 3
    expect layer.0.visible == 1
    click Design/beams
    wait_frames 4
    click Design/beams/outer
    wait_frames 3
    wait_solved 100
    expect layer.1.beams > 100
    expect layer.1.beam_planarity < 1e-6
    screenshot PICTURES/layers.png
    remember ticket solved
    ctrl_click Design/thickness
    wait_frames 3
    type "0.05"
    key Enter
    wait_frames 3
    wait_solved 60
    expect layer.1.thickness == 0.05
    expect layer.1.sides > 100
    expect ticket == $solved            # thickness is no matter of the solver
    click "Design/layer 0"
    wait_frames 3
    expect active_layer == 0
    double_click "Design/layer 0"
    wait_frames 4
    type "shell"
    key Enter
    wait_frames 4
    expect layer.0.name == shell
    key Tab
    wait_frames 2
    expect active_layer == 1
    click Menu/Layer
    wait_frames 3
    click "Menu/Layer/remove layer"
    wait_frames 3
    expect layers == 1
    expect layer.0.name == shell
    wait_solved 60
    key Ctrl+Z
    wait_frames 3
    expect layers == 2
    wait_solved 100
    expect layer.1.beams > 100
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
