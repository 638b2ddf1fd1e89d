#include "core/complex/explicit_intersection.h"

#include <Eigen/SVD>

#include "core/complex/point_equations.h"

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
    if (complex.planes_of_point.valence(j) < 3) {
      result.failed.push_back({j, TpiFailure::TooFewPlanes, 0.0, 0.0});
      continue;
    }
    const auto [normals, right] = PointEquations(complex, j);
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
