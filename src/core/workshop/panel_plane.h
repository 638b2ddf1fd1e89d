// Planes of panels and what is measured flat in them. Internal use and pattern/. Units: as the points given.
// Threads: pure.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/base/geometry.h"

namespace planewright {

struct PanelPlanes {
  Points normals;  // #P x 3, unit
  Vector offsets;  // #P: plane i is { x : normals_i . x = offsets_i }
};

// Least-squares planes of the corners; normals on the side of the panel's Newell vector. A panel whose area
// is nothing (collinear corners, loops that cancel out) has the mean normal of the panels it shares sides
// with; without any, some normal of its own corners, on the side of `up`. Every plane goes through the mean
// of its corners. Precondition: panels of three corners and more.
PanelPlanes fit_panel_planes(const Points& points, const Polygons& panels, const Vector3d& up);

// Corners in a plane's own coordinates, counter-clockwise seen from where `normal` points to (where the panel
// is), relative to the first corner; what a corner is off the plane is dropped.
std::vector<Eigen::Vector2d> flat_outline(const Points& points, std::span<const int> panel,
                                          const Vector3d& normal);

}  // namespace planewright
