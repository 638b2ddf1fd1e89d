#include "core/problem/demands/uncrossed_demand.h"

#include <gtest/gtest.h>

#include "core/problem/demands/star_rows.h"
#include "support/shape_demands.h"

namespace planewright {
namespace {

using namespace test;

const Demand kUncrossed{"uncrossed", true, "", {}};

// An arrow whose first corner is reflex.
Shape arrow() {
  return flat_polygon({{0, 0}, {-1, -1}, {2, 0}, {-1, 1}});
}

TEST(UncrossedDemand, MeasuresTheCornersOfQuads) {
  const auto complex = planarize_of(arrow().mesh());
  const auto problem = with_demand(complex, kUncrossed);
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::Panel);
  ASSERT_EQ(rows.size(), 4u);
  const Vector z = problem->from_state(initial_state(*complex));
  const Vector values = constraint_values(*problem, z);
  const double edge = complex->mean_edge, size = std::sqrt(2.0) / edge;  // of area 2
  const double expected[4] = {-2, 2, 6, 2};
  const std::vector<char> waived = problem->waived_at(z.data());
  for (size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(values[rows[c]], expected[c] / (edge * edge) / size, 1e-12) << c;
    EXPECT_NEAR(problem->bounds(rows[c]).low, 1e-3 * size, 1e-15);
    EXPECT_GE(problem->bounds(rows[c]).high, kNoLimit);
    EXPECT_EQ(waived[static_cast<size_t>(rows[c])], c % 2 == 0) << c;  // the second and fourth hold
  }
  EXPECT_EQ(std::count(waived.begin(), waived.end(), 1), 2);
  EXPECT_EQ(violation(*problem, initial_state(*complex), "uncrossed"), 0.0);
}

TEST(UncrossedDemand, TiesKeepTheFirstDiagonal) {
  const auto complex = planarize_of(grid(2, 2).mesh());
  const auto problem = with_demand(complex, kUncrossed);
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::Panel);
  ASSERT_EQ(rows.size(), 16u);
  State state = initial_state(*complex);
  state.x.setZero();
  for (const State& tied : {initial_state(*complex), state}) {
    const std::vector<char> waived = problem->waived_at(problem->from_state(tied).data());
    for (size_t c = 0; c < rows.size(); ++c) {
      EXPECT_EQ(waived[static_cast<size_t>(rows[c])], c % 2 == 1) << c;
      EXPECT_EQ(problem->row_element(rows[c]).index, static_cast<int>(c / 4));
    }
  }
}

// The theorem behind the rows, on quads of every kind in planes of every direction.
TEST(UncrossedDemand, SomeDiagonalHoldsExactlyWhereAQuadIsSimpleAndCounterClockwise) {
  const auto complex = planarize_of(grid(1, 1).mesh());
  const auto problem = with_demand(complex, {"uncrossed", true, "", {0.0, 0.0}});
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::Panel);
  std::mt19937 random(11);
  const auto next = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  State state = initial_state(*complex);
  int simple = 0, crossed = 0, clockwise = 0;
  for (int quad = 0; quad < 10000; ++quad) {
    const Vector3d normal = Vector3d(next(), next(), next()).normalized();
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    for (int j = 0; j < 4; ++j) state.x.row(j) = (next() * u + next() * v).transpose();
    state.n.row(0) = normal.transpose();
    const Vector z = problem->from_state(state);
    const Vector values = constraint_values(*problem, z);
    const std::vector<char> waived = problem->waived_at(z.data());
    bool holds = true;
    int left = 0;
    for (int row : rows) {
      if (waived[static_cast<size_t>(row)]) continue;
      ++left;
      holds = holds && values[row] > 0.0;
    }
    ASSERT_EQ(left, 2);
    const bool crosses = !find_self_crossing(state.x, complex->panels).empty();
    const bool turns_left = newell_vector(state.x, complex->panels[0]).dot(normal) > 0.0;
    ASSERT_EQ(holds, !crosses && turns_left) << quad << "\n" << state.x;
    ++(crosses ? crossed : turns_left ? simple : clockwise);
  }
  EXPECT_GT(simple, 2000);
  EXPECT_GT(crossed, 2000);
  EXPECT_GT(clockwise, 2000);
}

TEST(UncrossedDemand, HoldsEdgesToTheirDirection) {
  const auto complex = planarize_of(flat_polygon({{0, 0}, {3, 0}, {3, 2}, {0, 2}}).mesh());  // mean edge 2.5
  const auto problem = with_demand(complex, {"uncrossed", true, "", {1e-3, 0.2}});
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::PanelEdge);
  ASSERT_EQ(rows.size(), 4u);
  State state = initial_state(*complex);
  state.x.row(2) += Eigen::RowVector3d(-2, -3, 5);
  const Vector values = constraint_values(*problem, problem->from_state(state));
  for (int row : rows) {
    const PanelEdge& edge = complex->panel_edges[static_cast<size_t>(problem->row_element(row).index)];
    const bool along_x = edge.a + edge.b == 1 || edge.a + edge.b == 5;
    EXPECT_NEAR(problem->bounds(row).low, 0.2 * (along_x ? 1.2 : 0.8), 1e-12);
    EXPECT_TRUE(problem->row_is_linear(row));
    const bool moved = edge.a == 2 || edge.b == 2;
    const double shortened = !moved ? 0.0 : along_x ? 2.0 / 2.5 : 3.0 / 2.5;
    EXPECT_NEAR(values[row], (along_x ? 1.2 : 0.8) - shortened, 1e-12) << edge.a << edge.b;
  }
}

TEST(UncrossedDemand, EdgesWithoutLengthHaveNoDirection) {
  TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  complex.preferred.row(1) = complex.preferred.row(0) + Eigen::RowVector3d(5e-4, 0, 0);
  complex.panel_edges.clear();
  finish(complex);
  const auto problem = with_demand(std::make_shared<const TangentComplex>(complex), kUncrossed);
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::PanelEdge);
  EXPECT_EQ(rows.size(), complex.panel_edges.size() - 1);
  for (int row : rows) {
    const PanelEdge& edge = complex.panel_edges[static_cast<size_t>(problem->row_element(row).index)];
    EXPECT_NE(edge.a + edge.b, 1);
  }
}

TEST(UncrossedDemand, TrianglesHaveOnlyEdgesAndLargePanelsStars) {
  const auto triangles = with_demand(planarize_of(octahedron().mesh()), kUncrossed);
  EXPECT_TRUE(rows_of(*triangles, "uncrossed", ElementKind::Panel).empty());
  EXPECT_EQ(rows_of(*triangles, "uncrossed", ElementKind::PanelEdge).size(), 12u);

  const auto complex = planarize_of(honeycomb(2, 1).mesh());
  const auto problem = with_demand(complex, kUncrossed), star = with_demand(complex, {"star", true, "", {}});
  const auto rows = rows_of(*problem, "uncrossed", ElementKind::Panel), same = rows_of(*star, "star");
  ASSERT_EQ(rows.size(), 12u);
  ASSERT_EQ(same.size(), 12u);
  const Vector z = problem->from_state(perturbed(*complex, 0.3));
  const Vector values = constraint_values(*problem, z), star_values = constraint_values(*star, z);
  for (size_t k = 0; k < 12; ++k) {
    EXPECT_EQ(values[rows[k]], star_values[same[k]]);
    EXPECT_EQ(problem->bounds(rows[k]).low, star->bounds(same[k]).low);
  }
  const std::vector<char> waived = problem->waived_at(z.data());
  EXPECT_EQ(std::count(waived.begin(), waived.end(), 1), 0);
}

TEST(UncrossedDemand, KeepsToItsSelection) {
  const auto complex = planarize_of(twisted_grid(3, 1).mesh());
  const auto problem = with_demand(complex, {"uncrossed", true, "ends", {}}, {{"ends", {}, {}, {0, 2}}});
  std::vector<int> panels;
  for (int row : rows_of(*problem, "uncrossed", ElementKind::Panel))
    panels.push_back(problem->row_element(row).index);
  EXPECT_EQ(panels, (std::vector{0, 0, 0, 0, 2, 2, 2, 2}));
  const auto edges = rows_of(*problem, "uncrossed", ElementKind::PanelEdge);
  EXPECT_EQ(edges.size(), 8u);  // not the two that only the middle panel has
  for (int row : edges) {
    const PanelEdge& edge = complex->panel_edges[static_cast<size_t>(problem->row_element(row).index)];
    EXPECT_TRUE(edge.left == 0 || edge.left == 2 || edge.right == 0 || edge.right == 2);
  }
}

TEST(UncrossedDemand, RefusesSharesThatAreNone) {
  for (const std::vector<double>& values :
       {std::vector{-1e-3}, std::vector{2.0}, std::vector{1e-3, -0.1}, std::vector{1e-3, 1.1}}) {
    const auto problem = try_with_demand(planarize_of(cube().mesh()), {"uncrossed", true, "", values});
    ASSERT_FALSE(problem);
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_NE(problem.error().text().find(values.size() == 1 ? "'eps'" : "'kappa'"), std::string::npos);
  }
}

TEST(UncrossedDemand, Derivatives) {
  expect_derivatives(kUncrossed);
}

TEST(UncrossedDemand, UncrossesWhatASolveLeavesCrossed) {
  for (const auto& [name, complex] :
       {NamedComplex{"pushed grid", planarize_of(pushed_grid().mesh())},
        NamedComplex{"rough grid", planarize_of(jittered(grid(4, 4), 0.25, 0.8, 5).mesh())}}) {
    const auto without = solve(*problem_of(complex, {{"position", 1.0}}));
    EXPECT_EQ(without.status, SolveStatus::Converged) << name;
    EXPECT_FALSE(find_self_crossing(without.state.x, complex->panels).empty()) << name;
    const auto problem = with_demand(complex, kUncrossed);
    EXPECT_GT(violation(*problem, without.state, "uncrossed"), 0.05) << name;
    const auto with = solve(*problem);
    EXPECT_EQ(with.status, SolveStatus::Converged) << name << ": " << with.stop_reason;
    EXPECT_LT(violation(*problem, with.state, "uncrossed"), 1e-6) << name;
    EXPECT_LT(off_plane(*complex, with.state), 1e-9) << name;
    EXPECT_TRUE(find_self_crossing(with.state.x, complex->panels).empty()) << name;
    for (int i = 0; i < complex->panels.size(); ++i)
      EXPECT_GT(newell_vector(with.state.x, complex->panels[i]).dot(with.state.n.row(i)), 0.0) << name << i;
  }
}

// Planar panels with a reflex corner each are simple as they are: nothing may move, which it would if all
// four corners had to turn left.
TEST(UncrossedDemand, LeavesReflexQuadsAlone) {
  Shape shape = grid(2, 1);
  shape.positions(1, 0) = 1.6;  // the middle edge leans over so far that the right panel gets a notch
  shape.positions(1, 1) = 0.7;
  const auto complex = planarize_of(shape.mesh());
  const auto problem = with_demand(complex, kUncrossed);
  const Vector z = problem->from_state(initial_state(*complex));
  const Vector values = constraint_values(*problem, z);
  int reflex = 0;
  for (int row : rows_of(*problem, "uncrossed", ElementKind::Panel)) reflex += values[row] < -0.1;
  EXPECT_EQ(reflex, 1);
  const auto report = solve(*problem);
  EXPECT_EQ(report.status, SolveStatus::Converged) << report.stop_reason;
  EXPECT_LT(distance(*complex, report.state, initial_state(*complex)), 1e-6);
}

TEST(UncrossedDemand, KeepsEdgesOfDualsFromTurningRound) {
  const auto complex = dual_of(jittered(triangle_grid(4, 4), 0.2, 0.4, 2).mesh(), {0.1});
  const auto shortest = [&complex](const State& state) {
    double least = 1e9;
    for (const PanelEdge& edge : complex->panel_edges) {
      const Vector3d wanted = complex->preferred.row(edge.b) - complex->preferred.row(edge.a);
      least = std::min(least, wanted.dot(state.x.row(edge.b) - state.x.row(edge.a)) / wanted.squaredNorm());
    }
    return least;
  };
  EXPECT_LT(shortest(solve(*problem_of(complex, {{"position", 1.0}})).state), 0.08);
  const auto with = solve(*with_demand(complex, kUncrossed));
  EXPECT_EQ(with.status, SolveStatus::Converged) << with.stop_reason;
  EXPECT_GT(shortest(with.state), 0.1 - 1e-5);
}

}  // namespace
}  // namespace planewright
