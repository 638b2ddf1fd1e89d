#include <Eigen/SparseCholesky>
#include <algorithm>
#include <numeric>

#include "core/solve/cholesky_backend.h"

namespace planewright {
namespace {

class EigenCholesky final : public CholeskyBackend {
 public:
  EigenCholesky(int size, const std::vector<int>& rows, const std::vector<int>& columns)
      : matrix_(size, size), place_(rows.size()) {
    values.resize(rows.size());
    // Places of the entries in compressed columns; repeated ones share theirs.
    std::vector<int> order(rows.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int k) {
      const auto e = static_cast<size_t>(k);
      return std::pair(columns[e], rows[e]);
    };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
    std::vector<Eigen::Triplet<double>> entries;
    for (size_t k = 0; k < order.size(); ++k) {
      if (k == 0 || key(order[k]) != key(order[k - 1]))
        entries.emplace_back(key(order[k]).second, key(order[k]).first, 0.0);
      place_[static_cast<size_t>(order[k])] = static_cast<int>(entries.size()) - 1;
    }
    matrix_.setFromTriplets(entries.begin(), entries.end());
    factors_.analyzePattern(matrix_);
  }

  bool factorise() override {
    double* const stored = matrix_.valuePtr();
    std::fill_n(stored, matrix_.nonZeros(), 0.0);
    for (size_t k = 0; k < values.size(); ++k) stored[place_[k]] += values[k];
    factors_.factorize(matrix_);
    const bool done = factors_.info() == Eigen::Success;
    negative_pivots = done ? 0 : 1;  // it stops at the first
    if (!done) error = "the matrix is not positive definite";
    return done;
  }

  void solve(Vector& right) override { right = factors_.solve(right).eval(); }

 private:
  Eigen::SparseMatrix<double> matrix_;
  std::vector<int> place_;  // per value
  Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace

std::unique_ptr<CholeskyBackend> make_eigen_cholesky(int size, const std::vector<int>& rows,
                                                     const std::vector<int>& columns) {
  return std::make_unique<EigenCholesky>(size, rows, columns);
}

}  // namespace planewright
