#include "core/problem/problem.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/problem/contradictions.h"
#include "core/problem/demands/demand_catalogue.h"
#include "core/problem/demands/pins.h"
#include "core/problem/demands/separation.h"
#include "core/problem/energies/energy_catalogue.h"
#include "core/problem/fixed_planes_constraint.h"
#include "core/problem/foot_points.h"
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
  out.input.vertices = (complex.input.vertices.rowwise() - centre.transpose()) / scale;
  return out;
}

// Copies the variables of a stencil into `local`.
void gather(const double* z, std::span<const int> stencil, std::vector<double>& local) {
  for (size_t k = 0; k < stencil.size(); ++k) local[k] = z[stencil[k]];
}

// A demand's values, complete and in mean edges about `centre` (model coordinates).
Result<std::vector<double>> normalised_values(const DemandInfo& info, const Demand& demand,
                                              const Vector3d& centre, double scale) {
  if (demand.values.size() > info.parameters.size())
    return fail(ErrorCode::Usage,
                "the demand '" + demand.name + "' takes " + std::to_string(info.parameters.size()) +
                    " values, not " + std::to_string(demand.values.size()),
                "demands");
  std::vector<double> values;
  for (size_t k = 0; k < info.parameters.size(); ++k) {
    const DemandParameter& parameter = info.parameters[k];
    const bool given = k < demand.values.size();
    double value = given ? demand.values[k] : parameter.default_value;
    if (!std::isfinite(value))
      return fail(ErrorCode::Usage,
                  "'" + parameter.name + "' of the demand '" + demand.name + "' is not a finite number",
                  "demands");
    if (std::abs(value) >= kNoLimit) {  // "none", whatever the unit
      values.push_back(value);
      continue;
    }
    switch (parameter.unit) {
      case DemandUnit::Length:
        value /= scale;
        break;
      case DemandUnit::CoordinateX:
      case DemandUnit::CoordinateY:
      case DemandUnit::CoordinateZ: {
        const int axis = static_cast<int>(parameter.unit) - static_cast<int>(DemandUnit::CoordinateX);
        value = (value - centre[axis]) / scale;
        break;
      }
      case DemandUnit::Edges:
      case DemandUnit::None:
        break;
    }
    values.push_back(value);
  }
  return values;
}

// Infinite where the row could not be evaluated: comparisons would take a NaN for met.
double violation(double value, const Bounds& bounds) {
  if (std::isnan(value)) return std::numeric_limits<double>::infinity();
  return std::max({bounds.low - value, value - bounds.high, 0.0});
}

}  // namespace

Result<std::shared_ptr<const Problem>> Problem::create(std::shared_ptr<const TangentComplex> complex,
                                                       const ProblemSettings& settings,
                                                       const FrozenGeometry& frozen) {
  std::shared_ptr<Problem> problem(new Problem);
  problem->complex_ = complex;
  problem->layout_ = {complex->point_count(), complex->plane_count(), settings.freedom, settings.outside};
  problem->centre_ = complex->preferred.colwise().mean();
  problem->scale_ = complex->mean_edge;
  problem->normalised_ = normalise(*complex, problem->centre_, problem->scale_);

  if (auto added = problem->add_energies(settings, frozen); !added) return tl::unexpected(added.error());
  const TangentComplex& normalised = problem->normalised_;
  if (settings.freedom == Freedom::Fixed) {
    auto fixed = make_fixed_planes_constraint(normalised, problem->layout_);
    if (!fixed) return tl::unexpected(fixed.error());
    problem->add_constraint(std::move(*fixed));
    problem->planarity_rows_ = problem->rows_;
  } else {
    problem->add_constraint(make_incidence_constraint(normalised, problem->layout_));
    const int first = problem->planarity_rows_ = problem->rows_;
    problem->add_constraint(make_unit_normal_constraint(problem->layout_));
    problem->unit_normal_rows_ = {first, problem->rows_};
  }
  if (auto added = problem->add_demands(settings, frozen); !added) return tl::unexpected(added.error());
  problem->assemble();
  problem->waive(settings.demands.waived);
  problem->find_inert_rows();
  // A patch takes its demands from a whole that was checked, and what it holds is not where a builder has it.
  if (settings.outside.empty())
    if (auto possible = check_contradictions(*problem); !possible) return tl::unexpected(possible.error());
  return std::shared_ptr<const Problem>(std::move(problem));
}

Result<void> Problem::add_energies(const ProblemSettings& settings, const FrozenGeometry& frozen) {
  double largest = 0.0;
  for (const auto& [name, weight] : settings.weights) {
    if (auto known = find_energy(name); !known) return tl::unexpected(known.error());
    if (!std::isfinite(weight) || weight < 0.0)
      return fail(ErrorCode::Usage, "the weight of '" + name + "' is not a finite number of at least 0",
                  "weights", "Give 0 to switch an energy off");
    largest = std::max(largest, weight);
  }
  if (largest > 0.0) largest_weight_ = largest;

  FootPoints feet;
  EnergyContext context{normalised_, layout_, nullptr};
  if (const auto closeness = settings.weights.find("closeness");
      closeness != settings.weights.end() && closeness->second > 0.0) {
    auto found =
        foot_points(*complex_, frozen.at ? frozen.at->x : complex_->preferred, frozen.reference.get());
    if (!found) return tl::unexpected(found.error());
    feet = std::move(*found);
    feet.foot = (feet.foot.rowwise() - centre_.transpose()) / scale_;
    context.feet = &feet;
  }
  for (const EnergyInfo& info : energy_catalogue()) {
    const auto weight = settings.weights.find(info.name);
    if (weight == settings.weights.end() || weight->second == 0.0) continue;
    auto energy = info.make(context);
    double factor = energy->terms() > 0 ? weight->second * layout_.points / energy->terms() : 0.0;
    if (const auto whole = settings.factors.find(info.name); whole != settings.factors.end())
      factor = whole->second;
    energies_.push_back({std::move(energy), weight->second, factor});
  }
  return {};
}

Result<void> Problem::add_demands(const ProblemSettings& settings, const FrozenGeometry& frozen) {
  const Demands& demands = settings.demands;
  if (!std::isfinite(demands.margin) || demands.margin < 0.0)
    return fail(ErrorCode::Usage, "the margin of the demands is not a finite number of at least 0", "margin",
                "Give mean edges, 1e-4 for example");
  std::optional<State> at;
  if (frozen.at) at = normalised_state(*frozen.at);
  std::optional<NeighbourLayer> neighbour;
  if (frozen.neighbour) {
    // Both layers in this one's frame; they share the mesh, so their origins are close.
    const NeighbourLayer& other = *frozen.neighbour;
    State state = other.state;
    state.x.rowwise() += (other.complex->origin - complex_->origin).transpose();
    neighbour = NeighbourLayer{other.complex, normalised_state(state)};
  }

  for (const Demand& demand : demands.list) {
    if (!demand.on) continue;
    const auto info = find_demand(demand.name);
    if (!info) return tl::unexpected(info.error());
    if (!(*info)->fits(complex_->kind)) {
      const bool dual = complex_->kind == ComplexKind::Dual;
      return fail(ErrorCode::Usage,
                  "the demand '" + demand.name + "' means nothing " +
                      (dual                                       ? "for a dual"
                       : complex_->kind == ComplexKind::Planarize ? "when planarizing"
                                                                  : "for panels of clusters"),
                  "demands", dual ? "Planarize a polygon mesh instead" : "Make a dual instead");
    }
    const Selection* selection = nullptr;
    if (!demand.selection.empty()) {
      const auto found = std::find_if(settings.selections.begin(), settings.selections.end(),
                                      [&](const Selection& s) { return s.name == demand.selection; });
      if (found == settings.selections.end()) {
        std::string known;
        for (const Selection& s : settings.selections) known += (known.empty() ? "" : ", ") + s.name;
        return fail(
            ErrorCode::Usage,
            "there is no selection '" + demand.selection + "' for the demand '" + demand.name + "'",
            "demands",
            (known.empty() ? "There are none" : "Known: " + known) + "; leave it out for the whole model");
      }
      selection = &*found;
    }
    const auto values = normalised_values(**info, demand, complex_->origin + centre_, scale_);
    if (!values) return tl::unexpected(values.error());
    const SelectedElements where = selected_elements(normalised_, selection);
    DemandContext context{normalised_,
                          layout_,
                          where,
                          *values,
                          demands.margin,
                          settings.side,
                          at ? &*at : nullptr,
                          neighbour ? &*neighbour : nullptr};
    auto constraints = (*info)->make(context);
    if (!constraints) return tl::unexpected(constraints.error());
    for (auto& constraint : *constraints) {
      has_demands_ = has_demands_ || constraint->rows() > 0;
      add_constraint(std::move(constraint));
    }
  }

  const PinFrame frame{complex_->origin + centre_, scale_};
  for (auto make : {make_pin_constraint, make_plane_pin_constraint}) {
    auto pins = make(normalised_, layout_, demands, frame);
    if (!pins) return tl::unexpected(pins.error());
    has_demands_ = has_demands_ || (*pins)->rows() > 0;
    if ((*pins)->rows() > 0) add_constraint(std::move(*pins));
  }
  if (!frozen.separations.empty()) {
    has_demands_ = true;
    add_constraint(make_separation_constraint(layout_, frozen.separations, centre_, scale_));
  }
  return {};
}

void Problem::add_constraint(std::unique_ptr<Constraint> constraint) {
  const int first = rows_;
  rows_ += constraint->rows();
  constraints_.push_back({std::move(constraint), first});
}

void Problem::assemble() {
  const auto size_of = [this](const RowFamily& family, int row) {
    longest_stencil_ = std::max(longest_stencil_, static_cast<int>(family.stencil(row).size()));
    most_curvature_ = std::max(most_curvature_, static_cast<int>(family.curvature(row).size()));
  };
  for (const EnergyTerm& term : energies_)
    for (int row = 0; row < term.energy->rows(); ++row) {
      size_of(*term.energy, row);
      for (int variable : term.energy->stencil(row)) {
        residual_pattern_.rows.push_back(residuals_);
        residual_pattern_.columns.push_back(variable);
      }
      ++residuals_;
    }
  for (const ConstraintTerm& term : constraints_)
    for (int row = 0; row < term.constraint->rows(); ++row) {
      size_of(*term.constraint, row);
      bounds_.push_back(term.constraint->bounds(row));
      for (int variable : term.constraint->stencil(row)) {
        jacobian_.rows.push_back(term.first_row + row);
        jacobian_.columns.push_back(variable);
      }
    }
}

const Problem::Hessian& Problem::hessian() const {
  std::call_once(hessian_made_, [this] { hessian_ = assemble_hessian(); });
  return hessian_;
}

Problem::Hessian Problem::assemble_hessian() const {
  Hessian out;
  PatternBuilder builder;
  int added = 0;
  for (const EnergyTerm& term : energies_) {
    TermSlots& slots = out.energies.emplace_back();
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      slots.first.push_back(added);
      for (size_t a = 0; a < stencil.size(); ++a)
        for (size_t b = 0; b <= a; ++b, ++added) builder.add(stencil[a], stencil[b]);
    }
    slots.first.push_back(added);
  }
  for (const ConstraintTerm& term : constraints_) {
    TermSlots& slots = out.constraints.emplace_back();
    for (int row = 0; row < term.constraint->rows(); ++row) {
      const auto stencil = term.constraint->stencil(row);
      slots.first.push_back(added);
      for (const StencilPair& pair : term.constraint->curvature(row)) {
        builder.add(stencil[pair.first], stencil[pair.second]);
        ++added;
      }
    }
    slots.first.push_back(added);
  }
  // The whole diagonal, so that a solver can damp any unknown.
  for (int v = 0; v < variables(); ++v) builder.add(v, v);

  std::vector<int> slot_of;
  out.pattern = builder.build(slot_of);
  out.diagonal.assign(slot_of.end() - variables(), slot_of.end());
  const auto hand_out = [&slot_of](TermSlots& term) {
    const int first = term.first.front();
    term.slots.assign(slot_of.begin() + first, slot_of.begin() + term.first.back());
    for (int& slot : term.first) slot -= first;
  };
  std::for_each(out.energies.begin(), out.energies.end(), hand_out);
  std::for_each(out.constraints.begin(), out.constraints.end(), hand_out);
  return out;
}

void Problem::waive(const std::vector<Waiver>& waivers) {
  given_up_.assign(static_cast<size_t>(rows_), 0);
  if (waivers.empty()) return;
  const std::set<Waiver> given_up(waivers.begin(), waivers.end());
  for (const ConstraintTerm& term : constraints_)
    for (int row = 0; row < term.constraint->rows(); ++row)
      if (given_up.contains({std::string(term.constraint->name()), term.constraint->element(row)})) {
        bounds_[term.first_row + row] = {-kUnbounded, kUnbounded};
        given_up_[static_cast<size_t>(term.first_row + row)] = 1;
      }
}

const Constraint& Problem::family(int row, int& row_in_family) const {
  auto term = std::upper_bound(constraints_.begin(), constraints_.end(), row,
                               [](int r, const ConstraintTerm& t) { return r < t.first_row; });
  --term;  // constraints without rows share their first row with the next one, which upper_bound passes
  row_in_family = row - term->first_row;
  return *term->constraint;
}

std::string_view Problem::row_name(int row) const {
  int local;
  return family(row, local).name();
}
std::string_view Problem::row_unit(int row) const {
  int local;
  return family(row, local).unit();
}
ElementRef Problem::row_element(int row) const {
  int local;
  const Constraint& constraint = family(row, local);
  return constraint.element(local);
}

bool Problem::row_is_linear(int row) const {
  int local;
  const Constraint& constraint = family(row, local);
  return constraint.curvature(local).empty();
}

std::vector<char> Problem::waived_at(const double* z) const {
  std::vector<char> waived(static_cast<size_t>(rows_), 0);
  for (const ConstraintTerm& term : constraints_)
    term.constraint->waive_alternatives(
        z, std::span(waived).subspan(static_cast<size_t>(term.first_row),
                                     static_cast<size_t>(term.constraint->rows())));
  return waived;
}

void Problem::residual_values(const double* z, double* out) const {
  std::vector<double> local(longest_stencil_);
  for (const EnergyTerm& term : energies_) {
    const double root = std::sqrt(term.factor);
    for (int row = 0; row < term.energy->rows(); ++row) {
      gather(z, term.energy->stencil(row), local);
      *out++ = root * term.energy->evaluate(row, local.data(), nullptr, nullptr);
    }
  }
}

void Problem::residual_jacobian(const double* z, double* out) const {
  std::vector<double> local(longest_stencil_);
  for (const EnergyTerm& term : energies_) {
    const double root = std::sqrt(term.factor);
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      gather(z, stencil, local);
      term.energy->evaluate(row, local.data(), out, nullptr);
      for (size_t k = 0; k < stencil.size(); ++k) *out++ *= root;
    }
  }
}

State Problem::normalised_state(const State& state) const {
  return {(state.x.rowwise() - centre_.transpose()) / scale_, state.n, state.h / scale_};
}

void Problem::find_inert_rows() {
  if (layout_.outside.empty()) return;
  inert_.assign(static_cast<size_t>(rows_), 1);
  for (int slot = 0; slot < jacobian_.size(); ++slot)
    if (layout_.is_free(jacobian_.columns[static_cast<size_t>(slot)]))
      inert_[static_cast<size_t>(jacobian_.rows[static_cast<size_t>(slot)])] = 0;
}

std::map<std::string, double> Problem::energy_factors() const {
  std::map<std::string, double> factors;
  for (const EnergyTerm& term : energies_) factors[std::string(term.energy->name())] = term.factor;
  return factors;
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

void Problem::hessian_values(const double* z, double factor, const double* multipliers, double* out,
                             Curvature curvature) const {
  const bool exact = curvature == Curvature::Exact;
  const Hessian& places = hessian();
  std::fill(out, out + places.pattern.size(), 0.0);
  std::vector<double> local(longest_stencil_), slope(longest_stencil_), bend(most_curvature_);
  for (size_t t = 0; t < energies_.size(); ++t) {
    const EnergyTerm& term = energies_[t];
    const TermSlots& slots = places.energies[t];
    const double twice = 2.0 * factor * term.factor;
    for (int row = 0; row < term.energy->rows(); ++row) {
      const auto stencil = term.energy->stencil(row);
      const auto pairs = exact ? term.energy->curvature(row) : std::span<const StencilPair>{};
      gather(z, stencil, local);
      const double r =
          term.energy->evaluate(row, local.data(), slope.data(), pairs.empty() ? nullptr : bend.data());
      // (r^2)'' = 2 (grad r grad r^T + r r''); the stencil's triangle is stored row by row.
      const int* slot = slots.slots.data() + slots.first[row];
      for (size_t a = 0, k = 0; a < stencil.size(); ++a)
        for (size_t b = 0; b <= a; ++b, ++k) out[slot[k]] += twice * slope[a] * slope[b];
      for (size_t k = 0; k < pairs.size(); ++k) {
        const int position = pairs[k].first * (pairs[k].first + 1) / 2 + pairs[k].second;
        out[slot[position]] += twice * r * bend[k];
      }
    }
  }
  if (!exact) return;
  for (size_t t = 0; t < constraints_.size(); ++t) {
    const ConstraintTerm& term = constraints_[t];
    const TermSlots& slots = places.constraints[t];
    for (int row = 0; row < term.constraint->rows(); ++row) {
      const auto pairs = term.constraint->curvature(row);
      if (pairs.empty()) continue;
      gather(z, term.constraint->stencil(row), local);
      term.constraint->evaluate(row, local.data(), nullptr, bend.data());
      const int* slot = slots.slots.data() + slots.first[row];
      for (size_t k = 0; k < pairs.size(); ++k) out[slot[k]] += multipliers[term.first_row + row] * bend[k];
    }
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
  const std::vector<char> waived = waived_at(z);
  std::vector<ConstraintViolation> result;
  for (const ConstraintTerm& term : constraints_) {
    const std::string_view name = term.constraint->name();
    auto entry = std::find_if(result.begin(), result.end(), [&](const auto& e) { return e.name == name; });
    if (entry == result.end()) {
      entry = result.insert(result.end(), ConstraintViolation{});
      entry->name = name;
      entry->unit = term.constraint->unit();
    }
    entry->rows += term.constraint->rows();
    for (int row = 0; row < term.constraint->rows(); ++row) {
      const int r = term.first_row + row;
      entry->waived += given_up_[static_cast<size_t>(r)];
      if (waived[r]) continue;
      const double v = violation(values[r], bounds_[r]);
      if (v > entry->max_violation) {
        entry->max_violation = v;
        entry->worst = term.constraint->element(row);
      }
      if (v > tolerance) ++entry->violated;
    }
  }
  return result;
}

std::vector<Problem::RowViolation> Problem::violated_rows(const double* z, double tolerance) const {
  Vector values(rows_);
  constraint_values(z, values.data());
  const std::vector<char> waived = waived_at(z);
  std::vector<RowViolation> result;
  for (int row = 0; row < rows_; ++row)
    if (const double v = violation(values[row], bounds_[row]); v > tolerance && !waived[row])
      result.push_back({row, v});
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
    if (layout_.is_free(v)) {
      if (std::isnan(slope[v])) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::abs(slope[v]));
    }
  return largest;
}

}  // namespace planewright
