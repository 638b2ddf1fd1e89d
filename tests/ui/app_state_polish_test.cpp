// Which solver the window asks for, when a polish starts, and what one must not disturb. The tests rest on
// what was asked for, not on which solver answered.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace std::chrono_literals;
using namespace test;

void run_for(AppState& state, std::chrono::milliseconds time) {
  const auto limit = Clock::now() + time;
  run_until(state, [&] { return Clock::now() > limit; });
}

void change_fairing(AppState& state, double weight, std::string merge_key = {}) {
  LayerSettings settings = state.document().settings();
  settings.weights["fairing"] = weight;
  state.change_settings(std::move(settings), "Weight of fairing", std::move(merge_key));
}

void change_offset(AppState& state, double offset) {
  LayerSettings settings = state.document().settings();
  settings.offset = offset;
  state.change_settings(std::move(settings), "Offset", "offset");
}

TEST(AppStatePolish, SlidersOffsetsAndPinsAskTheTangentSolver) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.asked_solver(), SolverKind::Tangent);
  state.select_point(0, Combine::Replace);
  ASSERT_EQ(state.pin_selection(), 1);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.asked_solver(), SolverKind::Tangent);
  const Vector3d at = *state.pin_place(state.document().settings().demands.pins[0]);
  const double edge = state.mean_edge();
  for (int i = 1; i <= 3; ++i) {
    // Each begins at a polished result, so that what it asks for is its own.
    state.polish();
    ASSERT_TRUE(settle(state));
    ASSERT_TRUE(state.polished());
    ASSERT_EQ(state.asked_solver(), SolverKind::Auto);
    const auto ticket = state.ticket();
    if (i == 1) change_fairing(state, 0.5, "weight fairing");
    if (i == 2) change_offset(state, 0.1 * edge);
    if (i == 3) state.move_pin(0, at + Vector3d(0, 0, 0.05 * edge));
    ASSERT_TRUE(run_until(state, [&] { return state.ticket() > ticket; }));
    EXPECT_EQ(state.asked_solver(), SolverKind::Tangent) << i;
    EXPECT_FALSE(state.polishing()) << i;
    state.end_merge();
    ASSERT_TRUE(settle(state));
    EXPECT_FALSE(state.polished()) << i;
  }
}

TEST(AppStatePolish, GoesOnFromTheResultAndKeepsItInView) {
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  ASSERT_TRUE(state.can_polish());
  EXPECT_FALSE(state.polished());
  const auto before = state.shown();
  const auto revision = state.document().revision();
  state.polish();
  EXPECT_TRUE(state.solving());
  ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
  EXPECT_EQ(state.asked_solver(), SolverKind::Auto);
  EXPECT_FALSE(state.can_polish());
  ASSERT_TRUE(run_until(state, [&] {
    EXPECT_TRUE(state.shown() == before || state.shown()->final) << "a state on Ipopt's way, not planar";
    return state.settled();
  }));
  EXPECT_TRUE(state.polished());
  EXPECT_EQ(state.report()->status, SolveStatus::Converged);
  EXPECT_EQ(state.shown()->ticket(), state.ticket());
  EXPECT_LE(state.shown()->planarity.max_relative_to_bbox, 1e-9);
  EXPECT_EQ(state.document().revision(), revision);
  EXPECT_FALSE(state.document().can_undo()) << "a polish is no step of undo";
  EXPECT_TRUE(state.messages().empty());
}

TEST(AppStatePolish, NothingToPolish) {
  AppState state;
  EXPECT_FALSE(state.can_polish());
  state.polish();
  state.open_sample("dome", 100);
  EXPECT_FALSE(state.can_polish());
  ASSERT_TRUE(run_until(state, [&] { return state.shown() != nullptr; }));
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.can_polish());
  state.polish();
  ASSERT_TRUE(settle(state));
  EXPECT_FALSE(state.can_polish()) << "it is polished";
  // A result of another design than the present one is none.
  state.solve();
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.can_polish());
  state.set_auto_solve(false);
  change_fairing(state, 1.0);
  EXPECT_FALSE(state.can_polish());
  const auto ticket = state.ticket();
  state.polish();
  run_for(state, 50ms);
  EXPECT_EQ(state.ticket(), ticket);
  state.undo();
  EXPECT_TRUE(state.can_polish());
}

TEST(AppStatePolish, AnEditSupersedesIt) {
  for (const bool drags : {false, true}) {
    AppState state;
    state.open_sample("torus", 600);
    ASSERT_TRUE(settle(state));
    state.polish();
    ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
    change_fairing(state, 0.5, drags ? "weight fairing" : "");
    state.update(Clock::now());
    EXPECT_FALSE(state.polishing()) << "at once, though a polish shows no step";
    EXPECT_EQ(state.asked_solver(), SolverKind::Tangent);
    state.end_merge();
    ASSERT_TRUE(settle(state));
    EXPECT_FALSE(state.polished());
    EXPECT_TRUE(state.up_to_date());
  }
}

TEST(AppStatePolish, StoppingItKeepsTheResult) {
  AppState state;
  state.open_sample("torus", 600);
  ASSERT_TRUE(settle(state));
  const auto before = state.shown();
  const SolveStatus status = state.report()->status;
  state.polish();
  ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
  state.stop();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.report()->status, status);
  if (!state.polished()) {  // unless it was through already
    EXPECT_EQ(state.shown(), before);
    EXPECT_TRUE(state.can_polish());
  }
  EXPECT_TRUE(state.messages().empty());
}

TEST(AppStatePolish, ByItselfOnceAndNotWhileAControlIsHeld) {
  AppState state;
  state.set_polish_automatically(true);
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.polished());
  EXPECT_EQ(state.ticket(), 2u) << "a solve and its polish";
  run_for(state, 100ms);
  EXPECT_EQ(state.ticket(), 2u) << "once";

  change_fairing(state, 0.5, "weight fairing");
  ASSERT_TRUE(settle(state));
  run_for(state, 100ms);
  EXPECT_FALSE(state.polished());
  EXPECT_EQ(state.asked_solver(), SolverKind::Tangent);
  EXPECT_FALSE(state.solving());
  const auto held = state.ticket();
  state.end_merge();
  EXPECT_TRUE(state.solving());
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.polished());
  EXPECT_EQ(state.ticket(), held + 1);
  state.undo();
  EXPECT_FALSE(state.document().can_undo()) << "the drag alone was a step";
}

TEST(AppStatePolish, ByItselfNotAfterAStop) {
  AppState state;
  state.set_polish_automatically(true);
  state.open_sample("torus", 600);
  ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
  const auto ticket = state.ticket();
  state.stop();
  ASSERT_TRUE(settle(state));
  run_for(state, 100ms);
  EXPECT_EQ(state.ticket(), ticket);
}

TEST(AppStatePolish, EveryLayerInTurn) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  Layer inner = state.document().design().layers[1];
  inner.coplanar_with = 0;  // solved again when the other's polish has moved that
  state.change_layer(1, inner, "Beams to outer");
  state.set_polish_automatically(true);
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.polished());
  EXPECT_EQ(state.layer_status(1), LayerStatus::Done);
  state.set_active_layer(0);
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.polished());
  EXPECT_EQ(state.layer_status(0), LayerStatus::Done);
}

// An edit of one layer ends the polish of another, whose result stands.
TEST(AppStatePolish, OfAnotherLayerLeavesItsResult) {
  AppState state;
  state.open_sample("torus", 600);
  ASSERT_TRUE(settle(state));
  state.add_layer();
  ASSERT_TRUE(settle(state));
  state.polish();
  ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
  EXPECT_EQ(state.solving_layer(), 1);
  const auto inner = state.shown(1);
  state.set_active_layer(0);
  change_fairing(state, 0.2);
  state.update(Clock::now());
  EXPECT_EQ(state.solving_layer(), 0);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown(1), inner);
  state.set_active_layer(1);
  EXPECT_TRUE(state.can_polish());
}

TEST(AppStatePolish, ThicknessIsShownWhileItRuns) {
  AppState state;
  state.open_sample("torus", 600);
  ASSERT_TRUE(settle(state));
  state.polish();
  ASSERT_TRUE(run_until(state, [&] { return state.polishing(); }));
  Layer thick = state.document().design().layers[0];
  thick.thickness = 0.05 * state.mean_edge();
  state.change_layer(0, thick, "Thickness");
  EXPECT_TRUE(state.polishing()) << "no matter of the solver";
  ASSERT_TRUE(run_until(state, [&] { return state.shown()->thickness != nullptr; }));
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.shown()->thickness);
  EXPECT_TRUE(state.polished());
}

}  // namespace
}  // namespace planewright::ui
