#include "core/cluster/proxy.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace planewright {
namespace {

Matrix3d full(const SecondMoments& m) {
  Matrix3d matrix;
  matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  return matrix;
}

// The unit n with the least n.Q n - 2 b.n. Stationary: (Q + s) n = b; least where s is at least minus the
// least eigenvalue, on which side |n| falls with s.
Vector3d least_on_sphere(const Matrix3d& q, const Vector3d& b) {
  Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(q);
  const Vector3d& values = eigen.eigenvalues();  // ascending
  const Matrix3d& axes = eigen.eigenvectors();
  const Vector3d along = axes.transpose() * b;
  const double size = along.norm();
  const auto solution = [&](double shift) -> Vector3d {
    Vector3d n = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const double stiffness = values[k] - values[0] + shift;
      if (stiffness > 0.0) n[k] = along[k] / stiffness;
    }
    return n;
  };
  double low = 0.0, high = size;
  // At 0 the first axis is left out: if the others are too short even there, it takes the rest.
  if (Vector3d n = solution(0.0); std::abs(along[0]) <= 1e-14 * values[2] && n.squaredNorm() < 1.0) {
    n[0] = std::copysign(std::sqrt(1.0 - n.squaredNorm()), along[0]);
    return (axes * n).normalized();
  }
  for (int k = 0; k < 200 && high - low > 1e-15 * high; ++k) {
    const double middle = 0.5 * (low + high);
    (solution(middle).squaredNorm() > 1.0 ? low : high) = middle;
  }
  return (axes * solution(high)).normalized();
}

Vector3d best_normal(const RegionSums& sums, const Matrix3d& spread, const ClusterMetric& metric) {
  const double size = sums.normal.norm();
  if (metric.distance <= 0.0) return size > 0.0 ? Vector3d(sums.normal / size) : Vector3d::UnitZ();
  Vector3d normal;
  if (metric.normal > 0.0 && size > 0.0) {
    normal = least_on_sphere(metric.distance * spread, metric.normal * sums.normal);
  } else {
    normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(spread).eigenvectors().col(0);
    if (normal.dot(sums.normal) < 0.0) normal = -normal;
  }
  return normal.allFinite() ? normal : Vector3d::UnitZ();
}

}  // namespace

Result<void> check_metric(const ClusterMetric& metric) {
  for (const double weight : {metric.normal, metric.distance, metric.compactness})
    if (!std::isfinite(weight) || weight < 0.0)
      return fail(ErrorCode::Usage, "a weight of the metric is negative or not finite", "metric",
                  "Give weights that are 0 or more");
  if (metric.normal <= 0.0 && metric.distance <= 0.0)
    return fail(ErrorCode::Usage, "the metric weighs neither normals nor distances", "metric",
                "Give one of the two a positive weight");
  return {};
}

ClusterMetric for_regions(ClusterMetric metric, int regions) {
  metric.distance *= regions;
  return metric;
}

void RegionSums::add(const FaceGraph& graph, int f) {
  const FaceShape& shape = graph.shapes[f];
  const Vector3d& c = shape.centre;
  const double a = shape.area;
  area += a;
  normal += a * shape.normal;
  centre += a * c;
  centre_squared += a * c.squaredNorm();
  SecondMoments about;
  about << c.x() * c.x(), c.x() * c.y(), c.x() * c.z(), c.y() * c.y(), c.y() * c.z(), c.z() * c.z();
  moments += graph.moments[f] + a * about;
  ++faces;
}

RegionSums& RegionSums::operator+=(const RegionSums& other) {
  area += other.area;
  normal += other.normal;
  centre += other.centre;
  centre_squared += other.centre_squared;
  moments += other.moments;
  faces += other.faces;
  return *this;
}

FittedProxy fit_proxy(const RegionSums& sums, const ClusterMetric& metric) {
  FittedProxy fitted;
  if (!(sums.area > 0.0)) return fitted;
  const Vector3d centre = sums.centre / sums.area;
  fitted.proxy.centre = centre;
  const Matrix3d spread = full(sums.moments) - sums.area * centre * centre.transpose();
  fitted.proxy.normal = best_normal(sums, spread, metric);
  const Vector3d& n = fitted.proxy.normal;
  // Sums of squares, which rounding may bring below 0.
  fitted.normal = std::max(0.0, 2.0 * (sums.area - n.dot(sums.normal)));
  fitted.distance = std::max(0.0, n.dot(spread * n));
  const double compactness = std::max(0.0, sums.centre_squared - sums.area * centre.squaredNorm());
  fitted.error =
      metric.normal * fitted.normal + metric.distance * fitted.distance + metric.compactness * compactness;
  return fitted;
}

}  // namespace planewright
