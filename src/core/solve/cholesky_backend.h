// CholeskyBackend: what SparseCholesky (sparse_cholesky.h) hands its matrix to. Indices 0-based, lower
// triangle, repeated entries added up; threads as there. Internal to solve/.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

class CholeskyBackend {
 public:
  virtual ~CholeskyBackend() = default;
  virtual bool factorise() = 0;           // `values`; false: error, out_of_memory and negative_pivots say why
  virtual void solve(Vector& right) = 0;  // NaN where it fails

  std::vector<double> values;  // one per entry of the pattern
  std::string error;
  bool out_of_memory = false;
  int negative_pivots = 0;  // of the last factorise()
};

std::unique_ptr<CholeskyBackend> make_mumps_cholesky(int size, std::vector<int> rows,
                                                     std::vector<int> columns, int block);
std::unique_ptr<CholeskyBackend> make_eigen_cholesky(int size, const std::vector<int>& rows,
                                                     const std::vector<int>& columns);

}  // namespace planewright
