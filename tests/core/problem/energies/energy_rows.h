// Looking at an energy's rows one by one, for the tests of this folder.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "core/problem/energy.h"
#include "support/problems.h"

namespace planewright::test {

// A quad, a triangle, a pentagon and a heptagon round each other; open, none but the triangle planar.
inline Shape mixed_polygons() {
  return {make_points({{0, 0, 0},
                       {2, 0, 0},
                       {2, 1, 0.2},
                       {0, 1, 0.1},
                       {1, 2, 0.4},
                       {3, 2, 0.3},
                       {4, 1, 0},
                       {-1, 2, 0.2},
                       {-1, 3, 0},
                       {1, 3.5, 0.1},
                       {3, 3, 0.2}}),
          {{0, 1, 2, 3}, {3, 2, 4}, {2, 1, 6, 5, 4}, {3, 4, 5, 10, 9, 8, 7}}};
}

inline std::vector<int> stencil(const RowFamily& family, int row) {
  const auto variables = family.stencil(row);
  return {variables.begin(), variables.end()};
}

inline Vector gather(const RowFamily& family, int row, const Vector& z) {
  const auto variables = stencil(family, row);
  Vector local(static_cast<Eigen::Index>(variables.size()));
  for (size_t k = 0; k < variables.size(); ++k) local[static_cast<Eigen::Index>(k)] = z[variables[k]];
  return local;
}

inline double value(const RowFamily& family, int row, const Vector& z) {
  return family.evaluate(row, gather(family, row, z).data(), nullptr, nullptr);
}

inline Vector slope(const RowFamily& family, int row, const Vector& z) {
  const Vector local = gather(family, row, z);
  Vector out = Vector::Constant(local.size(), 1e9);
  family.evaluate(row, local.data(), out.data(), nullptr);
  return out;
}

// Sum of squares / terms: an energy of weight 1 per point.
inline double mean_square(const Energy& energy, const Vector& z) {
  double sum = 0.0;
  for (int row = 0; row < energy.rows(); ++row) sum += std::pow(value(energy, row, z), 2);
  return sum / energy.terms();
}

// Unknowns of a complex that is in normalised units already.
inline Vector unknowns(const Layout& layout, const State& state) {
  Vector z(layout.size());
  for (int j = 0; j < layout.points; ++j) z.segment<3>(layout.x(j)) = state.x.row(j);
  for (int i = 0; i < layout.planes; ++i) {
    z.segment<3>(layout.n(i)) = state.n.row(i);
    z[layout.h(i)] = state.h[i];
  }
  return z;
}

}  // namespace planewright::test
