#include "core/mesh/sample_grids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace planewright {
namespace {

// The k-th of n steps from -1 to 1; exactly antisymmetric, so that symmetric designs are so to the last bit.
double step(double k, int n) {
  return (2.0 * k - n) / n;
}

void add_triangle(Polygons& faces, int a, int b, int c) {
  faces.push_back(std::array{a, b, c});
}

}  // namespace

int staggered_vertex_count(int rows, int columns) {
  const int plain = rows / 2 + 1, shifted = (rows + 1) / 2;
  return plain * (columns + 1) + shifted * (columns + 2);
}

Pattern staggered_triangles(int rows, int columns) {
  return staggered_triangles(rows, columns, [](int, int) { return false; });
}

Pattern staggered_triangles(int rows, int columns, const OtherWay& other_way) {
  Pattern p;
  p.uv.resize(staggered_vertex_count(rows, columns), 2);
  p.faces.reserve(rows * (2 * columns + 1), 3 * rows * (2 * columns + 1));
  // A shifted row has its vertices at the middle of the steps, and both ends.
  int next = 0;
  std::vector<int> first(static_cast<size_t>(rows) + 1);
  for (int r = 0; r <= rows; ++r) {
    first[r] = next;
    const bool shifted = r % 2 == 1;
    const int count = shifted ? columns + 2 : columns + 1;
    for (int k = 0; k < count; ++k) {
      const double u = shifted ? std::clamp(step(k - 0.5, columns), -1.0, 1.0) : step(k, columns);
      p.uv.row(next++) << u, step(r, rows);
    }
  }
  for (int r = 0; r < rows; ++r) {
    // Below and above a step k of the plain row stand the shifted vertices k, k + 1 (and one more at the
    // end).
    const bool plain_below = r % 2 == 0;
    const int plain = plain_below ? first[r] : first[r + 1], shifted = plain_below ? first[r + 1] : first[r];
    for (int k = 0; k <= columns; ++k) {
      if (k < columns && other_way(r, k)) {
        if (plain_below) {
          add_triangle(p.faces, plain + k, plain + k + 1, shifted + k);
          add_triangle(p.faces, plain + k + 1, shifted + k + 1, shifted + k);
        } else {
          add_triangle(p.faces, shifted + k, shifted + k + 1, plain + k + 1);
          add_triangle(p.faces, shifted + k, plain + k + 1, plain + k);
        }
      } else if (plain_below) {
        add_triangle(p.faces, plain + k, shifted + k + 1, shifted + k);
        if (k < columns) add_triangle(p.faces, plain + k, plain + k + 1, shifted + k + 1);
      } else {
        add_triangle(p.faces, shifted + k, shifted + k + 1, plain + k);
        if (k < columns) add_triangle(p.faces, shifted + k + 1, plain + k + 1, plain + k);
      }
    }
  }
  return p;
}

Pattern quads(int rows, int columns) {
  Pattern p;
  p.uv.resize((rows + 1) * (columns + 1), 2);
  p.faces.reserve(rows * columns, 4 * rows * columns);
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) p.uv.row(r * (columns + 1) + c) << step(c, columns), step(r, rows);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * (columns + 1) + c, above = a + columns + 1;
      p.faces.push_back(std::array{a, a + 1, above + 1, above});
    }
  return p;
}

Pattern diagonal_triangles(int rows, int columns) {
  Pattern p = quads(rows, columns);
  const Polygons cells = std::move(p.faces);
  p.faces = {};
  p.faces.reserve(2 * cells.size(), 6 * cells.size());
  for (int f = 0; f < cells.size(); ++f) {
    const auto q = cells[f];
    add_triangle(p.faces, q[0], q[1], q[2]);
    add_triangle(p.faces, q[0], q[2], q[3]);
  }
  return p;
}

Pattern hexagonal_disc(int rings) {
  Pattern p;
  p.uv.resize(1 + 3 * rings * (rings + 1), 2);
  p.uv.row(0).setZero();
  auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < 6 * ring; ++k) {
      const double radius = static_cast<double>(ring) / rings, angle = std::numbers::pi * k / (3.0 * ring);
      p.uv.row(first(ring) + k) << radius * std::cos(angle), radius * std::sin(angle);
    }
  p.faces.reserve(6 * rings * rings, 18 * rings * rings);
  for (int ring = 1; ring <= rings; ++ring)
    for (int sector = 0; sector < 6; ++sector)
      for (int k = 0; k < ring; ++k) {
        // A sector has `ring` steps outside and ring - 1 inside.
        const int inner_count = std::max(1, 6 * (ring - 1));
        auto outer = [&](int j) { return first(ring) + (sector * ring + j) % (6 * ring); };
        auto inner = [&](int j) { return first(ring - 1) + (sector * (ring - 1) + j) % inner_count; };
        add_triangle(p.faces, inner(k), outer(k), outer(k + 1));
        if (k + 1 < ring) add_triangle(p.faces, inner(k), outer(k + 1), inner(k + 1));
      }
  return p;
}

Pattern torus_triangles(int rows, int columns) {
  Pattern p;
  const bool staggered = rows % 2 == 0;
  p.uv.resize(rows * columns, 2);
  p.faces.reserve(2 * rows * columns, 6 * rows * columns);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      p.uv.row(r * columns + c) << step(c + (staggered && r % 2 == 1 ? 0.5 : 0.0), columns), step(r, rows);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int above = (r + 1) % rows * columns, after = (c + 1) % columns;
      const int a = r * columns + c, b = r * columns + after;
      // Seen from a shifted row, the vertices of the next one stand half a step back.
      if (staggered && r % 2 == 1) {
        add_triangle(p.faces, a, above + after, above + c);
        add_triangle(p.faces, a, b, above + after);
      } else {
        add_triangle(p.faces, a, b, above + c);
        add_triangle(p.faces, b, above + after, above + c);
      }
    }
  return p;
}

GridSize fit_grid(int panels, double columns_per_row, GridSize least, int row_step,
                  const std::function<std::int64_t(std::int64_t, std::int64_t)>& count) {
  constexpr double kShapeWeight = 0.1;  // a twisted pattern costs as much as 10 % deviation
  GridSize best = least;
  double best_score = INFINITY;
  const int most_rows =
      least.rows + 4 * row_step + static_cast<int>(3.0 * std::sqrt(panels / columns_per_row));
  for (int rows = least.rows; rows <= most_rows; rows += row_step) {
    const auto base = count(rows, 0);
    const auto guess = (panels - base) / (count(rows, 1) - base);
    for (auto columns : {guess, guess + 1}) {
      columns = std::max<std::int64_t>(columns, least.columns);
      const double deviation = std::abs(static_cast<double>(count(rows, columns) - panels)) / panels;
      const double shape = std::abs(std::log(static_cast<double>(columns) / rows / columns_per_row));
      const double score = deviation + kShapeWeight * shape;
      if (score >= best_score) continue;
      best_score = score;
      best = {rows, static_cast<int>(columns)};
    }
  }
  return best;
}

}  // namespace planewright
