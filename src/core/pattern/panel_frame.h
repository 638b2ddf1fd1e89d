// PanelFrame: coordinates within a panel's plane, and its outline in them.
//
// Units: mm. Threads: pure.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/workshop/workshop_model.h"

namespace planewright {

using Eigen::Vector2d;

inline double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}
double signed_area(std::span<const Vector2d> contour);  // mm^2, > 0 counter-clockwise
// Whether the contour crosses itself (diagnose/panel_shape.h).
bool crosses_itself(std::span<const Vector2d> contour);

struct PanelFrame {
  Vector3d origin;   // in the plane
  Vector3d x, y, n;  // right-handed, n outside

  Vector2d flat(const Vector3d& point) const { return {x.dot(point - origin), y.dot(point - origin)}; }
  // height: above the plane, along n.
  Vector3d point(const Vector2d& at, double height = 0.0) const {
    return origin + at.x() * x + at.y() * y + height * n;
  }
};

// Origin: the foot of the panel's first corner. y: as near to model.up as the plane allows; where up is
// square to the panel (lies_flat): to the model's +y, then to its +x.
PanelFrame panel_frame(const WorkshopModel& model, int panel);
bool lies_flat(const WorkshopModel& model, int panel);

// The panel's corners in the frame.
std::vector<Vector2d> outline(const WorkshopModel& model, int panel, const PanelFrame& frame);

}  // namespace planewright
