// SparseCholesky: a symmetric positive definite sparse system, analysed once per pattern; factorised by MUMPS
// (SYM = 1), or, for small systems that must not wait for MUMPS' one thread, by Eigen.
//
// MUMPS was the fastest of what Debian offers whose licence goes with Ipopt's (measured at 10,000 panels:
// 0.07 s a factorisation against 0.6 s for Eigen's simplicial one; CHOLMOD, 0.25 s, is GPL). Indices 0-based;
// lower triangle. Threads: with MUMPS every call enters its gate; with Eigen one object is used by one thread
// at a time, different ones by several.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

class CholeskyBackend;

class SparseCholesky {
 public:
  enum class Backend { Mumps, Eigen };
  // rows[k] >= columns[k]; repeated entries are added up. block: the unknowns come in groups of so many that
  // always stand together, which makes the analysis that much cheaper; size is a multiple of it.
  SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns, int block = 1,
                 Backend backend = Backend::Mumps);
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
  // Overwrites right (#size) with the solution; with NaN where even that fails (error(), out_of_memory()).
  // Precondition: the last factorise() returned true.
  void solve(Vector& right) const;

  const std::string& error() const;
  bool out_of_memory() const;
  int negative_pivots() const;  // of the last factorise(); Eigen stops at the first

 private:
  std::unique_ptr<CholeskyBackend> backend_;
};

}  // namespace planewright
