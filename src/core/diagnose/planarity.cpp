#include "core/diagnose/planarity.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

namespace planewright {
namespace {

// Greatest distance of the corners from their least-squares plane.
double deviation(const Points& points, std::span<const int> polygon) {
  if (polygon.size() <= 3) return 0.0;
  const Vector3d centre = centroid(points, polygon);
  Matrix3d scatter = Matrix3d::Zero();
  for (int v : polygon) {
    const Vector3d arm = points.row(v).transpose() - centre;
    scatter += arm * arm.transpose();
  }
  // The eigenvector solver works on the matrix scaled to 1: covariances of small panels would underflow
  // otherwise.
  const double size = scatter.trace();
  if (size <= 0.0) return 0.0;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter / size);
  // The eigenvalue loses half of the digits of a nearly planar panel; distances to the plane do not. The
  // normal itself is good to rounding times the aspect of the panel.
  const Vector3d normal = solver.eigenvectors().col(0);
  double largest = 0.0;
  for (int v : polygon) largest = std::max(largest, std::abs(normal.dot(points.row(v).transpose() - centre)));
  return largest;
}

}  // namespace

Planarity measure_planarity(const Points& points, const Polygons& polygons) {
  Planarity result;
  result.per_panel.resize(polygons.size());
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3d low = Vector3d::Constant(infinity), high = Vector3d::Constant(-infinity);
  double sum = 0.0;
  for (int p = 0; p < polygons.size(); ++p) {
    const double d = deviation(points, polygons[p]);
    result.per_panel[p] = d;
    sum += d;
    if (result.worst < 0 || d > result.max) {
      result.max = d;
      result.worst = p;
    }
    for (int v : polygons[p]) {
      low = low.cwiseMin(points.row(v).transpose());
      high = high.cwiseMax(points.row(v).transpose());
    }
  }
  if (polygons.size() == 0) return result;
  result.mean = sum / polygons.size();
  const double diagonal = (high - low).norm();
  result.max_relative_to_bbox = diagonal > 0.0 ? result.max / diagonal : 0.0;
  return result;
}

Displacement measure_displacement(const Points& points, const Points& reference) {
  Displacement result;
  result.per_point = (points - reference).rowwise().norm();
  if (points.rows() == 0) return result;
  result.max = result.per_point.maxCoeff();
  result.rms = result.per_point.norm() / std::sqrt(static_cast<double>(points.rows()));
  return result;
}

}  // namespace planewright
