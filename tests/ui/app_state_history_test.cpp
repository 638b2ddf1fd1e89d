// Edits of the mesh, undo and redo in the window's state: what is shown at each moment, and what follows.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;
using namespace test;

void change_fairing(AppState& state, double weight, std::string merge_key = {}) {
  LayerSettings settings = state.document().settings();
  settings.weights["fairing"] = weight;
  state.change_settings(std::move(settings), "Weight of fairing", std::move(merge_key));
}

int inner_edge(const PolygonMesh& mesh) {
  int edge = 0;
  while (!mesh.can_flip(edge) || mesh.is_border_vertex(mesh.edge(edge).a) ||
         mesh.is_border_vertex(mesh.edge(edge).b) || !may_apply(mesh, MeshEdit::collapse(edge))) {
    ++edge;
  }
  return edge;
}

TEST(AppStateHistory, UndoAndRedoShowThePanelsOfTheMoment) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto opened = state.shown()->fingerprint;
  ASSERT_TRUE(state.edit_mesh(MeshEdit::collapse(inner_edge(*state.document().mesh()))));
  ASSERT_TRUE(settle(state));
  const auto collapsed = state.shown()->fingerprint;
  change_fairing(state, 1.0);
  ASSERT_TRUE(settle(state));
  const auto faired = state.shown()->fingerprint;
  EXPECT_NE(collapsed, faired);
  EXPECT_EQ(state.document().history().size(), 2u) << "solves that follow by themselves are no steps";

  const auto ticket = state.ticket();
  const auto expect_shown = [&](std::uint64_t fingerprint) {
    ASSERT_TRUE(settle(state));
    EXPECT_EQ(state.shown()->fingerprint, fingerprint);
    EXPECT_TRUE(state.shown()->final);
    EXPECT_TRUE(state.up_to_date());
    EXPECT_NE(state.report(), nullptr);
    EXPECT_EQ(state.ticket(), ticket) << "nothing was solved again";
  };
  state.undo();
  expect_shown(collapsed);
  state.undo();
  expect_shown(opened);
  state.go_to(2);
  expect_shown(faired);
  state.go_to(0);
  expect_shown(opened);
  state.redo();
  expect_shown(collapsed);
}

TEST(AppStateHistory, ASolveThatIsAskedForIsAStep) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto opened = state.shown()->fingerprint;
  state.set_auto_solve(false);
  change_fairing(state, 2.0);
  state.solve();
  ASSERT_TRUE(settle(state));
  const auto solved = state.shown()->fingerprint;
  EXPECT_EQ(state.document().history(), (std::vector<std::string>{"Weight of fairing", "Solve"}));
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->fingerprint, opened);
  EXPECT_FALSE(state.up_to_date()) << "of another weight";
  EXPECT_EQ(state.document().settings().weights.at("fairing"), 2.0);
  state.redo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->fingerprint, solved);
  EXPECT_TRUE(state.up_to_date());
}

TEST(AppStateHistory, AnUndoStopsTheSolveThatRuns) {
  AppState state;
  state.open_sample("torus", 1500);
  ASSERT_TRUE(settle(state));
  const auto opened = state.shown()->fingerprint;
  change_fairing(state, 3.0);
  ASSERT_TRUE(run_until(state, [&] { return state.solving_layer().has_value(); }));
  state.undo();
  EXPECT_FALSE(state.solving());
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->fingerprint, opened);
  EXPECT_TRUE(state.up_to_date());
  state.redo();
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.up_to_date()) << "what was not finished is solved";
  EXPECT_NE(state.shown()->fingerprint, opened);
}

TEST(AppStateHistory, AnEditStopsTheSolveThatRunsAndKeepsItsState) {
  AppState state;
  state.open_sample("torus", 1500);
  ASSERT_TRUE(settle(state));
  state.set_auto_solve(false);
  change_fairing(state, 3.0);
  state.solve();
  ASSERT_TRUE(run_until(state, [&] { return state.solving_layer().has_value(); }));
  const auto ticket = state.ticket();
  ASSERT_TRUE(state.edit_mesh(MeshEdit::collapse(inner_edge(*state.document().mesh()))));
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.ticket(), ticket) << "nothing else was solved";
  EXPECT_FALSE(state.up_to_date());
  EXPECT_EQ(state.shown()->ticket(), ticket);
  EXPECT_EQ(state.shown()->complex().plane_count(), state.document().mesh()->vertex_count() + 1);
  EXPECT_EQ(state.document().undo_name().substr(0, 8), "Collapse") << "a solve of another mesh is no step";
  EXPECT_TRUE(state.messages().empty());
}

TEST(AppStateHistory, ASolveGoesOnAfterEveryKindOfEdit) {
  AppState state;
  state.open_sample("dome", 120);
  ASSERT_TRUE(settle(state));
  const PolygonMesh& mesh = *state.document().mesh();
  const int edge = inner_edge(mesh);
  const MeshEdge ends = mesh.edge(edge);
  std::vector<MeshEdit> edits{
      MeshEdit::collapse(edge), MeshEdit::split_edge(edge), MeshEdit::flip(edge),
      MeshEdit::move_vertex(ends.a, mesh.positions().row(ends.b).transpose() * 0.3 +
                                        mesh.positions().row(ends.a).transpose() * 0.7)};
  for (int f = 0; f < mesh.face_count() && edits.size() < 5; ++f) {
    if (may_apply(mesh, MeshEdit::delete_face(f))) edits.push_back(MeshEdit::delete_face(f));
  }
  for (const MeshEdit& edit : edits) {
    ASSERT_TRUE(state.edit_mesh(edit)) << describe(edit);
    ASSERT_TRUE(settle(state)) << describe(edit);
    ASSERT_NE(state.report(), nullptr) << describe(edit);
    EXPECT_TRUE(state.up_to_date());
    EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9) << describe(edit);
    EXPECT_EQ(state.shown()->ids, state.document().ids());
    state.undo();
    ASSERT_TRUE(settle(state));
  }
  EXPECT_FALSE(state.document().can_undo());
}

TEST(AppStateHistory, WhatIsSelectedFollowsAndWhatIsGoneIsSaid) {
  AppState state;
  state.open_sample("dome", 120);
  ASSERT_TRUE(settle(state));
  const PolygonMesh& mesh = *state.document().mesh();
  const int edge = inner_edge(mesh);
  const int gone = std::max(mesh.edge(edge).a, mesh.edge(edge).b), last = mesh.vertex_count() - 1;
  ASSERT_LT(gone, last);
  state.select({{}, {gone, last}, {}, {}}, Combine::Replace);
  state.store_selection("roof");
  state.set_auto_solve(false);
  ASSERT_TRUE(state.edit_mesh(MeshEdit::collapse(edge)));
  EXPECT_EQ(state.selection().vertices, std::vector<int>{last - 1});
  ASSERT_EQ(state.messages().size(), 1u);
  EXPECT_EQ(state.messages()[0].what, "1 element of selection roof went with it (Ctrl Z brings all back)");

  // The panels shown are still those of the mesh before; a click on the last one means the same panel.
  EXPECT_EQ(state.shown()->complex().plane_count(), last + 1);
  state.clear_selection();
  state.select_panel(last, Combine::Replace);
  EXPECT_EQ(state.selection().vertices, std::vector<int>{last - 1});
  EXPECT_EQ(state.shown_panel(last - 1), last);
  EXPECT_EQ(state.of_shown(state.selection()).vertices, std::vector<int>{last});
  EXPECT_EQ(state.pin_selection(), 1);
  EXPECT_EQ(state.document().settings().demands.plane_pins.at(0).panel_origin, last - 1);
  state.solve();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->complex().plane_count(), last);
  EXPECT_EQ(state.shown_panel(last - 1), last - 1);
}

}  // namespace
}  // namespace planewright::ui
