#include "core/solve/primal_dual_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "core/solve/demand_projection.h"
#include "core/solve/hold.h"
#include "core/solve/row_penalties.h"

namespace planewright {
namespace {

// Penalties rho. Equations start soft enough to leave a narrow curved valley, and stiffen as steps get short.
constexpr double kSoftEquations = 1e4, kStiffEquations = 1e7, kInequalities = 1e3;
// Of Gauss-Newton steps where the linearisation holds: the energy is right from the first step.
constexpr double kStraightEquations = 1e6;
constexpr double kLongStep = 0.3, kLongestStep = 0.6;  // mean edges, radians
// How boldly steps are taken; both by trial, on eight meshes without demands and on twenty demands.
struct Pace {
  double merit_penalty;            // of the merit's own augmented Lagrangian
  double short_step;               // edges, from which equations stiffen
  double damping_after_rejection;  // at least: less seldom helps, and each try costs a factorisation
};
constexpr Pace kFreePace{30.0, 0.1, 0.1}, kDemandPace{100.0, 0.05, 1e-4};
constexpr double kLeastDamping = 1e-6, kMostDamping = 1e9;
constexpr double kTowardsHere = 1e-6;                     // keeps points in place that no energy pulls
constexpr double kPointShare = 0.1;                       // of the planes' damping that points get
constexpr double kFirstShare = 0.05, kLeastShare = 0.02;  // of the curvature
constexpr int kForget = 6;                                // steps
constexpr int kMostTries = 40;                            // factorisations for one step
constexpr double kAccept = 1e-3;                          // ratio of actual to predicted decrease
// Conjugate gradients, where the coupling of points is left to them.
constexpr double kIterativeTolerance = 1e-2;
// More points than this, coupled by energies, would make the exact matrix too large: Gauss-Newton steps with
// conjugate gradients go on to the end there.
constexpr int kMostCoupledPoints = 120000;
// Gauss-Newton steps are good enough while each takes this share off the slope.
constexpr double kShrinking = 0.3;
// Largest violation, mean edges, after the first stiff step that still shows a linearisation that holds: the
// torus leaves 1e-3, real meshes 1e-1 and more.
constexpr double kSmooth = 1e-2;
// Slope, in tolerances, from which Newton steps finish what Gauss-Newton steps left.
constexpr double kNearlyThere = 10.0;
// Every so many steps the energy of the projected state is compared.
constexpr int kFlatInterval = 10, kFlatSpan = 2;
// Demands make the projection dear (twenty factorisations and more).
constexpr int kDemandInterval = 20, kDemandSpan = 1;
constexpr double kFlat = 1e-3;  // relative fall of the energy over the span of intervals
constexpr double kRounding = 1e-12;
// Share of the tolerance below which further steps would only shuffle the last digits.
constexpr double kFarBelow = 1e-4;

class PrimalDualNewton {
 public:
  PrimalDualNewton(const Problem& problem, Vector& z, Vector& multipliers, const NewtonOptions& options,
                   TangentCache& cache, PlanarFrames& frames, const std::stop_token& stop)
      : problem_(problem),
        z_(z),
        multipliers_(multipliers),
        options_(options),
        cache_(cache),
        frames_(frames),
        stop_(stop),
        rows_(problem),
        hold_(problem, z),
        share_(1.0 / problem.largest_weight()),
        points_(3 * problem.layout().points),
        pace_(problem.has_demands() ? kDemandPace : kFreePace),
        gauss_newton_(options.begin_gauss_newton),
        damping_(options.damping) {
    rows_.equations = gauss_newton_ ? kStraightEquations : kSoftEquations;
    rows_.inequalities = kInequalities;
    rows_.multipliers = multipliers;
    if (options.at_solution) {
      rows_.equations = kStiffEquations;
      curvature_ = 1.0;
      damping_ = kLeastDamping;
    }
    choose_equations();
  }

  NewtonReport run() {
    while (report_.end == NewtonEnd::StepLimit && report_.steps < options_.max_steps) {
      if (stop_.stop_requested()) {
        report_.end = NewtonEnd::Stopped;
        break;
      }
      linearise();
      if (report_.steps > 0 && is_converged()) {
        report_.end = NewtonEnd::Converged;
        break;
      }
      if (report_.end != NewtonEnd::StepLimit || !take_step()) break;
      if (options_.only_straight && report_.steps == 1 && violation_ > kSmooth)
        report_.end = NewtonEnd::NotStraight;
      if (report_.steps % (problem_.has_demands() ? kDemandInterval : kFlatInterval) == 0 && is_flat())
        report_.end = NewtonEnd::Flat;
    }
    if (report_.end == NewtonEnd::StepLimit && report_.steps > 0) {
      linearise();  // the last step may have been the one
      if (meets_tolerance()) report_.end = NewtonEnd::Converged;
    }
    keep_best();
    multipliers_ = rows_.multipliers;
    return report_;
  }

 private:
  // Curvature needs the exact matrix, whose negative pivots it watches. Where energies couple points, steps
  // without curvature are cheaper with conjugate gradients.
  void choose_equations() {
    const bool dropped = gauss_newton_;
    equations_ = std::make_unique<TangentEquations>(
        problem_, dropped ? EnergyCoupling::Dropped : EnergyCoupling::Exact, &cache_);
    equations_->set_iterative_tolerance(kIterativeTolerance);
    equations_->set_stop(stop_);
  }
  // Precondition: Gauss-Newton steps still, whose equations drop the coupling of points.
  bool too_large() const {
    return problem_.layout().points > kMostCoupledPoints && equations_->drops_couplings();
  }

  void linearise() {
    rows_.choose_alternatives(z_);
    equations_->linearise(z_, true);
    values_ = equations_->constraints();
    slopes_.assign(rows_.multipliers.data(), rows_.multipliers.data() + rows_.multipliers.size());
    Vector slope = equations_->gradient_of(share_, nullptr, slopes_);
    if (hold_.active()) slope.head(points_) += hold_.gradient(z_.data());
    const double before = report_.first_order;
    report_.first_order = slope.lpNorm<Eigen::Infinity>();
    report_.infeasibility = violation_ = rows_.violation(values_);
    if (!gauss_newton_ || report_.steps < 2 || too_large_) return;
    const bool shrinking = report_.first_order <= kShrinking * before;
    if (!shrinking) {
      // Never begun where the first steps already do: they may be the last ones.
      if (report_.first_order <= options_.first_order) return;
      if (options_.only_straight && report_.first_order > kNearlyThere * options_.first_order) {
        report_.end = NewtonEnd::NotStraight;
        return;
      }
      if (!(too_large_ = too_large())) {
        gauss_newton_ = false;
        choose_equations();
        equations_->linearise(z_, true);
      }
    }
  }

  bool meets_tolerance() const {
    return report_.infeasibility <= options_.feasible && report_.first_order <= options_.first_order;
  }

  // Steps with curvature converge quadratically, so once below the tolerance they go on while each still
  // gains an order of magnitude: a step or two more, and the result no longer depends on where exactly the
  // test was met.
  bool is_converged() {
    if (!meets_tolerance()) return false;
    const bool gains = report_.first_order <= 0.1 * met_at_;
    met_at_ = report_.first_order;
    return gauss_newton_ || !gains || report_.first_order <= kFarBelow * options_.first_order;
  }

  void assemble() {
    rows_.linearise(values_, weights_, slopes_);
    equations_->assemble(share_, weights_, slopes_);
    if (hold_.active()) {
      Vector slope = Vector::Zero(equations_->unknowns());
      slope.head(points_) = hold_.gradient(z_.data());
      equations_->add_slope(slope);
    }
    if (!gauss_newton_ && curvature_ > 0.0)
      equations_->add_curvature(z_, share_, rows_.multipliers, curvature_);
  }

  double merit(const Vector& z, const Vector& y) {
    trial_values_.resize(problem_.rows());
    problem_.constraint_values(z.data(), trial_values_.data());
    const double sum = share_ * problem_.objective(z.data()) + hold_.value(z.data()) +
                       rows_.value(trial_values_, y, pace_.merit_penalty);
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

  // The multipliers that a step leads to; those of inequalities only ever push inwards.
  Vector stepped_multipliers(const Vector& change) const {
    Vector y = Vector::Zero(problem_.rows());
    for (int row = 0; row < problem_.rows(); ++row) {
      const double weight = weights_[static_cast<size_t>(row)], slope = slopes_[static_cast<size_t>(row)];
      if (weight == 0.0) continue;
      y[row] = slope + weight * change[row];
      if (!rows_.is_equation(row)) y[row] = slope < 0.0 ? std::min(0.0, y[row]) : std::max(0.0, y[row]);
    }
    return y;
  }

  // Decrease of the merit with multipliers y that the quadratic model of a step promises.
  double predicted(const Vector& step, const Vector& change, const Vector& y, double on_points) {
    rows_.slopes(values_, y, pace_.merit_penalty, merit_slopes_);
    double stiffer = 0.0;  // what the step's own penalties put into its model beyond the merit's
    for (int row = 0; row < problem_.rows(); ++row) {
      if (!rows_.counts(row)) continue;
      const auto r = static_cast<size_t>(row);
      const bool active = merit_slopes_[r] != 0.0 || rows_.is_equation(row);
      stiffer += (weights_[r] - (active ? pace_.merit_penalty : 0.0)) * change[row] * change[row];
    }
    Vector slope = equations_->gradient_of(share_, nullptr, merit_slopes_);
    if (hold_.active()) slope.head(points_) += hold_.gradient(z_.data());
    const double damped = on_points * step.head(points_).squaredNorm() +
                          damping_ * step.tail(step.size() - points_).squaredNorm();
    const double curvature = -equations_->gradient().dot(step) - damped;
    return -(slope.dot(step) + 0.5 * curvature - 0.5 * stiffer);
  }

  // Ratio of actual to predicted decrease; at rounding level every step is as good as predicted.
  double ratio_of(double before, double after, double prediction) const {
    const double rounding = kRounding * std::max(1.0, std::abs(before));
    if (std::abs(prediction) < rounding && std::abs(before - after) < 10.0 * rounding) return 1.0;
    if (prediction > 0.0) return (before - after) / prediction;
    return after < before ? 0.3 : -1.0;
  }

  // False if the solve ends here (report_.end says why).
  bool take_step() {
    assemble();
    if (!equations_->gradient().allFinite()) {  // no damping can help
      report_.end = NewtonEnd::NotFinite;
      return false;
    }
    double raise = 4.0;
    bool finite = true;
    for (int tries = 0; tries < kMostTries; ++tries) {
      if (stop_.stop_requested()) {
        report_.end = NewtonEnd::Stopped;
        return false;
      }
      const double on_points =
          kTowardsHere + kPointShare * damping_ + (hold_.active() ? hold_.curvature() : 0.0);
      ++report_.factorisations;
      if (!equations_->factorise({on_points, damping_})) {
        if (equations_->out_of_memory()) {
          report_.end = NewtonEnd::OutOfMemory;
          return false;
        }
        if (!gauss_newton_ && curvature_ > 0.0) {
          indefinite_at_ = curvature_;
          since_indefinite_ = 0;
          curvature_ *= 0.6;
          if (curvature_ < kLeastShare) curvature_ = 0.0;
          assemble();
        } else {
          damping_ = std::max(4.0 * damping_, 1e-4);
        }
        continue;
      }
      const Vector step = equations_->solve(-equations_->gradient());
      if (step.size() == 0 && equations_->out_of_memory()) {
        report_.end = NewtonEnd::OutOfMemory;
        return false;
      }
      double ratio = -1.0, length = 0.0;
      if ((finite = step.size() > 0)) {
        length = step.lpNorm<Eigen::Infinity>();
        const Vector change = equations_->constraint_change(step), y = stepped_multipliers(change);
        const Vector trial = equations_->moved(z_, step);
        const double before = merit(z_, y), after = merit(trial, y);
        finite = std::isfinite(before);
        if (length <= kLongestStep && std::isfinite(after))
          ratio = ratio_of(before, after, predicted(step, change, y, on_points));
        if (ratio > kAccept) {
          z_ = trial;
          rows_.multipliers = y;
          violation_ = rows_.violation(trial_values_);
          accepted(ratio, length);
          return true;
        }
      }
      if (damping_ >= kMostDamping) break;
      if (options_.only_straight && report_.steps == 0) {
        report_.end = NewtonEnd::NotStraight;
        return false;
      }
      damping_ = std::max(damping_ * raise, pace_.damping_after_rejection);
      raise *= 2.0;
    }
    report_.end = finite ? NewtonEnd::NoStep : NewtonEnd::NotFinite;
    return false;
  }

  void accepted(double ratio, double length) {
    ++report_.steps;
    report_.damping = damping_;
    damping_ *= ratio > 0.75 ? 0.3 : ratio > 0.25 ? 0.7 : 2.0;
    damping_ = std::clamp(damping_, kLeastDamping, kMostDamping);
    if (!gauss_newton_) raise_curvature();
    if (length < pace_.short_step)
      rows_.equations = std::min(3.0 * rows_.equations, kStiffEquations);
    else if (length > kLongStep)
      rows_.equations = std::max(rows_.equations / 3.0, kSoftEquations);
    if (problem_.has_demands()) follow_active_set(length);
    frames_.tell(z_, report_.first_order, length, PlanarFrames::Distance::Near);
  }

  // Inequalities stiffen while the same ones push from step to step, which then converges like equations do.
  void follow_active_set(double length) {
    std::vector<char> active(static_cast<size_t>(problem_.rows()), 0);
    for (int row = 0; row < problem_.rows(); ++row)
      active[static_cast<size_t>(row)] = !rows_.is_equation(row) && rows_.multipliers[row] != 0.0;
    if (active == active_ && length < pace_.short_step)
      rows_.inequalities = std::min(3.0 * rows_.inequalities, kStiffEquations);
    else if (active != active_)
      rows_.inequalities = std::max(rows_.inequalities / 10.0, kInequalities);
    active_ = std::move(active);
  }

  // Back towards the full curvature, but for a while not to the share that was found indefinite: there a step
  // costs two factorisations.
  void raise_curvature() {
    const double raised = std::min(1.0, 1.3 * curvature_ + 0.05);
    if (++since_indefinite_ > kForget) indefinite_at_ = std::numeric_limits<double>::infinity();
    curvature_ =
        raised < indefinite_at_ ? raised : std::max(curvature_, 0.5 * (curvature_ + 0.9 * indefinite_at_));
  }

  // Projected copies now and then: their energies say whether the solve still gains anything where the slope
  // cannot say it (rows that depend on each other leave multipliers open), and the best is what is kept then.
  bool is_flat() {
    if (report_.steps < options_.max_steps && report_.steps < kFlatSpan * kFlatInterval) return false;
    const size_t span = problem_.has_demands() ? kDemandSpan : kFlatSpan;
    Vector projected = z_;
    const DemandProjectionReport projection =
        project_onto_demands(problem_, projected, kDemandProjectionSteps, stop_, &cache_);
    const double energy = projection.met ? share_ * problem_.objective(projected.data())
                                         : std::numeric_limits<double>::infinity();
    if (energy < best_energy_) {
      best_energy_ = energy;
      best_ = z_;
      best_multipliers_ = rows_.multipliers;
    }
    checkpoints_.push_back({best_energy_, report_.first_order});
    const size_t n = checkpoints_.size();
    if (n <= span) return false;
    const Checkpoint &then = checkpoints_[n - 1 - span], &now = checkpoints_[n - 1];
    const bool energy_falls = now.energy < (1.0 - kFlat) * then.energy;
    // Within sight of the end, short of it: let it get there.
    const bool slope_falls = now.slope < 0.1 * then.slope || now.slope <= 30.0 * options_.first_order;
    return !energy_falls && !slope_falls &&
           static_cast<int>(n) >= (problem_.has_demands() ? kDemandPatience : kPatience);
  }
  // Intervals before flatness is believed. Active sets that go on changing seldom end by themselves.
  static constexpr int kPatience = 10, kDemandPatience = 3;

  // A solve that did not converge gives the best that it saw.
  void keep_best() {
    if (report_.end == NewtonEnd::Converged || best_.size() == 0) return;
    Vector projected = z_;
    const DemandProjectionReport projection =
        project_onto_demands(problem_, projected, kDemandProjectionSteps, stop_, &cache_);
    if (projection.met && share_ * problem_.objective(projected.data()) <= best_energy_) return;
    z_ = best_;
    rows_.multipliers = best_multipliers_;
  }

  struct Checkpoint {
    double energy, slope;
  };
  const Problem& problem_;
  Vector& z_;
  Vector& multipliers_;
  const NewtonOptions& options_;
  TangentCache& cache_;
  PlanarFrames& frames_;
  const std::stop_token& stop_;
  RowPenalties rows_;
  Hold hold_;
  double share_;  // energies relative to the largest weight
  Eigen::Index points_;
  Pace pace_;
  std::unique_ptr<TangentEquations> equations_;
  bool gauss_newton_, too_large_ = false;
  double indefinite_at_ = std::numeric_limits<double>::infinity();  // share of the curvature
  int since_indefinite_ = 0;
  double damping_, curvature_ = kFirstShare, violation_ = 0.0;
  Vector values_, trial_values_;
  std::vector<double> weights_, slopes_, merit_slopes_;
  std::vector<char> active_;  // #rows, inequalities that push
  std::vector<Checkpoint> checkpoints_;
  double met_at_ = std::numeric_limits<double>::infinity();  // slope when the test was last met
  double best_energy_ = std::numeric_limits<double>::infinity();
  Vector best_, best_multipliers_;
  NewtonReport report_;
};

}  // namespace

NewtonReport minimise_primal_dual(const Problem& problem, Vector& z, Vector& multipliers,
                                  const NewtonOptions& options, TangentCache& cache, PlanarFrames& frames,
                                  const std::stop_token& stop) {
  return PrimalDualNewton(problem, z, multipliers, options, cache, frames, stop).run();
}

}  // namespace planewright
