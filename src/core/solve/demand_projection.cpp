#include "core/solve/demand_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/solve/tangent_equations.h"

namespace planewright {
namespace {

constexpr double kInside = 1e-8;       // how far inside its bounds an inequality aims
constexpr double kCloseEnough = 1e-5;  // Phi below which active sets are worth their factorisations
constexpr int kActiveSets = 4;
constexpr double kCeiling = 1e-2, kLeastDamping = 1e-12, kMostDamping = 1e4;

class DemandProjector {
 public:
  DemandProjector(const Problem& problem, Vector& z, TangentCache* cache, double target)
      : problem_(problem), equations_(problem, EnergyCoupling::Dropped, cache), z_(z), target_(target) {
    // Steps keep normals unit; an interior point iterate's are so only to its tolerance.
    for (int i = 0; i < problem.layout().planes; ++i)
      if (problem.layout().is_free(problem.layout().n(i))) z_.segment<3>(problem.layout().n(i)).normalize();
    const auto [first, last] = problem.unit_normal_rows();
    skip_ = problem.inert_rows();
    skip_.resize(static_cast<size_t>(problem.rows()), 0);
    std::fill(skip_.begin() + first, skip_.begin() + last, 1);
    for (int row = 0; row < problem.rows(); ++row) {
      Bounds bounds = problem.bounds(row);
      const double inside = std::min(kInside, 0.25 * (bounds.high - bounds.low));
      if (bounds.low > -kNoLimit) bounds.low += inside;
      if (bounds.high < kNoLimit) bounds.high -= inside;
      aim_.push_back(bounds);
    }
  }

  DemandProjectionReport run(int max_steps, const std::stop_token& stop) {
    DemandProjectionReport report;
    const Vector start = z_;
    double factor = 1.0, ceiling = kCeiling;
    measure(z_);
    double phi = phi_;
    bool rejected = false;
    while (std::isfinite(phi) && !finished() && report.steps < max_steps && !stop.stop_requested()) {
      equations_.linearise(z_, false);
      const double damping = std::clamp(2.0 * factor * phi * share_, kLeastDamping, ceiling);
      const Vector step = find_step(damping, phi < kCloseEnough || rejected, stop, report.factorisations);
      if (step.size() == 0 && equations_.out_of_memory()) {
        report.out_of_memory = true;
        break;
      }
      double trial_phi = std::numeric_limits<double>::infinity();
      Vector trial;
      if (step.size() > 0) {
        trial = equations_.moved(z_, step);
        measure(trial);
        trial_phi = phi_;
      }
      if (trial_phi < phi) {
        // At rounding level steps only shuffle the last digits.
        const bool at_rounding = phi < 1e-22 && trial_phi > 0.5 * phi;
        stalled_ = trial_phi > 0.98 * phi ? stalled_ + 1 : 0;
        ++report.steps;
        if (trial_phi < 0.5 * phi) factor *= 0.2;
        ceiling = std::max(kCeiling, ceiling / 8.0);
        z_ = trial;
        phi = trial_phi;
        rejected = false;
        chord_steps(phi, stop);
        if (at_rounding || stalled_ >= kPatience) break;
      } else {
        measure(z_);
        rejected = true;
        if (damping >= kMostDamping || phi < 1e-26) break;
        if (damping >= ceiling)
          ceiling *= 8.0;
        else
          factor = std::max(factor, kLeastDamping / (2.0 * phi * share_)) * 8.0;
      }
    }
    measure(z_);
    report.incidence = incidence_;
    report.violation = violation_;
    report.met = violation_ <= kDemandTolerance;
    report.planar = incidences() <= kDemandTolerance;
    const Eigen::Index points = problem_.layout().points;
    if (points > 0)
      report.move =
          Eigen::Map<const Points>(Vector(z_ - start).data(), points, 3).rowwise().norm().maxCoeff();
    return report;
  }

 private:
  static constexpr int kPatience = 12;  // steps that gain less than 2 % each before a stall is believed

  bool finished() const { return incidence_ <= target_ && violation_ <= std::max(target_, kFinished); }
  // Equations of demands need not be met closer than rounding allows; inequalities aim inside.
  static constexpr double kFinished = 1e-12;

  // Further steps with the factors of the last one, while each leaves less than a small share of Phi.
  void chord_steps(double& phi, const std::stop_token& stop) {
    while (!finished() && !stop.stop_requested()) {
      for (size_t row = 0; row < weights_.size(); ++row) {
        const double m = skip_[row] || waived_[row]
                             ? 0.0
                             : miss(static_cast<int>(row), values_[static_cast<Eigen::Index>(row)]);
        if (weights_[row] == 0.0 && m != 0.0) return;  // a row that the factors know nothing of
        slopes_[row] = weights_[row] == 0.0 ? 0.0 : m;
      }
      const Vector step = equations_.solve(-equations_.gradient_of(0.0, nullptr, slopes_));
      if (step.size() == 0) return;
      const Vector trial = equations_.moved(z_, step);
      measure(trial);
      if (!(phi_ < (phi < kCloseEnough ? kNearChordShare : kFarChordShare) * phi)) {
        measure(z_);
        return;
      }
      z_ = trial;
      phi = phi_;
    }
  }
  // Far away a new factorisation is worth more than a step that gains little.
  static constexpr double kNearChordShare = 0.25, kFarChordShare = 0.1;

  double incidences() const {
    double worst = 0.0;
    for (int row = 0; row < problem_.planarity_rows(); ++row) {
      if (std::isnan(values_[row])) return std::numeric_limits<double>::infinity();
      worst = std::max(worst, std::abs(values_[row]));
    }
    return worst;
  }

  // Signed distance from what a row aims at; 0 inside, NaN where it could not be evaluated.
  double miss(int row, double value) const {
    const Bounds& aim = aim_[static_cast<size_t>(row)];
    if (std::isnan(value)) return value;
    return value < aim.low ? value - aim.low : value > aim.high ? value - aim.high : 0.0;
  }

  void measure(const Vector& z) {
    values_.resize(problem_.rows());
    problem_.constraint_values(z.data(), values_.data());
    waived_ = problem_.waived_at(z.data());
    phi_ = violation_ = incidence_ = 0.0;
    for (int row = 0; row < problem_.rows(); ++row) {
      if (skip_[static_cast<size_t>(row)] || waived_[static_cast<size_t>(row)]) continue;
      const double m = miss(row, values_[row]);
      phi_ += 0.5 * m * m;
      const Bounds bounds = problem_.bounds(row);
      const double v = std::max({bounds.low - values_[row], values_[row] - bounds.high, 0.0});
      violation_ = std::max(violation_, v);
      if (bounds.low == bounds.high) incidence_ = std::max(incidence_, v);
    }
    // Comparisons would take a row that is not a number for met.
    if (!std::isfinite(phi_)) phi_ = violation_ = incidence_ = std::numeric_limits<double>::infinity();
  }

  // Rows that a step has to bring to their aim: those that miss it, and (active_sets) those that would.
  Vector find_step(double damping, bool active_sets, const std::stop_token& stop, int& factorisations) {
    const auto rows = static_cast<size_t>(problem_.rows());
    weights_.assign(rows, 0.0);
    slopes_.assign(rows, 0.0);
    for (size_t row = 0; row < rows; ++row) {
      if (skip_[row] || waived_[row]) continue;
      const double m = miss(static_cast<int>(row), values_[static_cast<Eigen::Index>(row)]);
      const bool equation = aim_[row].low == aim_[row].high;
      if (m == 0.0 && !equation) continue;
      weights_[row] = 1.0;
      slopes_[row] = m;
    }
    Vector step;
    for (int round = 0;; ++round) {
      equations_.assemble(0.0, weights_, slopes_);
      ++factorisations;
      step = equations_.step(damping, damping);
      if (step.size() == 0 || !active_sets || round == kActiveSets || stop.stop_requested()) return step;
      const Vector change = equations_.constraint_change(step);
      bool grown = false;
      for (size_t row = 0; row < rows; ++row) {
        if (weights_[row] != 0.0 || skip_[row] || waived_[row]) continue;
        const auto r = static_cast<Eigen::Index>(row);
        if (miss(static_cast<int>(row), values_[r] + change[r]) == 0.0) continue;
        // Aim at the bound it would cross.
        const Bounds& aim = aim_[row];
        weights_[row] = 1.0;
        slopes_[row] = values_[r] + change[r] < aim.low ? values_[r] - aim.low : values_[r] - aim.high;
        grown = true;
      }
      if (!grown) return step;
    }
  }

  const Problem& problem_;
  TangentEquations equations_;
  Vector& z_;
  double target_;
  std::vector<char> skip_, waived_;
  std::vector<Bounds> aim_;
  Vector values_;
  std::vector<double> weights_, slopes_;
  double phi_ = 0.0, violation_ = 0.0, incidence_ = 0.0;
  int stalled_ = 0;
  // Phi is a sum: its share of a thousand rows damps alike at every size.
  double share_ = std::min(1.0, 1000.0 / std::max(problem_.rows(), 1));
};

}  // namespace

DemandProjectionReport project_onto_demands(const Problem& problem, Vector& z, int max_steps,
                                            std::stop_token stop, TangentCache* cache, double target) {
  return DemandProjector(problem, z, cache, target).run(max_steps, stop);
}

}  // namespace planewright
