#include "core/mesh/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

namespace planewright {
namespace {

using Point2 = Eigen::Vector2d;

// Twice the signed area of a triangle, positive if it runs counter-clockwise.
double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// The polygon's corners in the plane of its Newell normal, which is then the plane's upper side. Relative to
// the first corner, so that a model far from the origin loses no digits.
std::vector<Point2> flatten(const Points& points, std::span<const int> polygon) {
  const Vector3d normal = newell_vector(points, polygon).stableNormalized();
  // Any axis not along the normal does; a polygon without area has no normal, and any plane is as good.
  Vector3d axis = Vector3d::Zero();
  Eigen::Index least = 0;
  normal.cwiseAbs().minCoeff(&least);
  axis[least] = 1.0;
  const Vector3d u = normal.isZero() ? Vector3d::UnitX() : Vector3d(axis.cross(normal).normalized());
  const Vector3d v = normal.isZero() ? Vector3d::UnitY() : Vector3d(normal.cross(u));
  std::vector<Point2> flat;
  flat.reserve(polygon.size());
  for (int i : polygon) {
    const Vector3d d = points.row(i) - points.row(polygon[0]);
    flat.emplace_back(d.dot(u), d.dot(v));
  }
  return flat;
}

// Reflex corners by cells of a square grid, about one per cell: only they can lie inside an ear.
class ReflexGrid {
 public:
  ReflexGrid(const std::vector<Point2>& points, const std::vector<int>& reflex) {
    if (reflex.empty()) return;
    Point2 high = low_ = points[reflex[0]];
    for (int i : reflex) {
      low_ = low_.cwiseMin(points[i]);
      high = high.cwiseMax(points[i]);
    }
    side_ = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(reflex.size()))));
    size_ = (high - low_) / side_;
    first_.assign(static_cast<size_t>(side_ * side_) + 1, 0);
    for (int i : reflex) ++first_[cell(points[i]) + 1];
    for (size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    std::vector<int> fill(first_.begin(), first_.end() - 1);
    entries_.resize(reflex.size());
    for (int i : reflex) entries_[fill[cell(points[i])]++] = i;
  }

  // Calls visit(i) for the reflex corners in the cells that the box touches, until one returns true. Takes
  // the work off the budget.
  template <class Visit>
  bool any_in_box(const Point2& low, const Point2& high, std::int64_t& budget, Visit&& visit) const {
    if (entries_.empty()) return false;
    const int x0 = column(low.x(), 0), x1 = column(high.x(), 0), y0 = column(low.y(), 1),
              y1 = column(high.y(), 1);
    for (int y = y0; y <= y1; ++y) {
      // The cells of a row lie one after the other.
      const int begin = first_[y * side_ + x0], end = first_[y * side_ + x1 + 1];
      budget -= 1 + end - begin;
      for (int k = begin; k < end; ++k)
        if (visit(entries_[k])) return true;
    }
    return false;
  }

 private:
  int column(double value, int axis) const {
    if (!(size_[axis] > 0.0)) return 0;
    const double c = (value - low_[axis]) / size_[axis];
    return static_cast<int>(std::clamp(c, 0.0, side_ - 1.0));
  }
  int cell(const Point2& p) const { return column(p.y(), 1) * side_ + column(p.x(), 0); }

  Point2 low_ = Point2::Zero(), size_ = Point2::Zero();
  int side_ = 0;
  std::vector<int> first_, entries_;
};

class EarClipper {
 public:
  explicit EarClipper(std::vector<Point2> points)
      : points_(std::move(points)),
        n_(static_cast<int>(points_.size())),
        next_(points_.size()),
        previous_(points_.size()),
        reflex_(points_.size(), 0),
        grid_(points_, find_reflex()),
        budget_(std::min<std::int64_t>(1'000'000 + 1000 * std::int64_t{n_}, 100'000'000)) {}

  // Corners of the triangles, as positions in the polygon.
  std::vector<std::array<int, 3>> clip() {
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(static_cast<size_t>(n_ - 2));
    int i = 0, failed = 0;
    for (int left = n_; left > 3; --left) {
      while (!is_ear(i) && failed < left) {
        i = next_[i];
        ++failed;
      }
      // No ear: the polygon crosses itself or has shrunk to a line. Any corner must do; a convex one looks
      // best.
      if (failed >= left)
        for (int k = 0; k < left && reflex_[i]; ++k) i = next_[i];
      failed = 0;
      triangles.push_back({previous_[i], i, next_[i]});
      const int before = previous_[i], after = next_[i];
      next_[before] = after;
      previous_[after] = before;
      removed_[i] = 1;
      // A corner never becomes reflex when its neighbour goes, unless the polygon crosses itself.
      reflex_[before] = reflex_[before] && is_reflex(before);
      reflex_[after] = reflex_[after] && is_reflex(after);
      i = next_[after];  // skips one, so that the triangles spread instead of forming one fan
    }
    triangles.push_back({previous_[i], i, next_[i]});
    return triangles;
  }

 private:
  bool is_reflex(int i) const { return area2(points_[previous_[i]], points_[i], points_[next_[i]]) <= 0.0; }

  std::vector<int> find_reflex() {
    removed_.assign(points_.size(), 0);
    std::vector<int> reflex;
    for (int i = 0; i < n_; ++i) {
      next_[i] = (i + 1) % n_;
      previous_[i] = (i + n_ - 1) % n_;
    }
    for (int i = 0; i < n_; ++i) {
      reflex_[i] = is_reflex(i);
      if (reflex_[i]) reflex.push_back(i);
    }
    return reflex;
  }

  bool is_ear(int i) {
    // A hopeless polygon of very many corners must not take for ever: in the end its corners are cut off
    // unseen.
    if (--budget_ < 0) return true;
    if (is_reflex(i)) return false;
    const Point2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    return !grid_.any_in_box(a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c), budget_, [&](int j) {
      if (removed_[j] || !reflex_[j] || j == i || j == previous_[i] || j == next_[i]) return false;
      const Point2& p = points_[j];
      if (p == a || p == b || p == c) return false;
      return area2(a, b, p) >= 0.0 && area2(b, c, p) >= 0.0 && area2(c, a, p) >= 0.0;
    });
  }

  std::vector<Point2> points_;
  int n_;
  std::vector<int> next_, previous_;
  std::vector<char> reflex_, removed_;
  ReflexGrid grid_;
  std::int64_t budget_;  // steps: far more than a sane polygon takes, and about a second at most
};

}  // namespace

std::vector<std::array<int, 3>> triangulate(const Points& points, std::span<const int> polygon) {
  if (polygon.size() < 3) return {};
  if (polygon.size() == 3) return {{polygon[0], polygon[1], polygon[2]}};
  const std::vector<Point2> flat = flatten(points, polygon);
  if (polygon.size() == 4) {
    // The shorter diagonal, unless only the other one lies inside.
    const bool from_0 = area2(flat[0], flat[1], flat[2]) > 0.0 && area2(flat[0], flat[2], flat[3]) > 0.0;
    const bool from_1 = area2(flat[1], flat[2], flat[3]) > 0.0 && area2(flat[1], flat[3], flat[0]) > 0.0;
    const bool shorter = (points.row(polygon[0]) - points.row(polygon[2])).squaredNorm() <=
                         (points.row(polygon[1]) - points.row(polygon[3])).squaredNorm();
    if (from_1 && (!from_0 || !shorter))
      return {{polygon[1], polygon[2], polygon[3]}, {polygon[1], polygon[3], polygon[0]}};
    return {{polygon[0], polygon[1], polygon[2]}, {polygon[0], polygon[2], polygon[3]}};
  }
  auto triangles = EarClipper(flat).clip();
  for (auto& triangle : triangles)
    for (int& corner : triangle) corner = polygon[corner];
  return triangles;
}

}  // namespace planewright
