#include "core/solve/projection.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>

#include "core/solve/sparse_cholesky.h"

namespace planewright {
namespace {

using Eigen::Matrix3d;
using Tangents = Eigen::Matrix<double, 3, 2>;

Tangents tangents(const Vector3d& n) {
  Tangents t;
  t.col(0) = n.unitOrthogonal();
  t.col(1) = n.cross(t.col(0));
  return t;
}

// Works in mean edges about the complex's local 0.
class Projector {
 public:
  Projector(const TangentComplex& complex, const State& state, Freedom freedom)
      : complex_(complex), freedom_(freedom), scale_(complex.mean_edge) {
    anchors_ = complex.anchors / scale_;
    x_ = state.x / scale_;
    n_ = state.n;
    if (freedom_ != Freedom::Fixed)
      for (int i = 0; i < n_.rows(); ++i) n_.row(i).normalize();
    h_ = state.h / scale_;
    start_ = x_;
  }

  ProjectionReport run(double target, int max_factorisations, const std::stop_token& stop) {
    ProjectionReport report;
    residual_ = residuals(x_, n_, h_);
    report.before = largest(residual_);
    double damping_factor = 1.0, ceiling = kCeiling;
    // The merit is a sum: its share of a thousand rows damps alike at every size.
    const double share = std::min(1.0, 1000.0 / (complex_.incidence_count() + complex_.plane_count()));
    if (freedom_ != Freedom::Fixed && report.before > target) analyse();
    while (largest(residual_) > target && report.factorisations < max_factorisations &&
           !stop.stop_requested()) {
      const double merit = residual_.squaredNorm();  // 2 Phi
      const double damping = std::clamp(damping_factor * share * merit, 1e-12, ceiling);
      ++report.factorisations;
      if (!step(damping)) break;
      const Vector trial = residuals(x_trial_, n_trial_, h_trial_);
      const double trial_merit = trial.squaredNorm();
      if (trial_merit < merit) {
        // At rounding level steps only shuffle the last digits: one that gains little ends it.
        const bool at_rounding = largest(residual_) < 100.0 * target && trial_merit > 0.5 * merit;
        x_ = x_trial_;
        n_ = n_trial_;
        h_ = h_trial_;
        residual_ = trial;
        if (trial_merit < 0.5 * merit) damping_factor *= 0.2;
        ceiling = std::max(kCeiling, ceiling / 8.0);
        if (at_rounding) break;
      } else {
        if (largest(residual_) < 10.0 * target || damping >= kMostDamping) break;
        if (damping >= ceiling)
          ceiling *= 8.0;
        else
          damping_factor = std::max(damping_factor, 1e-12 / (share * merit)) * 8.0;
      }
    }
    report.after = largest(residual_);
    report.move = x_.rows() > 0 ? (x_ - start_).rowwise().norm().maxCoeff() : 0.0;
    report.reached = report.after <= 10.0 * target;
    return report;
  }

  // What may not move stays to the last bit.
  void store(State& state) const {
    state.x = x_ * scale_;
    if (freedom_ != Freedom::Fixed) state.n = n_;
    if (freedom_ == Freedom::NormalsAndOffsets) state.h = h_ * scale_;
  }

 private:
  // Damping that is not exceeded unless a step has failed with it, and at which there is no step left to try.
  static constexpr double kCeiling = 1e-2, kMostDamping = 1e4;

  static double largest(const Vector& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

  Vector residuals(const Points& x, const Points& n, const Vector& h) const {
    Vector c(complex_.incidence_count());
    int row = 0;
    for (int j = 0; j < complex_.point_count(); ++j)
      for (int i : complex_.planes_of_point[j]) c[row++] = n.row(i).dot(x.row(j) - anchors_.row(i)) - h[i];
    return c;
  }

  // The pattern: a 3 x 3 block per plane, and one per pair of planes that share a point.
  void analyse() {
    std::vector<std::uint64_t> keys;
    for_each_pair([&](int a, int b, size_t) { keys.push_back(key(a, b)); });
    for (int i = 0; i < complex_.plane_count(); ++i) keys.push_back(key(i, i));
    std::vector<std::uint64_t> distinct = keys;
    std::sort(distinct.begin(), distinct.end());
    distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
    block_of_pair_.reserve(keys.size());
    for (const std::uint64_t k : keys)
      block_of_pair_.push_back(
          static_cast<int>(std::lower_bound(distinct.begin(), distinct.end(), k) - distinct.begin()));

    std::vector<int> rows, columns;
    for (const std::uint64_t k : distinct) {
      const int a = static_cast<int>(k >> 32), b = static_cast<int>(k & 0xffffffffu);
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s) {
          // A diagonal block stores its upper entries as explicit zeros below, so that every block has 9
          // slots.
          const int row = 3 * a + r, column = 3 * b + s;
          rows.push_back(std::max(row, column));
          columns.push_back(std::min(row, column));
        }
    }
    blocks_.assign(distinct.size(), Matrix3d::Zero());
    values_.resize(9 * distinct.size());
    solver_ =
        std::make_unique<SparseCholesky>(3 * complex_.plane_count(), std::move(rows), std::move(columns));
  }

  static std::uint64_t key(int a, int b) {
    return static_cast<std::uint64_t>(a) << 32 | static_cast<std::uint32_t>(b);
  }

  // Every pair a >= b of planes of a point, points in order; planes of a point ascend.
  template <class Visit>
  void for_each_pair(Visit visit) const {
    size_t k = 0;
    for (int j = 0; j < complex_.point_count(); ++j) {
      const auto planes = complex_.planes_of_point[j];
      for (size_t r = 0; r < planes.size(); ++r)
        for (size_t s = 0; s <= r; ++s) visit(planes[r], planes[s], k++);
    }
  }

  // The linearised incidences of point j: rows n_i, and (x - v_i)^T T_i, -1 on plane i's three unknowns.
  void linearise(int j, Eigen::MatrixXd& normals, Eigen::MatrixXd& turns) const {
    const auto planes = complex_.planes_of_point[j];
    const auto k = static_cast<Eigen::Index>(planes.size());
    normals.resize(k, 3);
    turns.setZero(k, 3);
    for (Eigen::Index r = 0; r < k; ++r) {
      const int i = planes[static_cast<size_t>(r)];
      normals.row(r) = n_.row(i);
      if (freedom_ == Freedom::Fixed) continue;
      turns.row(r).head<2>() = (x_.row(j) - anchors_.row(i)) * tangents_[i];
      if (freedom_ == Freedom::NormalsAndOffsets) turns(r, 2) = -1.0;
    }
  }

  // One damped step into the trial state; false if the factorisation failed.
  bool step(double damping) {
    const int planes = complex_.plane_count();
    const bool planes_move = freedom_ != Freedom::Fixed;
    Vector p = Vector::Zero(3 * planes);
    std::vector<Eigen::MatrixXd> inverse(static_cast<size_t>(complex_.point_count()));
    Eigen::MatrixXd normals, turns;
    if (planes_move) {
      tangents_.resize(static_cast<size_t>(planes));
      for (int i = 0; i < planes; ++i) tangents_[i] = tangents(n_.row(i));
      std::fill(blocks_.begin(), blocks_.end(), Matrix3d::Zero());
    }
    size_t pair = 0;
    int row = 0;
    for (int j = 0; j < complex_.point_count(); ++j) {
      linearise(j, normals, turns);
      const Eigen::Index k = normals.rows();
      Eigen::MatrixXd gram = normals * normals.transpose();
      gram.diagonal().array() += damping;
      inverse[j] = gram.llt().solve(Eigen::MatrixXd::Identity(k, k));
      if (planes_move) {
        const Vector weighted = inverse[j] * residual_.segment(row, k);
        const auto list = complex_.planes_of_point[j];
        for (Eigen::Index r = 0; r < k; ++r) {
          p.segment<3>(3 * list[static_cast<size_t>(r)]) -= turns.row(r).transpose() * weighted[r];
          for (Eigen::Index s = 0; s <= r; ++s, ++pair)
            blocks_[block_of_pair_[pair]] += turns.row(r).transpose() * inverse[j](r, s) * turns.row(s);
        }
      }
      row += static_cast<int>(k);
    }
    if (planes_move && !solve_for_planes(pair, p)) return false;

    x_trial_ = x_;
    n_trial_ = n_;
    h_trial_ = h_;
    row = 0;
    for (int j = 0; j < complex_.point_count(); ++j) {
      linearise(j, normals, turns);
      const Eigen::Index k = normals.rows();
      Vector e = residual_.segment(row, k);
      const auto list = complex_.planes_of_point[j];
      for (Eigen::Index r = 0; r < k; ++r)
        e[r] += turns.row(r) * p.segment<3>(3 * list[static_cast<size_t>(r)]);
      x_trial_.row(j) -= (normals.transpose() * (inverse[j] * e)).transpose();
      row += static_cast<int>(k);
    }
    if (planes_move)
      for (int i = 0; i < planes; ++i) {
        n_trial_.row(i) += (tangents_[i] * p.segment<2>(3 * i)).transpose();
        n_trial_.row(i).normalize();
        if (freedom_ == Freedom::NormalsAndOffsets) h_trial_[i] += p[3 * i + 2];
      }
    return x_trial_.allFinite() && n_trial_.allFinite();
  }

  // p: right side in, planes' steps out. first_diagonal: where the planes' own blocks begin in
  // block_of_pair_.
  bool solve_for_planes(size_t first_diagonal, Vector& p) {
    for (int i = 0; i < complex_.plane_count(); ++i)
      blocks_[block_of_pair_[first_diagonal + static_cast<size_t>(i)]] += Matrix3d::Identity();
    // Diagonal blocks: the entries above the diagonal are the same matrix entries as those below.
    std::vector<bool> diagonal(blocks_.size(), false);
    for (int i = 0; i < complex_.plane_count(); ++i)
      diagonal[block_of_pair_[first_diagonal + static_cast<size_t>(i)]] = true;
    for (size_t b = 0; b < blocks_.size(); ++b)
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s)
          values_[9 * b + 3 * r + s] = diagonal[b] && s > r ? 0.0 : blocks_[b](r, s);
    if (!solver_->factorise(values_)) return false;
    solver_->solve(p);
    return true;
  }

  const TangentComplex& complex_;
  Freedom freedom_;
  double scale_;
  Points anchors_, x_, n_, x_trial_, n_trial_, start_;
  Vector h_, h_trial_, residual_;
  std::vector<Tangents> tangents_;
  std::vector<Matrix3d> blocks_;
  std::vector<int> block_of_pair_;
  std::vector<double> values_;
  std::unique_ptr<SparseCholesky> solver_;
};

}  // namespace

ProjectionReport project_onto_incidences(const TangentComplex& complex, State& state, Freedom freedom,
                                         double target, int max_factorisations, std::stop_token stop) {
  Projector projector(complex, state, freedom);
  const ProjectionReport report = projector.run(target, max_factorisations, stop);
  if (report.after < report.before) projector.store(state);
  return report;
}

}  // namespace planewright
