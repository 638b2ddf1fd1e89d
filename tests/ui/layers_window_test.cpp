// Layers in the real window, driven by scripts.
#include "support/window_fixture.h"

namespace planewright {
namespace {

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
