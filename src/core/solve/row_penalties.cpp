#include "core/solve/row_penalties.h"

#include <cmath>
#include <limits>

namespace planewright {

RowPenalties::RowPenalties(const Problem& problem) : problem_(problem) {
  const auto rows = static_cast<size_t>(problem.rows());
  multipliers = Vector::Zero(problem.rows());
  bounds_.reserve(rows);
  for (int row = 0; row < problem.rows(); ++row) bounds_.push_back(problem.bounds(row));
  left_out_ = problem.inert_rows();
  left_out_.resize(rows, 0);
  const auto [first, last] = problem.unit_normal_rows();
  std::fill(left_out_.begin() + first, left_out_.begin() + last, 1);
  waived_.assign(rows, 0);
}

void RowPenalties::choose_alternatives(const Vector& z) {
  if (!problem_.has_demands()) return;
  waived_ = problem_.waived_at(z.data());
  for (int row = 0; row < problem_.rows(); ++row)
    if (!counts(row)) multipliers[row] = 0.0;
}

double RowPenalties::violation(const Vector& values) const {
  double worst = 0.0;
  for (int row = 0; row < problem_.rows(); ++row) {
    if (!counts(row)) continue;
    if (std::isnan(values[row])) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, std::abs(values[row] - nearest(row, values[row])));
  }
  return worst;
}

double RowPenalties::value(const Vector& values, const Vector& y, double one_penalty) const {
  double sum = 0.0;
  for (int row = 0; row < problem_.rows(); ++row) {
    if (!counts(row)) continue;
    const double t = values[row] + y[row] / one_penalty, miss = t - nearest(row, t);
    sum += 0.5 * one_penalty * miss * miss;
  }
  return sum;
}

void RowPenalties::slopes(const Vector& values, const Vector& y, double one_penalty,
                          std::vector<double>& out) const {
  out.assign(static_cast<size_t>(problem_.rows()), 0.0);
  for (int row = 0; row < problem_.rows(); ++row) {
    if (!counts(row)) continue;
    const double t = values[row] + y[row] / one_penalty;
    out[static_cast<size_t>(row)] = one_penalty * (t - nearest(row, t));
  }
}

void RowPenalties::linearise(const Vector& values, std::vector<double>& weights,
                             std::vector<double>& out) const {
  weights.assign(static_cast<size_t>(problem_.rows()), 0.0);
  out.assign(weights.size(), 0.0);
  for (int row = 0; row < problem_.rows(); ++row) {
    if (!counts(row)) continue;
    const double rho = penalty(row), t = values[row] + multipliers[row] / rho, miss = t - nearest(row, t);
    if (miss == 0.0 && !is_equation(row)) continue;
    weights[static_cast<size_t>(row)] = rho;
    out[static_cast<size_t>(row)] = rho * miss;
  }
}

}  // namespace planewright
