#include "core/pattern/panel_frame.h"

#include <numeric>

#include "core/diagnose/panel_shape.h"

namespace planewright {
namespace {

// Below this sine of the angle between up and the normal no direction in the panel is "up".
constexpr double kFlat = 1e-6;

}  // namespace

double signed_area(std::span<const Vector2d> contour) {
  double twice = 0.0;
  for (size_t k = 1; k + 1 < contour.size(); ++k)
    twice += cross(contour[k] - contour[0], contour[k + 1] - contour[0]);
  return twice / 2;
}

bool crosses_itself(std::span<const Vector2d> contour) {
  Points points = Points::Zero(static_cast<Eigen::Index>(contour.size()), 3);
  for (size_t k = 0; k < contour.size(); ++k)
    points.row(static_cast<Eigen::Index>(k)).head<2>() = contour[k].transpose();
  std::vector<int> all(contour.size());
  std::iota(all.begin(), all.end(), 0);
  return crosses_itself(points, all);
}

bool lies_flat(const WorkshopModel& model, int panel) {
  return Vector3d(model.normals.row(panel)).cross(model.up).norm() < kFlat;
}

PanelFrame panel_frame(const WorkshopModel& model, int panel) {
  PanelFrame frame;
  frame.n = model.normals.row(panel);
  const Vector3d corner = model.points.row(model.panels[panel].front());
  frame.origin = corner - (frame.n.dot(corner) - model.plane_offsets[panel]) * frame.n;
  for (const Vector3d& up : {model.up, Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitX())}) {
    frame.y = up - frame.n.dot(up) * frame.n;
    if (frame.y.norm() < kFlat) continue;
    // Twice, as the first difference of a panel that lies nearly flat has few digits.
    frame.y.normalize();
    frame.y = (frame.y - frame.n.dot(frame.y) * frame.n).normalized();
    break;
  }
  frame.x = frame.y.cross(frame.n);
  return frame;
}

std::vector<Vector2d> outline(const WorkshopModel& model, int panel, const PanelFrame& frame) {
  std::vector<Vector2d> corners;
  for (const int j : model.panels[panel]) corners.push_back(frame.flat(model.points.row(j).transpose()));
  return corners;
}

}  // namespace planewright
