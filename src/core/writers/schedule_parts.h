// What the schedules look up for each panel. Internal to writers/. Threads: pure.
#pragma once

#include <string>
#include <vector>

#include "core/writers/schedule_writers.h"

namespace planewright {

inline constexpr double kSquareMetres = 1e-6;  // of a square millimetre

// The key of a kind of failure in tables and JSON: "edge_min".
const char* failure_key(ToleranceKind kind);

class ScheduleIndex {
 public:
  explicit ScheduleIndex(const ScheduleSources& sources);

  int class_of(int panel) const { return class_of_[panel]; }  // -1: none
  bool mirrored(int panel) const { return mirrored_[panel]; }
  int sheet_of(int panel) const { return sheet_of_[panel]; }  // -1: none
  const char* verdict(int panel) const;                       // "pass", "fail"
  const std::vector<const ToleranceFailure*>& failures(int panel) const { return failures_[panel]; }
  // "edge_min side 3: 24.1 < 50; planarity: 0.7 > 0.5"; sides 1-based
  std::string failures_text(int panel) const;

 private:
  const ToleranceVerdicts& verdicts_;
  std::vector<int> class_of_, sheet_of_;
  std::vector<bool> mirrored_;
  std::vector<std::vector<const ToleranceFailure*>> failures_;
};

}  // namespace planewright
