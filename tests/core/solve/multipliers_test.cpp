#include "core/solve/multipliers.h"

#include <gtest/gtest.h>

#include "core/solve/tangent_solver.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

SolveReport tightly_solved(const Problem& problem) {
  SolveOptions options;
  options.tolerance = 1e-9;
  return make_tangent_solver()->solve(problem, initial_state(problem.complex()), options, nullptr, {});
}

double residual(const Problem& problem, const Vector& z, const Vector& multipliers) {
  return problem.first_order_residual(z.data(), multipliers.data());
}

// Slope of f + y.c along each unit normal.
Vector slopes_along_normals(const Problem& problem, const Vector& z, const Vector& y) {
  const Vector slope = gradient(problem, z) + jacobian(problem, z).transpose() * y;
  Vector out(problem.layout().planes);
  for (int i = 0; i < out.size(); ++i) {
    const int n = problem.layout().n(i);
    out[i] = slope.segment<3>(n).dot(z.segment<3>(n));
  }
  return out;
}

TEST(Multipliers, OfUnitNormalsTakeTheSlopeAlongTheNormal) {
  for (const Freedom freedom : {Freedom::Normals, Freedom::NormalsAndOffsets}) {
    const auto problem = problem_of(dual_of(domed_triangle_grid(4, 3).mesh(), {0.2}),
                                    {{"position", 1.0}, {"normal-smoothness", 0.5}}, freedom);
    Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
    for (int i = 0; i < problem->layout().planes; ++i) z.segment<3>(problem->layout().n(i)) *= 1.0 + 0.1 * i;
    const auto [first, last] = problem->unit_normal_rows();
    Vector y(problem->rows());
    for (int r = 0; r < y.size(); ++r) y[r] = std::sin(1.3 * r);
    const Vector before = y;
    ASSERT_GT(slopes_along_normals(*problem, z, y).cwiseAbs().minCoeff(), 1e-3);
    complete_unit_normals(*problem, z, y);
    EXPECT_LE(slopes_along_normals(*problem, z, y).cwiseAbs().maxCoeff(), 1e-12);
    for (int r = 0; r < y.size(); ++r)
      if (r < first || r >= last) {
        EXPECT_EQ(y[r], before[r]) << r;
      }
  }
}

TEST(Multipliers, OfFixedPlanesNeedNoCompletion) {
  const auto problem =
      problem_of(dual_of(domed_triangle_grid(6, 5).mesh()), {{"position", 1.0}}, Freedom::Fixed);
  const Vector z = problem->from_state(perturbed(problem->complex(), 0.1));
  Vector y = Vector::LinSpaced(problem->rows(), -1.0, 1.0);
  const Vector before = y;
  complete_unit_normals(*problem, z, y);
  EXPECT_EQ(y, before);
}

TEST(Multipliers, AreFoundFromNothingAtAConvergedState) {
  for (const char* sample : {"dome", "twisted-roof"})
    for (const double factor : {1.0, 50.0}) {
      const SharedComplex complex = sample_complex(sample, 80);
      const auto problem = problem_of(complex, {{"position", factor}, {"fairing", 0.2 * factor}});
      const SolveReport report = tightly_solved(*problem);
      ASSERT_EQ(report.status, SolveStatus::Converged) << sample << ": " << report.stop_reason;
      const Vector z = problem->from_state(report.state), none = Vector::Zero(problem->rows());
      Vector completed = none;
      complete_unit_normals(*problem, z, completed);
      ASSERT_GT(residual(*problem, z, completed), 1e-3 * factor);
      TangentCache cache;
      for (TangentCache* used : {static_cast<TangentCache*>(nullptr), &cache}) {
        const Vector found = estimate_multipliers(*problem, z, none, used);
        EXPECT_LE(residual(*problem, z, found), 1e-6 * factor) << sample;
        // Where the rows are independent there is but one answer.
        if (sample == std::string("dome")) {
          EXPECT_LE((found - report.multipliers).cwiseAbs().maxCoeff(), 1e-4 * factor);
        }
      }
    }
}

TEST(Multipliers, AreNeverWorseThanTheGuess) {
  const SharedComplex complex = sample_complex("dome", 60);
  const auto problem = problem_of(complex, {{"position", 1.0}});
  const SolveReport report = tightly_solved(*problem);
  for (const double off : {0.0, 1e-9, 0.3})
    for (const double wrong : {0.0, 1e-10, 0.1}) {
      State state = perturbed(*complex, report.state, off);
      const Vector z = problem->from_state(state);
      Vector guess = report.multipliers;
      for (int r = 0; r < guess.size(); ++r) guess[r] += wrong * std::sin(2.1 * r);
      Vector completed = guess;
      complete_unit_normals(*problem, z, completed);
      const Vector found = estimate_multipliers(*problem, z, guess, nullptr);
      EXPECT_LE(residual(*problem, z, found), residual(*problem, z, completed)) << off << " " << wrong;
      EXPECT_LE(slopes_along_normals(*problem, z, found).cwiseAbs().maxCoeff(), 1e-10);
      if (off == 0.0) {
        EXPECT_LE(residual(*problem, z, found), 1e-7) << wrong;
      }
    }
}

TEST(Multipliers, OfInequalitiesPushInwardsAlone) {
  const SharedComplex complex = sample_complex("dome", 80, 0.05);
  ProblemSettings settings = demanding({demand("vertex"), demand("face"), demand("edge")});
  const auto problem = Problem::create(complex, settings).value();
  const SolveReport report = tightly_solved(*problem);
  ASSERT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  const Vector z = problem->from_state(report.state);
  // A guess that knows which rows push and nothing more.
  Vector guess = Vector::Zero(problem->rows());
  std::vector<int> pushing, resting;
  for (int r = 0; r < problem->rows(); ++r) {
    const Bounds bounds = problem->bounds(r);
    if (bounds.low == bounds.high) continue;
    (report.multipliers[r] != 0.0 ? pushing : resting).push_back(r);
    if (report.multipliers[r] != 0.0) guess[r] = -1e-12;
  }
  ASSERT_GT(pushing.size(), 5u);
  ASSERT_GT(resting.size(), 5u);
  const Vector found = estimate_multipliers(*problem, z, guess, nullptr);
  EXPECT_LE(residual(*problem, z, found), 1e-6);
  for (const int r : pushing) EXPECT_LE(found[r], 0.0) << r;
  for (const int r : resting) EXPECT_EQ(found[r], 0.0) << r;
  // Guesses of the wrong sign stay on their side of 0, whatever the least squares say.
  for (const int r : pushing) guess[r] = 1e-12;
  const Vector wrong = estimate_multipliers(*problem, z, guess, nullptr);
  for (const int r : pushing) EXPECT_GE(wrong[r], 0.0) << r;
  EXPECT_GT(residual(*problem, z, wrong), 1e-4);
}

// The same demand twice, and points between planes that are all the same: multipliers are not determined.
TEST(Multipliers, OfRowsThatDependOnEachOtherAreShared) {
  const double half = 0.5;
  const Demand floor = demand("on-plane", {0, 0, half, 0, 0, 1});
  const ProblemSettings settings = demanding({floor, floor});
  const SharedComplex complex = planarize_of(grid(3, 3).mesh());
  const auto problem = Problem::create(complex, settings).value();
  State state = initial_state(*complex);
  state.x.col(2).setConstant(half - complex->origin.z());
  state.h.setConstant(half);
  const Vector z = problem->from_state(state);
  ASSERT_TRUE(problem->violated_rows(z.data(), 1e-12).empty());
  const Vector found = estimate_multipliers(*problem, z, Vector::Zero(problem->rows()), nullptr);
  EXPECT_TRUE(found.allFinite());
  EXPECT_LE(residual(*problem, z, found), 1e-6);
  const std::vector<int> twice = rows_of(*problem, "on-plane");
  ASSERT_EQ(twice.size(), 2u * static_cast<size_t>(complex->point_count()));
  // Each point is held half an edge above where it wants to be, half of that by either row.
  for (const int r : twice) EXPECT_NEAR(found[r], -0.5, 1e-6);
}

}  // namespace
}  // namespace planewright
