#include "core/solve/sparse_cholesky.h"

#include <dmumps_c.h>

#include "core/solve/mumps_gate.h"

namespace planewright {
namespace {

constexpr int kUseCommWorld = -987654;  // the sequential library's only communicator
enum Job { kEnd = -2, kInit = -1, kAnalyse = 1, kFactorise = 2, kSolve = 3 };
constexpr int kMoreWorkspace = 14;  // ICNTL: percentage added to the estimated workspace
constexpr int kWorkspaceTooSmallInteger = -8, kWorkspaceTooSmallReal = -9, kOutOfMemory = -13;

}  // namespace

struct SparseCholesky::Impl {
  DMUMPS_STRUC_C mumps{};
  std::vector<int> rows, columns;
  std::vector<double> values;
  bool analysed = false;

  int& icntl(int k) { return mumps.icntl[k - 1]; }  // numbered as in the manual
  int run(int job) {
    mumps.job = job;
    dmumps_c(&mumps);
    return mumps.infog[0];
  }
};

SparseCholesky::SparseCholesky(int size, std::vector<int> rows, std::vector<int> columns)
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

bool SparseCholesky::factorise(std::span<const double> values) {
  std::copy(values.begin(), values.end(), impl_->values.begin());
  const auto gate = enter_mumps_gate();
  if (!impl_->analysed) {
    if (impl_->run(kAnalyse) < 0) {
      error_ = impl_->mumps.infog[0] == kOutOfMemory ? "out of memory" : "the analysis failed";
      return false;
    }
    impl_->analysed = true;
  }
  int status = impl_->run(kFactorise);
  while ((status == kWorkspaceTooSmallInteger || status == kWorkspaceTooSmallReal) &&
         impl_->icntl(kMoreWorkspace) < 1000) {
    impl_->icntl(kMoreWorkspace) *= 2;
    status = impl_->run(kFactorise);
  }
  if (status < 0) error_ = status == kOutOfMemory ? "out of memory" : "the matrix is singular";
  return status >= 0;
}

void SparseCholesky::solve(Vector& right) {
  const auto gate = enter_mumps_gate();
  impl_->mumps.rhs = right.data();
  impl_->mumps.nrhs = 1;
  impl_->mumps.lrhs = static_cast<int>(right.size());
  impl_->run(kSolve);
}

}  // namespace planewright
