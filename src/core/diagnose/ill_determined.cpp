#include "core/diagnose/ill_determined.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace planewright {

Vector determinacy(const TangentComplex& complex, const State& state) {
  Vector measure(complex.point_count());
  Eigen::SelfAdjointEigenSolver<Matrix3d> solver;
  for (int j = 0; j < complex.point_count(); ++j) {
    Matrix3d gram = Matrix3d::Zero();
    for (int i : complex.planes_of_point[j]) gram += state.n.row(i).transpose() * state.n.row(i);
    solver.computeDirect(gram, Eigen::EigenvaluesOnly);
    measure[j] = std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
  }
  return measure;
}

std::vector<IllDetermined> find_ill_determined(const TangentComplex& complex, const State& state,
                                               double threshold) {
  const Vector measure = determinacy(complex, state);
  std::vector<IllDetermined> found;
  for (int j = 0; j < complex.point_count(); ++j)
    if (complex.planes_of_point.valence(j) >= 3 && measure[j] < threshold) found.push_back({j, measure[j]});
  std::stable_sort(found.begin(), found.end(), [](const IllDetermined& a, const IllDetermined& b) {
    return a.singular_value < b.singular_value;
  });
  return found;
}

}  // namespace planewright
