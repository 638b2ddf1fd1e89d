#include "core/problem/demands/triple_product_rows.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace planewright {
namespace {

TEST(TripleProductRows, AreTheVolumeThatThreeVectorsSpan) {
  TripleProductRows rows("volume", "edges");
  const Vector3d p(1, 2, 3), d(0.5, -1, 2);
  rows.add(6, 0, p, d, {0.1, 0.2}, {ElementKind::Panel, 4});
  ASSERT_EQ(rows.rows(), 1);
  const auto stencil = rows.stencil(0);
  EXPECT_EQ(std::vector<int>(stencil.begin(), stencil.end()), (std::vector{6, 7, 8, 0, 1, 2}));
  EXPECT_EQ(rows.bounds(0).low, 0.1);
  EXPECT_EQ(rows.bounds(0).high, 0.2);
  EXPECT_EQ(rows.element(0), (ElementRef{ElementKind::Panel, 4}));

  const Vector3d k(2, 0, 1), l(-1, 4, 0);
  const double local[] = {2, 0, 1, -1, 4, 0};
  double gradient[6], curvature[6];
  Matrix3d spanned;
  spanned << k - p, l - p, d;
  EXPECT_NEAR(rows.evaluate(0, local, gradient, curvature), spanned.determinant(), 1e-13);
  EXPECT_NEAR((Eigen::Map<Vector3d>(gradient) - (l - p).cross(d)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((Eigen::Map<Vector3d>(gradient + 3) - d.cross(k - p)).norm(), 0.0, 1e-14);
  // The block d/dx_l d/dx_k is the matrix of v -> v x d, transposed or not: checked entry by entry.
  const auto pairs = rows.curvature(0);
  ASSERT_EQ(pairs.size(), 6u);
  for (size_t c = 0; c < 6; ++c) {
    ASSERT_GE(pairs[c].first, 3);
    ASSERT_LT(pairs[c].second, 3);
    EXPECT_EQ(curvature[c], Vector3d::Unit(pairs[c].first - 3).cross(d)[pairs[c].second]);
  }
}

}  // namespace
}  // namespace planewright
