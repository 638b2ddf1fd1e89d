// The smallest rectangle round a flat outline, and whether an outline can be turned so that it fits a sheet.
// Units: as the points given. Threads: pure.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace planewright {

struct SmallestRectangle {
  double width = 0.0, height = 0.0;                  // width >= height
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  // unit, the direction of the width
};

// Convex hull, counter-clockwise, without points on its sides. Fewer than three: the points have no area.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points);

// Of least area; of equal ones the first. It has a side of the hull on one of its own.
SmallestRectangle smallest_rectangle(const std::vector<Eigen::Vector2d>& points);

// Whether any turn brings the points into a rectangle of width x height, both widened by `slack`. Not the
// smallest rectangle alone is asked: a long outline may only fit aslant.
bool fits_rectangle(const std::vector<Eigen::Vector2d>& points, double width, double height, double slack);

}  // namespace planewright
