#include "core/base/geometry.h"

#include <Eigen/Geometry>

namespace planewright {

Vector3d newell_vector(const Points& points, std::span<const int> polygon) {
  Vector3d sum = Vector3d::Zero();
  if (polygon.size() < 3) return sum;
  const Vector3d origin = points.row(polygon[0]);
  for (size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vector3d a = points.row(polygon[k]).transpose() - origin;
    const Vector3d b = points.row(polygon[k + 1]).transpose() - origin;
    sum += a.cross(b);
  }
  return sum;
}

Vector3d centroid(const Points& points, std::span<const int> indices) {
  const Vector3d origin = points.row(indices[0]);
  Vector3d sum = Vector3d::Zero();
  for (int i : indices) sum += points.row(i).transpose() - origin;
  return origin + sum / static_cast<double>(indices.size());
}

double bounding_diagonal(const Points& points) {
  if (points.rows() == 0) return 0.0;
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

}  // namespace planewright
