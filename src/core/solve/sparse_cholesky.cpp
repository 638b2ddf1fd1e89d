#include "core/solve/sparse_cholesky.h"

#include <algorithm>

#include "core/solve/cholesky_backend.h"

namespace planewright {

SparseCholesky::SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns, int block,
                               Backend backend)
    : backend_(backend == Backend::Mumps
                   ? make_mumps_cholesky(size, std::move(rows), std::move(columns), block)
                   : make_eigen_cholesky(size, rows, columns)) {}

SparseCholesky::~SparseCholesky() = default;

std::span<double> SparseCholesky::values() {
  return backend_->values;
}

bool SparseCholesky::factorise() {
  return backend_->factorise();
}

bool SparseCholesky::factorise(std::span<const double> values) {
  std::copy(values.begin(), values.end(), backend_->values.begin());
  return factorise();
}

void SparseCholesky::solve(Vector& right) const {
  backend_->solve(right);
}

const std::string& SparseCholesky::error() const {
  return backend_->error;
}
bool SparseCholesky::out_of_memory() const {
  return backend_->out_of_memory;
}
int SparseCholesky::negative_pivots() const {
  return backend_->negative_pivots;
}

}  // namespace planewright
