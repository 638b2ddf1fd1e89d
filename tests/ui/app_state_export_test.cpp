// The export of what the window shows, without a window.
#include <gtest/gtest.h>

#include "support/app_state_runs.h"
#include "support/temporary_folder.h"
#include "ui/app_state.h"

namespace planewright::ui {
namespace {

using namespace test;

ExportChoice tables() {
  ExportChoice choice;
  choice.formats = {ExportFormat::Csv};
  return choice;
}
bool prepare(AppState& state, const ExportChoice& choice) {
  state.wanted_export = choice;
  return run_until(state, [&] { return !state.export_preparing(); });
}
bool export_to(AppState& state, const std::filesystem::path& folder) {
  ExportChoice choice;
  choice.formats = {ExportFormat::Csv, ExportFormat::Svg};
  state.wanted_export = choice;
  if (!run_until(state, [&] { return !state.export_preparing(); })) return false;
  if (!state.export_panels_to_workshop(choice, folder, false)) return false;
  return run_until(state, [&] { return !state.exporting_to_workshop(); });
}

TEST(AppStateExport, SaysWhyThereIsNothingToExport) {
  AppState state;
  ASSERT_TRUE(state.why_no_export());
  EXPECT_FALSE(state.why_no_export()->remedy.empty());
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  EXPECT_FALSE(state.why_no_export());
}

TEST(AppStateExport, WithoutPanelsNothingIsBegun) {
  const TemporaryFolder folder;
  AppState state;
  state.wanted_export = ExportChoice();
  state.update(Clock::now());
  EXPECT_FALSE(state.export_preparing()) << "there is nothing to wait for";
  EXPECT_FALSE(state.export_panels_to_workshop(ExportChoice(), folder / "out", false));
  EXPECT_FALSE(state.exporting_to_workshop());
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(AppStateExport, WritesAndKeepsTheNames) {
  const TemporaryFolder folder;
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  EXPECT_TRUE(state.document().given_names().empty());
  ASSERT_TRUE(export_to(state, folder / "out"));
  ASSERT_TRUE(state.export_outcome());
  EXPECT_TRUE(state.export_outcome()->certificate.pass());
  ASSERT_EQ(state.document().given_names().size(), 1u);
  EXPECT_EQ(state.document().given_names().begin()->second.size(),
            static_cast<std::size_t>(state.shown()->complex().plane_count()));
  EXPECT_TRUE(state.modified()) << "names are part of the project";
  EXPECT_FALSE(state.why_no_export()) << "the panels are as they were";
  EXPECT_TRUE(state.messages().empty()) << "the dialog tells";
}

TEST(AppStateExport, NothingIsReplacedUnaskedAndTheWindowsWordsSayHow) {
  const TemporaryFolder folder;
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  ASSERT_TRUE(export_to(state, folder / "out"));
  ASSERT_TRUE(export_to(state, folder / "out"));
  ASSERT_TRUE(state.export_error());
  EXPECT_FALSE(state.export_outcome()) << "the earlier one is not told again";
  EXPECT_NE(state.export_error()->remedy.find("Overwrite existing files"), std::string::npos);
  EXPECT_EQ(state.export_error()->remedy.find("--"), std::string::npos);
  state.forget_export_outcome();
  EXPECT_FALSE(state.export_error());
}

TEST(AppStateExport, StoppedItGivesNoNamesAndLeavesNoTrace) {
  const TemporaryFolder folder;
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  ExportChoice choice = tables();
  ASSERT_TRUE(prepare(state, choice));
  choice.layout.margin = 20.0;  // so that it has to be prepared first
  ASSERT_TRUE(state.export_panels_to_workshop(choice, folder / "out", false));
  EXPECT_FALSE(state.export_panels_to_workshop(choice, folder / "other", false)) << "one at a time";
  state.stop_export();
  ASSERT_TRUE(run_until(state, [&] { return !state.exporting_to_workshop(); }));
  state.update(Clock::now());
  EXPECT_TRUE(state.export_stopped());
  EXPECT_FALSE(state.export_outcome());
  EXPECT_FALSE(state.export_error());
  EXPECT_TRUE(state.document().given_names().empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(AppStateExport, AnErrorIsToldAndGivesNoNames) {
  const TemporaryFolder folder;
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  ASSERT_TRUE(export_to(state, folder / "no" / "such" / "place"));
  EXPECT_TRUE(state.export_error());
  EXPECT_FALSE(state.export_outcome());
  EXPECT_TRUE(state.document().given_names().empty());
}

TEST(AppStateExport, AfterTheDialogIsClosedTheResultIsAMessage) {
  const TemporaryFolder folder;
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  ExportChoice choice = tables();
  ASSERT_TRUE(prepare(state, choice));
  ASSERT_TRUE(state.export_panels_to_workshop(choice, folder / "out", false));
  state.wanted_export.reset();
  ASSERT_TRUE(run_until(state, [&] { return !state.exporting_to_workshop(); }));
  ASSERT_FALSE(state.messages().empty());
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Info);
  EXPECT_NE(state.messages().back().where.find("out"), std::string::npos);
  // Neither is an error lost.
  state.wanted_export = choice;
  ASSERT_TRUE(run_until(state, [&] { return !state.export_preparing(); }));
  ASSERT_TRUE(state.export_panels_to_workshop(choice, folder / "no" / "place", false));
  state.wanted_export.reset();
  ASSERT_TRUE(run_until(state, [&] { return !state.exporting_to_workshop(); }));
  EXPECT_EQ(state.messages().back().kind, Message::Kind::Error);
  EXPECT_NE(state.messages().back().where.find("place"), std::string::npos);
}

TEST(AppStateExport, AChangeOfTheContractIsPreparedAnew) {
  AppState state;
  ASSERT_TRUE(open_dome_at_the_workshop(state, 60));
  state.wanted_export = ExportChoice();
  ASSERT_TRUE(run_until(state, [&] { return state.export_preparation() != nullptr; }));
  EXPECT_FALSE(state.export_preparation()->made.solids);
  WorkshopContract contract = state.contract();
  contract.thickness = 20.0;
  state.change_contract(contract, "Thickness");
  ASSERT_TRUE(run_until(state, [&] {
    return !state.export_preparing() && state.export_preparation() != nullptr &&
           state.export_preparation()->made.solids;
  }));
}

}  // namespace
}  // namespace planewright::ui
