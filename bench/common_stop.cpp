#include "common_stop.h"

#include <limits>
#include <utility>

namespace planewright::bench {

CommonStop::CommonStop(std::shared_ptr<const Problem> normalised, std::shared_ptr<const Problem> solved,
                       const StopTest& test)
    : normalised_(std::move(normalised)),
      solved_(std::move(solved)),
      scale_(normalised_->complex().mean_edge / solved_->complex().mean_edge),
      test_(test) {}

// With lengths s times as large, f is s^2 and an incidence s times as large, a unit normal's row the same:
//   s^2 f + y_i s c_i + y_u c_u = s^2 (f + y_i/s c_i + y_u/s^2 c_u).
Vector CommonStop::normalised_multipliers(const Vector& multipliers) const {
  Vector normalised = multipliers / scale_;
  const auto [first, last] = normalised_->unit_normal_rows();
  normalised.segment(first, last - first) /= scale_;
  return normalised;
}

double CommonStop::residual(const State& state, const Vector& multipliers) const {
  if (multipliers.size() != normalised_->rows()) return std::numeric_limits<double>::quiet_NaN();
  const Vector z = normalised_->from_state(state), y = normalised_multipliers(multipliers);
  return normalised_->first_order_residual(z.data(), y.data()) / normalised_->largest_weight();
}

bool CommonStop::met(const Vector& z, const Vector& multipliers) const {
  const State state = solved_->to_state({z.data(), static_cast<size_t>(z.size())});
  Vector rows(normalised_->rows());
  normalised_->constraint_values(normalised_->from_state(state).data(), rows.data());
  return rows.cwiseAbs().maxCoeff() <= test_.feasible && residual(state, multipliers) <= test_.tolerance;
}

}  // namespace planewright::bench
