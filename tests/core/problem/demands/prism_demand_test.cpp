#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

double least_room(const Problem& problem, const State& state, int point) {
  const Vector values = row_values(problem, state);
  double least = kUnbounded;
  for (int r : rows_of(problem, "prism", {ElementKind::Point, point}))
    least = std::min(least, room(problem, values, r));
  return least;
}

// A right triangle: distances from its sides, at any height.
TEST(PrismDemand, IsTheDistanceFromTheSidesOfTheFace) {
  const Shape triangle{make_points({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}), {{0, 1, 2}}};
  const SharedComplex complex = dual_of(triangle.mesh());
  const auto problem = Problem::create(complex, demanding({demand("prism")})).value();
  ASSERT_EQ(rows_of(*problem, "prism", {ElementKind::Point, 0}).size(), 3u);
  State state = initial_state(*complex);
  const double edge = complex->mean_edge;
  for (const auto& [at, distance] :
       std::vector<std::pair<Vector3d, double>>{{{1, 1, 0}, 1.0},  // the centre of the circle inside
                                                {{1, 1, 5}, 1.0},
                                                {{2, 0.5, -3}, 0.5},
                                                {{0.25, 1, 0}, 0.25},
                                                {{4, 3, 1}, -2.4},  // beyond the long side
                                                {{1, -1, 0}, -1.0}}) {
    state.x.row(0) = at - complex->origin;
    EXPECT_NEAR(least_room(*problem, state, 0), distance / edge - 1e-4, 1e-12) << at.transpose();
  }
}

// Inside a polygon of any shape that is convex, whatever way it is turned in space.
TEST(PrismDemand, OfAConvexPolygonIsThePolygon) {
  Shape shape{Points(7, 3), {{0, 1, 2, 3, 4, 5, 6}}};
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.3, -0.5, 0.7, 0.4).normalized().toRotationMatrix();
  const auto corner = [](int k) { return Vector3d(2 * std::cos(0.9 * k), std::sin(0.9 * k), 0); };
  for (int k = 0; k < 7; ++k) shape.positions.row(k) = turn * corner(k);
  const SharedComplex complex = dual_of(shape.mesh());
  const auto problem = Problem::create(complex, demanding({demand("prism")})).value();
  ASSERT_EQ(rows_of(*problem, "prism", {ElementKind::Point, 0}).size(), 7u);
  State state = initial_state(*complex);
  EXPECT_GT(least_room(*problem, state, 0), 0.0);
  for (int k = 0; k < 7; ++k) {
    const Vector3d middle = 0.5 * (corner(k) + corner((k + 1) % 7));
    const Vector3d outwards = (corner((k + 1) % 7) - corner(k)).cross(Vector3d::UnitZ()).normalized();
    for (const double off : {-0.1, 0.1}) {
      state.x.row(0) = turn * (middle + off * outwards + Vector3d(0, 0, 1.5)) - complex->origin;
      EXPECT_NEAR(least_room(*problem, state, 0), -off / complex->mean_edge - 1e-4, 1e-9);
    }
  }
}

// An arrow head: the hull of its corners.
TEST(PrismDemand, OfAFaceThatIsNotConvexIsItsHull) {
  const Shape arrow{make_points({{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {0.5, 1, 0}}), {{0, 1, 2, 3}}};
  const SharedComplex complex = dual_of(arrow.mesh());
  const auto problem = Problem::create(complex, demanding({demand("prism")})).value();
  EXPECT_EQ(rows_of(*problem, "prism", {ElementKind::Point, 0}).size(), 3u);
  State state = initial_state(*complex);
  state.x.row(0) = Vector3d(0.25, 1, 0) - complex->origin;
  EXPECT_NEAR(least_room(*problem, state, 0), 0.25 / complex->mean_edge - 1e-4, 1e-12);
}

TEST(PrismDemand, OfABorderPointIsBetweenTheEndsOfItsEdge) {
  const Shape triangle{make_points({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}), {{0, 1, 2}}};
  const PolygonMesh mesh = triangle.mesh();
  const SharedComplex complex = dual_of(mesh);
  const auto problem = Problem::create(complex, demanding({demand("prism")})).value();
  State state = initial_state(*complex);
  for (int j = 0; j < complex->point_count(); ++j) {
    const PointOrigin& origin = complex->point_origin[j];
    const auto rows = rows_of(*problem, "prism", {ElementKind::Point, j});
    if (origin.kind == PointKind::Corner) {
      EXPECT_TRUE(rows.empty());
    }
    if (origin != PointOrigin{PointKind::BorderEdge, mesh.find_edge(0, 1)}) continue;
    ASSERT_EQ(rows.size(), 1u);
    for (const double x : {-0.5, 1.0, 3.5, 4.25}) {
      state.x.row(j) = Vector3d(x, 7, -2) - complex->origin;
      EXPECT_NEAR(least_room(*problem, state, j), std::min(x, 4.0 - x) / complex->mean_edge - 1e-4, 1e-12);
    }
  }
}

TEST(PrismDemand, LeavesRoomInSliversAndAsksNothingWithoutArea) {
  const Shape slivers{make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -1e-5, 0}}),
                      {{0, 1, 2}, {0, 2, 3}, {0, 4, 2}}};
  // The first has no area; the last is narrower than the margin.
  const Shape shape{slivers.positions, {{0, 2, 3}, {0, 4, 2}}};
  const SharedComplex complex = dual_of(shape.mesh());
  const auto problem = Problem::create(complex, demanding({demand("prism")})).value();
  for (int j : {0, 1}) EXPECT_GT(least_room(*problem, initial_state(*complex), j), 0.0);
  const Shape line{make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}), {{0, 1, 2}, {0, 2, 3}}};
  const auto flat = Problem::create(dual_of(line.mesh()), demanding({demand("prism")})).value();
  EXPECT_TRUE(rows_of(*flat, "prism", {ElementKind::Point, 0}).empty());
  EXPECT_EQ(rows_of(*flat, "prism", {ElementKind::Point, 1}).size(), 3u);
}

TEST(PrismDemand, KeepsToItsSelection) {
  const SharedComplex complex = dual_of(domed_triangle_grid(4, 3).mesh());
  const auto problem =
      Problem::create(complex, demanding({demand("prism", {}, "one")}, {{"one", {}, {}, {4}}})).value();
  EXPECT_EQ(rows_of(*problem, "prism").size(), 3u);
  EXPECT_EQ(rows_of(*problem, "prism", {ElementKind::Point, 4}).size(), 3u);
}

TEST(PrismDemand, HasRightDerivatives) {
  for (const auto& [what, complex] : small_complexes())
    if (complex->kind == ComplexKind::Dual)
      expect_right_derivatives(complex, demanding({demand("prism")}), what);
}

// Smoothness alone pulls points off their faces.
TEST(PrismDemand, IsMetByASolve) {
  Shape shape = shape_of(make_sample("saddle-roof", 80).value());
  std::mt19937 random(3);
  const double edge = dual_of(shape.mesh())->mean_edge;
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v)
    for (int c = 0; c < 2; ++c)
      shape.positions(v, c) += 0.8 * edge * (static_cast<double>(random()) / 4294967295.0 - 0.5);
  ProblemSettings settings = demanding({demand("prism")});
  settings.weights = {{"position", 0.001}, {"fairing", 1.0}};
  expect_demands_take_effect(dual_of(shape.mesh()), settings, 1e-2);
}

}  // namespace
}  // namespace planewright
