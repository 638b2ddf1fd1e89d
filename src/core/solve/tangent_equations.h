// TangentEquations: a problem's energies and rows linearised at a state, in the tangent space of that state,
// as one sparse positive definite system for a step.
//
// Unknowns of a step: 3 per point (its move) and 3 per plane (two turns of its normal, the change of its
// offset): 3X + 3P numbers, points first. Normals stay unit by construction, so the unit-normal rows are left
// out. Unknowns that the problem's Freedom fixes keep their place and get the step 0.
//
// The system of a step d is
//     ( 2 J^T J + sum_r weight_r g_r g_r^T + damping ) d = - ( 2 J^T e + sum_r slope_r g_r ),
// e and J: the energies' residuals (Problem::residual_values) and their Jacobian; g_r: gradient of constraint
// row r. The pattern is fixed at construction, whatever weights are 0, so that one analysis serves every
// step. Units: normalised (layout.h). Threads: one at a time; factorisations go through the MUMPS gate.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/problem/problem.h"
#include "core/solve/sparse_cholesky.h"

namespace planewright {

class TangentEquations {
 public:
  explicit TangentEquations(const Problem& problem);

  // Takes values and slopes at z (#variables). energies: whether residuals() are wanted too.
  void linearise(const Vector& z, bool energies);
  const Vector& residuals() const { return residuals_; }      // e, #residuals
  const Vector& constraints() const { return constraints_; }  // row values, #rows; unit-normal rows included

  // weights, slopes: #rows. energy_factor scales the energies (0 leaves them out).
  void assemble(double energy_factor, std::span<const double> weights, std::span<const double> slopes);
  // Adds to the gradient of what was assembled (#unknowns): a further energy, whose Hessian goes with the
  // damping.
  void add_slope(const Vector& slope) { gradient_ += slope; }
  // Adds damping to the diagonal of what was assembled, factorises and solves. Empty if the factorisation
  // failed.
  Vector step(double point_damping, double plane_damping);

  // What a step (#unknowns) changes to first order.
  Vector constraint_change(const Vector& step) const;  // #rows
  Vector residual_change(const Vector& step) const;    // #residuals
  // The gradient 2 J^T e + sum slope g at the last assemble() (#unknowns).
  const Vector& gradient() const { return gradient_; }

  // z moved along a step; normals are made unit.
  Vector moved(const Vector& z, const Vector& step) const;

  int unknowns() const { return 3 * nodes_; }

 private:
  // The rows of one kind (residuals or constraints): which nodes (points, then planes) each touches, and its
  // gradient there, three numbers a node.
  struct RowSet {
    const SparsePattern* pattern = nullptr;
    int rows = 0;
    std::vector<int> first_slot;     // #rows + 1, into the pattern
    Polygons nodes;                  // #rows lists of nodes, ascending
    std::vector<int> place;          // per pattern slot: index of its node within all lists
    std::vector<size_t> first_pair;  // #rows + 1, into pair_block
    std::vector<int> pair_block;     // per pair of nodes (later, earlier or same) of a row: its block
    std::vector<double> slopes;      // Jacobian values as the problem gives them, #pattern
    std::vector<double> gradient;    // 3 per entry of nodes
  };
  void prepare(RowSet& set, const SparsePattern& pattern, int rows);
  void analyse();
  void reduce(RowSet& set) const;
  void add_row(const RowSet& set, int row, double weight);
  void add_slope(const RowSet& set, int row, double slope);
  static double change(const RowSet& set, int row, const Vector& step);
  int node_of(int variable) const;

  const Problem& problem_;
  int points_, planes_, nodes_;
  RowSet energy_rows_, constraint_rows_;
  std::vector<Eigen::Matrix<double, 3, 2>> tangents_;  // #P
  Vector residuals_, constraints_, gradient_;
  std::vector<Matrix3d> blocks_;
  std::vector<int> diagonal_block_;  // #nodes
  std::vector<double> values_;       // 9 per block
  std::unique_ptr<SparseCholesky> solver_;
};

}  // namespace planewright
