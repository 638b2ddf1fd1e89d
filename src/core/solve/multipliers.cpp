#include "core/solve/multipliers.h"

#include <algorithm>

namespace planewright {
namespace {

constexpr double kStiff = 1e8;  // 1 / regularisation

}  // namespace

void complete_unit_normals(const Problem& problem, const Vector& z, Vector& multipliers) {
  const auto [first, last] = problem.unit_normal_rows();
  if (first == last) return;
  multipliers.segment(first, last - first).setZero();
  Vector slope(problem.variables()), values(problem.jacobian_pattern().size());
  problem.gradient(z.data(), slope.data());
  problem.jacobian_values(z.data(), values.data());
  const SparsePattern& pattern = problem.jacobian_pattern();
  for (int k = 0; k < pattern.size(); ++k)
    slope[pattern.columns[k]] += values[k] * multipliers[pattern.rows[k]];
  for (int i = 0; i < problem.layout().planes; ++i) {
    const auto n = z.segment<3>(problem.layout().n(i));
    multipliers[first + i] = -n.dot(slope.segment<3>(problem.layout().n(i))) / n.squaredNorm();
  }
}

Vector estimate_multipliers(const Problem& problem, const Vector& z, const Vector& guess,
                            TangentCache* cache) {
  Vector completed = guess;
  complete_unit_normals(problem, z, completed);
  const auto [first, last] = problem.unit_normal_rows();
  const std::vector<char> waived = problem.waived_at(z.data());
  std::vector<double> weights(static_cast<size_t>(problem.rows()), 0.0), slopes(weights.size(), 0.0);
  for (int row = 0; row < problem.rows(); ++row) {
    if ((row >= first && row < last) || waived[static_cast<size_t>(row)]) continue;
    const Bounds bounds = problem.bounds(row);
    if (bounds.low != bounds.high && guess[row] == 0.0) continue;
    weights[static_cast<size_t>(row)] = kStiff;
    slopes[static_cast<size_t>(row)] = guess[row];
  }
  TangentEquations equations(problem, EnergyCoupling::Dropped, cache);
  equations.linearise(z, true);
  equations.assemble(0.0, weights, slopes);
  if (!equations.factorise({1.0, 1.0})) return completed;
  const Vector left = equations.solve(-equations.gradient_of(1.0, nullptr, slopes));
  if (left.size() == 0) return completed;
  const Vector change = equations.constraint_change(left);
  Vector estimate = guess;
  for (int row = 0; row < problem.rows(); ++row) {
    const double weight = weights[static_cast<size_t>(row)];
    if (weight == 0.0) continue;
    estimate[row] += weight * change[row];
    const Bounds bounds = problem.bounds(row);
    if (bounds.low != bounds.high)
      estimate[row] = guess[row] < 0.0 ? std::min(0.0, estimate[row]) : std::max(0.0, estimate[row]);
  }
  complete_unit_normals(problem, z, estimate);
  return problem.first_order_residual(z.data(), estimate.data()) <
                 problem.first_order_residual(z.data(), completed.data())
             ? estimate
             : completed;
}

}  // namespace planewright
