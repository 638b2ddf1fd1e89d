#include "core/complex/explicit_intersection.h"

#include <Eigen/SVD>

namespace planewright {

const char* name(TpiFailure failure) {
  switch (failure) {
    case TpiFailure::TooFewPlanes:
      return "fewer than three planes";
    case TpiFailure::Parallel:
      return "planes (nearly) parallel to a common line";
    case TpiFailure::Overdetermined:
      return "more than three planes without a common point";
  }
  return "";
}

TpiResult explicit_intersection(const TangentComplex& complex, double singular_tolerance,
                                double residual_tolerance) {
  TpiResult result{initial_state(complex), {}};
  for (int j = 0; j < complex.point_count(); ++j) {
    const auto planes = complex.planes_of_point[j];
    const auto k = static_cast<Eigen::Index>(planes.size());
    if (k < 3) {
      result.failed.push_back({j, TpiFailure::TooFewPlanes, 0.0, 0.0});
      continue;
    }
    // Relative to f_j, so that a nearly singular system errs about the wanted position, not about the origin.
    Eigen::MatrixX3d normals(k, 3);
    Vector right(k);
    for (Eigen::Index r = 0; r < k; ++r) {
      const int i = planes[static_cast<size_t>(r)];
      normals.row(r) = complex.normals.row(i);
      right[r] =
          complex.offsets[i] - complex.normals.row(i).dot(complex.preferred.row(j) - complex.anchors.row(i));
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(normals, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const double smallest = svd.singularValues()[2];
    if (!(smallest >= singular_tolerance)) {
      result.failed.push_back({j, TpiFailure::Parallel, smallest, 0.0});
      continue;
    }
    const Vector3d move = svd.solve(right);
    const double residual = (normals * move - right).cwiseAbs().maxCoeff();
    if (residual > residual_tolerance * complex.mean_edge) {
      result.failed.push_back({j, TpiFailure::Overdetermined, smallest, residual});
      continue;
    }
    result.state.x.row(j) += move.transpose();
  }
  return result;
}

}  // namespace planewright
