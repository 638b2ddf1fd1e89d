#include "core/diagnose/panel_angles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace planewright {

std::vector<AcuteCorner> find_acute_corners(const Points& points, const Polygons& polygons, double limit) {
  std::vector<AcuteCorner> acute;
  for (int p = 0; p < polygons.size(); ++p) {
    const auto corners = polygons[p];
    const size_t n = corners.size();
    const Vector3d normal = newell_vector(points, corners);
    AcuteCorner sharpest{p, -1, limit};
    for (size_t k = 0; k < n; ++k) {
      const Vector3d at = points.row(corners[k]);
      const Vector3d back = points.row(corners[(k + n - 1) % n]).transpose() - at,
                     on = points.row(corners[(k + 1) % n]).transpose() - at;
      const Vector3d turn = on.cross(back);
      if (back.norm() == 0.0 || on.norm() == 0.0 || turn.dot(normal) < 0.0) continue;
      const double degrees = std::atan2(turn.norm(), on.dot(back)) * 180.0 / std::numbers::pi;
      if (degrees < sharpest.degrees) sharpest = {p, corners[k], degrees};
    }
    if (sharpest.point >= 0) acute.push_back(sharpest);
  }
  return acute;
}

}  // namespace planewright
