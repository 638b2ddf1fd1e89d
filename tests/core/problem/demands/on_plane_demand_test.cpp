#include <gtest/gtest.h>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

TEST(OnPlaneDemand, IsTheDistanceFromThePlane) {
  Shape shape = twisted_grid(3, 2);
  shape.positions.rowwise() += Eigen::RowVector3d(100, -50, 20);
  const SharedComplex complex = planarize_of(shape.mesh());
  // The normal is made unit.
  const auto problem =
      Problem::create(
          complex, demanding({demand("on-plane", {101, -49, 20, 0, 3, 4}, "two")}, {{"two", {2, 5}, {}, {}}}))
          .value();
  const auto rows = rows_of(*problem, "on-plane");
  ASSERT_EQ(rows.size(), 2u);
  const Vector values = row_values(*problem, initial_state(*complex));
  for (size_t k = 0; k < 2; ++k) {
    const int v = k == 0 ? 2 : 5;
    EXPECT_EQ(problem->row_element(rows[k]), (ElementRef{ElementKind::Point, v}));
    const Vector3d off = shape.positions.row(v).transpose() - Vector3d(101, -49, 20);
    EXPECT_EQ(problem->bounds(rows[k]).low, problem->bounds(rows[k]).high);
    EXPECT_NEAR(values[rows[k]] - problem->bounds(rows[k]).low,
                (0.6 * off.y() + 0.8 * off.z()) / complex->mean_edge, 1e-12);
  }
}

TEST(OnPlaneDemand, NeedsADirection) {
  const SharedComplex complex = planarize_of(cube().mesh());
  const auto refused = Problem::create(complex, demanding({demand("on-plane", {0, 0, 0, 0, 0, 0})}));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Usage);
  EXPECT_NE(refused.error().what.find("on-plane"), std::string::npos);
  for (const double tiny : {1e-200, 1e-300, 1e200})
    EXPECT_TRUE(Problem::create(complex, demanding({demand("on-plane", {0, 0, 0, 0, 0, tiny})}))) << tiny;
}

TEST(OnPlaneDemand, HasRightDerivatives) {
  for (const auto& [what, complex] : small_complexes())
    expect_right_derivatives(complex, demanding({demand("on-plane", {0, 0, 0.1, 1, 2, 3})}), what);
}

// A roof's edge that has to lie on a slab; a dual's lowest points on the floor.
TEST(OnPlaneDemand, IsMetByASolve) {
  const Shape roof = twisted_grid(9, 6, 0.03);
  Selection edge{"edge", {}, {}, {}};
  for (int v = 0; v <= 9; ++v) edge.vertices.push_back(v);
  expect_demands_take_effect(planarize_of(roof.mesh()),
                             demanding({demand("on-plane", {0, 0, 0.1, 0, 0, 1}, "edge")}, {edge}), 1e-2);

  const PolygonMesh dome = make_sample("dome", 80).value();
  const SharedComplex complex = dual_of(dome);
  Selection floor{"floor", {}, {}, {}};
  for (int e = 0; e < dome.edge_count(); ++e)
    if (dome.edge(e).border()) floor.edges.push_back(e);
  const double ground = dome.positions().col(2).minCoeff();
  expect_demands_take_effect(
      complex, demanding({demand("on-plane", {0, 0, ground, 0, 0, 1}, "floor")}, {floor}), 1e-3);
}

}  // namespace
}  // namespace planewright
