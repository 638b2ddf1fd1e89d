// Preparing and writing an export on workers.
#include "ui/export_work.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "support/temporary_folder.h"
#include "support/workshop_models.h"

namespace planewright::ui {
namespace {

namespace fs = std::filesystem;
using namespace test;

// 20 x 20 squares of half a metre: enough for a preparation to take a while.
ExportJob squares(int count = 20) {
  ExportJob job;
  job.model = std::make_shared<const WorkshopModel>(workshop_model(grid(count, count), 500.0));
  return job;
}

// Frames until `done`; false after two minutes.
template <class Done>
bool run_until(ExportWork& work, Done done) {
  const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!done()) {
    if (std::chrono::steady_clock::now() > limit) return false;
    work.update();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}
bool prepare(ExportWork& work, const ExportJob& job) {
  work.prepare(job);
  return run_until(work, [&] { return !work.preparing(); });
}

ExportSettings settings_for(const ExportJob& job, bool overwrite = false) {
  ExportChoice choice;
  choice.formats = {ExportFormat::Dxf, ExportFormat::Csv};
  return export_settings(choice, job.contract, "squares", "2026-01-01", overwrite);
}
std::optional<ExportEnd> write(ExportWork& work, const ExportJob& job, const fs::path& folder,
                               bool overwrite = false) {
  work.write(settings_for(job, overwrite), folder);
  std::optional<ExportEnd> end;
  run_until(work, [&] { return (end = work.take_end()).has_value(); });
  return end;
}
bool holds_nothing(const fs::path& folder) {
  return fs::directory_iterator(folder) == fs::directory_iterator();
}

TEST(ExportWork, PreparesSheetsAndWritesThemCertified) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(4);
  ASSERT_TRUE(prepare(work, job));
  ASSERT_NE(work.prepared(), nullptr);
  EXPECT_EQ(work.prepared()->made.patterns.size(), 16u);
  EXPECT_FALSE(work.prepared()->made.drawings.empty());
  const auto end = write(work, job, folder / "out");
  ASSERT_TRUE(end && end->outcome) << (end ? end->outcome.error().text() : "never ended");
  EXPECT_TRUE(end->outcome->certificate.pass());
  EXPECT_EQ(end->model, job.model);
  EXPECT_TRUE(fs::exists(folder / "out" / "certificate.json"));
  EXPECT_FALSE(work.writing());
  EXPECT_FALSE(work.take_end()) << "told once";
}

TEST(ExportWork, OfSeveralJobsTheNewestIsPrepared) {
  ExportWork work;
  ExportJob job = squares();
  for (const double margin : {10.0, 20.0, 30.0}) {
    job.layout.margin = margin;
    work.prepare(job);
    work.update();
  }
  ASSERT_TRUE(run_until(work, [&] { return !work.preparing(); }));
  EXPECT_EQ(work.prepared()->job.layout.margin, 30.0);
  const auto number = work.prepared()->number;
  ASSERT_TRUE(prepare(work, job));
  EXPECT_EQ(work.prepared()->number, number) << "the same job again starts nothing";
}

TEST(ExportWork, WhatCannotBePreparedIsSaidAndThenForgotten) {
  ExportWork work;
  ExportJob job = squares(4);
  job.layout.sheet = {15.0, 15.0};  // the margins leave nothing
  ASSERT_TRUE(prepare(work, job));
  ASSERT_TRUE(work.refusal());
  EXPECT_FALSE(work.refusal()->what.empty());
  job.layout.sheet = {3000.0, 1500.0};
  ASSERT_TRUE(prepare(work, job));
  EXPECT_FALSE(work.refusal());
  EXPECT_NE(work.prepared(), nullptr);
}

TEST(ExportWork, WritingWaitsForItsPreparation) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(6);
  work.prepare(job);
  ASSERT_TRUE(work.preparing());
  const auto end = write(work, job, folder / "out");
  ASSERT_TRUE(end && end->outcome);
  EXPECT_TRUE(end->outcome->certificate.pass());
}

TEST(ExportWork, WhatWaitsToBeWrittenIsNotReplacedByOtherSettings) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares();
  ExportJob other = job;
  other.layout.margin = 30.0;
  work.prepare(job);
  work.write(settings_for(job), folder / "out");
  work.prepare(other);
  work.rest();
  std::optional<ExportEnd> end;
  ASSERT_TRUE(run_until(work, [&] { return (end = work.take_end()).has_value(); }));
  ASSERT_TRUE(end->outcome) << end->outcome.error().text();
  EXPECT_EQ(work.prepared()->job, job);
  ASSERT_TRUE(prepare(work, other));
  EXPECT_EQ(work.prepared()->job, other);
}

TEST(ExportWork, WhatCannotBePreparedCannotBeWritten) {
  const TemporaryFolder folder;
  ExportWork work;
  ExportJob job = squares(4);
  job.layout.sheet = {15.0, 15.0};
  work.prepare(job);
  const auto end = write(work, job, folder / "out");
  ASSERT_TRUE(end);
  ASSERT_FALSE(end->outcome);
  ASSERT_TRUE(work.refusal());
  EXPECT_EQ(end->outcome.error().what, work.refusal()->what);
  EXPECT_FALSE(end->stopped);
  EXPECT_FALSE(work.writing());
  EXPECT_TRUE(holds_nothing(folder.path()));
}

TEST(ExportWork, AfterARestTheSameIsPreparedAgain) {
  ExportWork work;
  const ExportJob job = squares();
  work.prepare(job);
  work.rest();
  EXPECT_FALSE(work.preparing());
  work.prepare(job);
  EXPECT_TRUE(work.preparing());
  ASSERT_TRUE(run_until(work, [&] { return !work.preparing(); }));
  EXPECT_FALSE(work.refusal()) << "being stopped is no refusal";
  ASSERT_NE(work.prepared(), nullptr);
  EXPECT_EQ(work.prepared()->job, job);
}

TEST(ExportWork, AFolderThatIsNotThereIsAnErrorAndLeavesNothing) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(4);
  ASSERT_TRUE(prepare(work, job));
  const auto end = write(work, job, folder / "no" / "such" / "place");
  ASSERT_TRUE(end);
  ASSERT_FALSE(end->outcome);
  EXPECT_EQ(end->outcome.error().code, ErrorCode::Unwritable);
  EXPECT_FALSE(end->stopped);
  EXPECT_TRUE(holds_nothing(folder.path()));
}

TEST(ExportWork, AFileInTheWayIsAnErrorAndStays) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(4);
  const fs::path file = folder.write("out", "mine");
  ASSERT_TRUE(prepare(work, job));
  for (const fs::path& target : {file, file / "below"}) {
    const auto end = write(work, job, target, true);
    ASSERT_TRUE(end);
    ASSERT_FALSE(end->outcome) << target;
    EXPECT_EQ(end->outcome.error().code, ErrorCode::Unwritable);
    EXPECT_NE(end->outcome.error().text().find("out"), std::string::npos);
  }
  EXPECT_EQ(fs::file_size(file), 4u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(ExportWork, WhatIsThereIsNotReplacedUnasked) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(4);
  ASSERT_TRUE(prepare(work, job));
  ASSERT_TRUE(write(work, job, folder / "out")->outcome);
  const auto again = write(work, job, folder / "out");
  ASSERT_FALSE(again->outcome);
  EXPECT_EQ(again->outcome.error().code, ErrorCode::Unwritable);
  EXPECT_TRUE(write(work, job, folder / "out", true)->outcome);
}

TEST(ExportWork, StoppedItLeavesNoTrace) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares(12);
  ASSERT_TRUE(prepare(work, job));
  work.write(settings_for(job), folder / "out");
  ASSERT_TRUE(work.writing());
  work.stop();
  std::optional<ExportEnd> end;
  ASSERT_TRUE(run_until(work, [&] { return (end = work.take_end()).has_value(); }));
  EXPECT_TRUE(end->stopped);
  EXPECT_FALSE(end->outcome);
  EXPECT_TRUE(holds_nothing(folder.path()));
  EXPECT_TRUE(write(work, job, folder / "out")->outcome) << "and can be asked for again";
}

TEST(ExportWork, StoppedBeforeItsPreparationIsReadyItLeavesNoTrace) {
  const TemporaryFolder folder;
  ExportWork work;
  const ExportJob job = squares();
  work.prepare(job);
  ASSERT_TRUE(work.preparing());
  work.write(settings_for(job), folder / "out");
  work.stop();
  EXPECT_FALSE(work.writing());
  const auto end = work.take_end();
  ASSERT_TRUE(end);
  EXPECT_TRUE(end->stopped);
  ASSERT_TRUE(run_until(work, [&] { return !work.preparing(); }));
  EXPECT_NE(work.prepared(), nullptr) << "the preview is still wanted";
  work.update();
  EXPECT_FALSE(work.take_end());
  EXPECT_TRUE(holds_nothing(folder.path()));
}

TEST(ExportWork, ItsOwnerCanGoWhileItPrepares) {
  const TemporaryFolder folder;
  {
    ExportWork work;
    const ExportJob job = squares(40);
    work.prepare(job);
    work.write(settings_for(job), folder / "out");
    ASSERT_TRUE(work.preparing());
  }
  EXPECT_TRUE(holds_nothing(folder.path()));
}

TEST(ExportWork, EndsWithItsOwner) {
  const TemporaryFolder folder;
  {
    ExportWork work;
    const ExportJob job = squares(12);
    ASSERT_TRUE(prepare(work, job));
    work.write(settings_for(job), folder / "out");
  }
  EXPECT_TRUE(holds_nothing(folder.path()) || fs::exists(folder / "out" / "certificate.json"))
      << "whole or not at all";
}

}  // namespace
}  // namespace planewright::ui
