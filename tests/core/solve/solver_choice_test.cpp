#include "core/solve/solver_choice.h"

#include <gtest/gtest.h>

#include <set>

#include "support/solves.h"

namespace planewright {
namespace {

using namespace test;

TEST(SolverChoice, FindsEverySolverByItsName) {
  std::set<std::string> names;
  for (const SolverKind kind : all_solvers()) {
    const auto found = find_solver(name(kind));
    ASSERT_TRUE(found) << name(kind);
    EXPECT_EQ(*found, kind);
    names.insert(name(kind));
  }
  EXPECT_EQ(names, (std::set<std::string>{"auto", "ipopt", "tangent"}));
}

TEST(SolverChoice, RefusesOtherNamesAndListsTheKnown) {
  for (const char* wrong : {"", "Ipopt", "tangent ", "newton", "auto,ipopt"}) {
    const auto found = find_solver(wrong);
    ASSERT_FALSE(found) << wrong;
    EXPECT_EQ(found.error().code, ErrorCode::Usage);
    EXPECT_NE(found.error().text().find(std::string("'").append(wrong).append("'")), std::string::npos);
    for (const SolverKind kind : all_solvers())
      EXPECT_NE(found.error().text().find(name(kind)), std::string::npos) << found.error().text();
  }
}

TEST(SolverChoice, MakesTheSolverThatWasAskedFor) {
  const auto problem = problem_of(sample_complex("dome", 40), {{"position", 1.0}});
  const std::map<SolverKind, std::string> signature{
      {SolverKind::Ipopt, "ipopt"}, {SolverKind::Tangent, "tangent"}, {SolverKind::Auto, "tangent, ipopt"}};
  for (const SolverKind kind : all_solvers()) {
    const auto solver = make_solver(kind);
    ASSERT_NE(solver, nullptr) << name(kind);
    const SolveReport report = solver->solve(*problem, initial_state(problem->complex()), {}, nullptr, {});
    EXPECT_EQ(report.solver, signature.at(kind));
    EXPECT_EQ(report.status, SolveStatus::Converged) << name(kind) << ": " << report.stop_reason;
    expect_sound(*problem, report, name(kind));
  }
}

}  // namespace
}  // namespace planewright
