#include "core/problem/demands/convex_demand.h"

#include <gtest/gtest.h>

#include "support/shape_demands.h"

namespace planewright {
namespace {

using namespace test;

const Demand kConvex{"convex", true, "", {}};

// An arrow whose first corner is reflex: at the wanted lengths the rows are the sines of the turns.
TEST(ConvexDemand, MeasuresTheSineOfEachTurn) {
  const auto complex = planarize_of(flat_polygon({{0, 0}, {-1, -1}, {2, 0}, {-1, 1}}).mesh());
  const auto problem = with_demand(complex, kConvex);
  const auto rows = rows_of(*problem, "convex");
  ASSERT_EQ(rows.size(), 4u);
  State state = initial_state(*complex);
  Vector values = constraint_values(*problem, problem->from_state(state));
  const double blunt = std::sqrt(2.0 * 10.0);  // of the product of a short and a long edge
  EXPECT_NEAR(values[rows[0]], -1.0, 1e-12);
  EXPECT_NEAR(values[rows[1]], 2.0 / blunt, 1e-12);
  EXPECT_NEAR(values[rows[2]], 0.6, 1e-12);
  EXPECT_NEAR(values[rows[3]], 2.0 / blunt, 1e-12);
  for (int row : rows) {
    EXPECT_EQ(problem->bounds(row).low, 1e-3);
    EXPECT_GE(problem->bounds(row).high, kNoLimit);
    EXPECT_EQ(problem->row_element(row), (ElementRef{ElementKind::Panel, 0}));
  }
  EXPECT_NEAR(violation(*problem, state, "convex"), 1.001, 1e-12);
  state.x(0, 0) -= 1.5;  // the notch bulges out
  EXPECT_EQ(violation(*problem, state, "convex"), 0.0);
  state.n = -state.n;
  EXPECT_GT(violation(*problem, state, "convex"), 0.5);
}

TEST(ConvexDemand, TrianglesHaveTheirStrictestRow) {
  const auto complex = planarize_of(flat_polygon({{0, 0}, {1, 0}, {0, 3}}).mesh());
  const auto problem = with_demand(complex, kConvex);
  const auto rows = rows_of(*problem, "convex");
  ASSERT_EQ(rows.size(), 1u);
  // Between the legs of lengths 3 and sqrt(10).
  EXPECT_NEAR(constraint_values(*problem, problem->from_state(initial_state(*complex)))[rows[0]],
              3.0 / (3.0 * std::sqrt(10.0)), 1e-12);
}

TEST(ConvexDemand, KeepsToItsSelectionAndSkipsPanelsOfTwoPoints) {
  const auto complex = planarize_of(honeycomb(3, 2).mesh());
  const auto problem = with_demand(complex, {"convex", true, "one", {0.02}}, {{"one", {}, {}, {3}}});
  const auto rows = rows_of(*problem, "convex");
  ASSERT_EQ(rows.size(), 6u);
  for (int row : rows) {
    EXPECT_EQ(problem->row_element(row).index, 3);
    EXPECT_EQ(problem->bounds(row).low, 0.02);
  }
  const auto cube_corners = with_demand(dual_of(cube().mesh()), kConvex);
  EXPECT_EQ(rows_of(*cube_corners, "convex").size(), 8u);
}

TEST(ConvexDemand, RefusesSinesThatAreNone) {
  const auto problem = try_with_demand(planarize_of(cube().mesh()), {"convex", true, "", {-1e-3}});
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Usage);
}

TEST(ConvexDemand, Derivatives) {
  expect_derivatives(kConvex);
}

TEST(ConvexDemand, IsMetByASolveThatViolatesItWithout) {
  for (const auto& [name, complex] :
       {NamedComplex{"pushed grid", planarize_of(pushed_grid().mesh())},
        NamedComplex{"rough dual", dual_of(jittered(triangle_grid(4, 4), 0.1, 0.1, 2).mesh(), {0.1})}}) {
    const auto without = solve(*problem_of(complex, {{"position", 1.0}}));
    const auto problem = with_demand(complex, kConvex);
    EXPECT_GT(violation(*problem, without.state, "convex"), 0.1) << name;
    const auto with = solve(*problem);
    EXPECT_EQ(with.status, SolveStatus::Converged) << name << ": " << with.stop_reason;
    EXPECT_LT(violation(*problem, with.state, "convex"), 1e-6) << name;
    EXPECT_LT(off_plane(*complex, with.state), 1e-9) << name;
    // Every corner of every panel turns left, seen along its own outline's normal.
    for (int i = 0; i < complex->panels.size(); ++i) {
      const auto corners = complex->panels[i];
      const Vector3d up = newell_vector(with.state.x, corners);
      EXPECT_GT(up.dot(with.state.n.row(i)), 0.0) << name << " " << i;
      for (size_t c = 0; c < corners.size(); ++c) {
        const Vector3d a = with.state.x.row(corners[c]),
                       b = with.state.x.row(corners[(c + 1) % corners.size()]),
                       d = with.state.x.row(corners[(c + 2) % corners.size()]);
        EXPECT_GT(up.dot((b - a).cross(d - b)), 0.0) << name << " " << i << " " << c;
      }
    }
  }
}

}  // namespace
}  // namespace planewright
