// The export dialog in the real window.
#include "support/window_fixture.h"

namespace planewright {
namespace {

const std::string kDialogOverTheDome = R"(
    click Hint/close
    sample dome 100
    wait_loaded 20
    wait_solved 60
    click Toolbar/export
    wait_frames 5
    wait_export 60
    wait_frames 3
    expect export_open == 1
)";
// Types over what stands in the field of the folder.
std::string into(const std::string& folder) {
  return "click Export/folder\nwait_frames 2\nkey Ctrl+A\ntype \"" + folder +
         "\"\nkey Enter\nwait_frames 3\n";
}

TEST_F(WindowTest, TheExportDialogWritesCertifiedFiles) {
  const Playback run = play(kDialogOverTheDome + R"(
    expect export_sheets > 0
    expect export_parts_unplaced == 0
    expect export_formats == "dxf pdf csv"
    click "Export/format svg"
    wait_frames 3
    expect export_formats contains svg
    ctrl_click "Export/sheet width"
    wait_frames 2
    type 2500
    key Enter
    wait_frames 3
    wait_export 60
    remember export_sheets sheets
    screenshot PICTURES/export.png
)" + into("FOLDER/out") + R"(
    expect export_chosen_folder == "FOLDER/out"
    click Export/export
    wait_frames 3
    wait_export 120
    wait_frames 3
    expect export_error == ""
    expect export_pass == 1
    expect export_folder == "FOLDER/out"
    expect export_files > 4
    screenshot PICTURES/export_done.png
    click Export/export                # what is there is not replaced unasked
    wait_frames 3
    wait_export 120
    wait_frames 3
    expect export_error contains "The folder has files of these names"
    expect export_error contains "Overwrite existing files"
    expect export_pass == none
    click Export/overwrite
    wait_frames 3
    click Export/export
    wait_frames 3
    wait_export 120
    wait_frames 3
    expect export_pass == 1
    key Escape
    wait_frames 3
    expect export_open == 0
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  for (const char* file : {"certificate.json", "certificate.html", "panels.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / file)) << file;
  int dxf = 0, svg = 0;
  if (std::filesystem::exists(folder_ / "out"))
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder_ / "out")) {
      dxf += file.path().extension() == ".dxf" ? 1 : 0;
      svg += file.path().extension() == ".svg" ? 1 : 0;
    }
  EXPECT_GT(dxf, 0);
  EXPECT_EQ(dxf, svg);
}

TEST_F(WindowTest, TheExportDialogOpensInASmallWindow) {
  const Playback run = play(kDialogOverTheDome + R"(
    expect colours == none             # the button is beside the maps, not beneath them
    expect ui:Export/export == enabled
    screenshot PICTURES/export_small.png
  )",
                            "", 240, "1024x700");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, TheExportDialogTurnsItsSheets) {
  const Playback run = play(kDialogOverTheDome + R"(
    ctrl_click "Export/sheet height"
    wait_frames 2
    type 2500
    key Enter
    wait_frames 3
    wait_export 60
    expect export_sheets > 2
    expect export_sheet == 0
    click "Export/next sheet"
    wait_frames 3
    expect export_sheet == 1
    key PageDown
    wait_frames 3
    expect export_sheet == 2
    click "Export/previous sheet"
    wait_frames 3
    expect export_sheet == 1
    expect export_sheet_line contains "Sheet 2 of"
    remember export_zoom before
    wheel Export/preview 4
    wait_frames 3
    expect export_zoom > $before
    double_click Export/preview
    wait_frames 3
    expect export_zoom == $before
    click "Export/thumbnail 3"
    wait_frames 3
    expect export_sheet == 2
    expect export_sheet_line contains "Sheet 3 of"
    click Export/sheets                # one drawing of all, and no page beyond it
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_sheets == 1
    expect export_sheet == 0
    expect export_sheet_line contains "All panels in rows"
    expect "ui:Export/next sheet" == disabled
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, WhatTheExportDialogCannotWriteItSays) {
  const Playback run = play(kDialogOverTheDome + into("FOLDER/no/such/place") + R"(
    click Export/export
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_error contains place
    expect export_pass == none
    screenshot PICTURES/export_error.png
    ctrl_click "Export/sheet width"
    wait_frames 2
    type 15
    key Enter
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_refusal != ""
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "no"));
}

TEST_F(WindowTest, AFileInTheWayOfAnExportStays) {
  std::ofstream(folder_ / "taken") << "mine";
  const Playback run =
      play(kDialogOverTheDome + "click Export/overwrite\nwait_frames 3\n" + into("FOLDER/taken") + R"(
    click Export/export
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_error contains "taken"
    expect export_pass == none
    expect ui:Export/error == enabled
)" + into("FOLDER/taken/below") +
           R"(
    expect export_error == ""          # of the folder before
    click Export/export
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_error contains "below"
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  ASSERT_TRUE(std::filesystem::is_regular_file(folder_ / "taken"));
  EXPECT_EQ(std::filesystem::file_size(folder_ / "taken"), 4u);
}

// So many panels in so many formats that writing takes a while.
std::string dialog_over_many_panels() {
  std::string script = R"(
    click Hint/close
    sample dome 1500
    wait_loaded 20
    wait_solved 120
    click Toolbar/export
    wait_frames 5
)";
  for (const char* format : {"svg", "json", "obj", "ply", "stl", "gltf"})
    script += "click \"Export/format " + std::string(format) + "\"\nwait_frames 2\n";
  return script + "wait_export 120\nwait_frames 3\n";
}

TEST_F(WindowTest, AnExportThatIsStoppedLeavesNoTrace) {
  std::filesystem::create_directory(folder_ / "place");
  const Playback run = play(dialog_over_many_panels() + into("FOLDER/place/out") + R"(
    click Export/export
    wait_frames 2
    expect export_running == 1
    expect ui:Export/progress == enabled
    click Export/stop
    wait_export 120
    wait_frames 3
    expect export_stopped == 1
    expect export_error == ""
    expect export_pass == none
    expect ui:Export/stopped == enabled
    screenshot PICTURES/export_stopped.png
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "place"));
}

TEST_F(WindowTest, AnExportGoesOnWhenItsDialogIsClosed) {
  const Playback run = play(dialog_over_many_panels() + R"(
    click Export/folder
    wait_frames 2
    key Escape                         # leaves the field alone
    wait_frames 3
    expect export_open == 1
)" + into("FOLDER/out/") + R"(
    remember messages_posted before
    click Export/export
    key Escape
    wait_frames 3
    expect export_open == 0
    expect export_running == 1
    wait_export 120
    wait_frames 3
    expect messages_posted > $before
    expect last_message contains Certified
  )");
  EXPECT_EQ(run.status, 0) << run.output;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / "certificate.json"));
  // Beside this one the next design's folder is proposed.
  std::ifstream file(folder_ / "config" / "planewright" / "window.json");
  const std::string settings{std::istreambuf_iterator<char>(file), {}};
  EXPECT_NE(settings.find("\"last_folder\": \"" + folder_.string() + "\""), std::string::npos) << settings;
}

TEST_F(WindowTest, AResultIsOfWhatIsChosen) {
  const std::string write =
      "click Export/export\nwait_frames 3\nwait_export 120\nwait_frames 3\n"
      "expect export_error == \"\"\nexpect export_pass == 1\n";
  const Playback run = play(kDialogOverTheDome + "click Export/overwrite\nwait_frames 3\n" +
                            into("FOLDER/out") + write + R"(
    ctrl_click Export/gap
    wait_frames 2
    type 8
    key Enter
    wait_frames 3
    expect gap == 8
    expect export_pass == none
    wait_export 60
    wait_frames 3
)" + write + R"(
    key Ctrl+Z
    wait_frames 3
    expect gap == 0
    expect export_pass == none
    wait_export 60
    wait_frames 3
)" + write + R"(
    click "Export/format json"
    wait_frames 3
    expect export_pass == none
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

TEST_F(WindowTest, PanelsThatFailCanKeepAnExportBack) {
  const Playback run = play(kDialogOverTheDome + R"(
    key Escape
    wait_frames 3
    click "Findings/tab Workshop"
    wait_frames 3
    ctrl_click "Findings/edge min"
    wait_frames 2
    type 1200
    key Enter
    wait_frames 3
    wait_solved 20
    expect failing > 0
    key Ctrl+Shift+E
    wait_frames 5
    wait_export 60
    wait_frames 3
    expect export_failing > 0
    click "Export/failing Refuse"
    wait_frames 3
)" + into("FOLDER/out") + R"(
    click Export/export
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_error contains "edge length"
    click "Export/failing Mark them"
    wait_frames 3
    click Export/export
    wait_frames 3
    wait_export 60
    wait_frames 3
    expect export_error == ""
    expect export_files > 2
  )");
  EXPECT_EQ(run.status, 0) << run.output;
}

}  // namespace
}  // namespace planewright
