// The rows that stars, corners and diagonals are made of, by hand.
#include "core/problem/demands/panel_triangle_rows.h"

#include <gtest/gtest.h>

#include <random>

#include "support/shapes.h"

namespace planewright {
namespace {

const Layout kLayout{6, 2, Freedom::NormalsAndOffsets};

double evaluate(const Constraint& rows, int row, const std::vector<double>& z) {
  std::vector<double> local;
  for (int v : rows.stencil(row)) local.push_back(z[static_cast<size_t>(v)]);
  return rows.evaluate(row, local.data(), nullptr, nullptr);
}

// A square of side 2 round (5, 7) in the plane z = 3, points 1, 2, 3, 4; plane 1 looks up.
std::vector<double> square() {
  std::vector<double> z(static_cast<size_t>(kLayout.size()), 0.5);
  const double at[4][2] = {{4, 6}, {6, 6}, {6, 8}, {4, 8}};
  for (int c = 0; c < 4; ++c) {
    z[static_cast<size_t>(kLayout.x(c + 1, 0))] = at[c][0];
    z[static_cast<size_t>(kLayout.x(c + 1, 1))] = at[c][1];
    z[static_cast<size_t>(kLayout.x(c + 1, 2))] = 3.0;
  }
  z[static_cast<size_t>(kLayout.n(1, 0))] = z[static_cast<size_t>(kLayout.n(1, 1))] = 0.0;
  z[static_cast<size_t>(kLayout.n(1, 2))] = 1.0;
  return z;
}

TEST(PanelTriangleRows, MeasuresTwiceTheTriangleAboutItsCentre) {
  PanelTriangleRows rows("star", "edges");
  const Bounds bounds{0.25, kUnbounded};
  const ElementRef element{ElementKind::Panel, 1};
  rows.add(kLayout, 1, 1, 2, {{1, 2, 3, 4}}, 3.0, bounds, element);  // the middle: half of 2 x 1
  rows.add(kLayout, 1, 2, 1, {{1, 2, 3, 4}}, 3.0, bounds, element);  // the other way round
  rows.add(kLayout, 1, 1, 2, {{4}}, 1.0, bounds, element);           // half the square
  rows.add(kLayout, 1, 1, 3, {{2}}, 1.0, bounds, element);           // clockwise
  rows.add(kLayout, 1, 1, 2, {{1, 4}}, 1.0, bounds, element);        // (4, 7)
  rows.add(kLayout, 1, 3, 4, {{}, Vector3d(5.5, 7.5, 20.0)}, 2.0, bounds, element);  // beside the plane
  const auto z = square();
  EXPECT_DOUBLE_EQ(evaluate(rows, 0, z), 3.0 * 2.0);
  EXPECT_DOUBLE_EQ(evaluate(rows, 1, z), -3.0 * 2.0);
  EXPECT_DOUBLE_EQ(evaluate(rows, 2, z), 4.0);
  EXPECT_DOUBLE_EQ(evaluate(rows, 3, z), -4.0);
  EXPECT_DOUBLE_EQ(evaluate(rows, 4, z), 2.0);
  EXPECT_DOUBLE_EQ(evaluate(rows, 5, z), 2.0 * 2.0 * 0.5);
  ASSERT_EQ(rows.rows(), 6);
  EXPECT_EQ(rows.name(), "star");
  EXPECT_EQ(rows.unit(), "edges");
  EXPECT_EQ(rows.bounds(0).low, 0.25);
  EXPECT_EQ(rows.element(0), element);
  EXPECT_EQ(rows.stencil(0).size(), 15u);
  EXPECT_EQ(rows.stencil(2).size(), 12u);
  EXPECT_EQ(rows.stencil(4).size(), 12u);
  EXPECT_EQ(rows.stencil(5).size(), 9u);
}

// Against differences, at a place where nothing is planar and nothing unit.
TEST(PanelTriangleRows, DerivativesOfEveryKindOfCentre) {
  PanelTriangleRows rows("star", "edges");
  for (const TriangleCentre& centre :
       {TriangleCentre{{0, 1, 2, 3, 4, 5}}, TriangleCentre{{5}}, TriangleCentre{{2, 4, 1}},
        TriangleCentre{{3, 1}}, TriangleCentre{{1, 2}}, TriangleCentre{{}, Vector3d(0.3, -0.2, 0.9)}})
    rows.add(kLayout, 0, 1, 2, centre, 1.7, {0, 0}, {});
  std::mt19937 random(3);
  for (int row = 0; row < rows.rows(); ++row) {
    const size_t size = rows.stencil(row).size();
    std::vector<double> local(size), slope(size), up(size), down(size);
    for (double& value : local) value = static_cast<double>(random()) / 4294967295.0 - 0.5;
    const auto pairs = rows.curvature(row);
    std::vector<double> bend(pairs.size());
    const double value = rows.evaluate(row, local.data(), slope.data(), bend.data());
    EXPECT_EQ(value, rows.evaluate(row, local.data(), nullptr, nullptr));
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(static_cast<int>(size), static_cast<int>(size));
    for (size_t k = 0; k < pairs.size(); ++k) {
      ASSERT_GE(pairs[k].first, pairs[k].second);
      ASSERT_LT(pairs[k].first, static_cast<int>(size));
      hessian(pairs[k].first, pairs[k].second) += bend[k];
    }
    for (size_t v = 0; v < size; ++v) {
      const double at = local[v], step = 1e-4;
      local[v] = at + step;
      const double above = rows.evaluate(row, local.data(), up.data(), nullptr);
      local[v] = at - step;
      const double below = rows.evaluate(row, local.data(), down.data(), nullptr);
      local[v] = at;
      EXPECT_NEAR(slope[v], (above - below) / (2 * step), 1e-10) << row << " " << v;
      for (size_t u = v; u < size; ++u)
        EXPECT_NEAR(hessian(static_cast<int>(u), static_cast<int>(v)), (up[u] - down[u]) / (2 * step), 1e-10)
            << row << " " << u << " " << v;
    }
  }
}

}  // namespace
}  // namespace planewright
