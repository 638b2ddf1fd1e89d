#include "core/problem/derivative_check.h"

#include <Eigen/Core>
#include <cmath>

namespace planewright {
namespace {

using Dense = Eigen::MatrixXd;

Dense dense(const SparsePattern& pattern, const Vector& values, int rows, int columns) {
  Dense matrix = Dense::Zero(rows, columns);
  for (int k = 0; k < pattern.size(); ++k) matrix(pattern.rows[k], pattern.columns[k]) += values[k];
  return matrix;
}

Vector lagrangian_gradient(const Problem& problem, const Vector& z, double factor,
                           const Vector& multipliers) {
  Vector g(problem.variables()), values(problem.jacobian_pattern().size());
  problem.gradient(z.data(), g.data());
  g *= factor;
  problem.jacobian_values(z.data(), values.data());
  const SparsePattern& pattern = problem.jacobian_pattern();
  for (int k = 0; k < pattern.size(); ++k) g[pattern.columns[k]] += values[k] * multipliers[pattern.rows[k]];
  return g;
}

class Comparison {
 public:
  explicit Comparison(DerivativeCheck& check) : check_(check) {}
  void compare(const char* what, double analytic, double difference, int row, int column, double& error,
               double& norm) {
    const double e = std::abs(analytic - difference) / std::max(1.0, std::abs(analytic));
    norm = std::max(norm, std::abs(analytic));
    if (e > error) error = e;
    if (e > worst_) {
      worst_ = e;
      check_.worst = std::string(what) + "(" + std::to_string(row) + ", " + std::to_string(column) + ")";
    }
  }

 private:
  DerivativeCheck& check_;
  double worst_ = -1.0;
};

}  // namespace

DerivativeCheck check_derivatives(const Problem& problem, const Vector& z, double step) {
  DerivativeCheck check;
  Comparison comparison(check);
  const int n = problem.variables(), m = problem.rows();
  const double factor = 0.7;
  Vector multipliers(m);
  for (int r = 0; r < m; ++r) multipliers[r] = std::sin(1.0 + 2.0 * r);

  Vector gradient(n), jacobian_values(problem.jacobian_pattern().size());
  Vector hessian_values(problem.hessian_pattern().size());
  problem.gradient(z.data(), gradient.data());
  problem.jacobian_values(z.data(), jacobian_values.data());
  problem.hessian_values(z.data(), factor, multipliers.data(), hessian_values.data());
  const Dense jacobian = dense(problem.jacobian_pattern(), jacobian_values, m, n);
  const Dense hessian = dense(problem.hessian_pattern(), hessian_values, n, n);

  Vector shifted = z, c_up(m), c_down(m);
  for (int v = 0; v < n; ++v) {
    shifted[v] = z[v] + step;
    const double f_up = problem.objective(shifted.data());
    problem.constraint_values(shifted.data(), c_up.data());
    const Vector g_up = lagrangian_gradient(problem, shifted, factor, multipliers);
    shifted[v] = z[v] - step;
    const double f_down = problem.objective(shifted.data());
    problem.constraint_values(shifted.data(), c_down.data());
    const Vector g_down = lagrangian_gradient(problem, shifted, factor, multipliers);
    shifted[v] = z[v];

    comparison.compare("gradient", gradient[v], (f_up - f_down) / (2 * step), v, 0, check.gradient_error,
                       check.gradient_norm);
    for (int r = 0; r < m; ++r)
      comparison.compare("jacobian", jacobian(r, v), (c_up[r] - c_down[r]) / (2 * step), r, v,
                         check.jacobian_error, check.jacobian_norm);
    for (int u = v; u < n; ++u)
      comparison.compare("hessian", hessian(u, v), (g_up[u] - g_down[u]) / (2 * step), u, v,
                         check.hessian_error, check.hessian_norm);
  }
  return check;
}

}  // namespace planewright
