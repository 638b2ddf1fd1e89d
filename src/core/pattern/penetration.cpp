// penetrating_solids of thick_panel.h.
//
// Hulls first: solids that some face's normal, or a vector square to an edge of each, keeps apart do not
// penetrate, and that settles all convex pairs. For the few that are left the surfaces are tested, exactly.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/diagnose/crossings.h"
#include "core/mesh/triangulate.h"
#include "core/pattern/thick_panel.h"

namespace planewright {
namespace {

struct Solid {
  const ThickPanel* panel;
  Eigen::AlignedBox3d box;
  std::vector<Vector3d> normals, edges;  // unit
  std::vector<std::array<int, 3>> triangles;
};

Solid solid_of(const ThickPanel& panel) {
  Solid solid{&panel, {}, {}, {}, {}};
  for (Eigen::Index k = 0; k < panel.points.rows(); ++k) solid.box.extend(panel.points.row(k).transpose());
  for (int f = 0; f < panel.faces.size(); ++f) {
    const auto face = panel.faces[f];
    const Vector3d normal = newell_vector(panel.points, face);
    if (normal.norm() > 0.0) solid.normals.push_back(normal.normalized());
    for (const auto& triangle : triangulate(panel.points, face)) solid.triangles.push_back(triangle);
    for (size_t k = 0; k < face.size(); ++k) {
      const int a = face[k], b = face[(k + 1) % face.size()];
      const Vector3d edge = (panel.points.row(b) - panel.points.row(a)).transpose();
      if (a < b && edge.norm() > 0.0) solid.edges.push_back(edge.normalized());
    }
  }
  return solid;
}

// By how much the shadows of both on the unit direction overlap; <= 0: not.
double overlap(const Solid& a, const Solid& b, const Vector3d& direction) {
  const Vector in_a = a.panel->points * direction, in_b = b.panel->points * direction;
  return std::min(in_a.maxCoeff() - in_b.minCoeff(), in_b.maxCoeff() - in_a.minCoeff());
}

bool hulls_apart(const Solid& a, const Solid& b, double tolerance) {
  for (const Solid* solid : {&a, &b})
    for (const Vector3d& normal : solid->normals)
      if (overlap(a, b, normal) <= tolerance) return true;
  for (const Vector3d& p : a.edges)
    for (const Vector3d& q : b.edges) {
      const Vector3d across = p.cross(q);
      if (across.norm() > 1e-6 && overlap(a, b, across.normalized()) <= tolerance) return true;
    }
  return false;
}

double distance_to_triangle(const Vector3d& p, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double area = normal.norm();
  bool inside = area > 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const Vector3d edge = v - u;
    if (inside && normal.dot(edge.cross(p - u)) < 0.0) inside = false;
    const double along = edge.squaredNorm() > 0.0 ? (p - u).dot(edge) / edge.squaredNorm() : 0.0;
    nearest = std::min(nearest, (u + std::clamp(along, 0.0, 1.0) * edge - p).norm());
  }
  return inside ? std::abs(normal.dot(p - a)) / area : nearest;
}

// How deep the point lies in the solid; 0: not in it. Sum of the solid angles of its triangles.
double depth_in(const Solid& solid, const Vector3d& p) {
  double angle = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const auto& [i, j, k] : solid.triangles) {
    const Vector3d u = solid.panel->points.row(i), v = solid.panel->points.row(j),
                   w = solid.panel->points.row(k);
    nearest = std::min(nearest, distance_to_triangle(p, u, v, w));
    const Vector3d a = u - p, b = v - p, c = w - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle > 2.0 * std::numbers::pi ? nearest : 0.0;
}

// Points within the solid: below the middle of each triangle of its outer face, halfway to where the line
// leaves the solid.
std::vector<Vector3d> inner_points(const Solid& solid) {
  std::vector<Vector3d> result;
  const Points& points = solid.panel->points;
  const Vector3d down = -newell_vector(points, solid.panel->faces[0]).normalized();
  for (const auto& [i, j, k] : triangulate(points, solid.panel->faces[0])) {
    const Vector3d from = ((points.row(i) + points.row(j) + points.row(k)) / 3.0).transpose();
    double leaves = std::numeric_limits<double>::infinity();
    for (const auto& [r, s, t] : solid.triangles) {
      if (std::max({r, s, t}) < solid.panel->outer) continue;  // the outer face itself
      const Vector3d a = points.row(r), b = points.row(s), c = points.row(t);
      const Vector3d normal = (b - a).cross(c - a);
      const double slope = normal.dot(down);
      if (!(slope > 0.0)) continue;
      const double at = normal.dot(a - from) / slope;
      const Vector3d hit = from + at * down;
      if (at > 0.0 && normal.dot((b - a).cross(hit - a)) >= 0.0 &&
          normal.dot((c - b).cross(hit - b)) >= 0.0 && normal.dot((a - c).cross(hit - c)) >= 0.0)
        leaves = std::min(leaves, at);
    }
    if (std::isfinite(leaves)) result.push_back(from + leaves / 2 * down);
  }
  return result;
}

bool surfaces_penetrate(const Solid& a, const Solid& b, double tolerance) {
  if (!find_crossings({a.panel->points, a.panel->faces}, {b.panel->points, b.panel->faces}, tolerance)
           .empty())
    return true;
  // No surface passes through the other: one lies in the other, or both are the same, or they are apart.
  for (const auto& [inner, outer] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vector3d& p : inner_points(*inner))
      if (depth_in(*outer, p) > tolerance) return true;
  return false;
}

}  // namespace

std::vector<std::pair<int, int>> penetrating_solids(const ThickPanels& solids, double tolerance) {
  std::vector<Solid> all;
  for (const ThickPanel& panel : solids.panels)
    if (!panel.empty()) all.push_back(solid_of(panel));
  std::vector<size_t> order(all.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return std::pair(all[a].box.min().x(), a) < std::pair(all[b].box.min().x(), b);
  });
  std::vector<std::pair<int, int>> pairs;
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t j = i + 1; j < order.size(); ++j) {
      const Solid &a = all[order[i]], &b = all[order[j]];
      if (b.box.min().x() > a.box.max().x()) break;
      if (!a.box.intersects(b.box)) continue;
      if (hulls_apart(a, b, tolerance) || !surfaces_penetrate(a, b, tolerance)) continue;
      pairs.push_back(std::minmax(a.panel->panel, b.panel->panel));
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace planewright
