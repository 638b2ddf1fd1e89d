// SparseCholesky: a symmetric positive definite sparse system solved by MUMPS (SYM = 1), analysed once per
// pattern.
//
// MUMPS was the fastest of what Debian offers whose licence goes with Ipopt's (measured: 0.11 s a
// factorisation at 10,000 panels against 0.25 s for CHOLMOD supernodal, which is GPL, and 1-1.8 s for Eigen's
// simplicial one). Indices 0-based; lower triangle. Threads: every call enters the MUMPS gate.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

class SparseCholesky {
 public:
  // rows[k] >= columns[k], values come in this order at every factorise(); repeated entries are added up.
  SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  // values: #entries. False if the matrix is singular or memory runs out (error() says which). MUMPS with SYM
  // = 1 does not pivot and does not detect an indefinite matrix reliably: test the step, not this.
  bool factorise(std::span<const double> values);
  // Overwrites right (#size) with the solution. Precondition: the last factorise() returned true.
  void solve(Vector& right);
  const char* error() const { return error_; }

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  const char* error_ = "";
};

}  // namespace planewright
