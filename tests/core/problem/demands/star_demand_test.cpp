#include "core/problem/demands/star_demand.h"

#include <gtest/gtest.h>

#include "core/problem/demands/star_rows.h"
#include "support/shape_demands.h"

namespace planewright {
namespace {

using namespace test;

const Demand kStar{"star", true, "", {}};

double value(const Problem& problem, const State& state, int row) {
  return constraint_values(problem, problem.from_state(state))[row];
}

// Its smallest value about s at the wanted points, steps at s left out.
double smallest(const TangentComplex& complex, int panel, const Vector3d& s, int own_point) {
  double least = 1e9;
  const auto corners = complex.panels[panel];
  for (size_t c = 0; c < corners.size(); ++c) {
    const int k = corners[c], l = corners[(c + 1) % corners.size()];
    if (k == own_point || l == own_point) continue;
    const Vector3d a = complex.preferred.row(k).transpose() - s, b = complex.preferred.row(l).transpose() - s;
    least = std::min(least, complex.normals.row(panel).dot(a.cross(b)));
  }
  return least;
}

// 3 x 2, mean edge 2.5: each triangle about the middle has a quarter of the area 6.
TEST(StarDemand, MeasuresTrianglesAboutTheMean) {
  const auto problem =
      with_demand(planarize_of(flat_polygon({{0, 0}, {3, 0}, {3, 2}, {0, 2}}).mesh()), kStar);
  const auto rows = rows_of(*problem, "star");
  ASSERT_EQ(rows.size(), 4u);
  const double size = std::sqrt(6.0) / 2.5;
  State state = initial_state(problem->complex());
  for (int row : rows) {
    EXPECT_NEAR(value(*problem, state, row), 0.5 * size, 1e-12);
    EXPECT_DOUBLE_EQ(problem->bounds(row).low, 1e-3 * size);
    EXPECT_GE(problem->bounds(row).high, kNoLimit);
    EXPECT_EQ(problem->row_element(row), (ElementRef{ElementKind::Panel, 0}));
    EXPECT_EQ(problem->row_unit(row), "edges");
  }
  EXPECT_EQ(violation(*problem, state, "star"), 0.0);

  // The third corner goes past the first: the mean moves to (1, 0.75) x (0, 0) and the steps at it turn
  // round.
  state.x.row(2) += Eigen::RowVector3d(-4, -3, 0);
  const Vector3d s = state.x.colwise().mean();
  for (size_t k = 0; k < 4; ++k) {
    const Vector3d a = state.x.row(static_cast<int>(k)).transpose() - s;
    const Vector3d b = state.x.row(static_cast<int>((k + 1) % 4)).transpose() - s;
    EXPECT_NEAR(value(*problem, state, rows[k]), (a.x() * b.y() - a.y() * b.x()) / 6.25 / size, 1e-12) << k;
  }
  EXPECT_GT(violation(*problem, state, "star"), 0.1);

  state = initial_state(problem->complex());
  state.n = -state.n;
  EXPECT_NEAR(violation(*problem, state, "star"), 0.501 * size, 1e-12);
}

TEST(StarDemand, TrianglesHaveOneRow) {
  const auto problem = with_demand(planarize_of(flat_polygon({{0, 0}, {1, 0}, {0, 1}}).mesh()), kStar);
  const auto rows = rows_of(*problem, "star");
  ASSERT_EQ(rows.size(), 1u);
  const double edge = problem->complex().mean_edge, size = std::sqrt(0.5) / edge;
  EXPECT_NEAR(value(*problem, initial_state(problem->complex()), rows[0]), 1.0 / (edge * edge) / size, 1e-12);
}

TEST(StarDemand, ReflexBordersTakeAPointOfTheirOwn) {
  const auto complex = dual_of(reflex_outline().mesh());
  const auto problem = with_demand(complex, kStar);
  EXPECT_EQ(violation(*problem, initial_state(*complex), "star"), 0.0);
  const auto corners = complex->panels[4];
  ASSERT_EQ(corners.size(), 6u);
  EXPECT_LE(smallest(*complex, 4, centroid(complex->preferred, corners), -1),
            1e-9);  // why the mean will not do
  const TriangleCentre centre = star_centre(problem->normalised(), 4, 1e-3);
  ASSERT_EQ(centre.points.size(), 1u);
  double best = smallest(*complex, 4, complex->anchors.row(4), -1);
  for (int j : corners) best = std::max(best, smallest(*complex, 4, complex->preferred.row(j), j));
  EXPECT_GT(best, 0.1);
  EXPECT_NEAR(smallest(*complex, 4, complex->preferred.row(centre.points[0]), centre.points[0]), best, 1e-12);
  int rows = 0;
  for (int row : rows_of(*problem, "star")) rows += problem->row_element(row).index == 4;
  EXPECT_EQ(rows, 4);  // six steps without the two at the centre
}

// A saw blade of four teeth that only its middle sees whole; one tooth is long and takes the mean away.
TEST(StarDemand, DualsMayTakeTheirAnchor) {
  TangentComplex complex = build_dual(fan(8).mesh()).value();
  const auto corners = complex.panels[0];
  ASSERT_EQ(corners.size(), 8u);
  for (int c = 0; c < 8; ++c) {
    const double radius = c == 1 ? 20.0 : c % 2 == 1 ? 3.0 : 0.4;
    const double degrees = c % 2 == 1 ? 45.0 * (c - 1) + 85.0 : 45.0 * c;
    const double angle = std::numbers::pi * degrees / 180.0;
    complex.preferred.row(corners[static_cast<size_t>(c)]) =
        complex.anchors.row(0) + radius * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0);
  }
  complex.normals.row(0) << 0, 0, 1;
  const Vector3d mean = centroid(complex.preferred, corners);
  ASSERT_LT(smallest(complex, 0, mean, -1), 0.0);
  for (int j : corners) ASSERT_LT(smallest(complex, 0, complex.preferred.row(j), j), 0.0);
  const TriangleCentre centre = star_centre(complex, 0, 1e-3);
  EXPECT_TRUE(centre.points.empty());
  EXPECT_EQ(centre.fixed, Vector3d(complex.anchors.row(0)));
  complex.kind = ComplexKind::Planarize;  // whose anchor is no candidate
  EXPECT_FALSE(star_centre(complex, 0, 1e-3).points.empty());
}

TEST(StarDemand, ManyPointsTakeAFixedCentreSoThatRowsStayShort) {
  for (const int points : {12, 13}) {
    const auto complex = dual_of(fan(points).mesh());
    const auto problem = with_demand(complex, kStar);
    std::vector<int> entries(static_cast<size_t>(problem->rows()), 0);
    for (int row : problem->jacobian_pattern().rows) ++entries[static_cast<size_t>(row)];
    int rows = 0;
    for (int row : rows_of(*problem, "star")) {
      if (problem->row_element(row).index != 0) continue;
      ++rows;
      EXPECT_EQ(entries[static_cast<size_t>(row)], points == 12 ? 39 : 9);
      EXPECT_GT(value(*problem, initial_state(*complex), row), problem->bounds(row).low);
    }
    EXPECT_EQ(rows, points);
  }
}

TEST(StarDemand, KeepsToItsSelection) {
  const auto complex = planarize_of(twisted_grid(3, 2).mesh());
  const auto problem = with_demand(complex, {"star", true, "some", {0.01}}, {{"some", {}, {}, {1, 4}}});
  const auto rows = rows_of(*problem, "star");
  ASSERT_EQ(rows.size(), 8u);
  for (size_t k = 0; k < 8; ++k) EXPECT_EQ(problem->row_element(rows[k]).index, k < 4 ? 1 : 4);
  EXPECT_NEAR(problem->bounds(rows[0]).low, 0.01 * panel_size(problem->normalised(), 1), 1e-15);
}

TEST(StarDemand, RefusesSharesThatAreNone) {
  const auto complex = planarize_of(cube().mesh());
  for (const double eps : {-0.1, 1.5}) {
    const auto problem = try_with_demand(complex, {"star", true, "", {eps}});
    ASSERT_FALSE(problem);
    EXPECT_EQ(problem.error().code, ErrorCode::Usage);
    EXPECT_NE(problem.error().text().find("'eps' of the demand 'star'"), std::string::npos);
  }
}

TEST(StarDemand, SizesHaveAFloor) {
  EXPECT_NEAR(panel_size(build_planarize(flat_polygon({{0, 0}, {3, 0}, {3, 2}, {0, 2}}).mesh()).value(), 0),
              std::sqrt(6.0), 1e-12);
  TangentComplex complex = build_planarize(grid(1, 1).mesh()).value();
  complex.preferred.row(2).swap(complex.preferred.row(3));  // two loops that cancel out
  EXPECT_NEAR(panel_size(complex, 0), 0.25 * (2.0 + 2.0 * std::sqrt(2.0)) / 4.0, 1e-12);
  complex.preferred.setZero();
  EXPECT_EQ(panel_size(complex, 0), 0.05);
}

TEST(StarDemand, Derivatives) {
  expect_derivatives(kStar);
}

TEST(StarDemand, IsMetByASolveThatViolatesItWithout) {
  for (const auto& [name, complex] :
       {NamedComplex{"pushed grid", planarize_of(pushed_grid().mesh())},
        NamedComplex{"rough grid", planarize_of(jittered(grid(4, 4), 0.25, 0.8, 1).mesh())},
        NamedComplex{"rough dual", dual_of(jittered(triangle_grid(4, 4), 0.2, 0.4, 1).mesh(), {0.1})}}) {
    const auto without = solve(*problem_of(complex, {{"position", 1.0}}));
    const auto problem = with_demand(complex, kStar);
    ASSERT_EQ(without.status, SolveStatus::Converged) << name;
    EXPECT_GT(violation(*problem, without.state, "star"), 1e-3) << name;
    const auto with = solve(*problem);
    EXPECT_EQ(with.status, SolveStatus::Converged) << name << ": " << with.stop_reason;
    EXPECT_LT(violation(*problem, with.state, "star"), 1e-6) << name;
    EXPECT_LT(off_plane(*complex, with.state), 1e-9) << name;
    EXPECT_TRUE(find_self_crossing(with.state.x, complex->panels).empty()) << name;
  }
}

}  // namespace
}  // namespace planewright
