// Problems and their evaluation as plain vectors and dense matrices, for the tests of problem/ and solve/.
#pragma once

#include "core/problem/problem.h"
#include "support/complexes.h"

namespace planewright::test {

using SharedProblem = std::shared_ptr<const Problem>;

inline SharedProblem problem_of(SharedComplex complex, std::map<std::string, double> weights,
                                Freedom freedom = Freedom::NormalsAndOffsets) {
  return Problem::create(std::move(complex), {freedom, std::move(weights)}).value();
}

inline double objective(const Problem& problem, const State& state) {
  return problem.objective(problem.from_state(state).data());
}
inline Vector gradient(const Problem& problem, const Vector& z) {
  Vector out = Vector::Constant(problem.variables(), 1e9);  // has to be overwritten
  problem.gradient(z.data(), out.data());
  return out;
}
inline Vector constraint_values(const Problem& problem, const Vector& z) {
  Vector out = Vector::Constant(problem.rows(), 1e9);
  problem.constraint_values(z.data(), out.data());
  return out;
}
inline Eigen::MatrixXd jacobian(const Problem& problem, const Vector& z) {
  Vector values = Vector::Constant(problem.jacobian_pattern().size(), 1e9);
  problem.jacobian_values(z.data(), values.data());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(problem.rows(), problem.variables());
  for (int k = 0; k < values.size(); ++k)
    matrix(problem.jacobian_pattern().rows[k], problem.jacobian_pattern().columns[k]) += values[k];
  return matrix;
}
// Lower triangle of factor f'' + sum of multipliers c''.
inline Eigen::MatrixXd hessian(const Problem& problem, const Vector& z, double factor,
                               const Vector& multipliers) {
  Vector values = Vector::Constant(problem.hessian_pattern().size(), 1e9);
  problem.hessian_values(z.data(), factor, multipliers.data(), values.data());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(problem.variables(), problem.variables());
  for (int k = 0; k < values.size(); ++k)
    matrix(problem.hessian_pattern().rows[k], problem.hessian_pattern().columns[k]) += values[k];
  return matrix;
}

}  // namespace planewright::test
