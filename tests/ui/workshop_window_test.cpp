// The workshop in the real window: limits, verdicts, names, colours, failures, units and projects.
#include "support/window_fixture.h"

namespace planewright {
namespace {

const std::string kDomeAtTheWorkshop = R"(
    click Hint/close
    sample dome 400
    wait_loaded 20
    wait_solved 60
    click "Findings/tab Workshop"
    wait_frames 3
    wait_solved 60
)";

TEST_F(WindowTest, LimitsAreTypedAndFailuresAreGoneTo) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    expect failing == 0
    ctrl_click "Findings/edge min"
    wait_frames 2
    type 440
    key Enter
    wait_frames 3
    wait_solved 20
    expect limit_edge_min == 440
    expect failing > 0
    expect shares_break == 0
    expect undo == "Limit of Edge length"
    remember failing failing
    click "Findings/colour by"
    wait_frames 3
    click "Findings/colour by/all limits"
    wait_frames 3
    expect colours == tolerances
    click "Findings/failure 0"
    wait_frames 40
    expect failure == 0
    remember failure.0.panel panel
    expect selected_panel == $panel
    screenshot PICTURES/workshop.png
    key W
    wait_frames 40
    expect failure == 1
    double_click "Findings/edge min"    # back to no limit
    wait_frames 3
    wait_solved 20
    expect limit_edge_min == none
    expect failing == 0
    expect failure == -1
    key Ctrl+Z
    wait_frames 3
    wait_solved 20
    expect limit_edge_min == 440
    expect failing == $failing
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, ALimitIsDraggedAsOneStepWhileVerdictsFollow) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    remember history steps
    drag_by "Findings/area max" -60 0
    wait_frames 3
    wait_solved 20
    expect limit_area_max != none
    expect failing > 0
    key Ctrl+Z
    wait_frames 3
    wait_solved 20
    expect limit_area_max == none
    expect failing == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AGestureThatItsTabIsClosedUnderIsAStepOfItsOwn) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    expect history == 0
    wheel "Findings/thickness" 3
    click "Findings/tab Report"
    wait_frames 20
    click "Findings/tab Workshop"
    wait_frames 3
    wheel "Findings/thickness" 3
    wait_frames 60
    expect history == 2
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, NamesStandOnPanelsThatAreLargeEnough) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    expect names_drawn == 0
    key Y
    wait_frames 4
    expect names == 1
    remember names_drawn few
    expect names_drawn > 5
    zoom 6
    wait_frames 10
    expect names_drawn > 5
    screenshot PICTURES/workshop_names.png
    key Y
    wait_frames 3
    expect names_drawn == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, TheUnitIsTheDocumentsAndIsRemembered) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    expect unit == m
    click "Findings/unit"
    wait_frames 3
    click "Findings/unit/mm"
    wait_frames 3
    wait_solved 20
    expect unit == mm
    expect undo == "Unit mm"
    key Ctrl+Z
    wait_frames 3
    expect unit == m
    click Menu/View
    wait_frames 3
    click Menu/View/Unit
    wait_frames 3
    click Menu/View/Unit/ft
    wait_frames 3
    expect unit == ft
    sample torus
    wait_loaded 20
    wait_solved 60
    expect unit == ft
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  const Playback next = play("wait_loaded 20\nexpect unit == ft\n");
  EXPECT_EQ(next.status, 0) << next.output;
}

TEST_F(WindowTest, AToleranceSheetIsSavedAndLoaded) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    ctrl_click "Findings/edge min"
    wait_frames 2
    type 440
    key Enter
    wait_frames 3
    click "Findings/save sheet"
    wait_frames 4
    click Files/name
    key Ctrl+A
    type "FOLDER/office"
    key Enter
    wait_frames 20
    expect last_message contains "Saved office.json"
    double_click "Findings/edge min"
    wait_frames 3
    expect limit_edge_min == none
    click "Findings/load sheet"
    wait_frames 4
    click Files/name
    key Ctrl+A
    type "FOLDER/office.json"
    key Enter
    wait_frames 20
    wait_solved 20
    expect limit_edge_min == 440
    expect undo == "Tolerances of office.json"
    expect failing > 0
    drop "FOLDER/office.json"          # no mesh: told, and nothing is lost
    wait_frames 3
    click Leaving/discard
    wait_frames 20
    expect limit_edge_min == 440
    expect messages > 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AProjectIsSavedAndOpenedWithItsPanels) {
  const Playback run = play(kDomeAtTheWorkshop + R"(
    ctrl_click "Findings/thickness"
    wait_frames 2
    type 24
    key Enter
    wait_frames 3
    wait_solved 20
    expect contract_thickness == 24
    expect modified == 1
    remember fingerprint panels
    key Ctrl+S
    wait_frames 4
    expect browser_open == 1
    click Files/name
    key Ctrl+A
    type "FOLDER/roof"
    key Enter
    wait_frames 30
    expect modified == 0
    expect last_message contains "Saved roof.planewright"
    ctrl_click "Findings/thickness"
    wait_frames 2
    type 30
    key Enter
    wait_frames 3
    expect modified == 1
    drop "FOLDER/roof.planewright"
    wait_frames 3
    expect ui:Leaving/save == enabled
    screenshot PICTURES/leaving.png
    click Leaving/stay
    wait_frames 3
    expect contract_thickness == 30
    drop "FOLDER/roof.planewright"
    wait_frames 3
    click Leaving/discard
    wait_frames 3
    wait_loaded 20
    wait_solved 20
    expect contract_thickness == 24
    expect fingerprint == $panels
    expect badge == "As saved"
    ctrl_click "Findings/thickness"
    wait_frames 2
    type 36
    key Enter
    wait_frames 3
    drop "FOLDER/roof.planewright"     # saved under its name, then opened again
    wait_frames 3
    click Leaving/save
    wait_frames 20
    wait_loaded 20
    wait_solved 20
    expect contract_thickness == 36
    expect modified == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "roof.planewright"));
}

}  // namespace
}  // namespace planewright
