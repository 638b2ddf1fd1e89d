#include "ui/failure_list.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace planewright::ui {
namespace {

// Beyond the limit by which part of it; a limit of 0 can only be compared by the measure.
double excess(const ToleranceFailure& failure) {
  const double off = std::abs(failure.measured - failure.limit);
  return failure.limit != 0.0 ? off / std::abs(failure.limit) : off;
}

}  // namespace

std::optional<int> FailureList::find(const ToleranceFailure& wanted) const {
  for (int row = 0; row < size(); ++row) {
    const ToleranceFailure& here = failure(row);
    if (here.panel == wanted.panel && here.kind == wanted.kind && here.side == wanted.side) return row;
  }
  return std::nullopt;
}

FailureList make_failure_list(std::shared_ptr<const PreparedWorkshop> from, const HiddenFailures& hidden) {
  FailureList list;
  list.from = std::move(from);
  list.hidden = hidden;
  if (!list.from) return list;
  const std::vector<ToleranceFailure>& failures = list.from->verdicts.failures;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    const auto kind = static_cast<std::size_t>(failures[i].kind);
    ++list.count[kind];
    if (!hidden[kind]) list.rows.push_back(static_cast<int>(i));
  }
  const auto order = [&](int i) {
    const ToleranceFailure& failure = failures[static_cast<std::size_t>(i)];
    return std::tuple(failure.kind, -excess(failure), failure.panel, failure.side);
  };
  std::sort(list.rows.begin(), list.rows.end(), [&](int a, int b) { return order(a) < order(b); });
  return list;
}

}  // namespace planewright::ui
