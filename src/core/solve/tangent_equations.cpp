#include "core/solve/tangent_equations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace planewright {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// Row and column of each matrix entry of the kept blocks. The upper entries of a diagonal block are stored
// below the diagonal, as explicit zeros, so that every block has nine slots.
std::vector<int> entries(const TangentPattern& pattern, bool rows) {
  std::vector<int> out;
  out.reserve(9 * static_cast<size_t>(pattern.kept_blocks()));
  for (int b = 0; b < pattern.kept_blocks(); ++b) {
    const auto [later, earlier] = pattern.kept_pair(b);
    for (int r = 0; r < 3; ++r)
      for (int s = 0; s < 3; ++s) {
        const int row = 3 * later + r, column = 3 * earlier + s;
        out.push_back(rows ? std::max(row, column) : std::min(row, column));
      }
  }
  return out;
}

// L of a symmetric 3 x 3 block, lower triangle read; false where it is not positive definite.
bool cholesky(const double* m, double* l) {
  const double a = m[0];
  if (!(a > 0.0)) return false;
  l[0] = std::sqrt(a);
  l[3] = m[3] / l[0];
  l[6] = m[6] / l[0];
  const double b = m[4] - l[3] * l[3];
  if (!(b > 0.0)) return false;
  l[4] = std::sqrt(b);
  l[7] = (m[7] - l[6] * l[3]) / l[4];
  const double c = m[8] - l[6] * l[6] - l[7] * l[7];
  if (!(c > 0.0)) return false;
  l[8] = std::sqrt(c);
  return true;
}

void solve_lower(const double* l, double* v) {
  v[0] /= l[0];
  v[1] = (v[1] - l[3] * v[0]) / l[4];
  v[2] = (v[2] - l[6] * v[0] - l[7] * v[1]) / l[8];
}
void solve_upper(const double* l, double* v) {
  v[2] /= l[8];
  v[1] = (v[1] - l[7] * v[2]) / l[4];
  v[0] = (v[0] - l[3] * v[1] - l[6] * v[2]) / l[0];
}

}  // namespace

TangentWorkspace::TangentWorkspace(const Problem& problem, EnergyCoupling coupling)
    : pattern(problem, coupling),
      cholesky(3 * pattern.kept(), entries(pattern, true), entries(pattern, false), 3,
               problem.layout().outside.empty() ? SparseCholesky::Backend::Mumps
                                                : SparseCholesky::Backend::Eigen) {}

std::shared_ptr<TangentWorkspace> TangentCache::find_or_make(const Problem& problem,
                                                             EnergyCoupling coupling) {
  const auto fitting = std::find_if(kept_.begin(), kept_.end(), [&](const auto& workspace) {
    return workspace->pattern.fits(problem, coupling);
  });
  std::shared_ptr<TangentWorkspace> found;
  if (fitting != kept_.end()) {
    found = *fitting;
    kept_.erase(fitting);
  } else {
    if (kept_.size() == kMost) kept_.erase(kept_.begin());
    found = std::make_shared<TangentWorkspace>(problem, coupling);
  }
  kept_.push_back(found);
  return found;
}

TangentEquations::TangentEquations(const Problem& problem, EnergyCoupling coupling, TangentCache* cache)
    : problem_(problem),
      workspace_(cache ? cache->find_or_make(problem, coupling)
                       : std::make_shared<TangentWorkspace>(problem, coupling)),
      points_(problem.layout().points),
      planes_(problem.layout().planes),
      tangents_(static_cast<size_t>(planes_)) {
  const auto size = [](RowValues& values, const RowSet& set) {
    values.slopes.resize(static_cast<size_t>(set.pattern.size()));
    values.gradient.assign(3 * set.nodes.indices().size(), 0.0);
  };
  size(energy_values_, pattern().energies());
  size(constraint_values_, pattern().constraints());
  residuals_.resize(problem.residuals());
  constraints_.resize(problem.rows());
  gradient_ = Vector::Zero(unknowns());
  blocks_.resize(9 * static_cast<size_t>(pattern().blocks()));
  lower_.resize(9 * static_cast<size_t>(pattern().eliminated()));
  eliminated_.resize(9 * static_cast<size_t>(pattern().couplings()));
}

void TangentEquations::linearise(const Vector& z, bool energies) {
  const Layout& layout = problem_.layout();
  for (int i = 0; i < planes_; ++i) {
    const Vector3d n = z.segment<3>(layout.n(i)).normalized();
    auto& t = tangents_[static_cast<size_t>(i)];
    t.col(0) = n.unitOrthogonal();
    t.col(1) = n.cross(t.col(0));
  }
  problem_.constraint_values(z.data(), constraints_.data());
  problem_.jacobian_values(z.data(), constraint_values_.slopes.data());
  reduce(pattern().constraints(), constraint_values_);
  if (!energies) return;
  problem_.residual_values(z.data(), residuals_.data());
  problem_.residual_jacobian(z.data(), energy_values_.slopes.data());
  reduce(pattern().energies(), energy_values_);
}

// From slopes in z to slopes along the tangent space.
void TangentEquations::reduce(const RowSet& set, RowValues& values) const {
  std::fill(values.gradient.begin(), values.gradient.end(), 0.0);
  const Layout& layout = problem_.layout();
  for (size_t slot = 0; slot < set.place.size(); ++slot) {
    const int variable = set.pattern.columns[slot];
    if (set.place[slot] < 0 || !layout.is_free(variable)) continue;
    double* g = values.gradient.data() + 3 * static_cast<size_t>(set.place[slot]);
    const double slope = values.slopes[slot];
    if (variable < 3 * points_) {
      g[variable % 3] += slope;
    } else if (variable < 3 * (points_ + planes_)) {
      const int plane = (variable - 3 * points_) / 3, axis = (variable - 3 * points_) % 3;
      const auto& t = tangents_[static_cast<size_t>(plane)];
      g[0] += t(axis, 0) * slope;
      g[1] += t(axis, 1) * slope;
    } else {
      g[2] += slope;
    }
  }
}

void TangentEquations::add_row(const RowSet& set, const RowValues& values, int row, double weight) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  size_t pair = set.first_pair[static_cast<size_t>(row)];
  for (int a = 0; a < set.nodes.valence(row); ++a) {
    const double* ga = values.gradient.data() + 3 * (first + a);
    for (int b = 0; b <= a; ++b, ++pair) {
      if (set.pair_block[pair] < 0) continue;
      const double* gb = values.gradient.data() + 3 * (first + b);
      double* out = blocks_.data() + 9 * static_cast<size_t>(set.pair_block[pair]);
      for (int r = 0; r < 3; ++r) {
        const double w = weight * ga[r];
        for (int s = 0; s < 3; ++s) out[3 * r + s] += w * gb[s];
      }
    }
  }
}

void TangentEquations::add_slope(const RowSet& set, const RowValues& values, int row, double slope,
                                 Vector& out) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  const auto nodes = set.nodes[row];
  for (size_t a = 0; a < nodes.size(); ++a) {
    const double* g = values.gradient.data() + 3 * (static_cast<size_t>(first) + a);
    double* o = out.data() + 3 * nodes[a];
    for (int r = 0; r < 3; ++r) o[r] += slope * g[r];
  }
}

Vector TangentEquations::gradient_of(double energy_factor, const Vector* residuals,
                                     std::span<const double> slopes) const {
  Vector out = Vector::Zero(unknowns());
  const Vector& e = residuals ? *residuals : residuals_;
  if (energy_factor != 0.0)
    for (int row = 0; row < pattern().energies().rows; ++row)
      add_slope(pattern().energies(), energy_values_, row, 2.0 * energy_factor * e[row], out);
  for (int row = 0; row < pattern().constraints().rows; ++row)
    if (const double slope = slopes[static_cast<size_t>(row)]; slope != 0.0)
      add_slope(pattern().constraints(), constraint_values_, row, slope, out);
  return out;
}

void TangentEquations::assemble(double energy_factor, std::span<const double> weights,
                                std::span<const double> slopes) {
  std::fill(blocks_.begin(), blocks_.end(), 0.0);
  energy_factor_ = energy_factor;
  weights_.assign(weights.begin(), weights.end());
  if (energy_factor != 0.0)
    for (int row = 0; row < pattern().energies().rows; ++row)
      add_row(pattern().energies(), energy_values_, row, 2.0 * energy_factor);
  for (int row = 0; row < pattern().constraints().rows; ++row)
    if (weights[static_cast<size_t>(row)] != 0.0)
      add_row(pattern().constraints(), constraint_values_, row, weights[static_cast<size_t>(row)]);
  gradient_ = gradient_of(energy_factor, nullptr, slopes);
}

void TangentEquations::map_hessian() {
  const SparsePattern& hessian = problem_.hessian_pattern();
  const auto place = [&](int variable) {
    return static_cast<signed char>(variable < 3 * (points_ + planes_) ? variable % 3 : 3);
  };
  hessian_slots_.reserve(static_cast<size_t>(hessian.size()));
  for (int slot = 0; slot < hessian.size(); ++slot) {
    const int row = hessian.rows[slot], column = hessian.columns[slot];
    HessianSlot mapped{-1, place(row), place(column), false};
    if (problem_.layout().is_free(row) && problem_.layout().is_free(column))
      mapped.block =
          pattern().find_block(pattern().node_of(row), pattern().node_of(column), mapped.transposed);
    hessian_slots_.push_back(mapped);
  }
}

// A second derivative in z along n becomes one along the two turns; that a unit normal bends back as it turns
// adds -(n . dL/dn) to both of them, which is the unit-normal row's multiplier.
void TangentEquations::add_curvature(const Vector& z, double energy_factor, const Vector& multipliers,
                                     double share) {
  if (hessian_slots_.empty()) map_hessian();
  const SparsePattern& hessian = problem_.hessian_pattern();
  const Layout& layout = problem_.layout();
  std::vector<double> exact(static_cast<size_t>(hessian.size())), linear(exact.size());
  problem_.hessian_values(z.data(), energy_factor, multipliers.data(), exact.data());
  problem_.hessian_values(z.data(), energy_factor, nullptr, linear.data(), Curvature::GaussNewton);
  const auto direction = [&](int variable, signed char place) {
    Vector3d d = Vector3d::Zero();
    if (variable < 3 * points_) {
      d[place] = 1.0;
    } else if (place == 3) {
      d[2] = 1.0;
    } else {
      const auto& t = tangents_[static_cast<size_t>((variable - 3 * points_) / 3)];
      d[0] = t(place, 0);
      d[1] = t(place, 1);
    }
    return d;
  };
  for (size_t slot = 0; slot < hessian_slots_.size(); ++slot) {
    const HessianSlot& mapped = hessian_slots_[slot];
    const double value = share * (exact[slot] - linear[slot]);
    if (mapped.block < 0 || value == 0.0) continue;
    const int row = hessian.rows[static_cast<int>(slot)], column = hessian.columns[static_cast<int>(slot)];
    const Vector3d a = direction(row, mapped.row), b = direction(column, mapped.column);
    auto target = block(mapped.block);
    const bool same_node = pattern().node_of(row) == pattern().node_of(column);
    if (same_node) {
      target += value * a * b.transpose();
      if (row != column) target += value * b * a.transpose();
    } else if (mapped.transposed) {
      target += value * b * a.transpose();
    } else {
      target += value * a * b.transpose();
    }
  }
  if (layout.freedom == Freedom::Fixed) return;
  Vector slope(problem_.variables());
  problem_.gradient(z.data(), slope.data());
  slope *= energy_factor;
  const auto& set = pattern().constraints();
  for (int row = 0; row < set.rows; ++row)
    if (multipliers[row] != 0.0)
      for (int s = set.first_slot[static_cast<size_t>(row)]; s < set.first_slot[static_cast<size_t>(row) + 1];
           ++s)
        if (set.place[static_cast<size_t>(s)] >= 0)
          slope[set.pattern.columns[s]] +=
              multipliers[row] * constraint_values_.slopes[static_cast<size_t>(s)];
  for (int i = 0; i < planes_; ++i) {
    const double bend = z.segment<3>(layout.n(i)).normalized().dot(slope.segment<3>(layout.n(i)));
    const int own = pattern().diagonal_block()[static_cast<size_t>(points_ + i)];
    if (own < 0) continue;
    auto target = block(own);
    target(0, 0) -= share * bend;
    target(1, 1) -= share * bend;
  }
}

double TangentEquations::damping_of(int node) const {
  if (node < points_) return damping_.points;
  return plane_damping_.empty() ? damping_.planes
                                : damping_.planes * plane_damping_[static_cast<size_t>(node - points_)];
}

// The reduced matrix of the kept nodes, into the factorisation's own values.
bool TangentEquations::eliminate(const Damping& damping) {
  damping_ = damping;
  plane_damping_.assign(damping.per_plane.begin(), damping.per_plane.end());
  damping_.per_plane = {};
  const TangentPattern& p = pattern();
  const std::span<double> values = workspace_->cholesky.values();
  std::copy(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(values.size()), values.begin());
  size_t fill = 0;
  for (int e = 0; e < p.eliminated(); ++e) {
    double own[9];
    std::copy_n(blocks_.data() + 9 * static_cast<size_t>(p.kept_blocks() + e), 9, own);
    for (int k = 0; k < 3; ++k) {
      own[4 * k] += damping_.points;
      if (own[4 * k] == 0.0) own[4 * k] = 1.0;  // a point that nothing pulls stays
    }
    double* l = lower_.data() + 9 * static_cast<size_t>(e);
    if (!cholesky(own, l)) return false;
    const int begin = p.first_coupling(e), end = p.first_coupling(e + 1);
    for (int c = begin; c < end; ++c) {
      double* u = eliminated_.data() + 9 * static_cast<size_t>(c);
      std::copy_n(blocks_.data() + 9 * static_cast<size_t>(p.coupling_block(c)), 9, u);
      for (int r = 0; r < 3; ++r) solve_lower(l, u + 3 * r);  // rows of C L^-T
    }
    for (int a = begin; a < end; ++a)
      for (int b = begin; b <= a; ++b, ++fill) {
        const double *ua = eliminated_.data() + 9 * static_cast<size_t>(a),
                     *ub = eliminated_.data() + 9 * static_cast<size_t>(b);
        double* out = values.data() + 9 * static_cast<size_t>(p.fill()[fill]);
        for (int r = 0; r < 3; ++r)
          for (int s = 0; s < 3; ++s)
            out[3 * r + s] -=
                ua[3 * r] * ub[3 * s] + ua[3 * r + 1] * ub[3 * s + 1] + ua[3 * r + 2] * ub[3 * s + 2];
      }
  }
  for (const int node : p.kept_nodes()) {
    double* own = values.data() + 9 * static_cast<size_t>(p.diagonal_block()[static_cast<size_t>(node)]);
    own[1] = own[2] = own[5] = 0.0;  // the same matrix entries as those below the diagonal
    for (int k = 0; k < 3; ++k) {
      own[4 * k] += damping_of(node);
      // Held unknowns must not make the matrix singular.
      if (own[4 * k] == 0.0) own[4 * k] = 1.0;
    }
  }
  return true;
}

bool TangentEquations::factorise(const Damping& damping) {
  return eliminate(damping) && (pattern().kept() == 0 || workspace_->cholesky.factorise());
}

Vector TangentEquations::direct_solve(const Vector& right) {
  const TangentPattern& p = pattern();
  Vector out = right;
  Vector reduced(3 * p.kept());
  for (int k = 0; k < p.kept(); ++k)
    reduced.segment<3>(3 * k) = right.segment<3>(3 * p.kept_nodes()[static_cast<size_t>(k)]);
  for (int e = 0; e < p.eliminated(); ++e) {
    double* own = out.data() + 3 * p.eliminated_points()[static_cast<size_t>(e)];
    solve_lower(lower_.data() + 9 * static_cast<size_t>(e), own);
    for (int c = p.first_coupling(e); c < p.first_coupling(e + 1); ++c) {
      const double* u = eliminated_.data() + 9 * static_cast<size_t>(c);
      double* r = reduced.data() + 3 * p.coupled_kept(c);
      for (int k = 0; k < 3; ++k) r[k] -= u[3 * k] * own[0] + u[3 * k + 1] * own[1] + u[3 * k + 2] * own[2];
    }
  }
  if (p.kept() > 0) workspace_->cholesky.solve(reduced);
  for (int e = 0; e < p.eliminated(); ++e) {
    double* own = out.data() + 3 * p.eliminated_points()[static_cast<size_t>(e)];
    for (int c = p.first_coupling(e); c < p.first_coupling(e + 1); ++c) {
      const double* u = eliminated_.data() + 9 * static_cast<size_t>(c);
      const double* r = reduced.data() + 3 * p.coupled_kept(c);
      for (int k = 0; k < 3; ++k) own[k] -= u[k] * r[0] + u[3 + k] * r[1] + u[6 + k] * r[2];
    }
    solve_upper(lower_.data() + 9 * static_cast<size_t>(e), own);
  }
  for (int k = 0; k < p.kept(); ++k)
    out.segment<3>(3 * p.kept_nodes()[static_cast<size_t>(k)]) = reduced.segment<3>(3 * k);
  return out;
}

Vector TangentEquations::multiply(const Vector& v) const {
  Vector out(v.size());
  // Unknowns without any curvature or damping, which eliminate() gives 1, have no part in right sides, and so
  // none in v.
  for (int node = 0; node < pattern().nodes(); ++node)
    out.segment<3>(3 * node) = damping_of(node) * v.segment<3>(3 * node);
  if (energy_factor_ != 0.0)
    for (int row = 0; row < pattern().energies().rows; ++row)
      add_slope(pattern().energies(), energy_values_, row,
                2.0 * energy_factor_ * change(pattern().energies(), energy_values_, row, v), out);
  for (int row = 0; row < pattern().constraints().rows; ++row)
    if (const double weight = weights_[static_cast<size_t>(row)]; weight != 0.0)
      add_slope(pattern().constraints(), constraint_values_, row,
                weight * change(pattern().constraints(), constraint_values_, row, v), out);
  return out;
}

Vector TangentEquations::conjugate_gradients(const Vector& right) {
  constexpr int kMostIterations = 100;
  Vector x = direct_solve(right);
  Vector r = right - multiply(x);
  const double goal = iterative_tolerance_ * right.norm();
  Vector y = direct_solve(r), d = y;
  double ry = r.dot(y);
  for (int k = 0; k < kMostIterations && r.norm() > goal && !stop_.stop_requested(); ++k) {
    const Vector hd = multiply(d);
    const double curvature = d.dot(hd);
    if (!(curvature > 0.0)) break;
    const double alpha = ry / curvature;
    x += alpha * d;
    r -= alpha * hd;
    y = direct_solve(r);
    const double next = r.dot(y);
    d = y + (next / ry) * d;
    ry = next;
  }
  return x;
}

Vector TangentEquations::solve(const Vector& right) {
  const bool direct = !pattern().incomplete() || energy_factor_ == 0.0;
  Vector out = direct ? direct_solve(right) : conjugate_gradients(right);
  return out.allFinite() ? out : Vector();
}

Vector TangentEquations::step(const Damping& damping) {
  if (!factorise(damping)) return {};
  return solve(-gradient_);
}

double TangentEquations::change(const RowSet& set, const RowValues& values, int row, const Vector& step) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  const auto nodes = set.nodes[row];
  double sum = 0.0;
  for (size_t a = 0; a < nodes.size(); ++a) {
    const double* g = values.gradient.data() + 3 * (static_cast<size_t>(first) + a);
    const double* s = step.data() + 3 * nodes[a];
    sum += g[0] * s[0] + g[1] * s[1] + g[2] * s[2];
  }
  return sum;
}

Vector TangentEquations::constraint_change(const Vector& step) const {
  const RowSet& set = pattern().constraints();
  Vector out(set.rows);
  for (int row = 0; row < set.rows; ++row) out[row] = change(set, constraint_values_, row, step);
  return out;
}

Vector TangentEquations::residual_change(const Vector& step) const {
  const RowSet& set = pattern().energies();
  Vector out(set.rows);
  for (int row = 0; row < set.rows; ++row) out[row] = change(set, energy_values_, row, step);
  return out;
}

Vector TangentEquations::moved(const Vector& z, const Vector& step) const {
  const Layout& layout = problem_.layout();
  Vector out = z;
  out.head(3 * points_) += step.head(3 * points_);
  if (layout.freedom == Freedom::Fixed) return out;
  for (int i = 0; i < planes_; ++i) {
    if (layout.is_outside(points_ + i)) continue;
    const auto turn = step.segment<3>(3 * (points_ + i));
    auto n = out.segment<3>(layout.n(i));
    n += tangents_[static_cast<size_t>(i)] * turn.head<2>();
    n.normalize();
    if (layout.is_free(layout.h(i))) out[layout.h(i)] += turn[2];
  }
  return out;
}

}  // namespace planewright
