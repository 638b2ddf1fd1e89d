// TangentEquations: a problem's energies and rows linearised at a state, in the tangent space of that state,
// as one sparse positive definite system for a step.
//
// Unknowns of a step: 3 per point (its move) and 3 per plane (two turns of its normal, the change of its
// offset): 3X + 3P numbers, points first. Normals stay unit by construction, so the unit-normal rows are left
// out. Unknowns that the problem's Freedom fixes keep their place and get the step 0.
//
// The matrix is
//     H = 2 factor J^T J + curvature + sum_r weight_r g_r g_r^T + damping,
// J: Jacobian of the energies' residuals (Problem::residual_values); g_r: gradient of constraint row r;
// curvature: what the residuals' and rows' own second derivatives add (add_curvature). Points that no row
// couples are eliminated first, one 3 x 3 block each (tangent_pattern.h); MUMPS factorises the rest, or Eigen
// in a local problem, so that it never waits for the solver. With EnergyCoupling::Dropped the factors are
// those of H without the coupling of points by energies, and solve() is a conjugate gradient iteration on H
// itself that they precondition: cheaper, for steps that need not be exact, than factorising fairing's second
// neighbourhoods.
//
// The pattern depends on stencils alone, so one analysis serves every step and, handed on in a TangentCache,
// every later solve of a problem of the same topology. Units: normalised (layout.h). Threads: one at a time;
// factorisations of whole problems go through the MUMPS gate. Of equations that share a cache,
// factorise() of one may void the factors of the others.
#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/problem/problem.h"
#include "core/solve/sparse_cholesky.h"
#include "core/solve/tangent_pattern.h"

namespace planewright {

// What is worth keeping between solves: the pattern, and MUMPS' analysis of it.
struct TangentWorkspace {
  TangentWorkspace(const Problem& problem, EnergyCoupling coupling);
  TangentPattern pattern;
  SparseCholesky cholesky;
};

// The workspaces used last. Threads: one at a time.
class TangentCache {
 public:
  std::shared_ptr<TangentWorkspace> find_or_make(const Problem& problem, EnergyCoupling coupling);
  void clear() { kept_.clear(); }

 private:
  static constexpr size_t kMost = 3;
  std::vector<std::shared_ptr<TangentWorkspace>> kept_;  // the newest last
};

// How planes and points are damped: added to the diagonal of H.
struct Damping {
  double points = 0.0, planes = 0.0;
  std::span<const double> per_plane = {};  // #planes, times `planes`; empty: 1 for each
};

class TangentEquations {
 public:
  // cache may be null.
  explicit TangentEquations(const Problem& problem, EnergyCoupling coupling = EnergyCoupling::Exact,
                            TangentCache* cache = nullptr);

  // Takes values and slopes at z (#variables). energies: whether residuals() are wanted too.
  void linearise(const Vector& z, bool energies);
  const Vector& residuals() const { return residuals_; }      // e, #residuals
  const Vector& constraints() const { return constraints_; }  // row values, #rows; unit-normal rows included

  // weights, slopes: #rows. energy_factor scales the energies (0 leaves them out).
  void assemble(double energy_factor, std::span<const double> weights, std::span<const double> slopes);
  // Adds `share` of the second derivatives of the energies' residuals (times energy_factor) and of the rows
  // (times multipliers, #rows) at the last linearise(), without which H is Gauss-Newton's. With it H may be
  // indefinite: factorise() then fails. Precondition: EnergyCoupling::Exact, or no coupling was dropped.
  void add_curvature(const Vector& z, double energy_factor, const Vector& multipliers, double share);
  // Adds to the gradient of what was assembled (#unknowns): a further energy, whose Hessian goes with the
  // damping.
  void add_slope(const Vector& slope) { gradient_ += slope; }
  // The gradient 2 J^T e + sum slope g at the last assemble() (#unknowns).
  const Vector& gradient() const { return gradient_; }
  // The same with other slopes and, where not null, other residuals, at the point of the last linearise().
  Vector gradient_of(double energy_factor, const Vector* residuals, std::span<const double> slopes) const;

  // Factorises what was assembled plus damping. False: not positive definite, singular, or out of memory
  // (error()).
  bool factorise(const Damping& damping);
  // H^-1 right, with the last factors. right: #unknowns. Empty if the result is not finite.
  Vector solve(const Vector& right);
  // factorise() and solve(-gradient()); empty if either fails.
  Vector step(const Damping& damping);
  Vector step(double point_damping, double plane_damping) {
    return step(Damping{point_damping, plane_damping});
  }
  // Relative residual at which conjugate gradients end; without dropped couplings solve() is direct.
  void set_iterative_tolerance(double tolerance) { iterative_tolerance_ = tolerance; }
  // Ends conjugate gradients early, with what they have: a hundred of them cost a dozen factorisations.
  void set_stop(std::stop_token stop) { stop_ = std::move(stop); }
  const std::string& error() const { return workspace_->cholesky.error(); }
  bool out_of_memory() const { return workspace_->cholesky.out_of_memory(); }

  // What a step (#unknowns) changes to first order.
  Vector constraint_change(const Vector& step) const;  // #rows
  Vector residual_change(const Vector& step) const;    // #residuals

  // z moved along a step; normals are made unit.
  Vector moved(const Vector& z, const Vector& step) const;

  // Whether energies couple points and EnergyCoupling::Dropped left that out of the factors.
  bool drops_couplings() const { return pattern().incomplete(); }
  int unknowns() const { return 3 * pattern().nodes(); }
  const Eigen::Matrix<double, 3, 2>& tangents(int plane) const {
    return tangents_[static_cast<size_t>(plane)];
  }

 private:
  using RowSet = TangentPattern::RowSet;
  using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
  // Numbers that go with a RowSet.
  struct RowValues {
    std::vector<double> slopes;    // Jacobian values as the problem gives them, #pattern
    std::vector<double> gradient;  // 3 per entry of nodes
  };
  const TangentPattern& pattern() const { return workspace_->pattern; }
  Eigen::Map<Block> block(int index) {
    return Eigen::Map<Block>(blocks_.data() + 9 * static_cast<size_t>(index));
  }
  void reduce(const RowSet& set, RowValues& values) const;
  void add_row(const RowSet& set, const RowValues& values, int row, double weight);
  static void add_slope(const RowSet& set, const RowValues& values, int row, double slope, Vector& out);
  static double change(const RowSet& set, const RowValues& values, int row, const Vector& step);
  void map_hessian();
  bool eliminate(const Damping& damping);
  Vector direct_solve(const Vector& right);
  Vector conjugate_gradients(const Vector& right);
  Vector multiply(const Vector& v) const;  // H v
  double damping_of(int node) const;

  const Problem& problem_;
  std::shared_ptr<TangentWorkspace> workspace_;
  int points_, planes_;
  RowValues energy_values_, constraint_values_;
  std::vector<Eigen::Matrix<double, 3, 2>> tangents_;  // #P
  Vector residuals_, constraints_, gradient_;
  std::vector<double> blocks_;              // 9 per block, as TangentPattern orders them
  std::vector<double> lower_, eliminated_;  // 9 per eliminated point: L of its block; 9 per coupling: C L^-T
  // As assembled and factorised last.
  double energy_factor_ = 0.0;
  std::vector<double> weights_;
  Damping damping_;
  std::vector<double> plane_damping_;
  // Per Hessian slot of the problem: its nodes' block and the places of its row and column within (built when
  // curvature is first asked for).
  struct HessianSlot {
    int block;
    signed char row, column;  // of the nodes: 0..2; normals: axis; offset: 3
    bool transposed;
  };
  std::vector<HessianSlot> hessian_slots_;
  double iterative_tolerance_ = 1e-3;
  std::stop_token stop_;
};

}  // namespace planewright
