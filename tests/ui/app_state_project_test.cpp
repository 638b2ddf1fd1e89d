// Projects in the window's state: what is saved comes back as it was shown.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/app_state_runs.h"
#include "support/temporary_folder.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

bool save(AppState& state, const std::filesystem::path& path) {
  state.save_project(path);
  return run_until(state, [&] { return !state.saving(); });
}
bool open(AppState& state, const std::filesystem::path& path) {
  state.open_file(path);
  return run_until(state, [&] { return !state.loading(); }) && settle(state);
}

TEST(AppStateProject, PanelsComeBackBitForBitAndAreNotSolvedAgain) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.change_settings(with_fairing(state, 0.3), "Weight of fairing");
  WorkshopContract contract = state.contract();
  contract.thickness = 12.0;
  state.change_contract(contract, "Thickness");
  ASSERT_TRUE(settle(state));
  EXPECT_TRUE(state.modified());
  ASSERT_TRUE(save(state, folder.path() / "roof.planewright"));
  EXPECT_FALSE(state.modified());
  EXPECT_EQ(state.title(), "roof.planewright");
  const auto fingerprint = state.shown()->fingerprint;

  AppState again;
  ASSERT_TRUE(open(again, folder.path() / "roof.planewright"));
  EXPECT_EQ(again.shown()->fingerprint, fingerprint);
  EXPECT_EQ(again.ticket(), 0u) << "nothing was solved";
  EXPECT_TRUE(again.shows_saved());
  EXPECT_TRUE(again.up_to_date());
  EXPECT_EQ(again.layer_status(0), LayerStatus::Saved);
  EXPECT_FALSE(again.modified());
  EXPECT_EQ(again.contract().thickness, 12.0);
  EXPECT_EQ(again.document().settings().weights.at("fairing"), 0.3);
  EXPECT_FALSE(again.document().can_undo());
  ASSERT_NE(again.findings(), nullptr);

  again.solve();
  ASSERT_TRUE(settle(again));
  EXPECT_FALSE(again.shows_saved());
  ASSERT_NE(again.report(), nullptr);
}

TEST(AppStateProject, WhatIsTakenBackNeedsNoSaving) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 60);
  ASSERT_TRUE(settle(state));
  EXPECT_FALSE(state.modified()) << "the solve that follows by itself is no change";
  state.change_settings(with_fairing(state, 2.0), "Weight of fairing");
  EXPECT_TRUE(state.modified());
  ASSERT_TRUE(save(state, folder.path() / "a.planewright"));
  EXPECT_FALSE(state.modified());
  state.undo();
  EXPECT_TRUE(state.modified());
  state.redo();
  EXPECT_FALSE(state.modified());
  state.change_settings(with_fairing(state, 3.0), "Weight of fairing", "fairing");
  state.change_settings(with_fairing(state, 2.0), "Weight of fairing", "fairing");  // dragged back
  EXPECT_FALSE(state.modified());
}

TEST(AppStateProject, UndoComesBackToWhatWasSaved) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  ASSERT_TRUE(save(state, folder.path() / "a.planewright"));
  ASSERT_TRUE(open(state, folder.path() / "a.planewright"));
  const auto fingerprint = state.shown()->fingerprint;
  state.change_settings(with_fairing(state, 2.0), "Weight of fairing");
  ASSERT_TRUE(settle(state));
  EXPECT_FALSE(state.shows_saved());
  EXPECT_NE(state.shown()->fingerprint, fingerprint);
  state.undo();
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.shown()->fingerprint, fingerprint);
  EXPECT_TRUE(state.shows_saved());
}

TEST(AppStateProject, PanelsOfEarlierSettingsAreSolvedWhenItIsOpened) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.set_auto_solve(false);
  state.change_settings(with_fairing(state, 2.0), "Weight of fairing");
  ASSERT_FALSE(state.up_to_date());
  ASSERT_TRUE(save(state, folder.path() / "late.planewright"));
  AppState again;
  ASSERT_TRUE(open(again, folder.path() / "late.planewright"));
  EXPECT_FALSE(again.shows_saved());
  EXPECT_NE(again.report(), nullptr);
  EXPECT_TRUE(again.up_to_date());
}

TEST(AppStateProject, ASaveThatEndsAfterAnotherDesignIsOpenedIsNotItsFile) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 400);
  ASSERT_TRUE(settle(state));
  state.save_project(folder.path() / "a.planewright");
  state.open_sample("torus");
  ASSERT_TRUE(run_until(state, [&] { return !state.saving() && !state.loading(); }));
  ASSERT_TRUE(settle(state));
  EXPECT_EQ(state.document().name(), "torus");
  EXPECT_TRUE(state.project_path().empty() || state.opened_count() == 1);
  EXPECT_EQ(state.title(), "torus");
}

TEST(AppStateProject, ALayerWithoutPanelsIsSolved) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.set_auto_solve(false);
  state.duplicate_layer(0);
  ASSERT_TRUE(save(state, folder.path() / "two.planewright"));
  AppState again;
  ASSERT_TRUE(open(again, folder.path() / "two.planewright"));
  ASSERT_EQ(again.layer_count(), 2);
  EXPECT_EQ(again.layer_status(0), LayerStatus::Saved);
  EXPECT_NE(again.report(1), nullptr);
  EXPECT_NE(again.shown(1), nullptr);
}

TEST(AppStateProject, ClustersComeBackWithTheirPanels) {
  const TemporaryFolder folder;
  AppState state;
  state.open_sample("dome", 300);
  ASSERT_TRUE(settle(state));
  LayerSettings settings = state.document().settings();
  settings.mode = ComplexKind::Cluster;
  state.change_settings(settings, "Mode cluster");
  ASSERT_TRUE(settle(state));
  ASSERT_NE(state.clusters(), nullptr);
  ASSERT_TRUE(save(state, folder.path() / "c.planewright"));
  AppState again;
  ASSERT_TRUE(open(again, folder.path() / "c.planewright"));
  ASSERT_NE(again.clusters(), nullptr);
  EXPECT_EQ(again.clusters()->regions.region_of_face, state.clusters()->regions.region_of_face);
  EXPECT_EQ(again.shown()->fingerprint, state.shown()->fingerprint);
  EXPECT_EQ(again.ticket(), 0u) << "nothing was solved";
  EXPECT_NE(again.region_view(), nullptr);
}

TEST(AppStateProject, WhatCannotBeReadLosesNothing) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "bad.planewright")
      << "{\"format\": \"planewright project\", \"version\": 99}";
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  const auto fingerprint = state.shown()->fingerprint;
  ASSERT_TRUE(open(state, folder.path() / "bad.planewright"));
  ASSERT_FALSE(state.messages().empty());
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Error);
  EXPECT_EQ(state.document().name(), "dome");
  EXPECT_EQ(state.shown()->fingerprint, fingerprint);
}

TEST(AppStateProject, WhatCannotBeWrittenStaysUnsaved) {
  AppState state;
  state.open_sample("dome", 100);
  ASSERT_TRUE(settle(state));
  state.change_settings(with_fairing(state, 0.3), "Weight of fairing");
  ASSERT_TRUE(save(state, "/nowhere/at/all/roof.planewright"));
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Error);
  EXPECT_TRUE(state.modified());
  EXPECT_TRUE(state.project_path().empty());
}

}  // namespace
}  // namespace planewright::ui
