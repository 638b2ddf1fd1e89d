#include "core/solve/tangent_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

SharedProblem demanding(SharedComplex complex, Freedom freedom = Freedom::NormalsAndOffsets) {
  ProblemSettings settings{freedom, {{"position", 1.0}, {"fairing", 0.3}, {"normal-smoothness", 0.2}}};
  settings.demands.list = {{"vertex"}, {"face"}, {"edge"}};
  return Problem::create(std::move(complex), settings).value();
}

// Where a step takes z, by the equations' own retraction, for differences.
double energy_after(const Problem& problem, const TangentEquations& equations, const Vector& z,
                    const Vector& step) {
  return problem.objective(equations.moved(z, step).data());
}

TEST(TangentEquations, GradientIsThatOfTheEnergiesAlongTheMove) {
  for (const Freedom freedom : {Freedom::NormalsAndOffsets, Freedom::Normals}) {
    const auto problem = demanding(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), freedom);
    const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
    TangentEquations equations(*problem);
    equations.linearise(z, true);
    const std::vector<double> none(static_cast<size_t>(problem->rows()), 0.0);
    equations.assemble(1.0, none, none);
    const Vector gradient = equations.gradient();
    ASSERT_GT(gradient.norm(), 0.1);
    const double step = 1e-6;
    for (int k = 0; k < equations.unknowns(); ++k) {
      Vector d = Vector::Zero(equations.unknowns());
      d[k] = step;
      const double up = energy_after(*problem, equations, z, d);
      const double down = energy_after(*problem, equations, z, Vector(-d));
      EXPECT_NEAR(gradient[k], (up - down) / (2.0 * step), 1e-6) << "unknown " << k;
    }
  }
}

TEST(TangentEquations, RowsChangeAsTheyAreLinearised) {
  const auto problem = demanding(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}));
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
  TangentEquations equations(*problem);
  equations.linearise(z, true);
  Vector step(equations.unknowns());
  for (int k = 0; k < step.size(); ++k) step[k] = 1e-6 * std::sin(1.0 + k);
  const Vector change = equations.constraint_change(step), residual_change = equations.residual_change(step);
  const auto residuals_at = [&](const Vector& at) {
    Vector out(problem->residuals());
    problem->residual_values(at.data(), out.data());
    return out;
  };
  const Vector up = equations.moved(z, step), down = equations.moved(z, Vector(-step));
  Vector expected = 0.5 * (constraint_values(*problem, up) - constraint_values(*problem, down));
  const auto [first, last] = problem->unit_normal_rows();
  expected.segment(first, last - first).setZero();  // kept by the move itself
  EXPECT_LE((change - expected).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT(change.cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LE((residual_change - 0.5 * (residuals_at(up) - residuals_at(down))).cwiseAbs().maxCoeff(), 1e-11);
}

// The step of the sparse system against a dense one put together from its own linearisation.
TEST(TangentEquations, TheStepSolvesTheNormalEquations) {
  const auto problem = demanding(dual_of(domed_triangle_grid(3, 3).mesh(), {0.2}));
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
  TangentEquations equations(*problem);
  equations.linearise(z, true);
  const int size = equations.unknowns();
  Eigen::MatrixXd rows(problem->rows(), size), residuals(problem->residuals(), size);
  for (int k = 0; k < size; ++k) {
    const Vector unit = Vector::Unit(size, k);
    rows.col(k) = equations.constraint_change(unit);
    residuals.col(k) = equations.residual_change(unit);
  }
  std::vector<double> weights(static_cast<size_t>(problem->rows())), slopes(weights.size());
  for (size_t r = 0; r < weights.size(); ++r) {
    weights[r] = r % 3 == 0 ? 0.0 : 1.0 + static_cast<double>(r % 7);
    slopes[r] = 0.1 * std::sin(static_cast<double>(r));
  }
  equations.assemble(0.7, weights, slopes);
  const Vector step = equations.step(0.01, 0.2);
  ASSERT_EQ(step.size(), size);
  const Eigen::Map<const Vector> w(weights.data(), problem->rows()), s(slopes.data(), problem->rows());
  Eigen::MatrixXd matrix = 1.4 * residuals.transpose() * residuals + rows.transpose() * w.asDiagonal() * rows;
  const int split = 3 * problem->layout().points;
  matrix.diagonal().head(split).array() += 0.01;
  matrix.diagonal().tail(size - split).array() += 0.2;
  const Vector right = -(1.4 * residuals.transpose() * equations.residuals() + rows.transpose() * s);
  EXPECT_LE((step - Vector(matrix.llt().solve(right))).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(step.norm(), 1e-3);
}

TEST(TangentEquations, NormalsStayUnitAndFixedUnknownsStay) {
  const auto problem = demanding(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), Freedom::Normals);
  const Vector z = problem->from_state(initial_state(problem->complex()));
  TangentEquations equations(*problem);
  equations.linearise(z, true);
  const std::vector<double> none(static_cast<size_t>(problem->rows()), 0.0);
  std::vector<double> pull(none.size(), 0.3);
  equations.assemble(1.0, none, pull);
  const Vector after = equations.moved(z, equations.step(0.1, 0.1));
  const Layout& layout = problem->layout();
  for (int i = 0; i < layout.planes; ++i) {
    EXPECT_NEAR(after.segment<3>(layout.n(i)).norm(), 1.0, 1e-15);
    EXPECT_EQ(after[layout.h(i)], z[layout.h(i)]);
  }
  EXPECT_GT((after - z).norm(), 1e-3);
}

}  // namespace
}  // namespace planewright
