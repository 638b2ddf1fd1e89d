#include <dmumps_c.h>

#include <algorithm>
#include <limits>

#include "core/solve/cholesky_backend.h"
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

class MumpsCholesky final : public CholeskyBackend {
 public:
  MumpsCholesky(int size, std::vector<int> rows, std::vector<int> columns, int block)
      : rows_(std::move(rows)), columns_(std::move(columns)) {
    for (int& r : rows_) ++r;  // Fortran counts from 1
    for (int& c : columns_) ++c;
    values.resize(rows_.size());
    const auto gate = enter_mumps_gate();
    mumps_.par = 1;
    mumps_.sym = 1;
    mumps_.comm_fortran = kUseCommWorld;
    run(kInit);
    for (int stream : {1, 2, 3, 4}) icntl(stream) = 0;  // silent
    icntl(kOrdering) = kScotch;
    if (block > 1) icntl(kBlockFormat) = -block;
    mumps_.n = size;
    mumps_.nnz = static_cast<MUMPS_INT8>(rows_.size());
    mumps_.irn = rows_.data();
    mumps_.jcn = columns_.data();
    mumps_.a = values.data();
  }
  ~MumpsCholesky() override {
    const auto gate = enter_mumps_gate();
    run(kEnd);
  }

  bool factorise() override {
    const auto gate = enter_mumps_gate();
    negative_pivots = 0;
    out_of_memory = false;
    if (!analyse()) return false;
    int status = run(kFactorise);
    while ((status == kWorkspaceTooSmallInteger || status == kWorkspaceTooSmallReal) &&
           icntl(kMoreWorkspace) < 1000) {
      icntl(kMoreWorkspace) *= 2;
      status = run(kFactorise);
    }
    negative_pivots = status >= 0 ? infog(kNegativePivots) : 0;
    note_memory(status);
    if (status < 0)
      error = out_of_memory         ? "out of memory"
              : status == kSingular ? "the matrix is singular"
                                    : "the factorisation failed (" + std::to_string(status) + ")";
    else if (negative_pivots > 0)
      error = "the matrix is not positive definite";
    return status >= 0 && negative_pivots == 0;
  }

  void solve(Vector& right) override {
    const auto gate = enter_mumps_gate();
    mumps_.rhs = right.data();
    mumps_.nrhs = 1;
    mumps_.lrhs = static_cast<int>(right.size());
    const int status = run(kSolve);
    if (status >= 0) return;
    note_memory(status);
    error = out_of_memory ? "out of memory" : "the solution failed (" + std::to_string(status) + ")";
    right.setConstant(std::numeric_limits<double>::quiet_NaN());  // not the right side taken for a solution
  }

 private:
  bool analyse() {
    if (analysed_) return true;
    const int status = run(kAnalyse);
    analysed_ = status >= 0;
    note_memory(status);
    if (!analysed_)
      error = out_of_memory ? "out of memory" : "the analysis failed (" + std::to_string(status) + ")";
    return analysed_;
  }
  void note_memory(int status) { out_of_memory = status == kOutOfMemory || status == kOutOfIntegerMemory; }
  int& icntl(int k) { return mumps_.icntl[k - 1]; }
  int infog(int k) const { return mumps_.infog[k - 1]; }
  int run(int job) {
    mumps_.job = job;
    dmumps_c(&mumps_);
    return mumps_.infog[0];
  }

  DMUMPS_STRUC_C mumps_{};
  std::vector<int> rows_, columns_;
  bool analysed_ = false;
};

}  // namespace

std::unique_ptr<CholeskyBackend> make_mumps_cholesky(int size, std::vector<int> rows,
                                                     std::vector<int> columns, int block) {
  return std::make_unique<MumpsCholesky>(size, std::move(rows), std::move(columns), block);
}

}  // namespace planewright
