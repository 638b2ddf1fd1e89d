// The left panel of the real window, driven by scripts: every energy has its slider, every demand its switch,
// and both steer the solve.
#include <sstream>
#include <string>
#include <vector>

#include "core/problem/demands/demand_catalogue.h"
#include "core/problem/energies/energy_catalogue.h"
#include "support/window_fixture.h"

namespace planewright {
namespace {

class DesignPanelTest : public WindowTest {};

TEST_F(DesignPanelTest, EveryEnergyHasASliderWithItsShare) {
  std::string script = R"(
    sample dome 100
    wait_loaded 20
    wait_solved 60
    expect share.position == 1
)";
  for (const EnergyInfo& energy : energy_catalogue()) {
    const std::string path = "\"Design/weight " + energy.name;
    script += "hover " + path + "\"\nexpect \"ui:Design/weight " + energy.name + "\" == enabled\n";
    script += "hover " + path + " number\"\nhover " + path + " help\"\nwait_frames 3\n";
  }
  script += R"(
    expect share.edge-length == none
    drag "Design/weight edge-length" 0.5
    expect weight.edge-length > 0
    wait_solved 60
    expect share.edge-length > 0
    expect share.edge-length < 1
    expect value.edge-length > 0
    expect share.position < 1
    # The small button takes it back, and goes.
    click "Design/weight edge-length reset"
    expect weight.edge-length == 0
    wait_frames 3
    expect "ui:Design/weight edge-length reset" == absent
    key Ctrl+Z
    wait_frames 3
    expect weight.edge-length > 0
    wait_solved 60
    screenshot PICTURES/weights.png
  )";
  const Playback run = play(script);
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(DesignPanelTest, ANewEnergyPullsTheSolveItsWay) {
  const Playback run = play(R"(
    sample dome 100
    wait_loaded 20
    wait_solved 60
    remember fingerprint before
    click "Design/weight normal-smoothness number"
    wait_frames 3
    type "0.001"
    key Enter
    wait_frames 3
    wait_solved 60
    print value.normal-smoothness
    click "Design/weight normal-smoothness number"
    wait_frames 3
    type "10"
    key Enter
    wait_frames 3
    wait_solved 60
    expect fingerprint != $before
    print value.normal-smoothness
    expect status == converged
    expect share.position > 0
  )");
  ASSERT_EQ(run.status, 0) << run.output;
  // Each is the weight times the energy: what is weighed more has gone down.
  std::vector<double> values;
  std::istringstream lines(run.output);
  const std::string key = "value.normal-smoothness = ";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(key)) values.push_back(std::stod(line.substr(key.size())));
  }
  ASSERT_EQ(values.size(), 2u) << run.output;
  EXPECT_LT(values[1] / 10, 0.9 * values[0] / 0.001) << run.output;
  EXPECT_GT(values[1], 0.0);
}

TEST_F(DesignPanelTest, PresetsAreOneStepAndKnowWhenTheyNoLongerHold) {
  const Playback run = play(R"(
    sample dome 100
    wait_loaded 20
    wait_solved 60
    expect preset == close-to-design
    click Design/preset
    wait_frames 3
    screenshot PICTURES/presets.png
    click "Design/preset/Smooth shell"
    wait_frames 3
    expect preset == smooth-shell
    expect weight.normal-smoothness == 1
    expect undo contains "Smooth shell"
    wait_solved 60
    expect share.normal-smoothness > 0
    wheel "Design/weight position" 1
    expect preset == custom
    key Ctrl+Z
    wait_frames 3
    expect preset == smooth-shell
    key Ctrl+Z
    wait_frames 3
    expect preset == close-to-design
    expect can_undo == 0
    expect weight.normal-smoothness == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(DesignPanelTest, EveryDemandOfTheModeHasASwitch) {
  for (const ComplexKind mode : {ComplexKind::Dual, ComplexKind::Planarize}) {
    std::string script = "sample dome 100\nwait_loaded 20\nwait_solved 60\nclick \"Design/auto\"\n";
    script += mode == ComplexKind::Dual ? "key 1\n" : "key 2\n";
    script += "wait_frames 3\n";
    for (const DemandInfo& demand : demand_catalogue()) {
      const std::string path = "Design/demand " + demand.name;
      const bool here = mode == ComplexKind::Dual ? demand.for_dual : demand.for_planarize;
      if (!here) {
        script += "expect \"ui:" + path + "\" == absent\n";
        continue;
      }
      script += "expect demand." + demand.name + " == 0\nclick \"" + path +
                "\"\nwait_frames 3\nexpect demand." + demand.name + " == 1\n";
      for (const DemandParameter& parameter : demand.parameters)
        script += "hover \"" + path + " " + parameter.name + "\"\n";
      script += "hover \"" + path + " help\"\n";
    }
    script += "screenshot PICTURES/demands_" + std::to_string(static_cast<int>(mode)) + ".png\n";
    const Playback run = play(script);
    EXPECT_EQ(run.status, 0) << run.output;
  }
}

TEST_F(DesignPanelTest, ADemandIsReportedMetShownAndTakenBack) {
  const Playback run = play(R"(
    sample dome 200
    wait_loaded 20
    wait_solved 60
    expect violation.face == none
    click "Design/demand face"
    wait_frames 3
    expect demand.face == 1
    expect undo contains "on"
    wait_solved 100
    expect rows.face > 0
    expect violation.face <= 1e-9
    expect violated.face == 0
    expect planarity_relative <= 1e-9
    expect "ui:Design/show face" == absent
    screenshot PICTURES/demand_met.png
    key Ctrl+Z
    wait_frames 3
    expect demand.face == 0
    wait_solved 60
    expect violation.face == none
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(DesignPanelTest, WhatCannotBeMetIsNamedShownAndGivenUp) {
  // Where a torus curves both ways its panels cannot be convex.
  const Playback run = play(R"(
    sample torus 100
    wait_loaded 20
    wait_solved 60
    click "Design/demand convex"
    wait_solved 150
    expect status == infeasible
    expect conflicts > 0
    expect violated.convex > 0
    remember conflicts named
    expect selected_panel == -1
    expect selected_point == -1
    remember camera before
    click "Design/show convex"
    wait_frames 5
    expect camera != $before
    remember camera there
    screenshot PICTURES/conflict.png
    key Escape
    click "Design/show conflict 3"
    wait_frames 5
    expect camera != $there
    print selected_panel selected_point
    screenshot PICTURES/conflict_shown.png
    click "Design/give up"
    wait_frames 3
    expect waived == $named
    expect undo contains "Give up"
    wait_solved 150
    expect status != infeasible
    expect conflicts == 0
    expect violated.convex == 0
    expect planarity_relative <= 1e-9
    hover "Design/take back"
    wait_frames 3
    screenshot PICTURES/given_up.png
    click "Design/take back"
    wait_frames 3
    expect waived == 0
    key Ctrl+Z
    key Ctrl+Z
    wait_frames 3
    expect waived == 0
    expect demand.convex == 1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(printed(run, "selected_panel") != "-1" || printed(run, "selected_point") != "-1") << run.output;
}

TEST_F(DesignPanelTest, NeverTouchTurnsOnAllThreeAndCountsCrossings) {
  const Playback run = play(R"(
    sample dome 200
    wait_loaded 20
    wait_solved 60
    expect crossings == -1
    click "Design/never touch"
    wait_frames 3
    expect demand.vertex == 1
    expect demand.face == 1
    expect demand.edge == 1
    expect never_touch == on
    wait_solved 200
    expect crossings == 0
    expect violation.edge <= 1e-9
    screenshot PICTURES/never_touch.png
    click "Design/demand edge"
    wait_frames 3
    expect never_touch == mixed
    click "Design/never touch"
    wait_frames 3
    expect never_touch == on
    click "Design/never touch"
    wait_frames 3
    expect never_touch == off
    expect demand.vertex == 0
    key Ctrl+Z
    wait_frames 3
    expect never_touch == on
    # What means nothing for the other mode is off there, in one step.
    key 2
    wait_frames 3
    expect demand.vertex == 0
    expect last_message contains "nothing in this mode"
    key Ctrl+Z
    wait_frames 3
    expect never_touch == on
    expect mode == dual
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(DesignPanelTest, ABandIsTypedAndEmptied) {
  const Playback run = play(R"(
    sample dome 100
    wait_loaded 20
    wait_solved 60
    click "Design/demand offset-band"
    wait_frames 3
    ctrl_click "Design/demand offset-band low"
    wait_frames 3
    type "-0.02"
    key Enter
    wait_frames 3
    expect demand.offset-band.low == -0.02
    ctrl_click "Design/demand offset-band high"
    wait_frames 3
    type "0.03"
    key Enter
    wait_frames 3
    expect demand.offset-band.high == 0.03
    wait_solved 60
    expect violation.offset-band <= 1e-9
    ctrl_click "Design/demand offset-band high"
    wait_frames 3
    key Backspace
    wait_frames 3
    key Enter
    wait_frames 3
    expect demand.offset-band.high == none
    key Ctrl+Z
    wait_frames 3
    expect demand.offset-band.high == 0.03
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(DesignPanelTest, FitsSmallAndLargeWindowsInBothThemes) {
  for (const char* size : {"1280x800", "1600x1000"}) {
    for (const char* theme : {"light", "dark"}) {
      const Playback run = play(
          "wait_loaded 20\nwait_solved 60\nhover \"Design/weight proxy-normal\"\nwait_frames 3\n"
          "screenshot PICTURES/design_" +
              std::string(size) + "_" + theme + ".png\nhover Design/Solve\n",
          "--theme " + std::string(theme), 240, size);
      EXPECT_EQ(run.status, 0) << run.output;
    }
  }
}

}  // namespace
}  // namespace planewright
