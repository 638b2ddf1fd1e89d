// BackgroundTask: one function at a time on a thread of its own, whose result the window picks up when it is
// there.
//
// Reading and writing files can take seconds; a frame must not. Threads: all members from one thread; the
// function runs on another and must own what it uses. The destructor waits for a running function.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

namespace planewright::ui {

template <class T>
class BackgroundTask {
 public:
  bool running() const { return job_ != nullptr; }

  // Precondition: !running(). `wake` is called on the worker when the result is there.
  void start(std::function<T()> work, std::function<void()> wake) {
    job_ = std::make_unique<Job>();
    job_->thread = std::jthread([job = job_.get(), work = std::move(work), wake = std::move(wake)] {
      job->result.emplace(work());
      job->done.store(true, std::memory_order_release);
      if (wake) wake();
    });
  }

  // The result, once, when it is there.
  std::optional<T> take() {
    if (!job_ || !job_->done.load(std::memory_order_acquire)) return std::nullopt;
    job_->thread.join();
    std::optional<T> result = std::move(job_->result);
    job_.reset();
    return result;
  }

 private:
  struct Job {
    std::optional<T> result;
    std::atomic<bool> done = false;
    std::jthread thread;  // last member: joins before the rest goes
  };
  std::unique_ptr<Job> job_;
};

}  // namespace planewright::ui
