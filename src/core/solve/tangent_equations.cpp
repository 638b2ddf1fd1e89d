#include "core/solve/tangent_equations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

namespace planewright {

TangentEquations::TangentEquations(const Problem& problem)
    : problem_(problem),
      points_(problem.layout().points),
      planes_(problem.layout().planes),
      nodes_(points_ + planes_),
      tangents_(static_cast<size_t>(planes_)) {
  prepare(energy_rows_, problem.residual_pattern(), problem.residuals());
  prepare(constraint_rows_, problem.jacobian_pattern(), problem.rows());
  analyse();
  residuals_.resize(problem.residuals());
  constraints_.resize(problem.rows());
  gradient_ = Vector::Zero(unknowns());
}

int TangentEquations::node_of(int variable) const {
  if (variable < 3 * points_) return variable / 3;
  if (variable < 3 * (points_ + planes_)) return points_ + (variable - 3 * points_) / 3;
  return points_ + variable - 3 * (points_ + planes_);
}

void TangentEquations::prepare(RowSet& set, const SparsePattern& pattern, int rows) {
  set.pattern = &pattern;
  set.rows = rows;
  set.slopes.resize(static_cast<size_t>(pattern.size()));
  set.place.resize(static_cast<size_t>(pattern.size()));
  set.first_slot.reserve(static_cast<size_t>(rows) + 1);
  const auto [skip_begin, skip_end] = problem_.unit_normal_rows();
  std::vector<int> nodes;
  for (int row = 0, slot = 0; row < rows; ++row) {
    const int begin = slot;
    set.first_slot.push_back(begin);
    nodes.clear();
    while (slot < pattern.size() && pattern.rows[slot] == row)
      nodes.push_back(node_of(pattern.columns[slot++]));
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    // Unit length is kept by moved(): such a row has no nodes, and its slots go nowhere.
    const bool skipped = &set == &constraint_rows_ && row >= skip_begin && row < skip_end;
    if (skipped) nodes.clear();
    const int first = static_cast<int>(set.nodes.indices().size());
    set.nodes.push_back(nodes);
    for (int s = begin; s < slot; ++s) {
      const auto found = std::lower_bound(nodes.begin(), nodes.end(), node_of(pattern.columns[s]));
      set.place[static_cast<size_t>(s)] = skipped ? -1 : first + static_cast<int>(found - nodes.begin());
    }
  }
  set.first_slot.push_back(pattern.size());
  set.gradient.resize(3 * set.nodes.indices().size());
}

// One 3 x 3 block per pair of nodes that some row couples, and per node.
void TangentEquations::analyse() {
  const auto key = [](int later, int earlier) {
    return static_cast<std::uint64_t>(later) << 32 | static_cast<std::uint32_t>(earlier);
  };
  std::vector<std::uint64_t> keys;
  for (RowSet* set : {&energy_rows_, &constraint_rows_})
    for (int row = 0; row < set->rows; ++row) {
      const auto nodes = set->nodes[row];
      for (size_t a = 0; a < nodes.size(); ++a)
        for (size_t b = 0; b <= a; ++b) keys.push_back(key(nodes[a], nodes[b]));
    }
  for (int node = 0; node < nodes_; ++node) keys.push_back(key(node, node));
  std::vector<std::uint64_t> distinct = keys;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  const auto block_of = [&](std::uint64_t k) {
    return static_cast<int>(std::lower_bound(distinct.begin(), distinct.end(), k) - distinct.begin());
  };
  size_t next = 0;
  for (RowSet* set : {&energy_rows_, &constraint_rows_})
    for (int row = 0; row <= set->rows; ++row) {
      set->first_pair.push_back(set->pair_block.size());
      if (row == set->rows) break;
      const auto count = static_cast<size_t>(set->nodes.valence(row));
      for (size_t k = 0; k < count * (count + 1) / 2; ++k) set->pair_block.push_back(block_of(keys[next++]));
    }
  for (int node = 0; node < nodes_; ++node) diagonal_block_.push_back(block_of(keys[next++]));

  std::vector<int> rows, columns;
  rows.reserve(9 * distinct.size());
  columns.reserve(9 * distinct.size());
  for (const std::uint64_t k : distinct)
    for (int r = 0; r < 3; ++r)
      for (int s = 0; s < 3; ++s) {
        // The upper entries of a diagonal block are stored below the diagonal, as explicit zeros (step()).
        const int row = 3 * static_cast<int>(k >> 32) + r, column = 3 * static_cast<int>(k & 0xffffffffu) + s;
        rows.push_back(std::max(row, column));
        columns.push_back(std::min(row, column));
      }
  blocks_.resize(distinct.size());
  values_.resize(9 * distinct.size());
  solver_ = std::make_unique<SparseCholesky>(unknowns(), std::move(rows), std::move(columns));
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
  problem_.jacobian_values(z.data(), constraint_rows_.slopes.data());
  reduce(constraint_rows_);
  if (!energies) return;
  problem_.residual_values(z.data(), residuals_.data());
  problem_.residual_jacobian(z.data(), energy_rows_.slopes.data());
  reduce(energy_rows_);
}

// From slopes in z to slopes along the tangent space.
void TangentEquations::reduce(RowSet& set) const {
  std::fill(set.gradient.begin(), set.gradient.end(), 0.0);
  const Layout& layout = problem_.layout();
  for (size_t slot = 0; slot < set.place.size(); ++slot) {
    const int variable = set.pattern->columns[slot];
    if (set.place[slot] < 0 || !layout.is_free(variable)) continue;
    double* g = set.gradient.data() + 3 * static_cast<size_t>(set.place[slot]);
    const double slope = set.slopes[slot];
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

void TangentEquations::add_row(const RowSet& set, int row, double weight) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  size_t pair = set.first_pair[static_cast<size_t>(row)];
  for (int a = 0; a < set.nodes.valence(row); ++a) {
    const Eigen::Map<const Vector3d> ga(set.gradient.data() + 3 * (first + a));
    for (int b = 0; b <= a; ++b, ++pair) {
      const Eigen::Map<const Vector3d> gb(set.gradient.data() + 3 * (first + b));
      blocks_[static_cast<size_t>(set.pair_block[pair])].noalias() += weight * ga * gb.transpose();
    }
  }
}

void TangentEquations::add_slope(const RowSet& set, int row, double slope) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  const auto nodes = set.nodes[row];
  for (size_t a = 0; a < nodes.size(); ++a)
    gradient_.segment<3>(3 * nodes[a]) +=
        slope * Eigen::Map<const Vector3d>(set.gradient.data() + 3 * (static_cast<size_t>(first) + a));
}

void TangentEquations::assemble(double energy_factor, std::span<const double> weights,
                                std::span<const double> slopes) {
  std::fill(blocks_.begin(), blocks_.end(), Matrix3d::Zero());
  gradient_.setZero();
  if (energy_factor != 0.0)
    for (int row = 0; row < energy_rows_.rows; ++row) {
      add_row(energy_rows_, row, 2.0 * energy_factor);
      add_slope(energy_rows_, row, 2.0 * energy_factor * residuals_[row]);
    }
  for (int row = 0; row < constraint_rows_.rows; ++row) {
    if (weights[static_cast<size_t>(row)] != 0.0)
      add_row(constraint_rows_, row, weights[static_cast<size_t>(row)]);
    if (slopes[static_cast<size_t>(row)] != 0.0)
      add_slope(constraint_rows_, row, slopes[static_cast<size_t>(row)]);
  }
}

Vector TangentEquations::step(double point_damping, double plane_damping) {
  for (size_t b = 0; b < blocks_.size(); ++b)
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(values_.data() + 9 * b) = blocks_[b];
  for (int node = 0; node < nodes_; ++node) {
    double* block = values_.data() + 9 * static_cast<size_t>(diagonal_block_[static_cast<size_t>(node)]);
    block[1] = block[2] = block[5] = 0.0;  // the same matrix entries as those below the diagonal
    const double damping = node < points_ ? point_damping : plane_damping;
    for (int k = 0; k < 3; ++k) {
      block[4 * k] += damping;
      // Held unknowns, and points that nothing pulls, must not make the matrix singular.
      if (block[4 * k] == 0.0) block[4 * k] = 1.0;
    }
  }
  if (!solver_->factorise(values_)) return {};
  Vector right = -gradient_;
  solver_->solve(right);
  return right.allFinite() ? right : Vector();
}

double TangentEquations::change(const RowSet& set, int row, const Vector& step) {
  const int first = set.nodes.offsets()[static_cast<size_t>(row)];
  const auto nodes = set.nodes[row];
  double sum = 0.0;
  for (size_t a = 0; a < nodes.size(); ++a)
    sum += step.segment<3>(3 * nodes[a])
               .dot(Eigen::Map<const Vector3d>(set.gradient.data() + 3 * (static_cast<size_t>(first) + a)));
  return sum;
}

Vector TangentEquations::constraint_change(const Vector& step) const {
  Vector out(constraint_rows_.rows);
  for (int row = 0; row < constraint_rows_.rows; ++row) out[row] = change(constraint_rows_, row, step);
  return out;
}

Vector TangentEquations::residual_change(const Vector& step) const {
  Vector out(energy_rows_.rows);
  for (int row = 0; row < energy_rows_.rows; ++row) out[row] = change(energy_rows_, row, step);
  return out;
}

Vector TangentEquations::moved(const Vector& z, const Vector& step) const {
  const Layout& layout = problem_.layout();
  Vector out = z;
  out.head(3 * points_) += step.head(3 * points_);
  if (layout.freedom == Freedom::Fixed) return out;
  for (int i = 0; i < planes_; ++i) {
    const auto turn = step.segment<3>(3 * (points_ + i));
    auto n = out.segment<3>(layout.n(i));
    n += tangents_[static_cast<size_t>(i)] * turn.head<2>();
    n.normalize();
    if (layout.is_free(layout.h(i))) out[layout.h(i)] += turn[2];
  }
  return out;
}

}  // namespace planewright
