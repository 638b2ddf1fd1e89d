#include "ui/frame_timings.h"

#include <algorithm>
#include <cstdio>

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
  line("scene", scene);
  line("panels", panels);
  line("frame", frame);
  return out;
}

}  // namespace planewright::ui
