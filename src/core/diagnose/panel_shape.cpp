#include "core/diagnose/panel_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

namespace planewright {
namespace {

using Eigen::Vector2d;

Vector3d viewing_direction(const Points& points, std::span<const int> polygon) {
  const Vector3d centre = centroid(points, polygon);
  Matrix3d scatter = Matrix3d::Zero();
  for (int v : polygon) {
    const Vector3d arm = points.row(v).transpose() - centre;
    scatter += arm * arm.transpose();
  }
  const Vector3d area = newell_vector(points, polygon);
  if (area.norm() > 1e-3 * scatter.trace()) return area.normalized();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(scatter / std::max(scatter.trace(), 1e-300))
      .eigenvectors()
      .col(0);
}

double side(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d, double tolerance) {
  const double ac = side(a, b, c), ad = side(a, b, d), ca = side(c, d, a), cb = side(c, d, b);
  const auto opposite = [tolerance](double s, double t) {
    return (s > tolerance && t < -tolerance) || (s < -tolerance && t > tolerance);
  };
  return opposite(ac, ad) && opposite(ca, cb);
}

}  // namespace

bool crosses_itself(const Points& points, std::span<const int> polygon) {
  const size_t n = polygon.size();
  if (n < 4) return false;
  const Vector3d normal = viewing_direction(points, polygon);
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  const Vector3d origin = points.row(polygon[0]);
  std::vector<Vector2d> flat;
  double size = 0.0;
  for (int p : polygon) {
    const Vector3d arm = points.row(p).transpose() - origin;
    flat.emplace_back(u.dot(arm), v.dot(arm));
    size = std::max(size, arm.squaredNorm());
  }
  const double tolerance = 1e-12 * size;  // what rounding makes of a touch
  for (size_t i = 0; i < n; ++i)
    for (size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;  // neighbours over the end of the list
      if (cross(flat[i], flat[i + 1], flat[k], flat[(k + 1) % n], tolerance)) return true;
    }
  return false;
}

std::vector<int> find_self_crossing(const Points& points, const Polygons& polygons) {
  std::vector<int> found;
  for (int p = 0; p < polygons.size(); ++p)
    if (crosses_itself(points, polygons[p])) found.push_back(p);
  return found;
}

std::vector<ShortEdge> find_short_edges(const TangentComplex& complex, const State& state, double threshold) {
  std::vector<ShortEdge> found;
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    const double length = (state.x.row(edge.a) - state.x.row(edge.b)).norm();
    if (length < threshold * complex.mean_edge) found.push_back({static_cast<int>(e), length});
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const ShortEdge& s, const ShortEdge& t) { return s.length < t.length; });
  return found;
}

}  // namespace planewright
