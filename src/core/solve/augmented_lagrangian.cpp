#include "core/solve/augmented_lagrangian.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/solve/hold.h"
#include "core/solve/row_penalties.h"
#include "core/solve/tangent_equations.h"

namespace planewright {
namespace {

constexpr int kInner = 4;                // steps between two updates of the multipliers
constexpr double kFirstPenalty = 100.0;  // rho
constexpr double kPenaltyGrowth = 3.0;
constexpr double kEnoughGain = 4.0;  // rows have to get better by this factor, else rho grows
constexpr double kFirstDamping = 1e-2, kMostDamping = 1e6, kLeastDamping = 1e-10;
constexpr double kPointShare = 0.1;           // of the planes' damping that points get
constexpr double kTowardsHere = 1e-6;         // keeps points in place that no energy pulls
constexpr double kIterativeTolerance = 1e-2;  // of steps where the coupling of points was dropped

class AugmentedLagrangian {
 public:
  AugmentedLagrangian(const Problem& problem, Vector& z, const AugmentedLagrangianOptions& options,
                      std::stop_token stop)
      : problem_(problem),
        equations_(problem, options.coupling, options.cache),
        rows_(problem),
        z_(z),
        options_(options),
        stop_(std::move(stop)),
        hold_(problem, z),
        share_(1.0 / problem.largest_weight()),
        values_(problem.rows()) {
    rows_.equations = rows_.inequalities = kFirstPenalty;
    for (int i = 0; i < problem.layout().planes; ++i)
      if (problem.layout().is_free(problem.layout().n(i))) z_.segment<3>(problem.layout().n(i)).normalize();
    equations_.set_iterative_tolerance(kIterativeTolerance);
    equations_.set_stop(stop_);
  }

  AugmentedLagrangianReport run() {
    rows_.choose_alternatives(z_);
    double worst_before = std::numeric_limits<double>::infinity();
    while (report_.steps < options_.max_steps && !stop_.stop_requested() && !report_.converged &&
           !report_.out_of_memory) {
      const int accepted = inner();
      if (accepted == 0 && damping_ >= kMostDamping) break;
      const double worst = update_multipliers();
      if (worst > worst_before / kEnoughGain)
        rows_.equations = rows_.inequalities =
            std::min(rows_.equations * kPenaltyGrowth, options_.most_penalty);
      worst_before = worst;
      rows_.choose_alternatives(z_);
    }
    report_.multipliers = rows_.multipliers / share_;
    return std::move(report_);
  }

 private:
  double lagrangian(const Vector& z) {
    problem_.constraint_values(z.data(), values_.data());
    const double sum = share_ * problem_.objective(z.data()) + hold_.value(z.data()) +
                       rows_.value(values_, rows_.multipliers, rows_.equations);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  void assemble() {
    equations_.linearise(z_, true);
    rows_.linearise(equations_.constraints(), weights_, slopes_);
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
        if (step.size() == 0 && equations_.out_of_memory()) {
          report_.out_of_memory = true;
          return accepted;
        }
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
          if (options_.tell)
            options_.tell(z_, equations_.gradient().lpNorm<Eigen::Infinity>(),
                          step.lpNorm<Eigen::Infinity>());
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
    rows_.slopes(values, rows_.multipliers, rows_.equations, slopes_);
    const Eigen::Map<const Vector> updated(slopes_.data(), problem_.rows());
    const double worst =
        problem_.rows() > 0 ? (updated - rows_.multipliers).lpNorm<Eigen::Infinity>() / rows_.equations : 0.0;
    rows_.multipliers = updated;
    report_.infeasibility = rows_.violation(values);
    Vector slope = equations_.gradient_of(share_, nullptr, slopes_);
    if (hold_.active()) slope.head(3 * problem_.layout().points) += hold_.gradient(z_.data());
    report_.first_order = slope.lpNorm<Eigen::Infinity>();
    report_.converged =
        report_.infeasibility <= options_.feasible && report_.first_order <= options_.first_order;
    return worst;
  }

  const Problem& problem_;
  TangentEquations equations_;
  RowPenalties rows_;
  Vector& z_;
  const AugmentedLagrangianOptions& options_;
  std::stop_token stop_;
  Hold hold_;
  double share_;  // energies relative to the largest weight
  Vector values_;
  std::vector<double> weights_, slopes_;
  double damping_ = kFirstDamping;
  AugmentedLagrangianReport report_;
};

}  // namespace

AugmentedLagrangianReport minimise_augmented_lagrangian(const Problem& problem, Vector& z,
                                                        const AugmentedLagrangianOptions& options,
                                                        std::stop_token stop) {
  return AugmentedLagrangian(problem, z, options, std::move(stop)).run();
}

}  // namespace planewright
