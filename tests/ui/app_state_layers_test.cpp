// Layers in the window's state: which are solved when, and what each keeps.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

// Mean of the planes' signed offsets: positive outside.
double distance_to_design(const AppState& state, int layer) {
  return state.shown(layer)->iterate->state.h.mean();
}

TEST(AppState, ASecondLayerIsSolvedOnItsOwnSideAndTheFirstAgain) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto first = state.shown(0);
  state.add_layer();
  EXPECT_EQ(state.layer_count(), 2);
  EXPECT_EQ(state.active_layer(), 1);
  EXPECT_EQ(state.shown(0), first) << "what was there stays until the solver has been there";
  EXPECT_EQ(state.shown(1), nullptr);
  EXPECT_FALSE(state.settled());
  ASSERT_TRUE(settle(state));
  for (int i = 0; i < 2; ++i) {
    ASSERT_NE(state.report(i), nullptr);
    EXPECT_EQ(state.report(i)->status, SolveStatus::Converged);
    EXPECT_EQ(state.layer_status(i), LayerStatus::Done);
    EXPECT_TRUE(state.shown(i)->final);
    EXPECT_LE(state.shown(i)->planarity.max_relative_to_bbox, 1e-9);
  }
  EXPECT_GT(distance_to_design(state, 0), 0.0);
  EXPECT_LT(distance_to_design(state, 1), 0.0);
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.layer_count(), 1);
  EXPECT_EQ(state.document().settings().offset, 0.0);
}

TEST(AppState, AChangeOfOneLayerLeavesTheOthersAlone) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(settle(state));
  const auto outer = state.shown(0), inner = state.shown(1);
  state.change_settings(with_fairing(state, 2.0), "Weight of fairing");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown(0), outer);
  EXPECT_NE(state.shown(1)->fingerprint, inner->fingerprint);

  // Names, eyes and the choice of the active layer solve nothing.
  const auto ticket = state.ticket();
  Layer renamed = state.document().design().layers[0];
  renamed.name = "shell";
  renamed.visible = false;
  state.change_layer(0, renamed, "Rename");
  state.set_active_layer(0);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.ticket(), ticket);
  EXPECT_EQ(state.shown(), outer);
  EXPECT_EQ(state.document().undo_name(), "Rename");
}

TEST(AppState, AFlipSolvesEveryLayerInTurn) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(settle(state));
  const auto outer = state.shown(0), inner = state.shown(1);
  int edge = 0;
  while (!state.document().may_edit(MeshEdit::flip(edge))) ++edge;
  ASSERT_TRUE(state.edit_mesh(MeshEdit::flip(edge)));
  state.update(Clock::now());
  EXPECT_EQ(state.solving_layer(), 1) << "the active one first";
  EXPECT_EQ(state.layer_status(0), LayerStatus::Waiting);
  ASSERT_TRUE(settle(state));
  EXPECT_NE(state.shown(0)->complex().panels, outer->complex().panels);
  EXPECT_NE(state.shown(1)->complex().panels, inner->complex().panels);
}

TEST(AppState, ALayerThatIsSupersededIsSolvedAgain) {
  AppState state;
  state.open_sample("torus", 600);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  // The other layer is under way when the active one changes.
  ASSERT_TRUE(run_until(state, [&] { return state.solving_layer() == 0; }));
  state.change_settings(with_fairing(state, 0.5), "Weight of fairing");
  state.update(Clock::now());
  EXPECT_EQ(state.solving_layer(), 1);
  ASSERT_TRUE(settle(state));
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(state.shown(i)->final);
    EXPECT_EQ(state.shown(i)->iterate->state.h.mean() > 0, i == 0);
  }
}

TEST(AppState, RemovingALayerWhileItIsSolved) {
  AppState state;
  state.open_sample("torus", 1500);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(run_until(state, [&] { return state.solving_layer() == 1; }));
  state.remove_layer(1);
  EXPECT_EQ(state.layer_count(), 1);
  EXPECT_FALSE(state.solving_layer());
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.shown()->final);
  EXPECT_GT(state.shown()->iterate->state.h.mean(), 0.0) << "the outer layer's result, not the removed one's";
  EXPECT_EQ(state.layer_status(0), LayerStatus::Done);
  state.remove_layer(0);
  EXPECT_EQ(state.layer_count(), 1) << "the last one stays";
}

TEST(AppState, RemovingTheFirstLayerKeepsTheSecondsResult) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(settle(state));
  const auto inner = state.shown(1);
  const auto ticket = state.ticket();
  state.remove_layer(0);
  EXPECT_EQ(state.active_layer(), 0);
  EXPECT_EQ(state.shown(), inner);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.ticket(), ticket) << "nothing had to be solved";
}

TEST(AppState, OpeningANewMeshLeavesOneLayer) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  state.open_sample("vault", 100);
  ASSERT_TRUE(run_until(state, [&] { return state.document().name() == "vault" && state.settled(); }));
  EXPECT_EQ(state.layer_count(), 1);
  EXPECT_EQ(state.document().settings().offset, 0.0);
}

TEST(AppState, ThicknessNeedsNoSolve) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto ticket = state.ticket();
  Layer thick = state.document().design().layers[0];
  thick.thickness = 0.05 * state.mean_edge();
  state.change_layer(0, thick, "Thickness", "thickness");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.ticket(), ticket);
  const auto& view = *state.shown();
  ASSERT_TRUE(view.thickness);
  EXPECT_EQ(view.thickness->sides.count, static_cast<int>(view.complex().panel_edges.size()));
  EXPECT_LT(view.thickness->sides.planarity, 1e-9 * state.mean_edge());
  EXPECT_EQ(view.thickness->back.geometry->polygons, view.complex().panels);
  thick.thickness = 0.0;
  state.change_layer(0, thick, "Thickness");
  ASSERT_TRUE(settle(state));
  EXPECT_FALSE(state.shown()->thickness);
}

TEST(AppState, ACoplanarLayerFollowsTheOneItIsFittedTo) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(settle(state));
  Layer inner = state.document().design().layers[1];
  inner.coplanar_with = 0;
  state.change_layer(1, inner, "Beams to outer");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.layer_status(1), LayerStatus::Done);
  ASSERT_TRUE(state.shown(1)->beams);
  EXPECT_EQ(state.shown(1)->beams->count, static_cast<int>(state.shown(1)->complex().panel_edges.size()));
  EXPECT_LT(state.shown(1)->beams->planarity, 1e-6 * state.mean_edge());
  EXPECT_TRUE(state.document().settings().demands.list.empty()) << "it is no demand of the designer's own";

  const auto before = state.shown(1);
  state.set_active_layer(0);
  state.change_settings(with_fairing(state, 3.0), "Weight of fairing");
  ASSERT_TRUE(settle(state));
  EXPECT_NE(state.shown(1)->fingerprint, before->fingerprint);
  EXPECT_LT(state.shown(1)->beams->planarity, 1e-6 * state.mean_edge());
}

}  // namespace
}  // namespace planewright::ui
