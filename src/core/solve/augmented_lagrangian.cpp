#include "core/solve/augmented_lagrangian.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/solve/hold.h"
#include "core/solve/tangent_equations.h"

namespace planewright {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kInner = 4;                // steps between two updates of the multipliers
constexpr double kFirstPenalty = 100.0;  // rho
constexpr double kPenaltyGrowth = 3.0;
constexpr double kEnoughGain = 4.0;  // rows have to get better by this factor, else rho grows
constexpr double kFirstDamping = 1e-2, kMostDamping = 1e6, kLeastDamping = 1e-10;
constexpr double kPointShare = 0.1;    // of the planes' damping that points get
constexpr double kTowardsHere = 1e-6;  // keeps points in place that no energy pulls

class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const Problem& problem, Vector& z, const AugmentedLagrangianOptions& options,
                      SolveObserver* observer, std::stop_token stop)
      : problem_(problem),
        equations_(problem),
        z_(z),
        options_(options),
        observer_(observer),
        stop_(std::move(stop)),
        hold_(problem, z),
        share_(1.0 / problem.largest_weight()),
        begun_(Clock::now()) {
    const auto rows = static_cast<size_t>(problem.rows());
    skip_.assign(rows, 0);
    const auto [first, last] = problem.unit_normal_rows();
    std::fill(skip_.begin() + first, skip_.begin() + last, 1);
    weights_.assign(rows, 0.0);
    slopes_.assign(rows, 0.0);
    multipliers_ = Vector::Zero(problem.rows());
    for (int i = 0; i < problem.layout().planes; ++i) {
      auto n = z_.segment<3>(problem.layout().n(i));
      if (problem.layout().freedom != Freedom::Fixed) n.normalize();
    }
  }

  AugmentedLagrangianReport run() {
    waived_ = problem_.waived_at(z_.data());
    double worst_before = std::numeric_limits<double>::infinity();
    while (report_.steps < options_.max_steps && !stop_.stop_requested() && !report_.converged) {
      const int accepted = inner();
      if (accepted == 0 && damping_ >= kMostDamping) break;
      const double worst = update_multipliers();
      if (worst > worst_before / kEnoughGain)
        penalty_ = std::min(penalty_ * kPenaltyGrowth, options_.most_penalty);
      worst_before = worst;
      waived_ = problem_.waived_at(z_.data());
    }
    report_.multipliers = multipliers_ / share_;
    return std::move(report_);
  }

 private:
  // The value of a row that is nearest to t within its bounds.
  double within(int row, double t) const {
    const Bounds bounds = problem_.bounds(row);
    return std::clamp(t, bounds.low, bounds.high);
  }
  bool counts(int row) const {
    return !skip_[static_cast<size_t>(row)] && !waived_[static_cast<size_t>(row)];
  }

  double lagrangian(const Vector& z) const {
    double sum = share_ * problem_.objective(z.data()) + hold_.value(z.data());
    Vector values(problem_.rows());
    problem_.constraint_values(z.data(), values.data());
    for (int row = 0; row < problem_.rows(); ++row) {
      if (!counts(row)) continue;
      const double t = values[row] + multipliers_[row] / penalty_, miss = t - within(row, t);
      sum += 0.5 * penalty_ * miss * miss;
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  void assemble() {
    equations_.linearise(z_, true);
    const Vector& values = equations_.constraints();
    for (int row = 0; row < problem_.rows(); ++row) {
      const auto r = static_cast<size_t>(row);
      weights_[r] = slopes_[r] = 0.0;
      if (!counts(row)) continue;
      const double t = values[row] + multipliers_[row] / penalty_, miss = t - within(row, t);
      const Bounds bounds = problem_.bounds(row);
      if (miss == 0.0 && bounds.low != bounds.high) continue;
      weights_[r] = penalty_;
      slopes_[r] = penalty_ * miss;
    }
    equations_.assemble(share_, weights_, slopes_);
    add_hold();
  }

  void add_hold() {
    if (!hold_.active()) return;
    Vector slope = Vector::Zero(equations_.unknowns());
    slope.head(3 * problem_.layout().points) = hold_.gradient(z_.data());
    equations_.add_slope(slope);
  }

  // At most kInner accepted steps; how many there were.
  int inner() {
    int accepted = 0;
    double now = lagrangian(z_);
    while (accepted < kInner && report_.steps < options_.max_steps && !stop_.stop_requested()) {
      assemble();
      double raise = 2.0;
      for (bool done = false; !done;) {
        if (report_.steps >= options_.max_steps || stop_.stop_requested()) return accepted;
        const double on_points = kPointShare * damping_ + kTowardsHere;
        const Vector step = equations_.step(on_points + (hold_.active() ? hold_.curvature() : 0.0), damping_);
        ++report_.steps;
        double ratio = -1.0;
        Vector trial;
        if (step.size() > 0) {
          trial = equations_.moved(z_, step);
          const Eigen::Index split = 3 * problem_.layout().points;
          const double predicted = -0.5 * equations_.gradient().dot(step) +
                                   0.5 * on_points * step.head(split).squaredNorm() +
                                   0.5 * damping_ * step.tail(step.size() - split).squaredNorm();
          const double then = lagrangian(trial);
          if (predicted > 0.0 && std::isfinite(then)) ratio = (now - then) / predicted;
          if (ratio > 1e-3) {
            z_ = trial;
            now = then;
          }
        }
        if (ratio > 1e-3) {
          damping_ *= ratio > 0.75 ? 0.2 : ratio > 0.25 ? 0.6 : 2.0;
          damping_ = std::clamp(damping_, kLeastDamping, kMostDamping);
          ++accepted;
          tell(step.lpNorm<Eigen::Infinity>());
          done = true;
        } else {
          damping_ *= raise;
          raise *= 2.0;
          if (damping_ >= kMostDamping) {
            damping_ = kMostDamping;
            return accepted;
          }
        }
      }
    }
    return accepted;
  }

  // The largest of violation and complementarity, which says how good the multipliers were.
  double update_multipliers() {
    equations_.linearise(z_, true);
    const Vector& values = equations_.constraints();
    double worst = 0.0;
    report_.infeasibility = 0.0;
    std::fill(weights_.begin(), weights_.end(), 0.0);
    std::fill(slopes_.begin(), slopes_.end(), 0.0);
    for (int row = 0; row < problem_.rows(); ++row) {
      if (!counts(row)) {
        multipliers_[row] = 0.0;
        continue;
      }
      const double t = values[row] + multipliers_[row] / penalty_, miss = t - within(row, t);
      const double change = penalty_ * miss - multipliers_[row];
      multipliers_[row] = penalty_ * miss;
      slopes_[static_cast<size_t>(row)] = multipliers_[row];
      worst = std::max(worst, std::abs(change) / penalty_);
      report_.infeasibility =
          std::max(report_.infeasibility, std::abs(values[row] - within(row, values[row])));
    }
    equations_.assemble(share_, weights_, slopes_);
    add_hold();
    report_.first_order = equations_.gradient().lpNorm<Eigen::Infinity>();
    report_.converged =
        report_.infeasibility <= options_.feasible && report_.first_order <= options_.first_order;
    return worst;
  }

  void tell(double step) {
    if (!observer_) return;
    Iteration iteration;
    iteration.number = options_.first_iteration + told_++;
    iteration.energies = problem_.energy_shares(z_.data());
    for (const auto& share : iteration.energies) iteration.objective += share.value;
    for (const auto& v : problem_.violations(z_.data(), kDetails))
      iteration.infeasibility = std::max(iteration.infeasibility, v.max_violation);
    iteration.first_order = equations_.gradient().lpNorm<Eigen::Infinity>();
    iteration.step = step;
    iteration.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    const State state = problem_.to_state({z_.data(), static_cast<size_t>(z_.size())});
    observer_->on_iteration(iteration, &state);
  }
  static constexpr double kDetails = 1e-9;

  const Problem& problem_;
  TangentEquations equations_;
  Vector& z_;
  const AugmentedLagrangianOptions& options_;
  SolveObserver* observer_;
  std::stop_token stop_;
  Hold hold_;
  double share_;  // energies relative to the largest weight
  Clock::time_point begun_;
  std::vector<char> skip_, waived_;
  std::vector<double> weights_, slopes_;
  Vector multipliers_;
  double penalty_ = kFirstPenalty, damping_ = kFirstDamping;
  int told_ = 0;
  AugmentedLagrangianReport report_;
};

}  // namespace

AugmentedLagrangianReport minimise_augmented_lagrangian(const Problem& problem, Vector& z,
                                                        const AugmentedLagrangianOptions& options,
                                                        SolveObserver* observer, std::stop_token stop) {
  return AugmentedLagrangian(problem, z, options, observer, std::move(stop)).run();
}

}  // namespace planewright
