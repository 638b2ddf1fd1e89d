#include "ui/frame_timings.h"

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace planewright::ui {

void TimingSeries::add(double milliseconds) {
  if (samples_.size() < kKept) {
    samples_.push_back(milliseconds);
  } else {
    samples_[count_ % kKept] = milliseconds;
  }
  ++count_;
  last_ = milliseconds;
  max_ = std::max(max_, milliseconds);
}

void TimingSeries::clear() {
  *this = TimingSeries();
}

double TimingSeries::median() const {
  if (samples_.empty()) return 0.0;
  std::vector<double> sorted = samples_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return *middle;
}

namespace {

double thread_milliseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace

ThreadClock::ThreadClock() : start_(thread_milliseconds()) {}
double ThreadClock::milliseconds() const {
  return thread_milliseconds() - start_;
}

void FrameTimings::clear() {
  *this = FrameTimings();
}

std::string FrameTimings::text() const {
  std::string out = "timing          count   median ms      max ms\n";
  const auto line = [&](const char* name, const TimingSeries& series) {
    char buffer[96];
    std::snprintf(buffer, sizeof buffer, "%-12s %8zu %11.2f %11.2f\n", name, series.count(), series.median(),
                  series.max());
    out += buffer;
  };
  line("drain", drain);
  line("prepare", prepare);
  line("upload", upload);
  line("stream", stream);
  line("stream cpu", stream_cpu);
  line("scene", scene);
  line("panels", panels);
  line("frame", frame);
  return out;
}

}  // namespace planewright::ui
