// Problem: a complex + energies + constraints, assembled as the sparse nonlinear program that every solver
// sees:
//
//   minimise  f(z) = sum_k w_k (X / N_k) sum_r r_kr(z)^2     subject to   low <= c(z) <= high,
//
// z as in layout.h, in normalised units: centroid of the wanted points at 0, mean panel edge 1, so that
// neither the place nor the scale of a model changes anything but the units of the answer. Weight 1 means the
// same everywhere.
//
// Patterns never change; values are filled in place in the same order at every call. The Hessian's is made
// when it is first asked for: solvers of Gauss-Newton steps never do, and it is most of a problem's memory.
// Hessian: lower triangle of  factor * f'' + sum_r multiplier_r c_r'', one slot per entry. Fixed unknowns
// (Freedom) keep their place. Immutable and shared: safe to read from any thread. Indices 0-based.
//
// Besides incidence and unit normals the rows come from the designer's demands (demands/demand_catalogue.h,
// pins, separations). A waived row keeps its place and loses its bounds.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/complex/state.h"
#include "core/problem/constraint.h"
#include "core/problem/demand.h"
#include "core/problem/energy.h"
#include "core/problem/frozen_geometry.h"
#include "core/problem/layout.h"

namespace planewright {

struct ProblemSettings {
  Freedom freedom = Freedom::NormalsAndOffsets;
  std::map<std::string, double> weights = {{"position", 1.0}};  // by energy name; a missing one is 0
  Demands demands = {};
  std::vector<Selection> selections = {};  // that the demands name
  double side = 1.0;                       // +1: the layer lies outside the mesh, -1: inside
  // A local problem on a patch of a larger complex (core/advise): Layout::outside, and what each energy's sum
  // is multiplied with there, so that it weighs what it does in the whole (Problem::energy_factors). Empty:
  // neither.
  std::vector<char> outside = {};
  std::map<std::string, double> factors = {};
};

// Row and column of each value slot.
struct SparsePattern {
  std::vector<int> rows, columns;
  int size() const { return static_cast<int>(rows.size()); }
};

// Which second derivatives a Hessian contains.
enum class Curvature {
  Exact,
  GaussNewton,  // of the energies alone, without the curvature of their residuals: positive semidefinite
};

class Problem {
 public:
  // Fails with ErrorCode::Usage: unknown energy, demand or selection, weight that is negative or not finite;
  // ErrorCode::Refused: stage fixed where planes have no common point; ErrorCode::Infeasible: demands that
  // contradict each other whatever the panels do (contradictions.h), both named.
  static Result<std::shared_ptr<const Problem>> create(std::shared_ptr<const TangentComplex> complex,
                                                       const ProblemSettings& settings,
                                                       const FrozenGeometry& frozen = {});

  const TangentComplex& complex() const { return *complex_; }       // model units
  const TangentComplex& normalised() const { return normalised_; }  // edges
  const Layout& layout() const { return layout_; }
  int variables() const { return layout_.size(); }
  int rows() const { return rows_; }

  // Between a state in model units and z. from_state: #z.
  Vector from_state(const State& state) const;
  State to_state(std::span<const double> z) const;

  double objective(const double* z) const;
  void gradient(const double* z, double* out) const;           // #z, overwritten
  void constraint_values(const double* z, double* out) const;  // #rows
  Bounds bounds(int row) const { return bounds_[row]; }
  // Rows that need not hold at z, because another row of the same alternative does (#rows, 1 = need not).
  std::vector<char> waived_at(const double* z) const;
  std::string_view row_name(int row) const;  // the demand's, "incidence" or "unit normal"
  std::string_view row_unit(int row) const;
  ElementRef row_element(int row) const;
  bool row_is_linear(int row) const;
  // The rows that keep points on their planes: [0, n).
  int planarity_rows() const { return planarity_rows_; }
  // The rows that keep the normals unit: [first, last); solvers that turn normals need none of them.
  std::pair<int, int> unit_normal_rows() const { return unit_normal_rows_; }
  // Whether there are rows besides incidence and unit normals.
  bool has_demands() const { return has_demands_; }

  // The energies as one sum of squares f = sum_r residual_r^2, weights included (#residuals; Jacobian slots
  // row by row).
  int residuals() const { return residuals_; }
  const SparsePattern& residual_pattern() const { return residual_pattern_; }
  void residual_values(const double* z, double* out) const;
  void residual_jacobian(const double* z, double* out) const;

  const SparsePattern& jacobian_pattern() const { return jacobian_; }
  void jacobian_values(const double* z, double* out) const;  // #jacobian slots
  const SparsePattern& hessian_pattern() const { return hessian().pattern; }
  // out: #slots. multipliers: #rows, not read for Curvature::GaussNewton.
  void hessian_values(const double* z, double factor, const double* multipliers, double* out,
                      Curvature curvature = Curvature::Exact) const;

  // The slot of each unknown's own diagonal entry (#z); every one is in the pattern.
  const std::vector<int>& hessian_diagonal() const { return hessian().diagonal; }

  // w X / N of each energy with a weight, by name.
  std::map<std::string, double> energy_factors() const;
  // Rows that no free unknown enters (#rows), which only a local problem has; empty: none.
  const std::vector<char>& inert_rows() const { return inert_; }

  double largest_weight() const { return largest_weight_; }  // 1 if every weight is 0

  // What each energy with a weight contributes to f at z, in catalogue order.
  struct EnergyShare {
    std::string name;
    double weight, value;
  };
  std::vector<EnergyShare> energy_shares(const double* z) const;
  // Per demand, in the order of the rows; demands of the same name are one entry. Alternatives count as
  // waived_at(z) says. A row that is not a number at z is violated by infinity.
  struct ConstraintViolation {
    std::string name, unit;
    double max_violation = 0.0;
    int violated = 0;  // rows beyond the tolerance
    int rows = 0;
    int waived = 0;    // of these, rows that were given up
    ElementRef worst;  // where max_violation is; meaningless if that is 0
  };
  std::vector<ConstraintViolation> violations(const double* z, double tolerance) const;
  struct RowViolation {
    int row;
    double amount;
  };
  std::vector<RowViolation> violated_rows(const double* z, double tolerance) const;  // ascending

  // Largest |d(f + multipliers . c)/dz| over the free unknowns: 0 at a first-order stationary point, infinite
  // where a slope is not a number.
  double first_order_residual(const double* z, const double* multipliers) const;

 private:
  Problem() = default;
  Result<void> add_energies(const ProblemSettings& settings, const FrozenGeometry& frozen);
  Result<void> add_demands(const ProblemSettings& settings, const FrozenGeometry& frozen);
  void add_constraint(std::unique_ptr<Constraint> constraint);
  void assemble();
  void waive(const std::vector<Waiver>& waivers);
  void find_inert_rows();
  const Constraint& family(int row, int& row_in_family) const;

  struct EnergyTerm {
    std::unique_ptr<Energy> energy;
    double weight, factor;  // factor = w X / N
  };
  struct ConstraintTerm {
    std::unique_ptr<Constraint> constraint;
    int first_row;
  };
  // Where the values of each row of a term go.
  struct TermSlots {
    std::vector<int>
        slots;  // per row: lower triangle of its stencil, row by row (energies), or curvature pairs
    std::vector<int> first;  // #rows + 1
  };
  struct Hessian {
    SparsePattern pattern;
    std::vector<int> diagonal;
    std::vector<TermSlots> energies, constraints;
  };
  const Hessian& hessian() const;
  Hessian assemble_hessian() const;

  State normalised_state(const State& state) const;
  double contribution(const EnergyTerm& term, const double* z) const;  // factor * sum of squares

  std::shared_ptr<const TangentComplex> complex_;
  TangentComplex normalised_;
  Vector3d centre_ = Vector3d::Zero();  // in the complex's local coordinates
  double scale_ = 1.0;                  // model units per edge
  Layout layout_;
  std::vector<EnergyTerm> energies_;
  std::vector<ConstraintTerm> constraints_;
  std::vector<Bounds> bounds_;
  std::vector<char> given_up_;  // #rows
  std::vector<char> inert_;     // #rows, or empty
  SparsePattern jacobian_, residual_pattern_;
  mutable std::once_flag hessian_made_;
  mutable Hessian hessian_;
  std::pair<int, int> unit_normal_rows_{0, 0};
  bool has_demands_ = false, has_alternatives_ = false;
  int residuals_ = 0;
  int rows_ = 0, planarity_rows_ = 0;
  double largest_weight_ = 1.0;
  int longest_stencil_ = 0, most_curvature_ = 0;
};

}  // namespace planewright
