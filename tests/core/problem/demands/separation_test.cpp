#include "core/problem/demands/separation.h"

#include <gtest/gtest.h>

#include "support/demands.h"

namespace planewright {
namespace {

using namespace test;

// Half spaces in model units, relative to the complex's origin.
TEST(Separation, KeepsPointsInHalfSpaces) {
  Shape shape = twisted_grid(4, 3);
  shape.positions = (2.5 * shape.positions).rowwise() + Eigen::RowVector3d(30, 40, 50);
  const SharedComplex complex = planarize_of(shape.mesh());
  const Vector3d normal = Vector3d(1, -2, 2) / 3.0;
  FrozenGeometry frozen;
  frozen.separations = {{6, normal, normal.dot(complex->preferred.row(6)) + 0.25, 3},
                        {8, -normal, -normal.dot(complex->preferred.row(8)) - 0.5, 2}};
  const auto problem = Problem::create(complex, {}, frozen).value();
  EXPECT_TRUE(problem->has_demands());
  const auto rows = rows_of(*problem, kSeparationName);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(problem->row_element(rows[0]), (ElementRef{ElementKind::Panel, 3}));
  EXPECT_EQ(problem->row_element(rows[1]), (ElementRef{ElementKind::Panel, 2}));
  State state = initial_state(*complex);
  Vector values = row_values(*problem, state);
  EXPECT_NEAR(room(*problem, values, rows[0]), -0.25 / complex->mean_edge, 1e-12);
  EXPECT_NEAR(room(*problem, values, rows[1]), 0.5 / complex->mean_edge, 1e-12);
  for (int r : rows) EXPECT_EQ(problem->bounds(r).high, kUnbounded);

  // And a solve moves the point there.
  const State after = solve(*problem).state;
  EXPECT_LE(violation(*problem, after, kSeparationName), kMet);
  EXPECT_LE(off_plane(*complex, after), 1e-9);
}

}  // namespace
}  // namespace planewright
