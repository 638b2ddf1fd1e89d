#include "core/problem/problem.h"

#include <cmath>

#include "core/problem/energies.h"
#include "core/problem/fixed_planes_constraint.h"
#include "core/problem/incidence_constraint.h"
#include "core/problem/pattern_builder.h"
#include "core/problem/unit_normal_constraint.h"

namespace planewright {
namespace {

// The complex moved to its centroid and scaled to mean edge 1.
TangentComplex normalise(const TangentComplex& complex, const Vector3d& centre, double scale) {
  TangentComplex out = complex;
  out.origin.setZero();
  out.anchors = (complex.anchors.rowwise() - centre.transpose()) / scale;
  out.preferred = (complex.preferred.rowwise() - centre.transpose()) / scale;
  out.offsets = complex.offsets / scale;
  out.mean_edge = complex.mean_edge / scale;
  return out;
}

// Copies the variables of a stencil into `local`.
void gather(const double* z, std::span<const int> stencil, std::vector<double>& local) {
  for (size_t k = 0; k < stencil.size(); ++k) local[k] = z[stencil[k]];
}

double violation(double value, const Bounds& bounds) {
  return std::max({bounds.low - value, value - bounds.high, 0.0});
}

}  // namespace

Result<std::shared_ptr<const Problem>> Problem::create(std::shared_ptr<const TangentComplex> complex,
                                                       const ProblemSettings& settings) {
  for (const auto& [name, weight] : settings.weights) {
    if (auto known = find_energy(name); !known) return tl::unexpected(known.error());
    if (!std::isfinite(weight) || weight < 0.0)
      return fail(ErrorCode::Usage, "the weight of '" + name + "' is not a finite number of at least 0",
                  "weights", "Give 0 to switch an energy off");
  }

  std::shared_ptr<Problem> problem(new Problem);
  problem->complex_ = complex;
  problem->layout_ = {complex->point_count(), complex->plane_count(), settings.freedom};
  problem->centre_ = complex->preferred.colwise().mean();
  problem->scale_ = complex->mean_edge;
  problem->normalised_ = normalise(*complex, problem->centre_, problem->scale_);

  double largest = 0.0;
  for (const auto& [name, weight] : settings.weights) largest = std::max(largest, weight);
  if (largest > 0.0) problem->largest_weight_ = largest;

  const TangentComplex& normalised = problem->normalised_;
  const Layout& layout = problem->layout_;
  for (const EnergyInfo& info : energy_catalogue()) {
    const auto weight = settings.weights.find(info.name);
    if (weight == settings.weights.end() || weight->second == 0.0) continue;
    auto energy = info.make(normalised, layout);
    const double factor = energy->terms() > 0 ? weight->second * layout.points / energy->terms() : 0.0;
    problem->energies_.push_back({std::move(energy), weight->second, factor, {}, {}});
  }
  if (settings.freedom == Freedom::Fixed) {
    auto fixed = make_fixed_planes_constraint(normalised, layout);
    if (!fixed) return tl::unexpected(fixed.error());
    problem->constraints_.push_back({std::move(*fixed), 0, {}, {}});
  } else {
    problem->constraints_.push_back({make_incidence_constraint(normalised, layout), 0, {}, {}});
    problem->constraints_.push_back({make_unit_normal_constraint(layout), 0, {}, {}});
  }
  problem->assemble();
  return std::shared_ptr<const Problem>(std::move(problem));
}

void Problem::assemble() {
  PatternBuilder hessian;
  int added = 0;
  for (EnergyTerm& term : energies_) {
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      longest_stencil_ = std::max(longest_stencil_, static_cast<int>(stencil.size()));
      most_curvature_ = std::max(most_curvature_, static_cast<int>(term.energy->curvature(row).size()));
      term.first_slot.push_back(added);
      for (size_t a = 0; a < stencil.size(); ++a)
        for (size_t b = 0; b <= a; ++b, ++added) hessian.add(stencil[a], stencil[b]);
    }
    term.first_slot.push_back(added);
  }
  for (ConstraintTerm& term : constraints_) {
    term.first_row = rows_;
    for (int row = 0; row < term.constraint->rows(); ++row, ++rows_) {
      const auto stencil = term.constraint->stencil(row);
      longest_stencil_ = std::max(longest_stencil_, static_cast<int>(stencil.size()));
      most_curvature_ = std::max(most_curvature_, static_cast<int>(term.constraint->curvature(row).size()));
      bounds_.push_back(term.constraint->bounds(row));
      for (int variable : stencil) {
        jacobian_.rows.push_back(rows_);
        jacobian_.columns.push_back(variable);
      }
      term.first_slot.push_back(added);
      for (const StencilPair& pair : term.constraint->curvature(row)) {
        hessian.add(stencil[pair.first], stencil[pair.second]);
        ++added;
      }
    }
    term.first_slot.push_back(added);
  }

  // The whole diagonal, so that a solver can damp any unknown.
  for (int v = 0; v < variables(); ++v) hessian.add(v, v);

  std::vector<int> slot_of;
  hessian_ = hessian.build(slot_of);
  diagonal_slots_.assign(slot_of.end() - variables(), slot_of.end());
  const auto hand_out = [&slot_of](auto& term) {
    const int first = term.first_slot.front();
    term.hessian_slots.assign(slot_of.begin() + first, slot_of.begin() + term.first_slot.back());
    for (int& slot : term.first_slot) slot -= first;
  };
  for (EnergyTerm& term : energies_) hand_out(term);
  for (ConstraintTerm& term : constraints_) hand_out(term);
}

Vector Problem::from_state(const State& state) const {
  Vector z(variables());
  for (int j = 0; j < layout_.points; ++j)
    for (int c = 0; c < 3; ++c) z[layout_.x(j, c)] = (state.x(j, c) - centre_[c]) / scale_;
  for (int i = 0; i < layout_.planes; ++i) {
    for (int c = 0; c < 3; ++c) z[layout_.n(i, c)] = state.n(i, c);
    z[layout_.h(i)] = state.h[i] / scale_;
  }
  return z;
}

State Problem::to_state(std::span<const double> z) const {
  State state{Points(layout_.points, 3), Points(layout_.planes, 3), Vector(layout_.planes)};
  for (int j = 0; j < layout_.points; ++j)
    for (int c = 0; c < 3; ++c) state.x(j, c) = z[layout_.x(j, c)] * scale_ + centre_[c];
  for (int i = 0; i < layout_.planes; ++i) {
    for (int c = 0; c < 3; ++c) state.n(i, c) = z[layout_.n(i, c)];
    state.h[i] = z[layout_.h(i)] * scale_;
  }
  return state;
}

double Problem::contribution(const EnergyTerm& term, const double* z) const {
  std::vector<double> local(longest_stencil_);
  double squares = 0.0;
  for (int row = 0; row < term.energy->rows(); ++row) {
    gather(z, term.energy->stencil(row), local);
    const double r = term.energy->evaluate(row, local.data(), nullptr, nullptr);
    squares += r * r;
  }
  return term.factor * squares;
}

double Problem::objective(const double* z) const {
  double sum = 0.0;
  for (const EnergyTerm& term : energies_) sum += contribution(term, z);
  return sum;
}

void Problem::gradient(const double* z, double* out) const {
  std::fill(out, out + variables(), 0.0);
  std::vector<double> local(longest_stencil_), slope(longest_stencil_);
  for (const EnergyTerm& term : energies_)
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      gather(z, stencil, local);
      const double r = term.energy->evaluate(row, local.data(), slope.data(), nullptr);
      for (size_t k = 0; k < stencil.size(); ++k) out[stencil[k]] += 2.0 * term.factor * r * slope[k];
    }
}

void Problem::constraint_values(const double* z, double* out) const {
  std::vector<double> local(longest_stencil_);
  for (const ConstraintTerm& term : constraints_)
    for (int row = 0; row < term.constraint->rows(); ++row) {
      gather(z, term.constraint->stencil(row), local);
      *out++ = term.constraint->evaluate(row, local.data(), nullptr, nullptr);
    }
}

void Problem::jacobian_values(const double* z, double* out) const {
  std::vector<double> local(longest_stencil_);
  for (const ConstraintTerm& term : constraints_)
    for (int row = 0; row < term.constraint->rows(); ++row) {
      const auto stencil = term.constraint->stencil(row);
      gather(z, stencil, local);
      term.constraint->evaluate(row, local.data(), out, nullptr);
      out += stencil.size();
    }
}

void Problem::hessian_values(const double* z, double factor, const double* multipliers, double* out) const {
  std::fill(out, out + hessian_.size(), 0.0);
  std::vector<double> local(longest_stencil_), slope(longest_stencil_), bend(most_curvature_);
  for (const EnergyTerm& term : energies_) {
    const double twice = 2.0 * factor * term.factor;
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      const auto pairs = term.energy->curvature(row);
      gather(z, stencil, local);
      const double r =
          term.energy->evaluate(row, local.data(), slope.data(), pairs.empty() ? nullptr : bend.data());
      // (r^2)'' = 2 (grad r grad r^T + r r''); the stencil's triangle is stored row by row.
      const int* slot = term.hessian_slots.data() + term.first_slot[row];
      for (size_t a = 0, k = 0; a < stencil.size(); ++a)
        for (size_t b = 0; b <= a; ++b, ++k) out[slot[k]] += twice * slope[a] * slope[b];
      for (size_t k = 0; k < pairs.size(); ++k) {
        const int position = pairs[k].first * (pairs[k].first + 1) / 2 + pairs[k].second;
        out[slot[position]] += twice * r * bend[k];
      }
    }
  }
  for (const ConstraintTerm& term : constraints_)
    for (int row = 0; row < term.constraint->rows(); ++row) {
      const auto pairs = term.constraint->curvature(row);
      if (pairs.empty()) continue;
      gather(z, term.constraint->stencil(row), local);
      term.constraint->evaluate(row, local.data(), nullptr, bend.data());
      const int* slot = term.hessian_slots.data() + term.first_slot[row];
      for (size_t k = 0; k < pairs.size(); ++k) out[slot[k]] += multipliers[term.first_row + row] * bend[k];
    }
}

std::vector<Problem::EnergyShare> Problem::energy_shares(const double* z) const {
  std::vector<EnergyShare> shares;
  for (const EnergyTerm& term : energies_)
    shares.push_back({std::string(term.energy->name()), term.weight, contribution(term, z)});
  return shares;
}

std::vector<Problem::ConstraintViolation> Problem::violations(const double* z, double tolerance) const {
  Vector values(rows_);
  constraint_values(z, values.data());
  std::vector<ConstraintViolation> result;
  for (const ConstraintTerm& term : constraints_) {
    ConstraintViolation entry{std::string(term.constraint->name()), std::string(term.constraint->unit()), 0.0,
                              0};
    for (int row = term.first_row; row < term.first_row + term.constraint->rows(); ++row) {
      const double v = violation(values[row], bounds_[row]);
      entry.max_violation = std::max(entry.max_violation, v);
      if (v > tolerance) ++entry.violated;
    }
    result.push_back(entry);
  }
  return result;
}

double Problem::first_order_residual(const double* z, const double* multipliers) const {
  Vector slope(variables()), values(jacobian_.size());
  gradient(z, slope.data());
  jacobian_values(z, values.data());
  for (int k = 0; k < jacobian_.size(); ++k)
    slope[jacobian_.columns[k]] += values[k] * multipliers[jacobian_.rows[k]];
  double largest = 0.0;
  for (int v = 0; v < variables(); ++v)
    if (layout_.is_free(v)) largest = std::max(largest, std::abs(slope[v]));
  return largest;
}

}  // namespace planewright
