// The outline's curve, and the demand that holds it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numeric>

#include "core/problem/demands/outline_curve.h"
#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

std::vector<int> round_trip(int n) {
  std::vector<int> all(static_cast<size_t>(n));
  std::iota(all.begin(), all.end(), 0);
  return all;
}
// A regular polygon with sides of length 1.
Points regular(int n) {
  Points points(n, 3);
  const double radius = 0.5 / std::sin(std::numbers::pi / n);
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    points.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
  }
  return points;
}

TEST(Outlines, RunAlongThePanels) {
  // 6 7 8
  // 3 4 5
  // 0 1 2
  EXPECT_EQ(outlines(*planarize_of(grid(2, 2).mesh())),
            (std::vector<std::vector<int>>{{0, 1, 2, 5, 8, 7, 6, 3}}));
  EXPECT_TRUE(outlines(*planarize_of(cube().mesh())).empty());
  // Two pieces that touch nowhere.
  Shape two = grid(1, 1);
  Points both(8, 3);
  both << two.positions, (two.positions.rowwise() + Eigen::RowVector3d(5, 0, 0)).eval();
  EXPECT_EQ(outlines(*planarize_of(Shape{both, {{0, 1, 3, 2}, {4, 5, 7, 6}}}.mesh())),
            (std::vector<std::vector<int>>{{0, 1, 3, 2}, {4, 5, 7, 6}}));
}

TEST(OutlineCurve, OfASquareHasFourSides) {
  const Shape square = grid(3, 2);
  const std::vector<int> outline = outlines(*planarize_of(square.mesh())).at(0);
  const OutlineCurve curve(square.positions, outline);
  ASSERT_EQ(curve.pieces().size(), 4u);
  int kinks = 0;
  for (size_t k = 0; k < outline.size(); ++k) {
    kinks += curve.is_kink(k);
    const CurvePiece& piece = curve.pieces()[static_cast<size_t>(curve.piece_of(k))];
    const Vector3d at = square.positions.row(outline[k]);
    EXPECT_NEAR((at - piece.start).norm() + (piece.end - at).norm(), piece.length(), 1e-14);
    EXPECT_EQ(curve.is_kink(k), (at - piece.start).norm() == 0.0);
  }
  EXPECT_EQ(kinks, 4);
  for (const CurvePiece& piece : curve.pieces()) {
    EXPECT_EQ(piece.before, -1);
    EXPECT_EQ(piece.after, -1);
    EXPECT_NEAR(piece.turn_at_start, 0.5 * std::numbers::pi, 1e-14);
  }
}

// 72 sides turn by 5 degrees each.
TEST(OutlineCurve, IsSmoothBelowFiveDegrees) {
  for (const auto& [n, kinks] : {std::pair{70, 70}, std::pair{75, 0}}) {
    const OutlineCurve curve(regular(n), round_trip(n));
    EXPECT_EQ(static_cast<int>(curve.pieces().size()), n);
    int found = 0;
    for (size_t k = 0; k < static_cast<size_t>(n); ++k) found += curve.is_kink(k);
    EXPECT_EQ(found, kinks);
  }
}

TEST(OutlineCurve, FollowsAPointAlongTheCurveButNotPastAKink) {
  const int n = 75;
  const Points points = regular(n);
  const OutlineCurve curve(points, round_trip(n));
  const int start = curve.piece_of(10);
  for (const int goal : {11, 12, 20, 9, 5, 0, 70}) {
    const Vector3d middle = 0.5 * (points.row(goal) + points.row((goal + 1) % n));
    EXPECT_EQ(curve.nearest_piece(start, middle), curve.piece_of(static_cast<size_t>(goal))) << goal;
  }
  // A hairpin: the other side is nearer, but lies behind kinks.
  const Points hairpin = make_points({{0, 0, 0}, {10, 0, 0}, {10, 0.1, 0}, {0, 0.1, 0}});
  const OutlineCurve narrow(hairpin, round_trip(4));
  EXPECT_EQ(narrow.nearest_piece(narrow.piece_of(0), Vector3d(5, 0.1, 0)), narrow.piece_of(0));
}

TEST(OutlineCurve, BearsPointsInOnePlace) {
  // Corners 1, 2 and 3 coincide, and so do the last and the first.
  const Points points = make_points({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}});
  const OutlineCurve curve(points, round_trip(6));
  ASSERT_EQ(curve.pieces().size(), 3u);
  for (size_t k : {1u, 2u, 3u}) {
    EXPECT_TRUE(curve.is_kink(k));
    EXPECT_EQ(curve.piece_of(k), curve.piece_of(1));
  }
  EXPECT_EQ(curve.piece_of(5), curve.piece_of(4));
  const OutlineCurve nowhere(Points::Zero(4, 3), round_trip(4));
  EXPECT_TRUE(nowhere.pieces().empty());
  EXPECT_EQ(nowhere.piece_of(2), -1);
  EXPECT_EQ(nowhere.nearest_piece(-1, Vector3d::Zero()), -1);
}

// Farthest of the border's points from the segments between wanted neighbours along the outline, mean edges.
double off_border(const TangentComplex& complex, const Points& curve, const State& state) {
  double worst = 0.0;
  for (const std::vector<int>& outline : outlines(complex))
    for (int j : outline) {
      double nearest = 1e9;
      for (size_t k = 0; k < outline.size(); ++k) {
        const Vector3d a = curve.row(outline[k]), b = curve.row(outline[(k + 1) % outline.size()]);
        const Vector3d x = state.x.row(j);
        const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + t * (b - a) - x).norm());
      }
      worst = std::max(worst, nearest);
    }
  return worst / complex.mean_edge;
}

// 3 x 2 quads in the plane: corners held, sides slide, in order.
TEST(BorderDemand, HoldsCornersAndLetsSidesSlide) {
  const SharedComplex complex = planarize_of(grid(3, 2).mesh());
  const auto problem = Problem::create(complex, demanding({demand("border")})).value();
  State state = initial_state(*complex);
  EXPECT_EQ(violation(*problem, state, "border"), 0.0);
  EXPECT_TRUE(rows_of(*problem, "border", {ElementKind::Point, 5}).empty());  // inside
  // 4 corners, 6 points on sides; order between neighbours on a side: 1-2 and 10-9.
  EXPECT_EQ(rows_of(*problem, "border").size(), 4u * 3 + 6 * 3 + 2);

  const auto moved = [&](int v, double x, double y, double z) {
    State s = state;
    s.x.row(v) += Eigen::RowVector3d(x, y, z);
    return violation(*problem, s, "border");
  };
  EXPECT_NEAR(moved(0, 0.2, 0, 0), 0.2, 1e-14);
  EXPECT_NEAR(moved(1, 0.2, 0, 0), 0.0, 1e-14);
  EXPECT_NEAR(moved(1, -0.9, 0, 0), 0.0, 1e-14);
  EXPECT_NEAR(moved(1, 1.5, 0, 0), 0.5 + 1e-4, 1e-14);     // past its neighbour
  EXPECT_NEAR(moved(1, -1.25, 0, 0), 0.25 + 1e-4, 1e-14);  // past the corner
  EXPECT_GT(moved(1, 0, 0.1, 0), 0.07);
  EXPECT_GT(moved(1, 0, 0, -0.1), 0.07);
  EXPECT_NEAR(moved(4, 0, -0.5, 0), 0.0, 1e-14);
  EXPECT_GT(moved(4, 0.1, 0, 0), 0.07);
  EXPECT_NEAR(moved(5, 1, 1, 1), 0.0, 1e-14);
}

TEST(BorderDemand, LiesWhereTheWantedPointsDo) {
  const Shape shape = twisted_grid(4, 3);
  const SharedComplex complex = planarize_of(shape.mesh(), {0.3});
  const auto problem = Problem::create(complex, demanding({demand("border")})).value();
  EXPECT_LT(violation(*problem, initial_state(*complex), "border"), 1e-12);
  const SharedComplex flat = planarize_of(shape.mesh());
  State below{flat->preferred, complex->normals, complex->offsets};
  EXPECT_GT(violation(*problem, below, "border"), 0.1);
}

TEST(BorderDemand, KeepsToItsSelection) {
  const SharedComplex complex = planarize_of(grid(3, 2).mesh());
  const auto problem =
      Problem::create(complex, demanding({demand("border", {}, "some")}, {{"some", {0, 1, 5}, {}, {}}}))
          .value();
  EXPECT_EQ(rows_of(*problem, "border").size(), 6u);
  EXPECT_EQ(rows_of(*problem, "border", {ElementKind::Point, 0}).size(), 3u);
  EXPECT_EQ(rows_of(*problem, "border", {ElementKind::Point, 1}).size(), 3u);
}

// A disc of triangles with 75 sides: points slide on; where one is tells which side it slides on next.
TEST(BorderDemand, FollowsThePointsFromRoundToRound) {
  const int n = 75;
  Shape disc{Points(n + 1, 3), {}};
  disc.positions << Eigen::RowVector3d::Zero(), regular(n);
  for (int k = 0; k < n; ++k) disc.faces.push_back(std::array{0, 1 + k, 1 + (k + 1) % n});
  const SharedComplex complex = planarize_of(disc.mesh());
  State state = initial_state(*complex);
  const auto on_side = [&](int side, double t) -> Eigen::RowVector3d {
    return (1 - t) * complex->preferred.row(1 + side % n) + t * complex->preferred.row(1 + (side + 1) % n);
  };
  const auto allows = [&](const State& at, const Eigen::RowVector3d& place) {
    FrozenGeometry frozen;
    frozen.at = &at;
    const auto problem = Problem::create(complex, demanding({demand("border")}), frozen).value();
    State s = at;
    s.x.row(1 + 10) = place;
    const Vector values = row_values(*problem, s);
    double worst = 0.0;
    for (int r : rows_of(*problem, "border", {ElementKind::Point, 1 + 10}))
      if (problem->jacobian_pattern().size() > 0) worst = std::min(worst, room(*problem, values, r));
    return worst > -1e-9;
  };
  // At the start: the side behind it. A little before its end, where it pushes on, shows the way back.
  EXPECT_TRUE(allows(state, on_side(10, 0.7)));
  EXPECT_FALSE(allows(state, on_side(9, 0.7)));
  State back = state;
  const Eigen::RowVector3d along = (on_side(10, 1.0) - on_side(10, 0.0)).normalized();
  back.x.row(11) -= 1e-5 * complex->mean_edge * along;
  EXPECT_TRUE(allows(state, back.x.row(11)));
  EXPECT_TRUE(allows(back, on_side(9, 0.7)));
  EXPECT_FALSE(allows(back, on_side(10, 0.7)));
  // Beyond the end of its side: the next one.
  State on = state;
  on.x.row(12) = on_side(11, 0.9);
  on.x.row(11) = on_side(10, 1.0) + 1e-5 * complex->mean_edge * along;
  EXPECT_TRUE(allows(on, on_side(11, 0.5)));
  EXPECT_FALSE(allows(on, on_side(10, 0.5)));
}

TEST(BorderDemand, OfADualHoldsCornersAndSlidesBetweenThem) {
  const PolygonMesh mesh = domed_triangle_grid(4, 3).mesh();
  const SharedComplex complex = dual_of(mesh, {0.2});
  const auto problem = Problem::create(complex, demanding({demand("border")})).value();
  std::map<int, Eigen::RowVector3d> corner;
  for (int j = 0; j < complex->point_count(); ++j)
    if (complex->point_origin[j].kind == PointKind::Corner)
      corner[complex->point_origin[j].element] = complex->preferred.row(j);
  State state = initial_state(*complex);
  for (int j = 0; j < complex->point_count(); ++j) {
    const PointOrigin& origin = complex->point_origin[j];
    const auto rows = rows_of(*problem, "border", {ElementKind::Point, j});
    EXPECT_EQ(rows.size(), origin.kind == PointKind::Face ? 0u : 3u);
    if (origin.kind != PointKind::BorderEdge) continue;
    const MeshEdge edge = mesh.edge(origin.element);
    const auto least = [&](double t, const Eigen::RowVector3d& off) {
      state.x.row(j) = (1 - t) * corner[edge.a] + t * corner[edge.b] + off;
      const Vector values = row_values(*problem, state);
      double worst = kUnbounded;
      for (int r : rows) worst = std::min(worst, room(*problem, values, r));
      return worst;
    };
    const Eigen::RowVector3d none(0, 0, 0);
    EXPECT_GT(least(0.3, none), -1e-12);
    EXPECT_GT(least(0.95, none), -1e-12);
    EXPECT_LT(least(1.1, none), -0.01);
    EXPECT_LT(least(-0.1, none), -0.01);
    EXPECT_LT(least(0.3, Eigen::RowVector3d(0, 0, 0.1)), -0.01);
  }
}

TEST(BorderDemand, OfADualNeedsTheClosedPolicy) {
  const auto refused =
      Problem::create(dual_of(domed_triangle_grid(4, 3).mesh(), {0.0, BorderPolicy::Interior}),
                      demanding({demand("border")}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Usage);
  EXPECT_NE(refused.error().remedy.find("closed"), std::string::npos);
  // A closed mesh has no border to hold.
  const auto closed = Problem::create(dual_of(icosahedron().mesh()), demanding({demand("border")}));
  ASSERT_TRUE(closed);
  EXPECT_TRUE(rows_of(**closed, "border").empty());
}

TEST(BorderDemand, HasRightDerivatives) {
  for (const auto& [what, complex] : small_complexes())
    if (!outlines(*complex).empty() && what.find("interior") == std::string::npos)
      expect_right_derivatives(complex, demanding({demand("border")}), what);
}

// A vault over a curved border, its inner vertices out of place.
TEST(BorderDemand, IsMetByASolveThatPlanarizes) {
  Shape vault = grid(9, 7);
  const PolygonMesh flat = vault.mesh();
  for (int v = 0; v < flat.vertex_count(); ++v) {
    const double x = vault.positions(v, 0) - 4.5, y = vault.positions(v, 1) - 3.5;
    vault.positions(v, 2) = -0.03 * x * x - 0.035 * y * y;
    if (!flat.is_border_vertex(v)) vault.positions(v, 2) += 0.05 * std::sin(2.0 * x + 3.0 * y);
  }
  const SharedComplex complex = planarize_of(vault.mesh());
  const State state = expect_demands_take_effect(complex, demanding({demand("border")}), 1e-4);
  EXPECT_LE(off_border(*complex, complex->preferred, state), 2e-6);
}

// A bulge over a floor with straight sides.
TEST(BorderDemand, IsMetByASolveOfADual) {
  Shape bulge = triangle_grid(8, 6);
  for (Eigen::Index v = 0; v < bulge.positions.rows(); ++v) {
    const double x = bulge.positions(v, 0) / 8, y = bulge.positions(v, 1) / 6;
    bulge.positions(v, 2) = 10.0 * x * (1 - x) * y * (1 - y) * (1.0 + x);
  }
  const SharedComplex complex = dual_of(bulge.mesh());
  const State state = expect_demands_take_effect(complex, demanding({demand("border")}), 1e-3);
  EXPECT_LE(off_border(*complex, complex->preferred, state), 2e-6);
}

}  // namespace
}  // namespace planewright
