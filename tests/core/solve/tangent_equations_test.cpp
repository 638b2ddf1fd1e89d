#include "core/solve/tangent_equations.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>

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

// Irregular weights and slopes of the rows, some of them 0.
std::vector<double> some_weights(const Problem& problem) {
  std::vector<double> weights;
  for (int r = 0; r < problem.rows(); ++r) weights.push_back(r % 3 == 0 ? 0.0 : 1.0 + r % 7);
  return weights;
}
std::vector<double> some_slopes(const Problem& problem) {
  std::vector<double> slopes;
  for (int r = 0; r < problem.rows(); ++r) slopes.push_back(0.1 * std::sin(static_cast<double>(r)));
  return slopes;
}

// The matrix of a step without its curvature, put together from the equations' own linearisation.
Eigen::MatrixXd dense_matrix(const Problem& problem, const TangentEquations& equations, double factor,
                             const std::vector<double>& weights, const Damping& damping) {
  const int size = equations.unknowns(), points = 3 * problem.layout().points;
  Eigen::MatrixXd rows(problem.rows(), size), residuals(problem.residuals(), size);
  for (int k = 0; k < size; ++k) {
    const Vector unit = Vector::Unit(size, k);
    rows.col(k) = equations.constraint_change(unit);
    residuals.col(k) = equations.residual_change(unit);
  }
  const Eigen::Map<const Vector> w(weights.data(), problem.rows());
  Eigen::MatrixXd matrix =
      2.0 * factor * residuals.transpose() * residuals + rows.transpose() * w.asDiagonal() * rows;
  for (int k = 0; k < size; ++k)
    matrix(k, k) +=
        k < points
            ? damping.points
            : damping.planes *
                  (damping.per_plane.empty() ? 1.0 : damping.per_plane[static_cast<size_t>(k - points) / 3]);
  return matrix;
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
  const auto weights = some_weights(*problem), slopes = some_slopes(*problem);
  equations.assemble(0.7, weights, slopes);
  const Vector step = equations.step(0.01, 0.2);
  ASSERT_EQ(step.size(), equations.unknowns());
  const Eigen::MatrixXd matrix = dense_matrix(*problem, equations, 0.7, weights, {0.01, 0.2});
  // The right side, from what each unknown does to residuals and rows.
  Vector right(equations.unknowns());
  const Eigen::Map<const Vector> s(slopes.data(), problem->rows());
  for (int k = 0; k < right.size(); ++k) {
    const Vector unit = Vector::Unit(right.size(), k);
    right[k] = -1.4 * equations.residual_change(unit).dot(equations.residuals()) -
               equations.constraint_change(unit).dot(s);
  }
  EXPECT_LE((step - Vector(matrix.llt().solve(right))).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_GT(step.norm(), 1e-3);
}

// Points that nothing couples are eliminated, whatever their valence and freedom; the answer must not show
// it.
TEST(TangentEquations, EliminatedPointsMoveAsTheDenseSystemSays) {
  auto complexes = small_complexes();
  complexes.push_back({"high_valence_planarize", planarize_of(fan(20).mesh())});
  for (const auto& [label, complex] : complexes)
    for (const Freedom freedom : {Freedom::Fixed, Freedom::Normals, Freedom::NormalsAndOffsets}) {
      ProblemSettings settings{freedom, {{"position", 1.0}, {"normal-smoothness", 0.2}, {"offset", 0.1}}};
      settings.demands.pins = {{complex->point_origin.front(), {0.1, {}, 0.3}}};
      const auto problem = Problem::create(complex, settings);
      if (!problem) continue;  // planes without a common point cannot be fixed
      ASSERT_GT(TangentPattern(**problem, EnergyCoupling::Exact).eliminated(), 0);
      TangentEquations equations(**problem);
      equations.linearise((*problem)->from_state(perturbed(*complex, 0.1)), true);
      const auto weights = some_weights(**problem), slopes = some_slopes(**problem);
      std::vector<double> per_plane;
      for (int i = 0; i < complex->plane_count(); ++i) per_plane.push_back(1.0 + i % 4);
      const Damping damping{0.01, 0.2, per_plane};
      equations.assemble(0.7, weights, slopes);
      const Vector step = equations.step(damping);
      ASSERT_EQ(step.size(), equations.unknowns()) << label;
      const Eigen::MatrixXd matrix = dense_matrix(**problem, equations, 0.7, weights, damping);
      const Vector expected = matrix.llt().solve(-equations.gradient());
      EXPECT_LE((step - expected).cwiseAbs().maxCoeff(), 1e-10) << label;
      EXPECT_GT(step.norm(), 1e-3) << label;
      // Any other right side with the same factors.
      Vector right(equations.unknowns());
      for (int k = 0; k < right.size(); ++k) right[k] = std::sin(3.0 * k);
      EXPECT_LE((matrix * equations.solve(right) - right).cwiseAbs().maxCoeff(), 1e-9) << label;
    }
}

TEST(TangentEquations, ConjugateGradientsSolveWithTheCouplingThatWasDropped) {
  for (const char* energy : {"fairing", "edge-length", "diagonal-length", "edge-direction"}) {
    const auto problem =
        problem_of(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), {{"position", 0.3}, {energy, 1.0}});
    const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
    const auto weights = some_weights(*problem), slopes = some_slopes(*problem);
    TangentEquations exact(*problem), dropped(*problem, EnergyCoupling::Dropped);
    ASSERT_TRUE(TangentPattern(*problem, EnergyCoupling::Dropped).incomplete()) << energy;
    const auto step_of = [&](TangentEquations& equations) {
      equations.linearise(z, true);
      equations.assemble(1.0, weights, slopes);
      return equations.step(0.01, 0.2);
    };
    const Vector step = step_of(exact);
    const Eigen::MatrixXd matrix = dense_matrix(*problem, exact, 1.0, weights, {0.01, 0.2});
    double loose = 0.0;
    for (const double tolerance : {1e-1, 1e-4, 1e-10}) {
      dropped.set_iterative_tolerance(tolerance);
      const Vector iterated = step_of(dropped);
      EXPECT_EQ(exact.gradient(), dropped.gradient());
      const Vector left = matrix * iterated + exact.gradient();
      EXPECT_LE(left.norm(), tolerance * exact.gradient().norm() * (1.0 + 1e-6)) << energy;
      if (tolerance == 1e-1) loose = left.norm();
      if (tolerance == 1e-10) {
        EXPECT_LE((iterated - step).cwiseAbs().maxCoeff(), 1e-7) << energy;
      }
    }
    EXPECT_GT(loose, 1e-9 * exact.gradient().norm()) << energy;  // the preconditioner alone is not the matrix
    // Rows alone need no iteration: nothing was dropped from them.
    dropped.set_iterative_tolerance(1.0);
    dropped.assemble(0.0, weights, slopes);
    exact.assemble(0.0, weights, slopes);
    EXPECT_LE((dropped.step(0.01, 0.2) - exact.step(0.01, 0.2)).cwiseAbs().maxCoeff(), 1e-9) << energy;
  }
}

// Slope of f + y.c along a step, at the place that a step d from z leads to.
Vector slope_after(const Problem& problem, const TangentEquations& equations, const Vector& z,
                   const Vector& y, const Vector& d) {
  const Layout& layout = problem.layout();
  const Vector at = equations.moved(z, d);
  const Vector slope = gradient(problem, at) + jacobian(problem, at).transpose() * y;
  Vector out(equations.unknowns());
  out.head(3 * layout.points) = slope.head(3 * layout.points);
  for (int i = 0; i < layout.planes; ++i) {
    const int first = 3 * (layout.points + i);
    const auto& t = equations.tangents(i);
    const Vector3d turned = z.segment<3>(layout.n(i)) + t * d.segment<2>(first), n = turned.normalized();
    const Vector3d across = slope.segment<3>(layout.n(i));
    out.segment<2>(first) = t.transpose() * (across - n * n.dot(across)) / turned.norm();
    out[first + 2] = slope[layout.h(i)];
    if (!layout.is_free(layout.n(i))) out.segment<2>(first).setZero();
    if (!layout.is_free(layout.h(i))) out[first + 2] = 0.0;
  }
  return out;
}

// Multipliers of an irregular sequence; unit-normal rows, which the tangent space leaves out, have none.
Vector some_multipliers(const Problem& problem) {
  Vector y(problem.rows());
  for (int r = 0; r < y.size(); ++r) y[r] = std::cos(1.7 * r);
  const auto [first, last] = problem.unit_normal_rows();
  y.segment(first, last - first).setZero();
  return y;
}

// With all of the curvature the matrix is the second derivative of f + y.c in the tangent space.
TEST(TangentEquations, CurvatureCompletesTheSecondDerivative) {
  struct Case {
    const char* what;
    SharedProblem problem;
  };
  ProblemSettings shapes{Freedom::NormalsAndOffsets, {{"position", 1.0}, {"edge-length", 0.6}}};
  shapes.demands.list = {{"star"}, {"uncrossed"}};
  const SharedComplex dome = dual_of(domed_triangle_grid(3, 2).mesh(), {0.2});
  const Case cases[] = {
      {"eliminated points",
       problem_of(dome, {{"position", 1.0}, {"normal-smoothness", 0.4}, {"proxy-normal", 0.3}})},
      {"coupled points, demands", demanding(dome)},
      {"offsets that stay", demanding(dome, Freedom::Normals)},
      {"planes that stay", problem_of(dual_of(domed_triangle_grid(6, 5).mesh()),
                                      {{"position", 1.0}, {"edge-length", 1.0}}, Freedom::Fixed)},
      {"panel shapes", Problem::create(planarize_of(twisted_grid(2, 2).mesh()), shapes).value()},
  };
  for (const auto& [what, problem] : cases) {
    SCOPED_TRACE(what);
    const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
    const Vector y = some_multipliers(*problem);
    const std::vector<double> none(static_cast<size_t>(problem->rows()), 0.0);
    TangentEquations equations(*problem);
    equations.linearise(z, true);
    const int size = equations.unknowns();
    Eigen::MatrixXd second(size, size);
    const double step = 1e-6;
    for (int k = 0; k < size; ++k) {
      const Vector d = step * Vector::Unit(size, k);
      second.col(k) =
          (slope_after(*problem, equations, z, y, d) - slope_after(*problem, equations, z, y, Vector(-d))) /
          (2.0 * step);
      // Fixed unknowns move nothing.
      const int plane = k / 3 - problem->layout().points;
      const bool is_free = plane < 0 || problem->layout().is_free(k % 3 == 2 ? problem->layout().h(plane)
                                                                             : problem->layout().n(plane));
      if (!is_free) second.col(k).setZero();
    }
    const Eigen::MatrixXd gauss_newton = dense_matrix(*problem, equations, 1.0, none, {});
    ASSERT_GT((second - gauss_newton).cwiseAbs().maxCoeff(), 0.1);
    // Damping that makes any share of it definite.
    const double damping =
        1.0 + Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(second).eigenvalues().cwiseAbs().maxCoeff();
    for (const double share : {1.0, 0.3}) {
      equations.assemble(1.0, none, none);
      equations.add_curvature(z, 1.0, y, share);
      ASSERT_TRUE(equations.factorise({damping, damping}));
      Eigen::MatrixXd expected = gauss_newton + share * (second - gauss_newton);
      expected.diagonal().array() += damping;
      for (int k = 0; k < size; ++k) {
        const Vector unit = Vector::Unit(size, k);
        EXPECT_LE((expected * equations.solve(unit) - unit).cwiseAbs().maxCoeff(), 1e-6) << "unknown " << k;
      }
    }
  }
}

TEST(TangentEquations, SaysThatAMatrixIsNotDefinite) {
  const auto problem = problem_of(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), {{"position", 1.0}});
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
  const std::vector<double> none(static_cast<size_t>(problem->rows()), 0.0);
  TangentEquations equations(*problem);
  equations.linearise(z, true);
  equations.assemble(1.0, none, none);
  equations.add_curvature(z, 1.0, 10.0 * some_multipliers(*problem), 1.0);
  EXPECT_FALSE(equations.factorise({1e-6, 1e-6}));
  EXPECT_FALSE(equations.out_of_memory());
  EXPECT_EQ(equations.step(1e-6, 1e-6).size(), 0);
  EXPECT_TRUE(equations.factorise({1e3, 1e3}));
  EXPECT_GT(equations.step(1e3, 1e3).norm(), 0.0);
  // An eliminated point's own block is looked at before MUMPS sees anything.
  equations.assemble(1.0, none, none);
  EXPECT_FALSE(equations.factorise({-3.0, 1.0}));
  EXPECT_FALSE(equations.out_of_memory());
  EXPECT_TRUE(equations.factorise({0.1, 1.0}));
}

TEST(TangentEquations, ValuesThatAreNoNumbersGiveNoStep) {
  const auto problem = problem_of(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}), {{"position", 1.0}});
  Vector z = problem->from_state(initial_state(problem->complex()));
  z[4] = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> one(static_cast<size_t>(problem->rows()), 1.0);
  TangentEquations equations(*problem);
  equations.linearise(z, true);
  equations.assemble(1.0, one, one);
  EXPECT_EQ(equations.step(0.1, 0.1).size(), 0);
  EXPECT_FALSE(equations.out_of_memory());
}

TEST(TangentEquations, ACacheChangesNoBitAndServesSeveralTopologies) {
  std::vector<SharedProblem> problems;
  for (const auto& [label, complex] : small_complexes()) {
    problems.push_back(problem_of(complex, {{"position", 1.0}, {"normal-smoothness", 0.2}}));
    problems.push_back(problem_of(complex, {{"position", 1.0}, {"fairing", 0.3}}));
  }
  const auto step_of = [](const Problem& problem, EnergyCoupling coupling, TangentCache* cache) {
    TangentEquations equations(problem, coupling, cache);
    equations.linearise(problem.from_state(perturbed(problem.complex(), 0.1)), true);
    equations.assemble(1.0, some_weights(problem), some_slopes(problem));
    return equations.step(0.01, 0.2);
  };
  TangentCache cache;
  for (int round = 0; round < 2; ++round)
    for (size_t p = 0; p < problems.size(); ++p)
      for (const EnergyCoupling coupling : {EnergyCoupling::Exact, EnergyCoupling::Dropped}) {
        const Vector alone = step_of(*problems[p], coupling, nullptr);
        ASSERT_GT(alone.size(), 0);
        for (const char* when : {"made", "found"}) {
          const Vector cached = step_of(*problems[p], coupling, &cache);
          EXPECT_TRUE(same_bits(alone, cached)) << "problem " << p << ", " << when;
        }
      }
}

TEST(TangentEquations, ACacheKeepsTheThreeUsedLast) {
  std::vector<SharedProblem> problems;
  for (const int columns : {2, 3, 4, 5})
    problems.push_back(problem_of(planarize_of(twisted_grid(columns, 2).mesh()), {{"position", 1.0}}));
  TangentCache cache;
  const auto get = [&](int p) {
    return cache.find_or_make(*problems[static_cast<size_t>(p)], EnergyCoupling::Exact);
  };
  const auto zero = get(0), one = get(1), two = get(2);
  EXPECT_EQ(get(0), zero);
  EXPECT_EQ(get(1), one);
  EXPECT_EQ(get(0), zero);
  get(3);  // takes the place of 2, the one unused for longest
  EXPECT_EQ(get(0), zero);
  EXPECT_EQ(get(1), one);
  EXPECT_NE(get(2), two);
  cache.clear();
  EXPECT_NE(get(1), one);
  EXPECT_TRUE(get(1)->pattern.fits(*problems[1], EnergyCoupling::Exact));
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
