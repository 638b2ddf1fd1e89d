#include "core/certify/contours_apart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/certify/border_distance.h"
#include "core/certify/exact_signs.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

Vector2d corner(const Contour& c, Eigen::Index i) {
  return c.row(i % c.rows());
}

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The least distance of a corner of one from the sides of the other: of contours that do not meet, theirs.
double corners_to_sides(const Contour& a, const Contour& b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < a.rows(); ++i) nearest = std::min(nearest, to_border(b, corner(a, i)));
  return nearest;
}

bool borders_meet(const Contour& a, const Contour& b) {
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index k = 0; k < b.rows(); ++k)
      if (segments_meet(corner(a, i), corner(a, i + 1), corner(b, k), corner(b, k + 1))) return true;
  return false;
}

bool deep_inside(const Contour& c, const Vector2d& p, double depth) {
  return covers(c, p) && to_border(c, p) > depth;
}

// A point in the widest place half way between two heights of corners.
Vector2d inner_point(const Contour& c) {
  std::vector<double> heights;
  for (Eigen::Index i = 0; i < c.rows(); ++i) heights.push_back(c(i, 1));
  std::sort(heights.begin(), heights.end());
  double y = heights.front(), gap = 0.0;
  for (size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > gap) {
      gap = heights[i] - heights[i - 1];
      y = 0.5 * (heights[i] + heights[i - 1]);
    }
  std::vector<double> borders;
  for (Eigen::Index i = 0; i < c.rows(); ++i) {
    const Vector2d a = corner(c, i), b = corner(c, i + 1);
    if ((a.y() <= y) != (b.y() <= y))
      borders.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(borders.begin(), borders.end());
  Vector2d point(c(0, 0), y);
  double widest = 0.0;
  for (size_t i = 0; i + 1 < borders.size(); i += 2)
    if (borders[i + 1] - borders[i] > widest) {
      widest = borders[i + 1] - borders[i];
      point.x() = 0.5 * (borders[i] + borders[i + 1]);
    }
  return point;
}

// Between two places where a side of a meets the border of b it lies inside b, or outside, as its middle
// does. Contours that lie on one another have no side inside, but an inside in common.
bool reaches_into(const Contour& a, const Contour& b, double tolerance) {
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const Vector2d p = corner(a, i), along = corner(a, i + 1) - p;
    if (deep_inside(b, p, tolerance)) return true;
    std::vector<double> places{0.0, 1.0};
    for (Eigen::Index k = 0; k < b.rows(); ++k) {
      const Vector2d q = corner(b, k), side = corner(b, k + 1) - q;
      if (!segments_meet(p, p + along, q, q + side)) continue;
      const double turn = cross(along, side);
      if (turn != 0.0) {
        places.push_back(std::clamp(cross(q - p, side) / turn, 0.0, 1.0));
      } else {
        for (const Vector2d& end : {q, Vector2d(q + side)})
          places.push_back(std::clamp((end - p).dot(along) / along.squaredNorm(), 0.0, 1.0));
      }
    }
    std::sort(places.begin(), places.end());
    for (size_t k = 0; k + 1 < places.size(); ++k)
      if (deep_inside(b, p + 0.5 * (places[k] + places[k + 1]) * along, tolerance)) return true;
  }
  return deep_inside(b, inner_point(a), tolerance);
}

}  // namespace

Apart apart(const Contour& a, const Contour& b, double spacing, double tolerance) {
  if (a.rows() < 3 || b.rows() < 3) return Apart::Overlap;  // nothing is certain of such
  if (spacing <= tolerance)
    return reaches_into(a, b, tolerance) || reaches_into(b, a, tolerance) ? Apart::Overlap : Apart::Yes;
  if (borders_meet(a, b) || covers(a, b.row(0)) || covers(b, a.row(0))) return Apart::Overlap;
  const double distance = std::min(corners_to_sides(a, b), corners_to_sides(b, a));
  return distance >= spacing - tolerance ? Apart::Yes : Apart::TooNear;
}

}  // namespace planewright
