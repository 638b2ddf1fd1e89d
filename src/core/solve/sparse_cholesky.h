// SparseCholesky: a symmetric positive definite sparse system solved by MUMPS (SYM = 1), analysed once per
// pattern.
//
// MUMPS was the fastest of what Debian offers whose licence goes with Ipopt's (measured: 0.11 s a
// factorisation at 10,000 panels against 0.25 s for CHOLMOD supernodal, which is GPL, and 1-1.8 s for Eigen's
// simplicial one). Indices 0-based; lower triangle. Threads: every call enters the MUMPS gate.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

class SparseCholesky {
 public:
  // rows[k] >= columns[k]; repeated entries are added up. block: the unknowns come in groups of so many that
  // always stand together, which makes the analysis that much cheaper; size is a multiple of it.
  SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns, int block = 1);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  // The matrix's values in the order of the pattern, to be filled in before factorise().
  std::span<double> values();
  // False if the matrix is singular or not definite, or memory runs out (error() says which). MUMPS with SYM
  // = 1 does not pivot: it counts negative pivots, but what it says of a nearly singular matrix is chance, so
  // test the step too.
  bool factorise();
  bool factorise(std::span<const double> values);
  // Overwrites right (#size) with the solution. Precondition: the last factorise() returned true.
  void solve(Vector& right) const;

  const std::string& error() const { return error_; }
  bool out_of_memory() const { return out_of_memory_; }
  int negative_pivots() const { return negative_pivots_; }  // of the last factorise()

 private:
  bool analyse();
  struct Impl;
  std::unique_ptr<Impl> impl_;
  std::string error_;
  int negative_pivots_ = 0;
  bool out_of_memory_ = false;
};

}  // namespace planewright
