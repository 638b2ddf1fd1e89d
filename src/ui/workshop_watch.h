// WorkshopWatch: keeps what the workshop makes of the shown panels up to date, one job at a time on a worker.
//
// A key says what a job is about, cheaply enough to be compared in every frame; a job costs more. What failed
// is not tried again with the same key. Threads: all members from one thread, and none of them waits.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "ui/background_task.h"
#include "ui/prepared_workshop.h"

namespace planewright::ui {

struct WorkshopKey {
  std::uint64_t layer = 0;
  std::shared_ptr<const Iterate> iterate;
  bool final = false;  // the outcome of a solve
  WorkshopContract contract;
  std::shared_ptr<const PolygonMesh> mesh;
  std::shared_ptr<const ReferenceSurface> reference;
  std::uint64_t names_given = 0;  // how often
  bool operator==(const WorkshopKey&) const = default;
};

class WorkshopWatch {
 public:
  // `wake`: called on the worker when there is something to take; may be empty.
  explicit WorkshopWatch(std::function<void()> wake) : wake_(std::move(wake)) {}

  bool busy() const { return task_.running(); }
  // The newest job was for this key.
  bool asked_for(const WorkshopKey& key) const { return asked_ == key; }
  // Precondition: !busy().
  void ask(WorkshopKey key, WorkshopJob job);
  // Takes what is ready; true if something was.
  bool update();

  // What the newest job that came to something made; null: none yet, or the newest came to nothing.
  const std::shared_ptr<const PreparedWorkshop>& newest() const { return newest_; }
  bool fits(const WorkshopKey& key) const { return newest_ && newest_key_ == key; }
  const std::optional<Error>& error() const { return error_; }  // of the newest job
  void forget();

 private:
  std::function<void()> wake_;
  std::optional<WorkshopKey> asked_, newest_key_;
  std::shared_ptr<const PreparedWorkshop> newest_;
  std::shared_ptr<const PreparedWorkshop> before_;  // the newest that there was, whose parts can be kept
  std::optional<Error> error_;
  bool forgotten_ = false;                         // what runs is of no interest any more
  BackgroundTask<Result<PreparedWorkshop>> task_;  // last member: its thread ends first
};

}  // namespace planewright::ui
