#include "core/problem/fixed_planes_constraint.h"

#include <gtest/gtest.h>

#include <set>

#include "core/complex/explicit_intersection.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

int rows_of_point(const Problem& problem, int j) {
  std::set<int> rows;
  const SparsePattern& pattern = problem.jacobian_pattern();
  for (int k = 0; k < pattern.size(); ++k)
    if (pattern.columns[k] >= problem.layout().x(j, 0) && pattern.columns[k] <= problem.layout().x(j, 2))
      rows.insert(pattern.rows[k]);
  return static_cast<int>(rows.size());
}

// Where all planes of a point are the same, it may slide along it: one row, met by f_j.
TEST(FixedPlanes, AFlatPlaceKeepsItsWantedPoints) {
  const SharedComplex complex = dual_of(triangle_grid(3, 3).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Fixed);
  EXPECT_EQ(problem->rows(), complex->point_count());
  const Vector z = problem->from_state(initial_state(*complex));
  EXPECT_NEAR(constraint_values(*problem, z).cwiseAbs().maxCoeff(), 0.0, 1e-14);
  EXPECT_NEAR(problem->objective(z.data()), 0.0, 1e-25);
  // Sliding is free, leaving the plane is not.
  State state = initial_state(*complex);
  state.x.col(0).array() += 0.3;
  EXPECT_NEAR(constraint_values(*problem, problem->from_state(state)).cwiseAbs().maxCoeff(), 0.0, 1e-14);
  state.x.col(2).array() += 0.3;
  EXPECT_NEAR(constraint_values(*problem, problem->from_state(state)).cwiseAbs().minCoeff(),
              0.3 / complex->mean_edge, 1e-12);
}

TEST(FixedPlanes, HoldPointsAtTheirIntersection) {
  const SharedComplex complex = dual_of(icosahedron().mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Fixed);
  EXPECT_EQ(problem->rows(), 3 * complex->point_count());
  const TpiResult exact = explicit_intersection(*complex);
  ASSERT_TRUE(exact.failed.empty());
  EXPECT_NEAR(constraint_values(*problem, problem->from_state(exact.state)).cwiseAbs().maxCoeff(), 0.0,
              1e-13);
  const Vector off = constraint_values(*problem, problem->from_state(initial_state(*complex)));
  EXPECT_GT(off.cwiseAbs().maxCoeff(), 0.05);
}

// One plane, two planes, three planes: as many rows.
TEST(FixedPlanes, RowsAreTheDirectionsThatPlanesDetermine) {
  const SharedComplex complex = dual_of(fan(5).mesh());
  const auto problem = problem_of(complex, {{"position", 1.0}}, Freedom::Fixed);
  for (int j = 0; j < complex->point_count(); ++j)
    EXPECT_EQ(rows_of_point(*problem, j), complex->planes_of_point.valence(j)) << j;
  // The same residual in other words: zero on all planes, and only there.
  State state = initial_state(*complex);
  const Vector c = constraint_values(*problem, problem->from_state(state));
  const Eigen::MatrixXd slopes = jacobian(*problem, problem->from_state(state));
  // Rows are orthonormal per point, so stepping back along them lands on the planes.
  const Vector z = problem->from_state(state) - slopes.transpose() * c;
  const State on = problem->to_state({z.data(), static_cast<size_t>(z.size())});
  EXPECT_NEAR(off_plane(*complex, on), 0.0, 1e-13);
}

TEST(FixedPlanes, FourPlanesThatAgreeAreTaken) {
  const auto problem = problem_of(dual_of(cube().mesh()), {{"position", 1.0}}, Freedom::Fixed);
  EXPECT_EQ(problem->rows(), 3 * 6);
}

TEST(FixedPlanes, FourPlanesWithoutACommonPointAreRefusedByName) {
  const SharedComplex complex = planarize_of(twisted_grid(3, 3).mesh());
  const auto problem = Problem::create(complex, {Freedom::Fixed, {{"position", 1.0}}});
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Refused);
  EXPECT_NE(problem.error().what.find("4 points"), std::string::npos) << problem.error().text();
  EXPECT_EQ(problem.error().where, "point 5");  // the first inner vertex
  EXPECT_NE(problem.error().remedy.find("normals"), std::string::npos);
}

TEST(FixedPlanes, ParallelPlanesApartAreRefused) {
  TangentComplex complex = build_dual(triangle_grid(2, 2).mesh()).value();
  complex.offsets[4] = 0.5;  // the middle vertex's plane is lifted off the others
  const auto problem =
      Problem::create(std::make_shared<const TangentComplex>(complex), {Freedom::Fixed, {{"position", 1.0}}});
  ASSERT_FALSE(problem);
  EXPECT_EQ(problem.error().code, ErrorCode::Refused);
}

}  // namespace
}  // namespace planewright
