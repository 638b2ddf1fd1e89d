#include "core/workshop/panel_rectangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planewright {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Vector2d quarter_turn(const Vector2d& v) {
  return {-v.y(), v.x()};
}

// Extents of points along a unit direction and square to it.
Vector2d extents(const std::vector<Vector2d>& points, const Vector2d& along) {
  Vector2d low = Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const Vector2d across = quarter_turn(along);
  for (const Vector2d& p : points) {
    const Vector2d at(along.dot(p), across.dot(p));
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  return high - low;
}

// Visits the extents of a hull along each of its sides, by rotating calipers: while sides are turned through
// in order, the farthest corners only go forwards.
template <class Visit>
void for_each_side(const std::vector<Vector2d>& hull, Visit&& visit) {
  const size_t n = hull.size();
  size_t right = 0, top = 0, left = 0;
  for (size_t k = 0; k < n; ++k) {
    const Vector2d along = (hull[(k + 1) % n] - hull[k]).normalized(), across = quarter_turn(along);
    const auto climb = [&](size_t from, const Vector2d& direction) {
      for (size_t steps = 0; steps < n; ++steps, from = (from + 1) % n)
        if (direction.dot(hull[(from + 1) % n] - hull[from]) <= 0.0) break;
      return from;
    };
    right = climb(k == 0 ? 1 % n : right, along);
    top = climb(k == 0 ? right : top, across);
    left = climb(k == 0 ? top : left, -along);
    visit(along, Vector2d(along.dot(hull[right] - hull[left]), across.dot(hull[top] - hull[k])));
  }
}

}  // namespace

std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
  const auto before = [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vector2d> hull;
  const auto chain = [&](auto first, auto last) {
    const size_t base = hull.size();
    for (auto p = first; p != last; ++p) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *p - hull[hull.size() - 2]) <= 0.0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // begins the other chain
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

SmallestRectangle smallest_rectangle(const std::vector<Vector2d>& points) {
  const std::vector<Vector2d> hull = convex_hull(points);
  SmallestRectangle best;
  if (hull.size() < 2) return best;
  if (hull.size() == 2) return {(hull[1] - hull[0]).norm(), 0.0, (hull[1] - hull[0]).normalized()};
  double least = std::numeric_limits<double>::infinity();
  for_each_side(hull, [&](const Vector2d& along, const Vector2d& size) {
    const double area = size.x() * size.y();
    if (!(area < least * (1.0 - 1e-9))) return;  // of those that rounding alone tells apart the first
    least = area;
    best = size.x() >= size.y() ? SmallestRectangle{size.x(), size.y(), along}
                                : SmallestRectangle{size.y(), size.x(), quarter_turn(along)};
  });
  return best;
}

bool fits_rectangle(const std::vector<Vector2d>& points, double width, double height, double slack) {
  const double long_side = std::max(width, height) + slack, short_side = std::min(width, height) + slack;
  const auto fits = [&](const Vector2d& size) {
    return std::max(size.x(), size.y()) <= long_side && std::min(size.x(), size.y()) <= short_side;
  };
  const std::vector<Vector2d> hull = convex_hull(points);
  if (hull.size() < 2) return true;
  if (hull.size() == 2) return (hull[1] - hull[0]).norm() <= std::hypot(long_side, short_side);

  // Turned from one side of the hull to the next, extents are those of two fixed corners, so they are concave
  // in the angle. Where both fit at all, they fit at the end of such a range or where one of them is exactly
  // a side of the sheet.
  bool found = false;
  double narrowest = std::numeric_limits<double>::infinity();
  for_each_side(hull, [&](const Vector2d&, const Vector2d& size) {
    found = found || fits(size);
    narrowest = std::min(narrowest, size.y());
  });
  if (found) return true;
  if (narrowest > short_side) return false;
  for (size_t i = 0; i < hull.size(); ++i)
    for (size_t k = i + 1; k < hull.size(); ++k) {
      const Vector2d arm = hull[k] - hull[i];
      const double reach = arm.norm();
      for (const double side : {long_side, short_side}) {
        if (reach < side) continue;
        const double turn = std::acos(side / reach), at = std::atan2(arm.y(), arm.x());
        for (const double angle : {at - turn, at + turn}) {
          Vector2d size = extents(hull, {std::cos(angle), std::sin(angle)});
          // The extent that was made to be `side` may miss it by rounding.
          if (std::abs(size.x() - side) <= 1e-12 * reach) size.x() = side;
          if (fits(size)) return true;
        }
      }
    }
  return false;
}

}  // namespace planewright
