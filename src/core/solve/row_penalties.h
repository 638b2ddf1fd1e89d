// RowPenalties: a problem's rows as an augmented Lagrangian sees them. A row with value c, bounds [low,
// high], multiplier estimate y and penalty rho adds
//
//     rho/2 dist(c + y / rho, [low, high])^2,
//
// which for an equation is y c + rho/2 c^2 up to a constant, and for an inequality nothing as long as it
// holds with room to spare. Shared by augmented_lagrangian.h and primal_dual_newton.h; internal to solve/.
//
// Unit-normal rows are left out: steps in the tangent space keep normals unit. Of alternatives only those
// count that choose_alternatives() found. Units: normalised; energies relative to the largest weight.
#pragma once

#include <algorithm>
#include <vector>

#include "core/problem/problem.h"

namespace planewright {

class RowPenalties {
 public:
  explicit RowPenalties(const Problem& problem);

  // Rows that need not hold at z, because another one of the same alternative does better there, do not
  // count.
  void choose_alternatives(const Vector& z);

  bool counts(int row) const {
    return !left_out_[static_cast<size_t>(row)] && !waived_[static_cast<size_t>(row)];
  }
  bool is_equation(int row) const {
    const Bounds& b = bounds_[static_cast<size_t>(row)];
    return b.low == b.high;
  }
  // What is nearest to t within a row's bounds.
  double nearest(int row, double t) const {
    const Bounds& b = bounds_[static_cast<size_t>(row)];
    return std::clamp(t, b.low, b.high);
  }
  double penalty(int row) const { return is_equation(row) ? equations : inequalities; }
  double violation(const Vector& values) const;  // largest, of the rows that count; infinite at a NaN

  // Sum of the terms above for values c (#rows) and multipliers y (#rows), with one penalty for all rows.
  double value(const Vector& values, const Vector& y, double one_penalty) const;
  // d value / dc, rho (c + y / rho - nearest) for each row (#rows; 0 where there is none).
  void slopes(const Vector& values, const Vector& y, double one_penalty, std::vector<double>& out) const;
  // The same with own penalties and multipliers, and the second derivatives (the penalty, or 0 for an
  // inequality with room to spare): what a Gauss-Newton step needs.
  void linearise(const Vector& values, std::vector<double>& weights, std::vector<double>& out) const;

  double equations = 100.0, inequalities = 100.0;  // rho
  Vector multipliers;                              // y, #rows

 private:
  std::vector<Bounds> bounds_;
  std::vector<char> left_out_, waived_;
  const Problem& problem_;
};

}  // namespace planewright
