// Hold: a faint wish of every point to stay where a solve began, for problems with demands whose energies
// leave points free. Without it the barriers and penalties of inequalities push such points to infinity.
// Internal to solve/; energies relative to the largest weight, lengths in mean edges.
#pragma once

#include "core/problem/problem.h"

namespace planewright {

class Hold {
 public:
  // Only position holds every point in every direction; where it weighs enough this weighs nothing.
  Hold(const Problem& problem, const Vector& z) : size_(3 * problem.layout().points) {
    if (!problem.has_demands()) return;
    double position = 0.0;
    for (const auto& share : problem.energy_shares(z.data()))
      if (share.name == "position") position = share.weight / problem.largest_weight();
    if (position >= kEnough) return;
    weight_ = kWeight;
    at_ = z.head(size_);
  }

  bool active() const { return weight_ > 0.0; }
  double value(const double* z) const {
    return active() ? weight_ * (Eigen::Map<const Vector>(z, size_) - at_).squaredNorm() : 0.0;
  }
  // Of the points' coordinates (3X). Precondition: active().
  Vector gradient(const double* z) const {
    return 2.0 * weight_ * (Eigen::Map<const Vector>(z, size_) - at_);
  }
  double curvature() const { return 2.0 * weight_; }  // of each coordinate

 private:
  // Small enough to leave a slope well below the tolerance at moves of an edge.
  static constexpr double kWeight = 5e-5, kEnough = 1e-3;
  Eigen::Index size_;
  double weight_ = 0.0;
  Vector at_;
};

}  // namespace planewright
