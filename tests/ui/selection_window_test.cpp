// Selecting and pinning in the real window, driven by scripts.
#include "support/window_fixture.h"

namespace planewright {
namespace {

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

}  // namespace
}  // namespace planewright
