// What both schedules say of a panel beyond its measures: class, sheet, verdict and failures. Internal to
// certify/. Threads: pure.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/certify/certificate.h"
#include "core/certify/value_check.h"

namespace planewright {

struct WrittenFailure {
  std::string kind;
  std::optional<double> side, measured, limit;  // side: 1-based
};

// As a file has it. Numbers: absent where it has nothing, not a number where it has something else.
struct WrittenEntry {
  std::optional<double> group, sheet;                   // 1-based
  std::string mirrored, verdict;                        // "yes", "no", "pass", "fail"
  std::optional<std::vector<WrittenFailure>> failures;  // absent: not to be understood
};

// "edge_min side 3: 24.1 < 50; crosses_itself". Absent: it is not like this, or a comparison is not true.
std::optional<std::vector<WrittenFailure>> failures_in(std::string_view text);

class EntryChecks {
 public:
  explicit EntryChecks(const ExportContent& content);
  void compare(int panel, const WrittenEntry& written);
  // "classes", "sheets", "verdicts and failures"
  void append_to(std::vector<Check>& checks) const;

 private:
  void compare_failures(int panel, const WrittenEntry& written);

  const ExportContent& content_;
  std::vector<std::optional<CongruenceMember>> member_;  // #P
  std::vector<double> class_, sheet_;                    // #P, 1-based; 0: none; not a number: on two
  std::vector<std::vector<const ToleranceFailure*>> failures_;
  ValueCheck classes_, sheets_, verdicts_;
};

}  // namespace planewright
