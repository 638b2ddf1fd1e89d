#include "core/solve/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <random>

namespace planewright {
namespace {

// A random symmetric positive definite matrix, sparse, as lower-triangle entries; some of them in two parts.
struct Sparse {
  int size;
  std::vector<int> rows, columns;
  std::vector<double> values;
  Eigen::MatrixXd dense;

  Sparse(int n, unsigned seed, double diagonal = 8.0) : size(n), dense(Eigen::MatrixXd::Zero(n, n)) {
    std::mt19937 random(seed);
    const auto next = [&] { return static_cast<double>(random()) / 4294967295.0 - 0.5; };
    for (int i = 0; i < n; ++i) add(i, i, diagonal + next());
    for (int k = 0; k < 3 * n; ++k) {
      const int a = static_cast<int>(random() % static_cast<unsigned>(n));
      const int b = static_cast<int>(random() % static_cast<unsigned>(n));
      if (a != b) add(std::max(a, b), std::min(a, b), next());
    }
    for (int i = 0; i < n; i += 3) add(i, i, 0.5);  // again: added up
  }
  void add(int row, int column, double value) {
    rows.push_back(row);
    columns.push_back(column);
    values.push_back(value);
    dense(row, column) += value;
    if (row != column) dense(column, row) += value;
  }
};

Vector some_vector(int n) {
  Vector v(n);
  for (int i = 0; i < n; ++i) v[i] = std::sin(1.0 + i);
  return v;
}

TEST(SparseCholesky, SolvesLikeADenseFactorisation) {
  for (const int n : {1, 2, 7, 60, 300}) {
    const Sparse matrix(n, static_cast<unsigned>(n));
    SparseCholesky solver(n, matrix.rows, matrix.columns);
    ASSERT_TRUE(solver.factorise(matrix.values)) << solver.error();
    const Vector right = some_vector(n);
    Vector x = right;
    solver.solve(x);
    EXPECT_LE((x - matrix.dense.llt().solve(right)).cwiseAbs().maxCoeff(), 1e-13) << n;
    // And once more with the same factors.
    Vector again = matrix.dense * Vector::Ones(n);
    solver.solve(again);
    EXPECT_LE((again - Vector::Ones(n)).cwiseAbs().maxCoeff(), 1e-13) << n;
  }
}

TEST(SparseCholesky, FactorisesNewValuesOnTheSamePattern) {
  const int n = 40;
  Sparse matrix(n, 5);
  SparseCholesky solver(n, matrix.rows, matrix.columns);
  for (const double scale : {1.0, 1e-6, 1e6, 3.0}) {
    std::vector<double> values = matrix.values;
    for (double& value : values) value *= scale;
    ASSERT_TRUE(solver.factorise(values));
    Vector x = scale * (matrix.dense * some_vector(n));
    solver.solve(x);
    EXPECT_LE((x - some_vector(n)).cwiseAbs().maxCoeff(), 1e-12) << scale;
  }
}

TEST(SparseCholesky, SeveralLiveSideBySide) {
  const Sparse a(30, 1), b(50, 2);
  SparseCholesky first(30, a.rows, a.columns), second(50, b.rows, b.columns);
  ASSERT_TRUE(first.factorise(a.values));
  ASSERT_TRUE(second.factorise(b.values));
  Vector x = a.dense * some_vector(30), y = b.dense * some_vector(50);
  first.solve(x);
  second.solve(y);
  EXPECT_LE((x - some_vector(30)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LE((y - some_vector(50)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SparseCholesky, ReportsASingularMatrixAndGoesOn) {
  // Row and column 1 are zero.
  SparseCholesky solver(3, {0, 1, 2, 2}, {0, 1, 2, 0});
  EXPECT_FALSE(solver.factorise(std::vector<double>{1.0, 0.0, 1.0, 0.5}));
  EXPECT_EQ(solver.error(), "the matrix is singular");
  ASSERT_TRUE(solver.factorise(std::vector<double>{1.0, 2.0, 1.0, 0.5}));
  Vector x = Vector{{1.5, 4.0, 1.5}};
  solver.solve(x);
  EXPECT_LE((x - Vector{{1.0, 2.0, 1.0}}).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace planewright
