// What the badge says in each state that a solve can be in.
#include "ui/solve_badge.h"

#include <gtest/gtest.h>

namespace planewright::ui {
namespace {

using Tone = SolveBadge::Tone;

SolveReport report_by(const std::string& solver, SolveStatus status = SolveStatus::Converged) {
  SolveReport report;
  report.solver = solver;
  report.status = status;
  report.iterations = 14;
  report.seconds = 0.42;
  report.first_order_residual = 2e-5;
  return report;
}

// Panels of the tangent solver, planar to rounding.
SolveStanding tangent_panels() {
  SolveStanding standing;
  standing.made_by = "tangent";
  standing.planarity = 2e-10;
  standing.planarity_tolerance = 1e-6;
  return standing;
}

std::string value_of(const SolveBadge& badge, const std::string& name) {
  for (const auto& [key, value] : badge.details) {
    if (key == name) return value;
  }
  return "absent";
}

TEST(SolveBadge, NothingToSay) {
  EXPECT_TRUE(solve_badge({}, "m").headline.empty());
}

TEST(SolveBadge, Opening) {
  SolveStanding standing = tangent_panels();
  standing.opening = "roof.obj";
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Opening roof.obj");
  EXPECT_EQ(badge.tone, Tone::Busy);
  EXPECT_TRUE(badge.planarity.empty()) << "of the design before";
}

TEST(SolveBadge, BeforeTheFirstPanels) {
  SolveStanding standing;
  standing.solving = true;
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Solving");
  EXPECT_EQ(badge.tone, Tone::Busy);
}

TEST(SolveBadge, Live) {
  SolveStanding standing = tangent_panels();
  standing.solving = true;
  standing.milliseconds_per_step = 31;
  EXPECT_EQ(solve_badge(standing, "m").pace, "31 ms/step") << "also before the first step of the next solve";
  Iteration step;
  step.number = 3;
  step.seconds = 0.093;
  step.first_order = 0.01;
  standing.newest = &step;
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Tangent, live");
  EXPECT_EQ(badge.tone, Tone::Busy);
  EXPECT_EQ(badge.planarity, "planar to 2e-10 m");
  EXPECT_EQ(badge.pace, "31 ms/step");
  EXPECT_EQ(value_of(badge, "First-order residual"), "0.01");
  EXPECT_EQ(value_of(badge, "Planarity, worst"), "2e-10 m");
  EXPECT_EQ(value_of(badge, "Steps"), "3");
  EXPECT_EQ(value_of(badge, "Time"), "93 ms");
}

TEST(SolveBadge, Converged) {
  const SolveReport report = report_by("tangent");
  SolveStanding standing = tangent_panels();
  standing.report = &report;
  const SolveBadge badge = solve_badge(standing, "mm");
  EXPECT_EQ(badge.headline, "Tangent, converged");
  EXPECT_EQ(badge.tone, Tone::Good);
  EXPECT_EQ(badge.planarity, "planar to 2e-10 mm");
  EXPECT_EQ(badge.pace, "14 steps, 420 ms");
  EXPECT_EQ(value_of(badge, "First-order residual"), "2e-05");
  EXPECT_EQ(value_of(badge, "Steps"), "14");
}

TEST(SolveBadge, Polishing) {
  const SolveReport report = report_by("tangent");
  SolveStanding standing = tangent_panels();
  standing.report = &report;
  standing.solving = standing.polishing = true;
  EXPECT_EQ(solve_badge(standing, "m").headline, "Polishing with Ipopt");
  Iteration step;
  step.number = 12;
  step.seconds = 3.44;
  standing.newest = &step;
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Polishing with Ipopt");
  EXPECT_EQ(badge.tone, Tone::Busy);
  EXPECT_EQ(badge.planarity, "planar to 2e-10 m") << "of the panels that stay in view";
  EXPECT_EQ(badge.pace, "step 12, 3.4 s");
}

TEST(SolveBadge, ConfirmedWhoeverIsNamed) {
  for (const char* solver : {"tangent, ipopt", "ipopt"}) {
    const SolveReport report = report_by(solver);
    SolveStanding standing = tangent_panels();
    standing.made_by = solver;
    standing.report = &report;
    standing.polished = true;
    const SolveBadge badge = solve_badge(standing, "m");
    EXPECT_EQ(badge.headline, "Ipopt, confirmed");
    EXPECT_EQ(badge.tone, Tone::Confirmed);
  }
}

TEST(SolveBadge, EveryOtherEndIsAWarning) {
  const std::pair<SolveStatus, const char*> ends[] = {
      {SolveStatus::Planar, "Tangent, not converged"}, {SolveStatus::Stopped, "Tangent, stopped"},
      {SolveStatus::NotPlanar, "Tangent, not planar"}, {SolveStatus::Infeasible, "Tangent, infeasible"},
      {SolveStatus::Failed, "Tangent, failed"},
  };
  for (const auto& [status, headline] : ends) {
    SolveReport report = report_by("tangent", status);
    report.stop_reason = "the limit was reached";
    SolveStanding standing = tangent_panels();
    standing.report = &report;
    const SolveBadge badge = solve_badge(standing, "m");
    EXPECT_EQ(badge.headline, headline);
    EXPECT_EQ(badge.tone, Tone::Warning);
    EXPECT_EQ(badge.explanation, "The limit was reached.");
  }
}

// A check mark on panels of another design would be a lie.
TEST(SolveBadge, AResultOfAnEarlierDesignIsNotConfirmed) {
  const SolveReport report = report_by("tangent, ipopt");
  SolveStanding standing = tangent_panels();
  standing.report = &report;
  standing.polished = standing.outdated = true;
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Ipopt, older than the design");
  EXPECT_EQ(badge.tone, Tone::Warning);
}

TEST(SolveBadge, ARefusedSolveLeavesPanelsInView) {
  const SolveBadge badge = solve_badge(tangent_panels(), "m");
  EXPECT_EQ(badge.headline, "Not solved");
  EXPECT_EQ(badge.tone, Tone::Warning);
}

TEST(SolveBadge, NotPlanarEnoughIsSaid) {
  SolveStanding standing = tangent_panels();
  standing.solving = true;
  standing.made_by = "ipopt";
  standing.planarity = 0.01;
  const SolveBadge badge = solve_badge(standing, "m");
  EXPECT_EQ(badge.headline, "Ipopt, live");
  EXPECT_EQ(badge.planarity, "planarity 0.01 m");
}

TEST(SolveBadge, TheSolverWorksOnAnotherLayer) {
  SolveStanding standing = tangent_panels();
  standing.solving = true;
  standing.other_layer = "inner";
  EXPECT_EQ(solve_badge(standing, "m").headline, "Solving inner");
  standing.polishing = true;
  EXPECT_EQ(solve_badge(standing, "m").headline, "Polishing inner");
}

TEST(SolveBadge, ReportsNameEverySolver) {
  EXPECT_EQ(solver_line(report_by("tangent")), "Tangent");
  EXPECT_EQ(solver_line(report_by("ipopt")), "Ipopt");
  EXPECT_EQ(solver_line(report_by("tangent, ipopt")), "Tangent, confirmed by Ipopt");
  EXPECT_EQ(solver_line(report_by("tangent, ipopt", SolveStatus::Planar)), "Tangent, then Ipopt");
  EXPECT_EQ(solver_line(report_by("")), "");
}

}  // namespace
}  // namespace planewright::ui
