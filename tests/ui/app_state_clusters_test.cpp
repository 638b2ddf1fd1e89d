// Clusters in the window's state: how they come to be, change with a slider and by hand, are undone, solved
// and measured.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/design/presets.h"
#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

void enter_clusters(AppState& state) {
  LayerSettings settings = state.document().settings();
  settings.mode = ComplexKind::Cluster;
  ASSERT_TRUE(apply(**find_preset("proxy-planes"), settings));
  state.change_settings(settings, "Mode cluster");
  ASSERT_TRUE(settle(state));
  ASSERT_NE(state.clusters(), nullptr);
}

void ask_for(AppState& state, int panels, const std::string& merge_key = {}) {
  ClusterOptions options = state.cluster_options();
  options.panels = panels;
  state.set_cluster_options(options, "Cluster into " + std::to_string(panels), merge_key);
}

// Two regions side by side.
std::pair<int, int> neighbours(const AppState& state) {
  const FaceGraph& graph = *state.clusters()->graph;
  const std::vector<int>& regions = state.clusters()->regions.region_of_face;
  for (std::size_t c = 0; c < graph.beside.size(); ++c) {
    if (graph.beside[c] < 0) continue;
    const int a = regions[graph.face_of_corner[c]], b = regions[graph.beside[c]];
    if (a != b) return {a, b};
  }
  return {-1, -1};
}

TEST(AppStateClusters, TheModeMakesRegionsAndSolvesThem) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  const std::size_t steps = state.document().history().size();
  enter_clusters(state);
  EXPECT_EQ(state.document().history().size(), steps + 1) << "the first clusters are part of the switch";
  EXPECT_GT(state.clusters()->regions.count(), 5);
  ASSERT_NE(state.shown(), nullptr);
  EXPECT_EQ(state.shown()->complex().kind, ComplexKind::Cluster);
  EXPECT_EQ(state.shown()->complex().plane_count(), state.clusters()->regions.count());
  EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9);
  ASSERT_NE(state.region_view(), nullptr);
  EXPECT_EQ(state.region_view()->clusters, state.clusters());
  ASSERT_TRUE(run_until(state, [&] { return state.cluster_report() != nullptr; }));
  EXPECT_TRUE(state.cluster_report()->panels_to_mesh.has_value());
  EXPECT_FALSE(state.cluster_report()->corners_by_valence.empty());
  EXPECT_GT(state.cluster_report()->l21, 0.0);
}

TEST(AppStateClusters, ADraggedSliderIsOneStepAndShowsItsLastValue) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const auto before = state.clusters();
  const std::size_t steps = state.document().history().size();
  for (const int panels : {22, 26, 31, 40}) {
    ask_for(state, panels, "clusters count");
    for (int i = 0; i < 3; ++i) state.update(Clock::now());
  }
  state.end_merge();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.cluster_options().panels, 40);
  EXPECT_EQ(state.clusters()->clustering.regions(), 40);
  EXPECT_EQ(state.document().history().size(), steps + 1);
  EXPECT_EQ(state.shown()->complex().plane_count(), state.clusters()->regions.count());
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters(), before);
  EXPECT_EQ(state.cluster_options().panels, before->options.panels);
  EXPECT_EQ(state.shown()->complex().plane_count(), before->regions.count());
  state.redo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters()->clustering.regions(), 40);
}

TEST(AppStateClusters, MergeAndSplitAreStepsAndAreSolved) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const int count = state.clusters()->regions.count();
  const auto [a, b] = neighbours(state);
  ASSERT_GE(a, 0);
  state.merge_regions(a, b);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters()->regions.count(), count - 1);
  EXPECT_TRUE(state.document().undo_name().starts_with("Merge regions"));
  EXPECT_EQ(state.shown()->complex().plane_count(), count - 1);
  state.split_region(std::min(a, b));
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters()->regions.count(), count);
  EXPECT_TRUE(state.document().undo_name().starts_with("Split region"));
  state.undo();
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters()->regions.count(), count);
  EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9);
}

TEST(AppStateClusters, WhatCannotBeMergedIsSaidAndNothingChanges) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const auto before = state.clusters();
  const auto posted = state.messages_posted();
  // One that region 0 does not touch.
  std::set<int> beside{0};
  const FaceGraph& graph = *before->graph;
  const std::vector<int>& regions = before->regions.region_of_face;
  for (std::size_t c = 0; c < graph.beside.size(); ++c) {
    if (graph.beside[c] >= 0 && regions[graph.face_of_corner[c]] == 0)
      beside.insert(regions[graph.beside[c]]);
  }
  int apart = 0;
  while (beside.contains(apart)) ++apart;
  ASSERT_LT(apart, before->regions.count());
  state.merge_regions(0, apart);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters(), before);
  EXPECT_EQ(state.messages_posted(), posted + 1);
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Refused);
  EXPECT_FALSE(state.messages().back().remedy.empty());
}

TEST(AppStateClusters, AStrokeMovesTheBorderAndIsOneStep) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const std::size_t steps = state.document().history().size();
  const FaceGraph& graph = *state.clusters()->graph;
  const std::vector<int> regions = state.clusters()->regions.region_of_face;
  // A face of another region that a region can take, and that region's face beside it.
  int from = -1, taken = -1;
  for (std::size_t c = 0; c < graph.beside.size() && from < 0; ++c) {
    const int f = graph.face_of_corner[c], g = graph.beside[c];
    if (g < 0 || regions[f] == regions[g]) continue;
    const auto painted = with_faces_painted(*state.clusters(), std::vector<int>{g}, f);
    if (!painted || !painted->refused.empty()) continue;
    from = f;
    taken = g;
  }
  ASSERT_GE(from, 0);
  state.begin_painting(from);
  EXPECT_EQ(state.painting_region(), regions[static_cast<std::size_t>(from)]);
  state.paint({taken});
  for (int i = 0; i < 5; ++i) state.update(Clock::now());
  state.end_painting();
  ASSERT_TRUE(settle(state));
  const std::vector<int>& now = state.clusters()->regions.region_of_face;
  EXPECT_EQ(now[static_cast<std::size_t>(taken)], now[static_cast<std::size_t>(from)]);
  EXPECT_EQ(state.document().history().size(), steps + 1);
  EXPECT_TRUE(state.document().undo_name().starts_with("Paint region"));
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.clusters()->regions.region_of_face, regions);
}

TEST(AppStateClusters, TooManyOrTooFewRegionsAreRefusedAndNothingIsLost) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const auto before = state.clusters();
  const auto fingerprint = state.shown()->fingerprint;
  for (const int panels : {100000, 0}) {
    ask_for(state, panels);
    ASSERT_TRUE(settle(state));
    ASSERT_TRUE(state.cluster_error().has_value()) << panels;
    EXPECT_NE(state.cluster_error()->what.find(std::to_string(panels)), std::string::npos)
        << state.cluster_error()->what;
    EXPECT_EQ(state.clusters(), before);
    EXPECT_EQ(state.shown()->fingerprint, fingerprint);
  }
  ask_for(state, 12);
  ASSERT_TRUE(settle(state));
  EXPECT_FALSE(state.cluster_error().has_value());
  EXPECT_EQ(state.clusters()->clustering.regions(), 12);
}

TEST(AppStateClusters, OneRegionForAClosedModelIsRepairedOrRefused) {
  AppState state;
  state.open_sample("torus", 200);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const auto before = state.clusters();
  ask_for(state, 1);
  ASSERT_TRUE(settle(state));
  if (state.cluster_error()) {
    EXPECT_EQ(state.clusters(), before);
    EXPECT_FALSE(state.cluster_error()->what.empty());
  } else {
    EXPECT_GT(state.clusters()->regions.count(), 1) << "no disk covers a torus";
    EXPECT_FALSE(state.clusters()->regions.repairs.empty());
  }
}

TEST(AppStateClusters, SeedsByLotAreTheSameForTheSameNumber) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  const auto with_seed = [&](std::uint32_t number) {
    ClusterOptions options = state.cluster_options();
    options.seeds = SeedKind::Random;
    options.seed_number = number;
    state.set_cluster_options(options, "Seed", {}, true);
    EXPECT_TRUE(settle(state));
    return state.clusters()->regions.region_of_face;
  };
  const auto first = with_seed(3), second = with_seed(4), again = with_seed(3);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, second);
}

TEST(AppStateClusters, StoppingKeepsTheRegionsThatThereAre) {
  AppState state;
  state.set_auto_solve(false);
  state.open_sample("dome", 8000);
  ASSERT_TRUE(run_until(state, [&] { return !state.loading() && !state.document().empty(); }));
  LayerSettings settings = state.document().settings();
  settings.mode = ComplexKind::Cluster;
  state.change_settings(settings, "Mode cluster");
  ASSERT_TRUE(run_until(state, [&] { return state.clustering(); }));
  state.stop();
  EXPECT_TRUE(state.busy());
  ASSERT_TRUE(run_until(state, [&] { return !state.clustering(); }));
  ASSERT_NE(state.clusters(), nullptr);
  EXPECT_GT(state.clusters()->regions.count(), 10);
  EXPECT_FALSE(state.cluster_error());
}

TEST(AppStateClusters, ARegionAndItsPanelAreSelectedTogether) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  enter_clusters(state);
  state.select_region(2, Combine::Replace);
  EXPECT_EQ(state.selected_regions(), (std::vector<int>{2}));
  state.select_region(4, Combine::Add);
  EXPECT_EQ(state.selected_regions(), (std::vector<int>{2, 4}));
  state.clear_selection();
  state.select_panel(3, Combine::Replace);
  EXPECT_EQ(state.selected_regions(), (std::vector<int>{3}));
}

}  // namespace
}  // namespace planewright::ui
