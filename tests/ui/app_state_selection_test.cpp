// Selections and pins in the window's state.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

TEST(AppState, SelectsElementsOfTheMeshAndStoresThem) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.select_panel(5, Combine::Replace);
  state.select_panel(9, Combine::Add);
  const auto& origin = state.shown()->complex().plane_origin;
  EXPECT_EQ(element_count(state.selection()), 2);
  EXPECT_TRUE(std::count(state.selection().vertices.begin(), state.selection().vertices.end(), origin[5]));
  EXPECT_EQ(state.selected_panel, 9);
  state.select_panel(9, Combine::Remove);
  EXPECT_EQ(state.selection().vertices, std::vector<int>{origin[5]});

  const auto ticket = state.ticket();
  state.store_selection();
  ASSERT_EQ(state.document().design().selections.size(), 1u);
  EXPECT_EQ(state.document().design().selections[0].name, "selection 1");
  EXPECT_TRUE(state.rename_selection("selection 1", "eaves"));
  EXPECT_FALSE(state.rename_selection("nothing", "eaves"));
  EXPECT_EQ(state.messages().size(), 1u);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.ticket(), ticket) << "no demand names it, so nothing is solved";
  state.undo();
  state.undo();
  EXPECT_TRUE(state.document().design().selections.empty());
}

TEST(AppState, ShowsElements) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.show_element({ElementKind::Panel, 7});
  EXPECT_EQ(state.selected_panel, 7);
  auto look = state.take_look_at();
  ASSERT_TRUE(look);
  EXPECT_NEAR((look->point - centroid(state.shown()->points, state.shown()->complex().panels[7])).norm(), 0,
              1e-12);
  EXPECT_FALSE(state.take_look_at()) << "once";
  state.show_element({ElementKind::PanelEdge, 3});
  EXPECT_EQ(state.selected_edge, 3);
  EXPECT_FALSE(state.selected_panel);
  state.show_element({ElementKind::Point, 11});
  EXPECT_EQ(state.selected_point, 11);
  state.take_look_at();
  state.show_element({ElementKind::Point, 1'000'000});
  EXPECT_FALSE(state.take_look_at());
  EXPECT_EQ(state.selected_point, 11);
}

TEST(AppState, APinnedPointStaysAndGoesWhereItIsMoved) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  int point = 0;
  while (state.shown()->complex().point_origin[static_cast<std::size_t>(point)].kind != PointKind::Face)
    ++point;
  const Vector3d at = state.shown()->points.row(point).transpose();
  state.select_point(point, Combine::Replace);
  EXPECT_EQ(state.pin_selection(), 1);
  EXPECT_EQ(state.document().undo_name(), "Pin 1 point");
  LayerSettings faired = with_fairing(state, 5.0);
  state.change_settings(faired, "Weight of fairing");
  ASSERT_TRUE(settle(state));
  const double edge = state.mean_edge();
  EXPECT_NEAR((Vector3d(state.shown()->points.row(point)) - at).norm(), 0.0, 1e-6 * edge);

  const Vector3d there = at + Vector3d(0, 0, 0.2 * edge);
  for (int i = 1; i <= 4; ++i) state.move_pin(0, at + Vector3d(0, 0, 0.05 * i * edge));
  state.end_merge();
  ASSERT_TRUE(settle(state));
  EXPECT_NEAR((Vector3d(state.shown()->points.row(point)) - there).norm(), 0.0, 1e-6 * edge);
  state.undo();
  const auto& pin = state.document().settings().demands.pins.at(0);
  EXPECT_NEAR(*pin.at[2] - state.scene_origin().z(), at.z(), 1e-9 * edge) << "the drag was one step";

  Pin flat = pin;
  flat.at = {std::nullopt, std::nullopt, flat.at[2]};
  state.change_pin(0, flat, "Free a coordinate");
  state.move_pin(0, there + Vector3d(edge, edge, 0));
  EXPECT_FALSE(state.document().settings().demands.pins[0].at[0]) << "what is free stays free";
  EXPECT_EQ(state.unpin_selection(), 1);
  EXPECT_TRUE(state.document().settings().demands.pins.empty());
}

TEST(AppState, APinnedPanelStaysInItsPlane) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const int panel = state.shown()->complex().plane_count() / 2;
  state.select_panel(panel, Combine::Replace);
  EXPECT_EQ(state.pin_selection(), 1);
  const State before = state.shown()->iterate->state;
  state.change_settings(with_fairing(state, 5.0), "Weight of fairing");
  ASSERT_TRUE(settle(state));
  const State& after = state.shown()->iterate->state;
  EXPECT_NEAR(after.n.row(panel).dot(before.n.row(panel)), 1.0, 1e-9);
  EXPECT_NEAR(after.h[panel], before.h[panel], 1e-6 * state.mean_edge());
  EXPECT_NE(after.x, before.x);
  state.remove_plane_pin(0);
  EXPECT_TRUE(state.document().settings().demands.plane_pins.empty());
}

}  // namespace
}  // namespace planewright::ui
