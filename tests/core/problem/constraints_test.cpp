// Incidence and unit normal rows by hand.
#include <gtest/gtest.h>

#include "core/problem/incidence_constraint.h"
#include "core/problem/unit_normal_constraint.h"
#include "support/problems.h"

namespace planewright {
namespace {

using namespace test;

class IncidenceConstraintTest : public testing::Test {
 protected:
  // Planes 0 (left) and 1 (right); points 0 {0}, 1 {0, 1}, 2 {1}, 3 {0}, 4 {0, 1}, 5 {1}.
  TangentComplex complex = build_planarize(grid(2, 1).mesh()).value();
  Layout layout{6, 2, Freedom::NormalsAndOffsets};
  std::unique_ptr<Constraint> incidence = make_incidence_constraint(complex, layout);
};

TEST_F(IncidenceConstraintTest, RowsFollowPointsAndTheirPlanes) {
  ASSERT_EQ(incidence->rows(), 8);
  const std::vector<std::pair<int, int>> expected{{0, 0}, {1, 0}, {1, 1}, {2, 1},
                                                  {3, 0}, {4, 0}, {4, 1}, {5, 1}};
  for (int row = 0; row < 8; ++row) {
    const auto [j, i] = expected[static_cast<size_t>(row)];
    const auto stencil = incidence->stencil(row);
    EXPECT_EQ(std::vector<int>(stencil.begin(), stencil.end()),
              (std::vector{layout.x(j, 0), layout.x(j, 1), layout.x(j, 2), layout.n(i, 0), layout.n(i, 1),
                           layout.n(i, 2), layout.h(i)}))
        << row;
  }
}

TEST_F(IncidenceConstraintTest, ValueAndDerivatives) {
  const Vector3d v = complex.anchors.row(0), x(1.5, 2.5, 3.5), n(0.25, -0.5, 2.0);
  const double z[] = {x[0], x[1], x[2], n[0], n[1], n[2], 0.75};
  double slope[7], bend[3];
  EXPECT_DOUBLE_EQ(incidence->evaluate(0, z, slope, bend), n.dot(x - v) - 0.75);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(slope[c], n[c]);
    EXPECT_DOUBLE_EQ(slope[3 + c], x[c] - v[c]);
    EXPECT_EQ(bend[c], 1.0);
    const StencilPair pair = incidence->curvature(0)[static_cast<size_t>(c)];
    EXPECT_EQ(pair.first, 3 + c);
    EXPECT_EQ(pair.second, c);
  }
  EXPECT_EQ(slope[6], -1.0);
}

// The sign: a positive offset lifts the plane along its normal.
TEST_F(IncidenceConstraintTest, PositiveOffsetLiftsAlongTheNormal) {
  const Vector3d v = complex.anchors.row(1), n = Vector3d(1, 2, 2) / 3.0;
  const double h = 0.6;
  const Vector3d lifted = v + h * n + Vector3d(2, -1, 0);  // (2, -1, 0) lies in the plane
  const double z[] = {lifted[0], lifted[1], lifted[2], n[0], n[1], n[2], h};
  EXPECT_NEAR(incidence->evaluate(2, z, nullptr, nullptr), 0.0, 1e-15);
  const double lowered[] = {lifted[0], lifted[1], lifted[2], n[0], n[1], n[2], -h};
  EXPECT_NEAR(incidence->evaluate(2, lowered, nullptr, nullptr), 2 * h, 1e-15);
}

TEST(UnitNormalConstraint, ValueAndDerivatives) {
  const Layout layout{4, 3, Freedom::Normals};
  const auto unit_normal = make_unit_normal_constraint(layout);
  ASSERT_EQ(unit_normal->rows(), 3);
  const auto stencil = unit_normal->stencil(2);
  EXPECT_EQ(std::vector<int>(stencil.begin(), stencil.end()),
            (std::vector{layout.n(2, 0), layout.n(2, 1), layout.n(2, 2)}));
  const double n[] = {1.0, -2.0, 2.0};
  double slope[3], bend[3];
  EXPECT_DOUBLE_EQ(unit_normal->evaluate(2, n, slope, bend), 4.0);  // (9 - 1) / 2
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(slope[c], n[c]);
    EXPECT_EQ(bend[c], 1.0);
    EXPECT_EQ(unit_normal->curvature(2)[static_cast<size_t>(c)].first, c);
    EXPECT_EQ(unit_normal->curvature(2)[static_cast<size_t>(c)].second, c);
  }
  const double unit[] = {0.0, 0.6, -0.8};
  EXPECT_NEAR(unit_normal->evaluate(0, unit, nullptr, nullptr), 0.0, 1e-16);
}

}  // namespace
}  // namespace planewright
