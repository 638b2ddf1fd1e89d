#include "core/certify/border_distance.h"

#include <algorithm>
#include <limits>

namespace planewright {

using Eigen::Vector2d;

double to_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d along = b - a;
  const double length = along.squaredNorm();
  const double t = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

double to_border(const Contour& contour, const Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < contour.rows(); ++i)
    nearest = std::min(nearest, to_segment(p, contour.row(i), contour.row((i + 1) % contour.rows())));
  return nearest;
}

}  // namespace planewright
