// Meshes, complexes and states that the tests of complex/, problem/ and solve/ share.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "core/complex/dual.h"
#include "core/complex/planarize.h"
#include "core/complex/state.h"
#include "core/mesh/sample_shapes.h"
#include "support/shapes.h"

namespace planewright::test {

using SharedComplex = std::shared_ptr<const TangentComplex>;

// A grid of quads bent into z = bend * (x y + 0.3 x^2), so that no inner quad is planar.
inline Shape twisted_grid(int columns, int rows, double bend = 0.1) {
  Shape shape = grid(columns, rows);
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v) {
    const double x = shape.positions(v, 0), y = shape.positions(v, 1);
    shape.positions(v, 2) = bend * (x * y + 0.3 * x * x * y);
  }
  return shape;
}

// The triangle grid on a paraboloid, seen from outside (above) convex.
inline Shape domed_triangle_grid(int columns, int rows, double rise = 0.05) {
  Shape shape = triangle_grid(columns, rows);
  for (Eigen::Index v = 0; v < shape.positions.rows(); ++v) {
    const double x = shape.positions(v, 0) - 0.5 * columns, y = shape.positions(v, 1) - 0.45 * rows;
    shape.positions(v, 2) = -rise * (x * x + 1.3 * y * y);
  }
  return shape;
}

// columns x rows hexagons, upward, on a gently bent surface: valence 3 inside.
inline Shape honeycomb(int columns, int rows, double bend = 0.05) {
  Shape shape;
  std::map<std::pair<int, int>, int> index;
  std::vector<std::array<double, 3>> positions;
  const auto corner = [&](int x, int row) {
    const auto [it, is_new] = index.try_emplace({x, row}, static_cast<int>(positions.size()));
    if (is_new) {
      const double px = 0.866 * x, py = 1.5 * row + ((x + row) % 2 == 0 ? 0.25 : -0.25);
      positions.push_back({px, py, bend * (px * py - 0.4 * py * py)});
    }
    return it->second;
  };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int x = 2 * c + r % 2;
      const std::array hexagon{corner(x, r),         corner(x + 1, r),     corner(x + 2, r),
                               corner(x + 2, r + 1), corner(x + 1, r + 1), corner(x, r + 1)};
      shape.faces.push_back(hexagon);
    }
  shape.positions.resize(static_cast<Eigen::Index>(positions.size()), 3);
  for (size_t v = 0; v < positions.size(); ++v)
    shape.positions.row(static_cast<Eigen::Index>(v)) << positions[v][0], positions[v][1], positions[v][2];
  return shape;
}

// 12 vertices on a sphere of this radius, 20 triangles, outward.
inline Shape icosahedron(double radius = 1.0) {
  const double g = std::numbers::phi;
  Shape shape{make_points({{-1, g, 0},
                           {1, g, 0},
                           {-1, -g, 0},
                           {1, -g, 0},
                           {0, -1, g},
                           {0, 1, g},
                           {0, -1, -g},
                           {0, 1, -g},
                           {g, 0, -1},
                           {g, 0, 1},
                           {-g, 0, -1},
                           {-g, 0, 1}}),
              {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
               {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
               {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  shape.positions *= radius / std::sqrt(1.0 + g * g);
  return shape;
}

inline Shape shape_of(const PolygonMesh& mesh) {
  return {mesh.positions(), mesh.faces()};
}

inline SharedComplex dual_of(const PolygonMesh& mesh, const DualOptions& options = {}) {
  return std::make_shared<const TangentComplex>(build_dual(mesh, options).value());
}
inline SharedComplex planarize_of(const PolygonMesh& mesh, const PlanarizeOptions& options = {}) {
  return std::make_shared<const TangentComplex>(build_planarize(mesh, options).value());
}

// A sample design as the program would take it, its dual (triangles) or itself, `offset` mean edges away.
inline SharedComplex sample_complex(std::string_view name, int panels, double offset = 0.0) {
  const PolygonMesh mesh = make_sample(name, panels).value();
  bool triangles = true;
  for (const SampleInfo& info : samples())
    if (info.name == name) triangles = info.triangles;
  const auto moved_by = [&](double distance) {
    return triangles ? dual_of(mesh, {distance}) : planarize_of(mesh, {distance});
  };
  const SharedComplex on_design = moved_by(0.0);
  return offset == 0.0 ? on_design : moved_by(offset * on_design->mean_edge);
}

struct NamedComplex {
  std::string name;
  SharedComplex complex;
};
// A small complex of every kind: closed, open, of valences 1 to 6, flat places and none.
inline std::vector<NamedComplex> small_complexes() {
  return {
      {"tetrahedron_dual", dual_of(tetrahedron().mesh())},
      {"cube_planarize", planarize_of(cube().mesh())},
      {"cube_dual", dual_of(cube().mesh())},
      {"open_fan_dual", dual_of(fan(6, true).mesh())},
      {"domed_grid_dual", dual_of(domed_triangle_grid(3, 2).mesh(), {0.1, BorderPolicy::Closed})},
      {"domed_grid_interior_dual", dual_of(domed_triangle_grid(3, 3).mesh(), {0, BorderPolicy::Interior})},
      {"twisted_grid_planarize", planarize_of(twisted_grid(3, 2).mesh())},
      {"honeycomb_planarize", planarize_of(honeycomb(3, 2).mesh(), {-0.05})},
      {"honeycomb_dual", dual_of(honeycomb(2, 2).mesh())},
      {"train_station_dual", dual_of(make_sample("train-station", 30).value())},
      {"twisted_roof_planarize", planarize_of(make_sample("twisted-roof", 30).value())},
  };
}

// A state whose points, normals (kept unit) and offsets are off by up to `size` mean edges (or radians).
inline State perturbed(const TangentComplex& complex, State state, double size, unsigned seed = 1) {
  std::mt19937 random(seed);
  // Not uniform_real_distribution: its sequence may differ between standard libraries.
  const auto next = [&] { return 2.0 * (static_cast<double>(random()) / 4294967295.0) - 1.0; };
  for (Eigen::Index k = 0; k < state.x.size(); ++k) state.x.data()[k] += size * complex.mean_edge * next();
  for (Eigen::Index k = 0; k < state.n.size(); ++k) state.n.data()[k] += size * next();
  for (Eigen::Index k = 0; k < state.h.size(); ++k) state.h[k] += size * complex.mean_edge * next();
  state.n.rowwise().normalize();
  return state;
}
inline State perturbed(const TangentComplex& complex, double size, unsigned seed = 1) {
  return perturbed(complex, initial_state(complex), size, seed);
}

// Largest |n . (x - v) - h| of the state, in mean edges.
inline double off_plane(const TangentComplex& complex, const State& state) {
  return incidence_residuals(complex, state).cwiseAbs().maxCoeff() / complex.mean_edge;
}

// What counts as planar to rounding: 1e-12 of the design's diagonal, in mean edges.
inline double rounding(const TangentComplex& complex) {
  return 1e-12 * bounding_diagonal(complex.preferred) / complex.mean_edge;
}

inline bool all_finite(const TangentComplex& complex) {
  return complex.anchors.allFinite() && complex.normals.allFinite() && complex.offsets.allFinite() &&
         complex.preferred.allFinite() && std::isfinite(complex.mean_edge);
}

inline bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && (a.array() == b.array()).all();
}

}  // namespace planewright::test
