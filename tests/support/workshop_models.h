// Workshop models made by hand, for tests of what comes after them: planes by Newell's normal, names P1, P2,
// ...
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "core/workshop/workshop_model.h"
#include "support/shapes.h"

namespace planewright::test {

// points: mm.
inline WorkshopModel workshop_model(const Points& points, const Polygons& panels) {
  WorkshopModel model;
  model.title = "test";
  model.model_unit = LengthUnit::Millimetre;
  model.points = points;
  model.panels = panels;
  model.normals.resize(panels.size(), 3);
  model.plane_offsets.resize(panels.size());
  std::map<std::pair<int, int>, int> edge_of;  // by its directed side
  for (int i = 0; i < panels.size(); ++i) {
    model.normals.row(i) = newell_vector(points, panels[i]).normalized();
    model.plane_offsets[i] = model.normals.row(i).dot(centroid(points, panels[i]));
    model.numbers.push_back(i);
    model.names.push_back(std::string("P").append(std::to_string(i + 1)));
    std::vector<int> edges;
    for (int k = 0; k < panels.valence(i); ++k) {
      const int a = panels[i][k], b = panels[i][(k + 1) % panels.valence(i)];
      if (const auto there = edge_of.find({b, a}); there != edge_of.end()) {
        model.edges[there->second].right = i;
        model.edges[there->second].right_side = k;
        edges.push_back(there->second);
      } else {
        edge_of[{a, b}] = static_cast<int>(model.edges.size());
        edges.push_back(static_cast<int>(model.edges.size()));
        model.edges.push_back({a, b, i, -1, k, -1});
      }
    }
    model.edges_of_panel.push_back(edges);
  }
  return model;
}

inline WorkshopModel workshop_model(const Shape& shape, double size) {
  return workshop_model(Points(shape.positions * size), shape.faces);
}

// The planes { x : n_i . x = h_i } cut the body { n_i . x <= h_i } out of space; its faces, from the corners
// where three of them meet. For planes in general position: every corner is of valence 3.
inline Shape body_of_planes(const Points& normals, const Vector& offsets) {
  const int n = static_cast<int>(normals.rows());
  const double slack = 1e-9 * offsets.cwiseAbs().maxCoeff();
  std::vector<Vector3d> corners;
  std::vector<std::vector<int>> corners_of(static_cast<size_t>(n));
  for (int i = 0; i < n; ++i)
    for (int j = i + 1; j < n; ++j)
      for (int k = j + 1; k < n; ++k) {
        Matrix3d m;
        m << normals.row(i), normals.row(j), normals.row(k);
        if (std::abs(m.determinant()) < 1e-9) continue;
        const Vector3d x = m.inverse() * Vector3d(offsets[i], offsets[j], offsets[k]);
        bool outside = false;
        for (int l = 0; l < n && !outside; ++l) outside = normals.row(l).dot(x) - offsets[l] > slack;
        if (outside) continue;
        for (const int f : {i, j, k}) corners_of[f].push_back(static_cast<int>(corners.size()));
        corners.push_back(x);
      }
  Shape shape;
  shape.positions.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (size_t k = 0; k < corners.size(); ++k) shape.positions.row(k) = corners[k].transpose();
  for (int i = 0; i < n; ++i) {
    std::vector<int>& face = corners_of[i];
    if (face.size() < 3) continue;
    const Vector3d z = normals.row(i).transpose(), x = z.unitOrthogonal(), y = z.cross(x);
    const Vector3d middle = centroid(shape.positions, face);
    const auto angle = [&](int j) {
      const Vector3d d = shape.positions.row(j).transpose() - middle;
      return std::atan2(y.dot(d), x.dot(d));
    };
    std::sort(face.begin(), face.end(), [&](int a, int b) { return angle(a) < angle(b); });
    shape.faces.push_back(face);
  }
  return shape;
}

// Tangent planes of a sphere at points spread evenly by the golden angle: a valence-3 dual of hexagons,
// pentagons and heptagons, closed.
inline Shape ball_of_tangent_planes(int panels, double radius) {
  Points normals(panels, 3);
  for (int i = 0; i < panels; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / panels, r = std::sqrt(1.0 - z * z);
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
    normals.row(i) << r * std::cos(turn), r * std::sin(turn), z;
  }
  return body_of_planes(normals, Vector::Constant(panels, radius));
}

// 12 pentagons, 20 corners, inscribed radius 1.
inline Shape dodecahedron() {
  const double g = std::numbers::phi, s = 1.0 / std::sqrt(1.0 + g * g);
  Points normals(12, 3);
  int row = 0;
  for (const double a : {1.0, -1.0})
    for (const double b : {1.0, -1.0}) {
      normals.row(row++) << 0, a, b * g;
      normals.row(row++) << a, b * g, 0;
      normals.row(row++) << b * g, 0, a;
    }
  return body_of_planes(normals * s, Vector::Ones(12));
}

// The faces of a shape without some of them: an open patch.
inline Shape without_faces(const Shape& shape, int from, int to) {
  Shape open{shape.positions, {}};
  for (int i = 0; i < shape.faces.size(); ++i)
    if (i < from || i >= to) open.faces.push_back(shape.faces[i]);
  return open;
}

// n x n planar quads of the hyperbolic paraboloid's translational net z = x^2 - y^2 (valence 4).
inline Shape saddle(int n, double bend) {
  Shape shape = grid(n, n);
  for (Eigen::Index k = 0; k < shape.positions.rows(); ++k) {
    const double x = shape.positions(k, 0) - n / 2.0, y = shape.positions(k, 1) - n / 2.0;
    shape.positions(k, 2) = bend * (x * x - y * y);
  }
  return shape;
}

}  // namespace planewright::test
