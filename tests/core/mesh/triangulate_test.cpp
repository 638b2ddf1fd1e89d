#include "core/mesh/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "support/shapes.h"

namespace planewright {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

std::vector<int> all(Eigen::Index n) {
  std::vector<int> indices(static_cast<size_t>(n));
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

Vector3d vector_area(const Points& p, const Triangles& triangles) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& t : triangles) sum += newell_vector(p, t);
  return sum;
}

double area(const Points& p, const Triangles& triangles) {
  double sum = 0.0;
  for (const auto& t : triangles) sum += newell_vector(p, t).norm();
  return sum;
}

// Covers the polygon exactly: no triangle outside (areas add up without cancelling), all turned as the
// polygon.
void expect_exact_cover(const Points& p, const std::vector<int>& polygon) {
  const Triangles triangles = triangulate(p, polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const Vector3d whole = newell_vector(p, polygon);
  EXPECT_NEAR((vector_area(p, triangles) - whole).norm(), 0.0, 1e-9 * whole.norm());
  EXPECT_NEAR(area(p, triangles), whole.norm(), 1e-9 * whole.norm());
  for (const auto& t : triangles) EXPECT_GE(newell_vector(p, t).dot(whole), -1e-12 * whole.squaredNorm());
}

Points ring(int n, double inner, double outer) {
  Points p(n, 3);
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n, radius = k % 2 == 0 ? outer : inner;
    p.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0.0;
  }
  return p;
}

TEST(Triangulate, Triangle) {
  const Points p = test::make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_EQ(triangulate(p, std::array{2, 0, 1}), (Triangles{{2, 0, 1}}));
}

TEST(Triangulate, QuadTakesTheShorterDiagonal) {
  const Points p = test::make_points({{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}});
  EXPECT_EQ(triangulate(p, std::array{0, 1, 2, 3}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
  EXPECT_EQ(triangulate(p, std::array{1, 2, 3, 0}), (Triangles{{1, 2, 3}, {1, 3, 0}}));
}

TEST(Triangulate, ConcaveQuadTakesTheInnerDiagonal) {
  // A dart whose reflex corner is each of the four in turn.
  const Points p = test::make_points({{0, 0, 0}, {3, -1, 0}, {1, 0, 0}, {3, 1, 0}});
  for (int shift = 0; shift < 4; ++shift)
    expect_exact_cover(p, {shift, (shift + 1) % 4, (shift + 2) % 4, (shift + 3) % 4});
}

TEST(Triangulate, ConvexAndStarShapedPolygons) {
  for (int n : {5, 6, 14, 100, 5000}) {
    expect_exact_cover(ring(n, 1.0, 1.0), all(n));
    if (n % 2 == 0) expect_exact_cover(ring(n, 0.4, 1.0), all(n));
  }
}

TEST(Triangulate, ConcavePolygonsInAnyPlaneAndOrder) {
  // The letter E.
  const Points flat = test::make_points({{0, 0, 0},
                                         {3, 0, 0},
                                         {3, 1, 0},
                                         {1, 1, 0},
                                         {1, 2, 0},
                                         {2, 2, 0},
                                         {2, 3, 0},
                                         {1, 3, 0},
                                         {1, 4, 0},
                                         {3, 4, 0},
                                         {3, 5, 0},
                                         {0, 5, 0}});
  std::vector<int> corners = all(12);
  for (const Vector3d& axis : {Vector3d(1, 0, 0), Vector3d(1, 2, 3), Vector3d(0, -1, 0.1)}) {
    Points p = flat * Eigen::AngleAxisd(1.1, axis.normalized()).toRotationMatrix().transpose();
    p.rowwise() += Eigen::RowVector3d(1e3, -2e3, 5e2);
    expect_exact_cover(p, corners);
    std::reverse(corners.begin(), corners.end());
    expect_exact_cover(p, corners);
    std::rotate(corners.begin(), corners.begin() + 5, corners.end());
  }
}

TEST(Triangulate, CornersOnAStraightSide) {
  const Points p = test::make_points({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}});
  expect_exact_cover(p, all(6));
}

TEST(Triangulate, Spiral) {
  // A corridor that winds inwards: every ear is hidden from most of the rest.
  constexpr int n = 400;
  Points p(2 * n, 3);
  for (int k = 0; k < n; ++k) {
    const double angle = 0.1 * k, radius = 100.0 - 0.2 * k;
    p.row(k) << radius * std::cos(angle), radius * std::sin(angle), 0;
    p.row(2 * n - 1 - k) << (radius - 2.0) * std::cos(angle), (radius - 2.0) * std::sin(angle), 0;
  }
  expect_exact_cover(p, all(2 * n));
}

TEST(Triangulate, CombWithManyTeeth) {
  constexpr int teeth = 5000;
  Points p(4 * teeth, 3);
  for (int k = 0; k < teeth; ++k) {
    p.row(4 * k) << 2.0 * k, 1.0, 0.0;
    p.row(4 * k + 1) << 2.0 * k, 1000.0 + k % 7, 0.0;
    p.row(4 * k + 2) << 2.0 * k + 1.0, 1000.0 + k % 5, 0.0;
    p.row(4 * k + 3) << 2.0 * k + 1.0, k + 1 < teeth ? 1.0 : 0.0, 0.0;
  }
  p(0, 1) = 0.0;
  expect_exact_cover(p, all(4 * teeth));
}

TEST(Triangulate, NonPlanarPolygon) {
  Points p = ring(8, 1.0, 1.0);
  for (int k = 0; k < 8; ++k) p(k, 2) = k % 2 == 0 ? 0.1 : -0.1;
  const Triangles triangles = triangulate(p, all(8));
  ASSERT_EQ(triangles.size(), 6u);
  EXPECT_NEAR((vector_area(p, triangles) - newell_vector(p, all(8))).norm(), 0.0, 1e-12);
}

TEST(Triangulate, AlwaysGivesAllTriangles) {
  unsigned state = 5;
  auto random = [&] {
    return static_cast<double>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0;
  };
  for (int round = 0; round < 2000; ++round) {
    const int n = 3 + static_cast<int>(12.0 * random());
    Points p(n, 3);
    // Crossing, repeated and collinear corners included.
    for (int k = 0; k < n; ++k) p.row(k) << std::floor(4.0 * random()), std::floor(4.0 * random()), 0.0;
    const Triangles triangles = triangulate(p, all(n));
    ASSERT_EQ(static_cast<int>(triangles.size()), n - 2);
    EXPECT_NEAR((vector_area(p, triangles) - newell_vector(p, all(n))).norm(), 0.0, 1e-9);
  }
  EXPECT_EQ(triangulate(Points::Zero(6, 3), all(6)).size(), 4u);
}

TEST(Triangulate, HopelessLargePolygonsEnd) {
  constexpr int n = 4'000;
  Points p(n, 3);
  unsigned state = 5;
  for (int k = 0; k < n; ++k)
    for (int axis = 0; axis < 3; ++axis) p(k, axis) = (state = state * 1664525u + 1013904223u) >> 8;
  EXPECT_EQ(triangulate(p, all(n)).size(), static_cast<size_t>(n - 2));
}

}  // namespace
}  // namespace planewright
