// Small polygon layers that the tests of this folder draw and pick.
#pragma once

#include <cmath>
#include <initializer_list>
#include <numbers>

#include "ui/render/scene.h"

namespace planewright::render {

inline Points rows(std::initializer_list<Vector3d> list) {
  Points points(static_cast<Eigen::Index>(list.size()), 3);
  Eigen::Index i = 0;
  for (const Vector3d& p : list) points.row(i++) = p.transpose();
  return points;
}

// The unit square on the ground, facing up.
inline PolygonLayer unit_square(double z = 0.0) {
  return {rows({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}), {{0, 1, 2, 3}}, {}, {}};
}

// 2 x 1 squares side by side along x, from 0 to 2.
inline PolygonLayer two_squares() {
  return {rows({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}),
          {{0, 1, 4, 3}, {1, 2, 5, 4}},
          {},
          {}};
}

// An L: the unit square twice as large, without its upper right quarter.
inline PolygonLayer letter_l() {
  return {
      rows({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}), {{0, 1, 2, 3, 4, 5}}, {}, {}};
}

// The cube -1..1, seen from outside counter-clockwise. Corner i has x, y, z from the bits of i.
inline PolygonLayer cube() {
  Points points(8, 3);
  for (int i = 0; i < 8; ++i) points.row(i) << ((i & 1) ? 1 : -1), ((i & 2) ? 1 : -1), ((i & 4) ? 1 : -1);
  return {
      points, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}, {}, {}};
}

// A closed torus of quads, facing outwards.
inline PolygonLayer torus(int rings, int sides) {
  PolygonLayer layer;
  layer.points.resize(rings * sides, 3);
  for (int i = 0; i < rings; ++i) {
    for (int k = 0; k < sides; ++k) {
      const double u = 2.0 * std::numbers::pi * i / rings, v = 2.0 * std::numbers::pi * k / sides;
      layer.points.row(i * sides + k) << (1.0 + 0.4 * std::cos(v)) * std::cos(u),
          (1.0 + 0.4 * std::cos(v)) * std::sin(u), 0.4 * std::sin(v);
      const int next_i = (i + 1) % rings, next_k = (k + 1) % sides;
      const int quad[] = {i * sides + k, next_i * sides + k, next_i * sides + next_k, i * sides + next_k};
      layer.polygons.push_back(quad);
    }
  }
  return layer;
}

}  // namespace planewright::render
