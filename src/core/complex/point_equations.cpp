#include "core/complex/point_equations.h"

namespace planewright {

PointEquations::PointEquations(const TangentComplex& complex, int j) {
  const auto planes = complex.planes_of_point[j];
  const auto count = static_cast<Eigen::Index>(planes.size());
  normals.resize(count, 3);
  right.resize(count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const int i = planes[static_cast<size_t>(r)];
    normals.row(r) = complex.normals.row(i);
    right[r] =
        complex.offsets[i] - complex.normals.row(i).dot(complex.preferred.row(j) - complex.anchors.row(i));
  }
}

}  // namespace planewright
