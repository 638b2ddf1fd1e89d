// Problem: a complex + energies + constraints, assembled as the sparse nonlinear program that every solver
// sees:
//
//   minimise  f(z) = sum_k w_k (X / N_k) sum_r r_kr(z)^2     subject to   low <= c(z) <= high,
//
// z as in layout.h, in normalised units: centroid of the wanted points at 0, mean panel edge 1, so that
// neither the place nor the scale of a model changes anything but the units of the answer. Weight 1 means the
// same everywhere.
//
// Patterns are fixed at construction; values are filled in place in the same order at every call. Hessian:
// lower triangle of  factor * f'' + sum_r multiplier_r c_r'', one slot per entry. Fixed unknowns (Freedom)
// keep their place. Immutable and shared: safe to read from any thread. Indices 0-based.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/complex/state.h"
#include "core/problem/constraint.h"
#include "core/problem/energy.h"
#include "core/problem/layout.h"

namespace planewright {

struct ProblemSettings {
  Freedom freedom = Freedom::NormalsAndOffsets;
  std::map<std::string, double> weights = {{"position", 1.0}};  // by energy name; a missing one is 0
};

// Row and column of each value slot.
struct SparsePattern {
  std::vector<int> rows, columns;
  int size() const { return static_cast<int>(rows.size()); }
};

class Problem {
 public:
  // Fails with ErrorCode::Usage: unknown energy, weight that is negative or not finite; ErrorCode::Refused:
  // stage fixed where planes have no common point.
  static Result<std::shared_ptr<const Problem>> create(std::shared_ptr<const TangentComplex> complex,
                                                       const ProblemSettings& settings);

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

  const SparsePattern& jacobian_pattern() const { return jacobian_; }
  void jacobian_values(const double* z, double* out) const;  // #jacobian slots
  const SparsePattern& hessian_pattern() const { return hessian_; }
  void hessian_values(const double* z, double factor, const double* multipliers,
                      double* out) const;  // #slots

  // The slot of each unknown's own diagonal entry (#z); every one is in the pattern.
  const std::vector<int>& hessian_diagonal() const { return diagonal_slots_; }

  double largest_weight() const { return largest_weight_; }  // 1 if every weight is 0

  // What each energy with a weight contributes to f at z, in catalogue order.
  struct EnergyShare {
    std::string name;
    double weight, value;
  };
  std::vector<EnergyShare> energy_shares(const double* z) const;
  struct ConstraintViolation {
    std::string name, unit;
    double max_violation;
    int violated;
  };
  std::vector<ConstraintViolation> violations(const double* z, double tolerance) const;

  // Largest |d(f + multipliers . c)/dz| over the free unknowns: 0 at a first-order stationary point.
  double first_order_residual(const double* z, const double* multipliers) const;

 private:
  Problem() = default;
  void assemble();

  struct EnergyTerm {
    std::unique_ptr<Energy> energy;
    double weight, factor;           // factor = w X / N
    std::vector<int> hessian_slots;  // per row: lower triangle of its stencil, row by row
    std::vector<int> first_slot;     // #rows + 1
  };
  struct ConstraintTerm {
    std::unique_ptr<Constraint> constraint;
    int first_row;
    std::vector<int> hessian_slots;  // per row: its curvature pairs
    std::vector<int> first_slot;
  };

  double contribution(const EnergyTerm& term, const double* z) const;  // factor * sum of squares

  std::shared_ptr<const TangentComplex> complex_;
  TangentComplex normalised_;
  Vector3d centre_ = Vector3d::Zero();  // in the complex's local coordinates
  double scale_ = 1.0;                  // model units per edge
  Layout layout_;
  std::vector<EnergyTerm> energies_;
  std::vector<ConstraintTerm> constraints_;
  std::vector<Bounds> bounds_;
  SparsePattern jacobian_, hessian_;
  std::vector<int> diagonal_slots_;
  int rows_ = 0;
  double largest_weight_ = 1.0;
  int longest_stencil_ = 0, most_curvature_ = 0;
};

}  // namespace planewright
