#include "core/solve/sparse_cholesky.h"

#include <dmumps_c.h>

#include <algorithm>

#include "core/solve/mumps_gate.h"

namespace planewright {
namespace {

constexpr int kUseCommWorld = -987654;  // the sequential library's only communicator
enum Job { kEnd = -2, kInit = -1, kAnalyse = 1, kFactorise = 2, kSolve = 3 };
// Numbers of MUMPS' controls and results, as its manual counts them.
constexpr int kOrdering = 7, kMoreWorkspace = 14, kBlockFormat = 15;  // ICNTL
constexpr int kScotch = 3;
constexpr int kNegativePivots = 12;  // INFOG
constexpr int kSingular = -10, kWorkspaceTooSmallInteger = -8, kWorkspaceTooSmallReal = -9;
constexpr int kOutOfMemory = -13, kOutOfIntegerMemory = -7;

}  // namespace

struct SparseCholesky::Impl {
  DMUMPS_STRUC_C mumps{};
  std::vector<int> rows, columns;
  std::vector<double> values;
  bool analysed = false;

  int& icntl(int k) { return mumps.icntl[k - 1]; }
  int infog(int k) const { return mumps.infog[k - 1]; }
  int run(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
    return mumps.infog[0];
  }
};

SparseCholesky::SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns, int block)
    : impl_(std::make_unique<Impl>()) {
  for (int& r : rows) ++r;  // Fortran counts from 1
  for (int& c : columns) ++c;
  impl_->rows = std::move(rows);
  impl_->columns = std::move(columns);
  impl_->values.resize(impl_->rows.size());

  const auto gate = enter_mumps_gate();
  impl_->mumps.par = 1;
  impl_->mumps.sym = 1;
  impl_->mumps.comm_fortran = kUseCommWorld;
  impl_->run(kInit);
  for (int stream : {1, 2, 3, 4}) impl_->icntl(stream) = 0;  // silent
  impl_->icntl(kOrdering) = kScotch;
  if (block > 1) impl_->icntl(kBlockFormat) = -block;
  impl_->mumps.n = size;
  impl_->mumps.nnz = static_cast<MUMPS_INT8>(impl_->rows.size());
  impl_->mumps.irn = impl_->rows.data();
  impl_->mumps.jcn = impl_->columns.data();
  impl_->mumps.a = impl_->values.data();
}

SparseCholesky::~SparseCholesky() {
  const auto gate = enter_mumps_gate();
  impl_->run(kEnd);
}

std::span<double> SparseCholesky::values() {
  return impl_->values;
}

bool SparseCholesky::factorise(std::span<const double> values) {
  std::copy(values.begin(), values.end(), impl_->values.begin());
  return factorise();
}

bool SparseCholesky::analyse() {
  if (impl_->analysed) return true;
  const int status = impl_->run(kAnalyse);
  impl_->analysed = status >= 0;
  out_of_memory_ = status == kOutOfMemory || status == kOutOfIntegerMemory;
  if (!impl_->analysed)
    error_ = out_of_memory_ ? "out of memory" : "the analysis failed (" + std::to_string(status) + ")";
  return impl_->analysed;
}

bool SparseCholesky::factorise() {
  const auto gate = enter_mumps_gate();
  negative_pivots_ = 0;
  out_of_memory_ = false;
  if (!analyse()) return false;
  int status = impl_->run(kFactorise);
  while ((status == kWorkspaceTooSmallInteger || status == kWorkspaceTooSmallReal) &&
         impl_->icntl(kMoreWorkspace) < 1000) {
    impl_->icntl(kMoreWorkspace) *= 2;
    status = impl_->run(kFactorise);
  }
  negative_pivots_ = status >= 0 ? impl_->infog(kNegativePivots) : 0;
  out_of_memory_ = status == kOutOfMemory || status == kOutOfIntegerMemory;
  if (status < 0)
    error_ = out_of_memory_        ? "out of memory"
             : status == kSingular ? "the matrix is singular"
                                   : "the factorisation failed (" + std::to_string(status) + ")";
  else if (negative_pivots_ > 0)
    error_ = "the matrix is not positive definite";
  return status >= 0 && negative_pivots_ == 0;
}

void SparseCholesky::solve(Vector& right) const {
  const auto gate = enter_mumps_gate();
  impl_->mumps.rhs = right.data();
  impl_->mumps.nrhs = 1;
  impl_->mumps.lrhs = static_cast<int>(right.size());
  impl_->run(kSolve);
}

}  // namespace planewright
