// Pins of points and of panels.
#include "core/problem/demands/pins.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

Shape far_grid() {
  Shape shape = twisted_grid(4, 3);
  shape.positions.rowwise() += Eigen::RowVector3d(200, -300, 50);
  return shape;
}

void expect_usage(const SharedComplex& complex, const ProblemSettings& settings, const std::string& word) {
  const auto problem = Problem::create(complex, settings);
  ASSERT_FALSE(problem) << word;
  EXPECT_EQ(problem.error().code, ErrorCode::Usage);
  EXPECT_NE(problem.error().text().find(word), std::string::npos) << problem.error().text();
}

TEST(Pins, AreAbsoluteModelCoordinates) {
  const Shape shape = far_grid();
  const SharedComplex complex = planarize_of(shape.mesh());
  const Vector3d at = shape.positions.row(7);
  ProblemSettings settings;
  settings.demands.pins = {{{PointKind::Vertex, 7}, {at[0], {}, at[2] + 0.5}}};
  const auto problem = Problem::create(complex, settings).value();
  EXPECT_TRUE(problem->has_demands());
  const auto rows = rows_of(*problem, "pin");
  ASSERT_EQ(rows.size(), 2u);
  const Vector values = row_values(*problem, initial_state(*complex));
  const double expected[] = {0.0, -0.5 / complex->mean_edge};
  for (size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(problem->row_element(rows[k]), (ElementRef{ElementKind::Point, 7}));
    EXPECT_EQ(problem->bounds(rows[k]).low, problem->bounds(rows[k]).high);
    EXPECT_NEAR(values[rows[k]] - problem->bounds(rows[k]).low, expected[k], 1e-12);
  }
}

TEST(Pins, OfEveryKindOfPoint) {
  const SharedComplex complex = dual_of(domed_triangle_grid(3, 2).mesh(), {0.1});
  ProblemSettings settings;
  for (const PointOrigin& origin : complex->point_origin)
    settings.demands.pins.push_back(Pin{origin, {std::nullopt, std::nullopt, 0.0}});
  const auto problem = Problem::create(complex, settings).value();
  const auto rows = rows_of(*problem, "pin");
  ASSERT_EQ(static_cast<int>(rows.size()), complex->point_count());
  const Vector values = row_values(*problem, initial_state(*complex));
  for (size_t j = 0; j < rows.size(); ++j) {
    EXPECT_EQ(problem->row_element(rows[j]), (ElementRef{ElementKind::Point, static_cast<int>(j)}));
    EXPECT_NEAR((values[rows[j]] - problem->bounds(rows[j]).low) * complex->mean_edge,
                complex->preferred(static_cast<Eigen::Index>(j), 2) + complex->origin.z(), 1e-12);
  }
}

TEST(Pins, OfWhatIsNotThereAreRefused) {
  const SharedComplex complex = planarize_of(far_grid().mesh());
  ProblemSettings settings;
  settings.demands.pins = {{{PointKind::Vertex, 999}, {0.0, 0.0, 0.0}}};
  expect_usage(complex, settings, "vertex 999");
  settings.demands.pins = {{{PointKind::Corner, 0}, {0.0, 0.0, 0.0}}};
  expect_usage(complex, settings, "the corner at vertex 0");
  settings.demands.pins = {{{PointKind::Vertex, 3}, {}}};
  expect_usage(complex, settings, "no coordinate");
  settings.demands.pins = {{{PointKind::Vertex, 3}, {std::numeric_limits<double>::infinity(), {}, {}}}};
  expect_usage(complex, settings, "no finite number");
  settings.demands.pins.clear();
  settings.demands.plane_pins = {{999, {}}};
  expect_usage(complex, settings, "face 999");
  settings.demands.plane_pins = {{3, PlanePin::Equation{{0, 0, 0}, 1.0}}};
  expect_usage(complex, settings, "face 3");
  settings.demands.plane_pins = {{3, PlanePin::Equation{{0, 0, 1}, std::nan("")}}};
  expect_usage(complex, settings, "face 3");
}

// A plane in absolute coordinates, from either side, of any length of its normal.
TEST(PlanePins, HoldNormalAndOffset) {
  const SharedComplex complex = planarize_of(far_grid().mesh());
  const Vector3d n = Vector3d(0.1, -0.2, 1.0).normalized();
  const Vector3d on = Vector3d(202, -299, 51);
  for (const double sign : {1.0, -1.0}) {
    ProblemSettings settings;
    settings.demands.plane_pins = {
        {5, PlanePin::Equation{{3 * sign * n[0], 3 * sign * n[1], 3 * sign * n[2]}, sign * n.dot(on)}}};
    const auto problem = Problem::create(complex, settings).value();
    const auto rows = rows_of(*problem, "plane pin");
    ASSERT_EQ(rows.size(), 3u);
    for (int r : rows) EXPECT_EQ(problem->row_element(r), (ElementRef{ElementKind::Panel, 5}));
    State state = initial_state(*complex);
    EXPECT_GT(violation(*problem, state, "plane pin"), 0.01);
    state.n.row(5) = n;
    state.h[5] = n.dot(on - complex->origin - complex->anchors.row(5).transpose());
    EXPECT_LT(violation(*problem, state, "plane pin"), 1e-12);
    State off = state;
    off.h[5] += 0.1;
    EXPECT_NEAR(violation(*problem, off, "plane pin"), 0.1 / complex->mean_edge, 1e-12);
    off = state;
    off.n.row(5) = (n + 0.1 * n.unitOrthogonal()).normalized();
    EXPECT_GT(violation(*problem, off, "plane pin"), 0.05);
  }
}

TEST(PlanePins, WithoutAnEquationHoldThePlaneAtTheStart) {
  const SharedComplex complex = dual_of(domed_triangle_grid(3, 2).mesh(), {0.1});
  ProblemSettings settings;
  settings.demands.plane_pins = {{4, {}}};
  const auto problem = Problem::create(complex, settings).value();
  EXPECT_LT(violation(*problem, initial_state(*complex), "plane pin"), 1e-14);
  EXPECT_GT(violation(*problem, perturbed(*complex, 0.1), "plane pin"), 1e-3);
}

TEST(Pins, HaveRightDerivatives) {
  for (const auto& [what, complex] : small_complexes()) {
    ProblemSettings settings;
    settings.demands.pins = {{complex->point_origin[1], {0.1, {}, {}}}};
    settings.demands.plane_pins = {{complex->plane_origin[0], {}}};
    expect_right_derivatives(complex, settings, what);
  }
}

TEST(Pins, AreMetByASolve) {
  const SharedComplex complex = dual_of(make_sample("dome", 80).value());
  const double edge = complex->mean_edge;
  ProblemSettings settings;
  const Vector3d at =
      complex->preferred.row(20).transpose() + complex->origin + Vector3d(0.1, -0.1, 0.1) * edge;
  settings.demands.pins = {{complex->point_origin[20], {at[0], at[1], at[2]}}};
  const Vector3d n = (Vector3d(complex->normals.row(5)) + 0.1 * Vector3d::UnitX()).normalized();
  settings.demands.plane_pins = {
      {complex->plane_origin[5],
       PlanePin::Equation{{n[0], n[1], n[2]},
                          n.dot(complex->anchors.row(5).transpose() + complex->origin) + 0.1 * edge}}};
  const auto free = problem_of(complex, {{"position", 1.0}});
  const auto problem = Problem::create(complex, settings).value();
  const State before = solve(*free).state;
  const State after = solve(*problem).state;
  for (const char* name : {"pin", "plane pin"}) {
    EXPECT_GT(violation(*problem, before, name), 0.05) << name;
    EXPECT_LE(violation(*problem, after, name), kMet) << name;
  }
  EXPECT_LE(off_plane(*complex, after), 1e-9);
  EXPECT_LT((after.x.row(20).transpose() + complex->origin - at).norm(), 2 * kMet * edge);
  EXPECT_LT((after.n.row(5).transpose() - n).norm(), 1e-7);
}

}  // namespace
}  // namespace planewright
