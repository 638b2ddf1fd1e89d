// What the window knows of the workshop, without a window.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

void limit_edges(AppState& state, double least) {
  WorkshopContract contract = state.contract();
  contract.tolerances.edge_min = least;
  state.change_contract(contract, "Limit of edge length");
}

TEST(AppStateWorkshop, IsMadeOnlyWhileItIsInSight) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop(), nullptr);
  state.workshop_in_sight = true;
  ASSERT_TRUE(settle(state));
  ASSERT_NE(state.workshop(), nullptr);
  EXPECT_TRUE(state.workshop_fits());
  EXPECT_EQ(state.workshop()->model->panel_count(), state.shown()->complex().plane_count());
  EXPECT_FALSE(state.workshop()->classes.empty());
}

TEST(AppStateWorkshop, LimitsAreAStepThatSolvesNothing) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  const auto ticket = state.ticket();
  ASSERT_EQ(state.workshop()->verdicts.failed, 0);
  const auto model = state.workshop()->model;
  limit_edges(state, 1e5);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop()->verdicts.passed, 0);
  EXPECT_EQ(state.workshop()->model, model) << "what has not changed is kept";
  EXPECT_EQ(state.ticket(), ticket);
  EXPECT_EQ(state.document().undo_name(), "Limit of edge length");
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop()->verdicts.failed, 0);
}

TEST(AppStateWorkshop, TheUnitChangesVerdictsAndNoCoordinate) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  EXPECT_EQ(state.unit(), "m");
  limit_edges(state, 10.0);
  const auto fingerprint = state.shown()->fingerprint;
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop()->verdicts.failed, 0);
  WorkshopContract contract = state.contract();
  contract.unit = LengthUnit::Millimetre;
  state.change_contract(contract, "Unit mm");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.unit(), "mm");
  EXPECT_EQ(state.workshop()->verdicts.passed, 0);
  EXPECT_EQ(state.shown()->fingerprint, fingerprint);
}

TEST(AppStateWorkshop, GoingToAFailureSelectsItsPanelAndLooksThere) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  limit_edges(state, 1e5);
  ASSERT_TRUE(settle(state));
  state.walk_failures(1);
  ASSERT_EQ(state.current_failure(), 0);
  const ToleranceFailure failure = state.failure_list().failure(0);
  EXPECT_EQ(state.selected_panel, failure.panel);
  const auto look = state.take_look_at();
  ASSERT_TRUE(look);
  const auto corners = state.shown()->complex().panels[failure.panel];
  const auto side = static_cast<std::size_t>(failure.side);
  const Vector3d middle = 0.5 * (state.shown()->points.row(corners[side]) +
                                 state.shown()->points.row(corners[(side + 1) % corners.size()]))
                                    .transpose();
  EXPECT_LT((look->point - middle).norm(), 1e-9);
  EXPECT_GT(look->outside.dot(state.shown()->iterate->state.n.row(failure.panel).transpose()), 0.99);
  state.walk_failures(-1);
  EXPECT_EQ(state.current_failure(), state.failure_list().size() - 1);
  limit_edges(state, 0.0);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.current_failure(), std::nullopt);
}

TEST(AppStateWorkshop, TakingBackALimitLeavesThePanelsThatWereSolvedMeanwhile) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  state.change_settings(with_fairing(state, 0.5), "Weight of fairing");
  limit_edges(state, 1e5);
  ASSERT_TRUE(settle(state));
  const auto fingerprint = state.shown()->fingerprint;
  const auto ticket = state.ticket();
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->fingerprint, fingerprint);
  EXPECT_EQ(state.ticket(), ticket) << "nothing was solved again";
  EXPECT_TRUE(state.up_to_date());
  EXPECT_EQ(state.workshop()->verdicts.failed, 0);
}

TEST(AppStateWorkshop, OfPanelsBeforeAFlipNothingIsToldOfThoseAfterIt) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  limit_edges(state, 1e5);
  ASSERT_TRUE(settle(state));
  int edge = 0;
  while (!state.document().may_edit(MeshEdit::flip(edge))) ++edge;
  ASSERT_TRUE(state.edit_mesh(MeshEdit::flip(edge)));
  const auto before = state.shown();
  bool any = false;
  ASSERT_TRUE(run_until(state, [&] {
    if (const auto workshop = state.workshop()) {
      for (int p = 0; p < workshop->model->panel_count(); ++p)
        any |= workshop->passports[static_cast<std::size_t>(p)].sides.size() !=
               state.shown()->complex().panels[p].size();
    }
    return state.settled() && state.shown() != before;
  }));
  EXPECT_FALSE(any);
}

TEST(AppStateWorkshop, NamesThatWereGivenStayWhenPanelsMove) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 100));
  WorkshopModel given = *state.workshop()->model;
  given.names[0] = "mine";
  state.keep_names(given);
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop()->model->names[0], "mine");
  LayerSettings settings = state.document().settings();
  settings.offset = 0.4;
  state.change_settings(settings, "Offset");
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.workshop()->model->names[0], "mine");
  EXPECT_EQ(state.workshop()->model->names, given.names);
  EXPECT_EQ(state.kept_names(), state.workshop()->model->panel_count());
  state.forget_names();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.kept_names(), 0);
  EXPECT_NE(state.workshop()->model->names[0], "mine");
}

}  // namespace
}  // namespace planewright::ui
