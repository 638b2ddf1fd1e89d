// Clusters in the real window, driven by scripts.
#include "support/window_fixture.h"

namespace planewright {
namespace {

// A bundled design, solved, in the mode of clusters.
const std::string kDomeInRegions = R"(
    click Hint/close
    sample dome 400
    wait_loaded 20
    wait_solved 60
    key 3
    wait_frames 3
    wait_solved 60
)";

TEST_F(WindowTest, TheThirdModeShowsRegionsBesideTheirPanels) {
  const Playback run = play(R"(
    click Hint/close
    sample dome 400
    wait_loaded 20
    wait_solved 60
    expect sight == panels
    expect ui:Design/regions == absent
    click "Design/mode Cluster"
    wait_frames 3
    wait_solved 60
    expect mode == cluster
    expect preset == proxy-planes
    expect status == converged
    expect regions > 5
    expect sight == beside
    remember regions regions
    expect panels == $regions
    expect undo == "Mode cluster"
    screenshot PICTURES/clusters.png
    click "Design/sight Input"
    wait_frames 3
    expect sight == regions
    key T
    wait_frames 3
    expect sight == beside
    key T
    wait_frames 6
    expect sight == over
    screenshot PICTURES/clusters_over.png
    click Menu/Clusters
    wait_frames 3
    click "Menu/Clusters/sight panels"
    wait_frames 3
    expect sight == panels
    key X                              # a tool needs regions in sight
    wait_frames 3
    expect tool == split
    expect sight == beside
    key Escape
    wait_frames 3
    expect tool == look
    key Ctrl+Z
    wait_frames 3
    wait_solved 60
    expect mode == dual
    expect sight == panels
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, TheSliderOfRegionsClustersWhileItIsDragged) {
  const Playback run = play(R"(
    click Hint/close
    sample dome 5000                   # 10,000 triangles
    wait_loaded 20
    wait_solved 120
    key 3
    wait_frames 3
    wait_solved 120
    remember regions before
    remember history steps
    clear_timings
    press Design/regions
    move Design/regions 0.5
    wait_frames 20
    move Design/regions 0.55
    wait_frames 20
    move Design/regions 0.6
    wait_frames 20
    move Design/regions 0.65
    wait_frames 20
    remember asked_regions dragged
    expect regions != $before          # while it is held
    release
    wait_solved 120
    print clustering_ms frame_median_ms frame_max_ms stream_cpu_max_ms regions asked_regions
    expect asked_regions == $dragged
    expect regions >= $dragged
    expect undo contains "Cluster into"
    expect clustering_ms < 1000
    remember history all
    key Ctrl+Z
    wait_frames 3
    wait_solved 120
    expect regions == $before
    screenshot PICTURES/clusters_slider.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, RegionsAreSplitAndMergedByClicksAndBroughtBack) {
  const Playback run = play(kDomeInRegions + R"(
    click "Design/regions number"
    wait_frames 3
    type "18"
    key Enter
    wait_frames 3
    wait_solved 60
    expect asked_regions == 18
    remember regions before
    click "Design/split region"
    wait_frames 3
    expect tool == split
    hover_region any
    wait_frames 3
    expect hovered_region >= 0
    screenshot PICTURES/clusters_split.png
    remember hovered_region split
    click_region any
    wait_frames 3
    wait_solved 60
    expect regions > $before
    remember regions more
    expect undo contains "Split region"
    expect panels == $more
    key J
    wait_frames 3
    expect tool == merge
    click_border any beside
    wait_frames 3
    wait_solved 60
    expect regions < $more
    remember history steps
    expect undo contains "Merge regions"
    click_region any                   # the other way: one, and then its neighbour
    wait_frames 3
    expect selected_regions == 1
    hover_region beside
    wait_frames 3
    screenshot PICTURES/clusters_merge.png
    click_region beside
    wait_frames 3
    wait_solved 60
    expect regions <= $more            # a repair may have split it again; that is told
    expect history > $steps
    expect undo contains "Merge regions"
    key Escape
    wait_frames 3
    expect tool == look
    key Ctrl+Z
    wait_frames 3
    key Ctrl+Z
    wait_frames 3
    key Ctrl+Z
    wait_frames 3
    wait_solved 60
    expect regions == $before
    expect panels == $before
    click_region any                   # plain: selects, and its panel
    wait_frames 3
    expect selected_regions == 1
    key Escape
    wait_frames 3
    expect selected == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, AStrokeOfTheBrushMovesABorder) {
  const Playback run = play(kDomeInRegions + R"(
    remember history steps
    key R
    wait_frames 3
    expect tool == paint
    remember camera before
    hover_region any
    wait_frames 3
    remember hovered_region from
    remember region_faces.$from faces
    screenshot PICTURES/clusters_brush.png
    drag_region any beside
    wait_frames 3
    wait_solved 60
    expect camera == $before           # the drag paints, it does not turn
    expect undo contains "Paint region"
    expect region_faces.$from > $faces
    screenshot PICTURES/clusters_painted.png
    key Ctrl+Z
    wait_frames 3
    wait_solved 60
    expect region_faces.$from == $faces
    expect can_redo == 1
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, TheReportNamesPanelsAndAClickGoesThere) {
  const Playback run = play(R"(
    click Hint/close
    sample train-station 900
    wait_loaded 20
    wait_solved 60
    key 3
    wait_frames 3
    wait_solved 60
    click "Findings/tab Report"
    wait_frames 30
    expect report_l21 > 0
    expect report_rms > 0
    expect report_acute > 0
    screenshot PICTURES/clusters_report.png
    remember camera before
    click "Findings/acute 0"
    wait_frames 40
    expect selected_panel >= 0
    expect camera != $before
    screenshot PICTURES/clusters_acute.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, NumbersOfRegionsThatCannotBeAreToldInThePanel) {
  const Playback run = play(R"(
    click Hint/close
    sample torus 300
    wait_loaded 20
    wait_solved 60
    key 3
    wait_frames 3
    wait_solved 60
    remember regions before
    remember fingerprint shown
    click "Design/regions number"
    wait_frames 3
    type "90000"
    key Enter
    wait_frames 3
    wait_solved 60
    expect cluster_error contains 90000
    expect regions == $before
    expect fingerprint == $shown
    screenshot PICTURES/clusters_too_many.png
    click "Design/regions number"
    wait_frames 3
    type "1"
    key Enter
    wait_frames 3
    wait_solved 60
    expect regions > 1                 # repaired, or what there was
    click "Design/regions number"
    wait_frames 3
    type "40"
    key Enter
    wait_frames 3
    wait_solved 60
    expect cluster_error == ""
    expect asked_regions == 40
    expect regions >= 40
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, MeasureAndSeedsAreChosenAndClusteredAnew) {
  const Playback run = play(R"script(
    click Hint/close
    sample dome 400
    wait_loaded 20
    wait_solved 60
    key 3
    wait_frames 3
    wait_solved 60
    click Design/metric
    wait_frames 3
    click "Design/metric/distances (L2)"
    wait_frames 3
    wait_solved 60
    expect undo contains "Measure"
    click Design/metric
    wait_frames 3
    click "Design/metric/own weights"
    wait_frames 3
    expect "ui:Design/metric distance" == enabled
    click Design/seeds
    wait_frames 3
    click "Design/seeds/by lot"
    wait_frames 3
    wait_solved 60
    ctrl_click Design/seed
    wait_frames 3
    type "7"
    key Enter
    wait_frames 3
    wait_solved 60
    expect undo contains "Seed 7"
    screenshot PICTURES/clusters_measure.png
    click "Design/cluster anew"
    wait_frames 3
    wait_solved 60
    expect undo contains "Cluster anew"
  )script",
                            "--theme dark");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
