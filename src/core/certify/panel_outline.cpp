#include "core/certify/panel_outline.h"

#include <Eigen/Geometry>

namespace planewright {

Contour outline_in_plane(const WorkshopModel& model, int panel) {
  const Vector3d normal = model.normals.row(panel);
  const Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  const Vector3d origin = model.points.row(model.panels[panel][0]);
  Contour outline(model.panels.valence(panel), 2);
  for (int k = 0; k < model.panels.valence(panel); ++k) {
    const Vector3d p = model.points.row(model.panels[panel][static_cast<size_t>(k)]).transpose() - origin;
    outline.row(k) << p.dot(x), p.dot(y);
  }
  return outline;
}

}  // namespace planewright
