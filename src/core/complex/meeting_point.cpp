#include "core/complex/meeting_point.h"

#include <Eigen/Dense>

namespace planewright {
namespace {

// Rungs of the ladder. At the least one a plane's tilt of about a degree decides nothing any more.
constexpr double kLeastHold = 1e-3, kMostHold = 1e6, kRung = 1.5;

}  // namespace

Vector3d meeting_point(std::span<const WantedPlane> planes, const Vector3d& from, double reach) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  Vector3d pull = Vector3d::Zero();
  for (const WantedPlane& plane : planes) {
    spread += plane.normal * plane.normal.transpose();
    pull += (plane.height - plane.normal.dot(from)) * plane.normal;
  }
  for (double hold = kLeastHold; hold < kMostHold; hold *= kRung) {
    const Vector3d step = (spread + hold * Eigen::Matrix3d::Identity()).ldlt().solve(pull);
    if (step.norm() <= reach) return from + step;
  }
  return from;
}

}  // namespace planewright
