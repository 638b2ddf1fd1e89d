// ExportWork: prepares an export and writes it, on workers, for the window to look on.
//
// Two things can go on at a time: the preparation of the newest settings, and the writing of what was
// prepared before. A preparation is stopped as soon as other settings are asked for; writing waits until
// what it is to write is prepared. Threads: all members from one thread, and none of them waits; the
// destructor asks the workers to stop, and waits for that. Units: mm.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "core/fabricate/export_run.h"
#include "core/mesh/closest_point.h"
#include "ui/background_task.h"
#include "ui/export_choice.h"

namespace planewright::ui {

// What is prepared, and from what.
struct ExportJob {
  std::shared_ptr<const WorkshopModel> model;
  std::shared_ptr<const ReferenceSurface> surface;  // that distances are measured from; null: none are
  WorkshopContract contract;
  ExportLayout layout;
  bool operator==(const ExportJob&) const = default;
};
struct PreparedExport {
  std::uint64_t number;  // of the preparations, from 1
  ExportJob job;
  ExportPreparation made;
};

struct ExportStage {
  std::string name;  // "measuring", "thickening", "nesting", "writing", "certifying"; empty: none yet
  double fraction = 0.0;
};

// How writing ended.
struct ExportEnd {
  std::shared_ptr<const WorkshopModel> model;
  Result<ExportOutcome> outcome;
  bool stopped = false;  // by stop(): outcome is an error then
};

class ExportWork {
 public:
  // `wake`: called from workers when there is something to take; may be empty.
  explicit ExportWork(std::function<void()> wake = {});
  ~ExportWork();
  ExportWork(const ExportWork&) = delete;
  ExportWork& operator=(const ExportWork&) = delete;

  // Once per frame with the same job is fine: only another one starts anything.
  void prepare(const ExportJob& job);
  // Nothing more is to be prepared, unless it is to be written.
  void rest();
  // Of the newest that is ready; perhaps not of the newest job. Null: none yet.
  const std::shared_ptr<const PreparedExport>& prepared() const { return prepared_; }
  // The newest job is neither ready nor refused.
  bool preparing() const;
  // Why the newest job cannot be prepared.
  const std::optional<Error>& refusal() const { return refusal_; }

  // Writes the newest job, prepared with these settings, once that is ready. Precondition: !writing() and
  // prepare() has been called.
  void write(ExportSettings settings, std::filesystem::path folder);
  bool writing() const { return wish_.has_value() || write_task_.running(); }
  bool stopping() const { return writing() && stop_asked_; }
  void stop();  // the writing
  // Of the writing, else of the preparation.
  ExportStage stage() const;

  // Takes what is ready, starts what is due. True if anything has changed.
  bool update();
  // How writing ended, once.
  std::optional<ExportEnd> take_end();

 private:
  // Written by a worker, read by the window.
  class Gauge {
   public:
    void set(std::string_view stage, double fraction);
    ExportStage read() const;

   private:
    mutable std::mutex mutex_;
    ExportStage stage_;
  };
  struct Wish {
    ExportSettings settings;
    std::filesystem::path folder;
  };
  using Made = Result<std::shared_ptr<const PreparedExport>>;

  void start_preparing();
  void start_writing();
  bool ready() const { return prepared_ && wanted_ && prepared_->job == *wanted_; }
  void end(Result<ExportOutcome> outcome, std::shared_ptr<const WorkshopModel> model);

  std::function<void()> wake_;
  std::uint64_t next_number_ = 1;
  std::optional<ExportJob> wanted_;   // the newest
  std::optional<ExportJob> running_;  // that the task works on
  std::shared_ptr<const PreparedExport> prepared_;
  std::optional<Error> refusal_;
  std::shared_ptr<Gauge> preparing_gauge_, writing_gauge_;
  std::stop_source prepare_stop_, write_stop_;
  std::optional<Wish> wish_;  // waits for the preparation
  bool stop_asked_ = false;
  std::shared_ptr<const WorkshopModel> written_model_;
  std::optional<ExportEnd> end_;
  // Last members: their threads end before what they refer to goes.
  BackgroundTask<Made> prepare_task_;
  BackgroundTask<Result<ExportOutcome>> write_task_;
};

}  // namespace planewright::ui
