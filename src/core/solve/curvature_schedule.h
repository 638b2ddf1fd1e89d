// CurvatureSchedule: which Hessian the steps of an interior point solve use, and when it changes. Internal to
// solve/.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace planewright {

// Which Hessian a step uses: first that of the energies alone (Gauss-Newton in the constraints) with some
// damping on the planes, then the exact one.
//
// Without the constraints' curvature the KKT system has the right inertia by itself: one factorisation a step
// instead of two to five, large steps, and symmetric saddles are left quickly (10,000-panel torus: 40 % of
// the energy at which exact steps alone end; train station: converges, where exact steps alone get lost in
// restoration). The damping keeps turns of the planes moderate; it grows, because undamped Gauss-Newton steps
// go round in circles in a few twisted places. Where this converges by itself it is left to; where the energy
// is flat and the slope still does not shrink, the exact Hessian finishes, quadratically.
class CurvatureSchedule {
 public:
  explicit CurvatureSchedule(int most) : most_(most) {}
  bool exact() const { return exact_ || iteration_ >= most_; }
  // In units of weight 1.
  double plane_damping() const { return 0.1 * std::pow(1.3, std::max(0, iteration_ - kAtLeast)); }

  void after(int iteration, double objective, double infeasibility, double first_order) {
    const bool flat = infeasibility <= kFlatInfeasibility &&
                      std::abs(objective - objective_) <= kFlat * std::abs(objective);
    flat_ = flat ? flat_ + 1 : 0;
    const bool shrinking = first_order <= 0.7 * first_order_;
    // Not too early: round a symmetric saddle the energy is flat for a few steps as well.
    if (iteration >= kAtLeast && flat_ >= 3 && !shrinking) exact_ = true;
    iteration_ = iteration;
    objective_ = objective;
    first_order_ = first_order;
  }

 private:
  static constexpr double kFlat = 1e-4;               // relative change of the energy in one step
  static constexpr double kFlatInfeasibility = 1e-4;  // mean edges
  static constexpr int kAtLeast = 15;
  int most_;
  int iteration_ = 0;
  int flat_ = 0;
  double objective_ = std::numeric_limits<double>::infinity();
  double first_order_ = std::numeric_limits<double>::infinity();
  bool exact_ = false;
};

}  // namespace planewright
