// The end of every solve: projected, measured again, and a status that says no more than was measured.
#include "core/solve/finish_solve.h"

#include <gtest/gtest.h>

#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

class FinishSolve : public testing::Test {
 protected:
  SolveReport finished(SolveStatus status, const State& state, const Vector& multipliers) {
    SolveReport report;
    report.status = status;
    report.stop_reason = "reason";
    finish_solve(*problem, problem->from_state(state), multipliers, SolveOptions{}, report);
    return report;
  }

  SharedComplex complex = dual_of(make_sample("dome", 80).value());
  SharedProblem problem = problem_of(complex, {{"position", 1.0}, {"fairing", 0.2}});
  SolveReport solved = solve(*problem);
  Vector no_multipliers = Vector::Zero(problem->rows());
};

TEST_F(FinishSolve, ProjectsAndMeasuresAgain) {
  const State off = perturbed(*complex, solved.state, 1e-3);
  const SolveReport report = finished(SolveStatus::Planar, off, solved.multipliers);
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  EXPECT_NEAR(report.incidence_residual, off_plane(*complex, report.state), 1e-13);
  EXPECT_NEAR(report.projection_move, distance(*complex, report.state, off), 1e-9);
  EXPECT_GT(report.projection_move, 1e-4);
  ASSERT_EQ(report.energies.size(), 2u);
  EXPECT_NEAR(energy(report), objective(*problem, report.state), 1e-12 * energy(report));
  ASSERT_EQ(report.constraints.size(), 2u);
  EXPECT_EQ(report.constraints[0].name, "incidence");
  EXPECT_LE(report.constraints[0].max_violation, 1e-12);
  EXPECT_EQ(report.status, SolveStatus::Planar);
  EXPECT_EQ(report.stop_reason, "reason");
}

TEST_F(FinishSolve, AConvergedStateStaysSo) {
  ASSERT_EQ(solved.status, SolveStatus::Converged);
  const SolveReport report = finished(SolveStatus::Converged, solved.state, solved.multipliers);
  EXPECT_EQ(report.status, SolveStatus::Converged);
  EXPECT_NEAR(report.first_order_residual, solved.first_order_residual, 1e-9);
}

// Planar, but a solver's word that it is stationary is not taken on trust.
TEST_F(FinishSolve, WhatIsNotStationaryIsNotCalledConverged) {
  for (const Vector& multipliers : {solved.multipliers, no_multipliers}) {
    const State state = perturbed(*complex, solved.state, 0.05);
    const SolveReport report = finished(SolveStatus::Converged, state, multipliers);
    EXPECT_EQ(report.status, SolveStatus::Planar);
    EXPECT_NE(report.stop_reason, "reason");
    EXPECT_GT(report.first_order_residual, SolveOptions{}.tolerance);
    EXPECT_LE(off_plane(*complex, report.state), 1e-12);
  }
}

// A solver's word that it cannot be done neither, when the projection did it.
TEST_F(FinishSolve, WhatTheProjectionReachedIsNotCalledInfeasible) {
  const SolveReport report =
      finished(SolveStatus::Infeasible, perturbed(*complex, solved.state, 0.05), no_multipliers);
  EXPECT_EQ(report.status, SolveStatus::Planar);
  EXPECT_LE(off_plane(*complex, report.state), 1e-12);
}

TEST_F(FinishSolve, StoppedAndFailedKeepTheirName) {
  for (const SolveStatus status : {SolveStatus::Stopped, SolveStatus::Failed}) {
    const SolveReport report = finished(status, perturbed(*complex, solved.state, 0.01), no_multipliers);
    EXPECT_EQ(report.status, status);
    EXPECT_LE(off_plane(*complex, report.state), 1e-9);
  }
}

// Nothing is projected any more when nobody wants it: then the report says that it is not planar.
TEST_F(FinishSolve, AnAbandonedSolveSaysWhatItLeft) {
  std::stop_source abandoned;
  abandoned.request_stop();
  SolveOptions options;
  options.abandoned = abandoned.get_token();
  SolveReport report;
  report.status = SolveStatus::Converged;
  const State off = perturbed(*complex, solved.state, 0.05);
  finish_solve(*problem, problem->from_state(off), no_multipliers, options, report);
  EXPECT_EQ(report.status, SolveStatus::NotPlanar);
  EXPECT_NEAR(report.incidence_residual, off_plane(*complex, off), 1e-9);
  EXPECT_GT(report.constraints[0].violated, 0);
}

}  // namespace
}  // namespace planewright
