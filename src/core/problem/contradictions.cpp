#include "core/problem/contradictions.h"

#include <cmath>
#include <vector>

namespace planewright {
namespace {

// Edges (or unit-free): below this a contradiction is rounding.
constexpr double kRounding = 1e-7;

// What the equations on single unknowns hold, and the row that does it (-1: free).
struct Held {
  std::vector<int> row;
  Vector z;
};

Held held_unknowns(const Problem& problem) {
  const SparsePattern& pattern = problem.jacobian_pattern();
  Held held{std::vector<int>(static_cast<size_t>(problem.variables()), -1), Vector::Zero(problem.variables())};
  Vector slopes(pattern.size()), values(problem.rows());
  problem.jacobian_values(held.z.data(), slopes.data());
  problem.constraint_values(held.z.data(), values.data());
  for (int k = 0; k < pattern.size(); ++k) {
    const int row = pattern.rows[k];
    const bool alone = (k == 0 || pattern.rows[k - 1] != row) &&
                       (k + 1 == pattern.size() || pattern.rows[k + 1] != row);
    const Bounds bounds = problem.bounds(row);
    if (!alone || bounds.low != bounds.high || slopes[k] == 0.0) continue;
    held.row[static_cast<size_t>(pattern.columns[k])] = row;
    held.z[pattern.columns[k]] = (bounds.low - values[row]) / slopes[k];
  }
  return held;
}

std::string describe(const Problem& problem, int row) {
  return "'" + std::string(problem.row_name(row)) + "' at " + text(problem.row_element(row));
}

}  // namespace

Result<void> check_contradictions(const Problem& problem) {
  const Held held = held_unknowns(problem);
  const SparsePattern& pattern = problem.jacobian_pattern();
  Vector slopes(pattern.size()), values(problem.rows());
  problem.jacobian_values(held.z.data(), slopes.data());
  problem.constraint_values(held.z.data(), values.data());
  for (int begin = 0; begin < pattern.size();) {
    const int row = pattern.rows[begin];
    int end = begin, pin = -1;
    bool settled = true;
    for (; end < pattern.size() && pattern.rows[end] == row; ++end) {
      const int holder = held.row[static_cast<size_t>(pattern.columns[end])];
      // A slope of 0 says "does not matter" only where the row is linear; the unknowns of others are all held
      // or not.
      if (holder < 0 && slopes[end] != 0.0) settled = false;
      if (holder >= 0 && slopes[end] != 0.0) pin = holder;
    }
    const Bounds bounds = problem.bounds(row);
    const double miss = std::max(bounds.low - values[row], values[row] - bounds.high);
    if (settled && pin >= 0 && pin != row && problem.row_is_linear(row) && miss > kRounding)
      return fail(ErrorCode::Infeasible,
                  describe(problem, row) + " and " + describe(problem, pin) + " contradict each other",
                  text(problem.row_element(row)), "Change or remove one of the two");
    begin = end;
  }
  return {};
}

}  // namespace planewright
