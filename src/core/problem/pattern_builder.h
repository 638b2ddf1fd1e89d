// PatternBuilder: collects the entries of a symmetric sparse matrix, gives each distinct one a slot, and
// tells every contributor where its values go. Internal to problem/.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/problem/problem.h"

namespace planewright {

class PatternBuilder {
 public:
  // Entry (a, b) of the lower triangle, in either order of its indices.
  void add(int a, int b) {
    const auto row = static_cast<std::uint64_t>(std::max(a, b)),
               column = static_cast<std::uint64_t>(std::min(a, b));
    keys_.push_back(row << 32 | column);
  }

  // slot_of: for each add(), in order, its slot; the pattern is sorted by row, then column.
  SparsePattern build(std::vector<int>& slot_of) const {
    std::vector<std::uint64_t> distinct = keys_;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    SparsePattern pattern;
    pattern.rows.reserve(distinct.size());
    pattern.columns.reserve(distinct.size());
    for (const std::uint64_t key : distinct) {
      pattern.rows.push_back(static_cast<int>(key >> 32));
      pattern.columns.push_back(static_cast<int>(key & 0xffffffffu));
    }
    slot_of.resize(keys_.size());
    for (size_t k = 0; k < keys_.size(); ++k)
      slot_of[k] =
          static_cast<int>(std::lower_bound(distinct.begin(), distinct.end(), keys_[k]) - distinct.begin());
    return pattern;
  }

 private:
  std::vector<std::uint64_t> keys_;
};

}  // namespace planewright
