// LineContour: the contour that the moved lines of a panel's sides enclose.
//
// Consecutive lines meet in its corners. Sides that have no length left are dropped, those that vanish first
// when the lines move from the outline to where they are first, and the lines beside them meet instead.
// Corners that shoot off are cut. Whatever is done only takes away from what the lines enclose. Threads:
// pure.
#pragma once

#include <vector>

#include "core/pattern/mitre_lines.h"

namespace planewright {

struct FarCorner {
  int corner;
  double distance;  // mm, within the plane, of where the lines meet from the panel's corner
  bool cut;         // false: it lies within the panel, or is a notch, where cutting would add to the part
};

struct LineContour {
  std::vector<Vector2d> points;  // counter-clockwise; empty: the lines enclose nothing simple
  // #sides: points where each side begins and ends; the same point: the side is lost.
  std::vector<int> start, end;
  std::vector<int> lost;       // sides, ascending
  std::vector<FarCorner> far;  // farther than `limit`
  bool empty() const { return points.empty(); }
};

// corners: of the outline that the lines moved from. limit: mm, from which on corners are far. meets: of each
// corner, whether all panels there have the point in common where its lines meet (empty: they all do). Where
// they have not, and a reflex corner moves along one of its sides, the other side's line runs on between that
// side and its neighbour: it is cut however near it is, and named only if it is far.
LineContour line_contour(const std::vector<SideLine>& lines, const std::vector<Vector2d>& corners,
                         double limit, const std::vector<bool>& meets = {});

}  // namespace planewright
