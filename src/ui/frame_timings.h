// FrameTimings: what the window's own thread spent, so that "never waits for the solver" can be measured.
//
// Units: milliseconds. Threads: the window's thread.
#pragma once

#include <chrono>
#include <string>
#include <vector>

namespace planewright::ui {

class TimingSeries {
 public:
  void add(double milliseconds);
  void clear();
  std::size_t count() const { return count_; }
  double median() const;               // of the last kKept samples; 0 without any
  double max() const { return max_; }  // of all samples
  double last() const { return last_; }

 private:
  static constexpr std::size_t kKept = 4096;
  std::vector<double> samples_;  // a ring once it is full
  std::size_t count_ = 0;
  double max_ = 0.0, last_ = 0.0;
};

struct FrameTimings {
  TimingSeries drain;  // taking iterates, scalars and outcomes from the solve session (frames that had some)
  TimingSeries prepare;  // off the window's thread: measures and arrays of one iterate
  TimingSeries upload;   // handing an iterate's arrays to OpenGL
  TimingSeries stream;   // both and all between, in one frame: what a solve costs the window
  TimingSeries
      stream_cpu;  // the same as processor time of the window's thread: without waiting for a busy machine
  TimingSeries scene;   // drawing the model, as far as the processor sees it
  TimingSeries panels;  // laying out and drawing everything else
  TimingSeries frame;   // a whole frame without sleeping

  void clear();
  std::string text() const;  // a table, one line per series
};

// Processor time of the calling thread.
class ThreadClock {
 public:
  ThreadClock();
  double milliseconds() const;

 private:
  double start_;
};

class Stopwatch {
 public:
  double milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace planewright::ui
