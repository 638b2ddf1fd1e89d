// FailureList: what of the failures of the tolerance sheet is listed and walked through.
//
// Threads: plain values.
#pragma once

#include <array>
#include <bitset>
#include <memory>
#include <optional>
#include <vector>

#include "ui/prepared_workshop.h"

namespace planewright::ui {

inline constexpr std::size_t kToleranceKinds = static_cast<std::size_t>(ToleranceKind::CrossesItself) + 1;
using HiddenFailures = std::bitset<kToleranceKinds>;  // by ToleranceKind

struct FailureList {
  // What it was made from.
  std::shared_ptr<const PreparedWorkshop> from;  // null: nothing is known, and the list is empty
  HiddenFailures hidden;

  std::vector<int>
      rows;  // indices into the failures: by kind, the worst first; those of hidden kinds left out
  std::array<int, kToleranceKinds> count{};  // of each kind, hidden or not

  int size() const { return static_cast<int>(rows.size()); }
  const ToleranceFailure& failure(int row) const {
    return from->verdicts.failures[static_cast<std::size_t>(rows[static_cast<std::size_t>(row)])];
  }
  // The row that is about the same panel, kind and side; none: it passes now, or is hidden.
  std::optional<int> find(const ToleranceFailure& failure) const;
};

FailureList make_failure_list(std::shared_ptr<const PreparedWorkshop> from, const HiddenFailures& hidden);

}  // namespace planewright::ui
