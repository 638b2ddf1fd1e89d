#include "core/mesh/closest_point.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "core/mesh/triangulate.h"

namespace planewright {
namespace {

using Box = Eigen::AlignedBox3d;

struct Triangle {
  std::array<Vector3d, 3> corner;
  int face;
};

// The point of a triangle closest to p, by the regions of Ericson, "Real-Time Collision Detection" 5.1.5.
Vector3d closest_on(const Triangle& t, const Vector3d& p) {
  const auto& [a, b, c] = t.corner;
  const Vector3d ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const Vector3d bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const Vector3d cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1.0 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

// What Eigen's BVMinimize asks for: squared distances to boxes and to triangles.
struct Nearest {
  using Scalar = double;
  const std::vector<Triangle>& triangles;
  Vector3d query;
  double best = std::numeric_limits<double>::infinity();
  int triangle = -1;
  Vector3d point = Vector3d::Zero();

  double minimumOnVolume(const Box& box) const { return box.squaredExteriorDistance(query); }
  double minimumOnObject(int index) {
    const Vector3d on = closest_on(triangles[static_cast<size_t>(index)], query);
    const double distance = (on - query).squaredNorm();
    // Equal distances (a shared edge): the lower index, so that the answer does not depend on the tree.
    if (distance < best || (distance == best && index < triangle)) {
      best = distance;
      triangle = index;
      point = on;
    }
    return distance;
  }
};

Vector3d normal_of(const Triangle& t) {
  return (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]).normalized();
}

}  // namespace

struct ReferenceSurface::Impl {
  Vector3d origin;                  // model coordinates of the local 0
  std::vector<Triangle> triangles;  // with area, local coordinates
  Eigen::KdBVH<double, 3, int> tree;
  Box bounds;
};

ReferenceSurface::ReferenceSurface(std::unique_ptr<Impl> impl, std::string name)
    : impl_(std::move(impl)), name_(std::move(name)) {}
ReferenceSurface::~ReferenceSurface() = default;

Result<std::shared_ptr<const ReferenceSurface>> ReferenceSurface::create(const Points& points,
                                                                         const Polygons& faces,
                                                                         std::string name) {
  if (!points.allFinite())
    return fail(ErrorCode::Refused, "a coordinate of the reference is not a finite number", name);
  auto impl = std::make_unique<Impl>();
  if (points.rows() > 0)
    impl->origin = 0.5 * (points.colwise().minCoeff() + points.colwise().maxCoeff()).transpose();
  const Points local = points.rowwise() - impl->origin.transpose();
  std::vector<int> indices;
  std::vector<Box> boxes;
  for (int f = 0; f < faces.size(); ++f)
    for (const auto& corners : triangulate(local, faces[f])) {
      const Triangle t{{local.row(corners[0]), local.row(corners[1]), local.row(corners[2])}, f};
      const Vector3d area = (t.corner[1] - t.corner[0]).cross(t.corner[2] - t.corner[0]);
      if (!(area.norm() > 0.0)) continue;
      indices.push_back(static_cast<int>(impl->triangles.size()));
      Box box(t.corner[0]);
      box.extend(t.corner[1]).extend(t.corner[2]);
      boxes.push_back(box);
      impl->bounds.extend(box);
      impl->triangles.push_back(t);
    }
  if (impl->triangles.empty())
    return fail(ErrorCode::Refused, "the reference has no face with area", name, "Give a mesh with faces");
  impl->tree.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  return std::shared_ptr<const ReferenceSurface>(new ReferenceSurface(std::move(impl), std::move(name)));
}

ClosestPoint ReferenceSurface::closest(const Vector3d& query, const Vector3d& origin) const {
  const Vector3d shift = origin - impl_->origin;
  Nearest nearest{impl_->triangles, query + shift};
  Eigen::BVMinimize(impl_->tree, nearest);
  const Triangle& t = impl_->triangles[static_cast<size_t>(nearest.triangle)];
  const Vector3d out = normal_of(t), arm = nearest.query - nearest.point;
  ClosestPoint found{nearest.point - shift, out, 0.0, t.face};
  const double distance = arm.norm();
  // Over an edge or a corner the distance grows along the arm, not along the face's normal.
  const double size = (t.corner[1] - t.corner[0]).norm();
  found.distance = std::copysign(distance, out.dot(arm));
  if (distance > 1e-9 * size) found.normal = arm / found.distance;
  return found;
}

Vector3d ReferenceSurface::low() const {
  return impl_->bounds.min() + impl_->origin;
}
Vector3d ReferenceSurface::high() const {
  return impl_->bounds.max() + impl_->origin;
}

}  // namespace planewright
