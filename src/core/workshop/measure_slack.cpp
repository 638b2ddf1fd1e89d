#include "core/workshop/measure_slack.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace planewright {

double coordinate_resolution(const WorkshopModel& model) {
  const double largest = model.origin.cwiseAbs().maxCoeff() +
                         (model.points.rows() == 0 ? 0.0 : model.points.cwiseAbs().maxCoeff());
  return 8.0 * std::numeric_limits<double>::epsilon() * largest;
}

double angle_slack(double resolution, double length) {
  const double rounding = 360.0 * kRelativeSlack;
  if (!(length > 0.0)) return kLargestAngleSlack;
  return std::min(kLargestAngleSlack, rounding + resolution / length * 180.0 / std::numbers::pi);
}

}  // namespace planewright
