// Small meshes with known counts, for tests of every folder.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/mesh/polygon_mesh.h"

namespace planewright::test {

struct Shape {
  Points positions;
  Polygons faces;

  PolygonMesh mesh() const { return PolygonMesh::from_polygons(positions, faces).value(); }
};

inline Points make_points(std::initializer_list<std::array<double, 3>> rows) {
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  Eigen::Index i = 0;
  for (const auto& row : rows) points.row(i++) << row[0], row[1], row[2];
  return points;
}

// 4 vertices, 4 triangles, closed; outward.
inline Shape tetrahedron() {
  return {make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

// 8 vertices, 6 quads, closed; outward, edges of length 1.
inline Shape cube() {
  return {
      make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}),
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
}

// 6 vertices, 8 triangles, closed; outward.
inline Shape octahedron() {
  return {make_points({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}),
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

// columns x rows unit quads in the plane z = 0, upward; vertex (x, y) has index y * (columns + 1) + x.
inline Shape grid(int columns, int rows) {
  Shape shape;
  shape.positions.resize((columns + 1) * (rows + 1), 3);
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) shape.positions.row(y * (columns + 1) + x) << x, y, 0;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const int a = y * (columns + 1) + x, above = a + columns + 1;
      shape.faces.push_back(std::array{a, a + 1, above + 1, above});
    }
  return shape;
}

// The same grid with every quad cut from its first to its third corner.
inline Shape triangle_grid(int columns, int rows) {
  const Shape quads = grid(columns, rows);
  Shape shape{quads.positions, {}};
  for (int f = 0; f < quads.faces.size(); ++f) {
    const auto q = quads.faces[f];
    shape.faces.push_back(std::array{q[0], q[1], q[2]});
    shape.faces.push_back(std::array{q[0], q[2], q[3]});
  }
  return shape;
}

// n triangles round vertex 0 at height 1, the others on the unit circle: closed round the hub, or (open)
// without the last triangle.
inline Shape fan(int n, bool open = false) {
  Shape shape;
  shape.positions.resize(n + 1, 3);
  shape.positions.row(0) << 0, 0, 1;
  for (int k = 0; k < n; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / n;
    shape.positions.row(k + 1) << std::cos(angle), std::sin(angle), 0;
  }
  for (int k = 0; k < (open ? n - 1 : n); ++k) shape.faces.push_back(std::array{0, 1 + k, 1 + (k + 1) % n});
  return shape;
}

}  // namespace planewright::test
