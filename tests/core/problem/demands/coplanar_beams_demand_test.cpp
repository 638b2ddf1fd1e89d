#include "core/problem/demands/coplanar_beams_demand.h"

#include <gtest/gtest.h>

#include "support/shape_demands.h"

namespace planewright {
namespace {

using namespace test;

const Demand kBeams{"coplanar-beams", true, "", {}};

FrozenGeometry beside(SharedComplex complex, State state) {
  FrozenGeometry frozen;
  frozen.neighbour =
      std::make_shared<const NeighbourLayer>(NeighbourLayer{std::move(complex), std::move(state)});
  return frozen;
}

// Largest distance of a beam's corner from the plane of its three others, by normals of its own.
double worst_beam(const TangentComplex& complex, const State& state, const State& other) {
  double worst = 0.0;
  for (const PanelEdge& edge : complex.panel_edges) {
    const Vector3d a = state.x.row(edge.a), b = state.x.row(edge.b), c = other.x.row(edge.a),
                   d = other.x.row(edge.b);
    worst = std::max(worst, std::abs((b - a).cross(c - a).normalized().dot(d - a)) / complex.mean_edge);
  }
  return worst;
}

TEST(CoplanarBeamsDemand, MeasuresHowFarACornerLiesOffThePlane) {
  const auto complex = planarize_of(grid(1, 1).mesh());
  State above = initial_state(*complex);
  above.x.col(2).array() += 1.0;
  const double twist = 0.5;
  above.x(1, 1) += twist;  // of edge 0-1
  const auto problem = with_demand(complex, kBeams, {}, beside(complex, above));
  const auto rows = rows_of(*problem, "coplanar-beams");
  ASSERT_EQ(rows.size(), 4u);
  const Vector values = constraint_values(*problem, problem->from_state(initial_state(*complex)));
  int twisted = 0;
  for (int row : rows) {
    EXPECT_EQ(problem->bounds(row).low, 0.0);
    EXPECT_EQ(problem->bounds(row).high, 0.0);
    ASSERT_EQ(problem->row_element(row).kind, ElementKind::PanelEdge);
    const PanelEdge& edge = complex->panel_edges[static_cast<size_t>(problem->row_element(row).index)];
    const bool first = edge.a + edge.b == 1;
    twisted += first;
    // d = (1, t, 0) against (a - a') x (b - b') of the square below: t / |d|, over the beam's width.
    const double expected = twist / std::sqrt(1.0 + twist * twist) / std::sqrt(1.0 + twist * twist / 4.0);
    EXPECT_NEAR(std::abs(values[row]), first ? expected : 0.0, 1e-12);
  }
  EXPECT_EQ(twisted, 1);
}

TEST(CoplanarBeamsDemand, IsRefusedWithoutALayerOfTheSamePanels) {
  const auto complex = dual_of(domed_triangle_grid(3, 2).mesh());
  const auto alone = try_with_demand(complex, kBeams);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().code, ErrorCode::Usage);
  EXPECT_NE(alone.error().text().find("needs another layer"), std::string::npos);
  for (const SharedComplex& other : {dual_of(domed_triangle_grid(3, 2).mesh(), {0.0, BorderPolicy::Interior}),
                                     planarize_of(domed_triangle_grid(3, 2).mesh())}) {
    const auto strange = try_with_demand(complex, kBeams, {}, beside(other, initial_state(*other)));
    ASSERT_FALSE(strange);
    EXPECT_EQ(strange.error().code, ErrorCode::Usage);
    EXPECT_NE(strange.error().text().find("other points or panels"), std::string::npos);
  }
}

TEST(CoplanarBeamsDemand, LeavesOutEdgesWithoutLengthAndUnselectedPanels) {
  const auto complex = planarize_of(grid(3, 1).mesh());
  State above = initial_state(*complex);
  above.x.col(2).array() += 0.2;
  above.x.row(1) = above.x.row(0);
  EXPECT_EQ(rows_of(*with_demand(complex, kBeams, {}, beside(complex, above)), "coplanar-beams").size(), 9u);
  const auto problem = with_demand(complex, {"coplanar-beams", true, "last", {}}, {{"last", {}, {}, {2}}},
                                   beside(complex, above));
  const auto rows = rows_of(*problem, "coplanar-beams");
  ASSERT_EQ(rows.size(), 4u);
  for (int row : rows) {
    const PanelEdge& edge = complex->panel_edges[static_cast<size_t>(problem->row_element(row).index)];
    EXPECT_TRUE(edge.left == 2 || edge.right == 2);
  }
}

TEST(CoplanarBeamsDemand, Derivatives) {
  expect_derivatives(kBeams, [](SharedComplex complex) {
    State other = perturbed(*complex, 0.1, 5);
    other.x += 0.3 * complex->mean_edge * Points::Random(other.x.rows(), 3);
    return beside(complex, other);
  });
}

TEST(CoplanarBeamsDemand, ASolveMakesBeamsFlatThatWereTwisted) {
  const Shape shape = jittered(domed_triangle_grid(3, 3, 0.1), 0.08, 0.03, 3);
  const auto inner = dual_of(shape.mesh()), outer = dual_of(shape.mesh(), {0.4});
  const State below = solve(*problem_of(inner, {{"position", 1.0}})).state;
  const auto without = solve(*problem_of(outer, {{"position", 1.0}}));
  EXPECT_GT(worst_beam(*outer, without.state, below), 0.01);
  const auto problem = with_demand(outer, kBeams, {}, beside(inner, below));
  EXPECT_GT(violation(*problem, without.state, "coplanar-beams"), 0.01);
  const auto with = solve(*problem);
  EXPECT_LT(violation(*problem, with.state, "coplanar-beams"), 1e-6) << with.stop_reason;
  EXPECT_LT(worst_beam(*outer, with.state, below), 1e-5);
  EXPECT_LT(off_plane(*outer, with.state), 1e-9);
}

}  // namespace
}  // namespace planewright
