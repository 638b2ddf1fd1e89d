// Triangle and quad patterns in the parameter square or disc, and how many rows and columns make a wished
// number of panels. Internal to this folder: what the sample shapes are drawn on.
#pragma once

#include <functional>

#include "core/base/geometry.h"

namespace planewright {

// Faces run counter-clockwise in the (u, v) plane.
struct Pattern {
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> uv;  // #V x 2
  Polygons faces;
};

// Rows of vertices at v = -1 .. 1, `rows` strips with `columns` steps along u = -1 .. 1. In every other row
// the vertices stand half a step aside, so that the triangles are equilateral, and inner vertices have
// valence 6. Symmetric in u; for even `rows` also in v. rows, columns >= 1.
Pattern staggered_triangles(int rows, int columns);
// The same, with some diagonals flipped: with other_way(row, k), 0 <= k < columns, the two triangles on the
// k-th step of the unshifted row at strip `row` are cut the other way, and two of the four vertices round
// them have valence 7, two 5. These strips must not touch: flips share no triangle.
using OtherWay = std::function<bool(int row, int k)>;
Pattern staggered_triangles(int rows, int columns, const OtherWay& other_way);
int staggered_vertex_count(int rows, int columns);

// A regular grid on the same square, all diagonals the same way: no symmetry. rows, columns >= 1.
Pattern diagonal_triangles(int rows, int columns);

// A regular grid of quads on the same square. rows, columns >= 1.
Pattern quads(int rows, int columns);

// A disc of radius 1: a hexagon of triangles, ring by ring bent to circles. 1 + 3 rings (rings + 1) vertices.
Pattern hexagonal_disc(int rings);

// A closed torus, u and v both -1 .. 1 and periodic: rows x columns vertices; every other row half a step
// aside if `rows` is even. rows, columns >= 3.
Pattern torus_triangles(int rows, int columns);

struct GridSize {
  int rows, columns;
};

// The grid with about `panels` panels, count(rows, columns) of them, and about `columns_per_row` columns for
// each row. Rows are multiples of row_step, from least.rows on. `count` grows linearly with the columns.
GridSize fit_grid(int panels, double columns_per_row, GridSize least, int row_step,
                  const std::function<std::int64_t(std::int64_t, std::int64_t)>& count);

}  // namespace planewright
