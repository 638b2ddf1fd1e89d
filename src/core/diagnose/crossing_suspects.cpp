#include "core/diagnose/crossing_suspects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace planewright {
namespace {

using Eigen::Vector2d;

struct Box {
  Vector3d low, high;
};

bool apart(const Box& a, const Box& b, int axis) {
  return a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis];
}

class Suspects {
 public:
  Suspects(const Points& points, const Polygons& panels, const Points& normals, double touch, double slack)
      : points_(points), panels_(panels), normals_(normals), touch_(touch), slack_(slack) {
    boxes_.reserve(static_cast<size_t>(panels.size()));
    for (int p = 0; p < panels.size(); ++p) boxes_.push_back(box_of(p));
  }

  std::vector<std::array<int, 2>> find() {
    std::vector<int> order;
    Box all{Vector3d::Constant(INFINITY), Vector3d::Constant(-INFINITY)};
    for (int p = 0; p < panels_.size(); ++p) {
      const Box& box = boxes_[static_cast<size_t>(p)];
      if (!box.low.allFinite() || !box.high.allFinite() || !normals_.row(p).allFinite()) continue;
      order.push_back(p);
      // Of the boxes' middles, as a single panel may reach far.
      const Vector3d middle = 0.5 * (box.low + box.high);
      all.low = all.low.cwiseMin(middle);
      all.high = all.high.cwiseMax(middle);
    }
    if (order.empty()) return {};
    Eigen::Index axis = 0;
    (all.high - all.low).maxCoeff(&axis);
    const int sweep = static_cast<int>(axis), second = (sweep + 1) % 3, third = (sweep + 2) % 3;
    std::sort(order.begin(), order.end(), [&](int p, int q) {
      const double a = boxes_[static_cast<size_t>(p)].low[sweep],
                   b = boxes_[static_cast<size_t>(q)].low[sweep];
      return a < b || (a == b && p < q);
    });
    std::vector<Box> swept;
    swept.reserve(order.size());
    for (const int p : order) swept.push_back(boxes_[static_cast<size_t>(p)]);
    std::vector<std::array<int, 2>> found;
    for (size_t k = 0; k < swept.size(); ++k)
      for (size_t l = k + 1; l < swept.size() && swept[l].low[sweep] <= swept[k].high[sweep]; ++l)
        if (!apart(swept[k], swept[l], second) && !apart(swept[k], swept[l], third)) {
          const int p = std::min(order[k], order[l]), q = std::max(order[k], order[l]);
          if (may_cross(p, q)) found.push_back({p, q});
        }
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  Vector3d at(int point) const { return points_.row(point); }

  // Panels that lie on one another may be `touch` apart.
  Box box_of(int p) const {
    Box box{Vector3d::Constant(INFINITY), Vector3d::Constant(-INFINITY)};
    for (const int j : panels_[p]) {
      box.low = box.low.cwiseMin(at(j));
      box.high = box.high.cwiseMax(at(j));
    }
    box.low.array() -= 0.5 * touch_ + slack_;
    box.high.array() += 0.5 * touch_ + slack_;
    return box;
  }

  // Heights of q's corners over p's plane, 0 within the slack.
  void heights(int p, int q, std::vector<double>& out) const {
    const auto corners = panels_[q];
    const Vector3d normal = normals_.row(p), foot = at(panels_[p][0]);
    out.resize(corners.size());
    for (size_t k = 0; k < corners.size(); ++k) {
      const double height = normal.dot(at(corners[k]) - foot);
      out[k] = std::abs(height) <= slack_ ? 0.0 : height;
    }
  }

  bool may_cross(int p, int q) {
    heights(p, q, over_p_);
    const auto [low_p, high_p] = std::minmax_element(over_p_.begin(), over_p_.end());
    const bool above_p = *low_p >= -touch_, below_p = *high_p <= touch_;
    if (above_p != below_p) return false;
    heights(q, p, over_q_);
    const auto [low_q, high_q] = std::minmax_element(over_q_.begin(), over_q_.end());
    const bool above_q = *low_q >= -touch_, below_q = *high_q <= touch_;
    if (above_p && above_q && below_q) return !parted_in_plane(p, q) && !parted_in_plane(q, p);
    if (above_p || above_q || below_q) return false;
    return share_a_chord(p, q) || pierces(q, over_p_, p) || pierces(p, over_q_, q);
  }

  // Whether an edge of p, prolonged, has p on one side and q on the other.
  bool parted_in_plane(int p, int q) const {
    const auto outline = panels_[p];
    const Vector3d normal = normals_.row(p);
    for (size_t k = 0; k < outline.size(); ++k) {
      const Vector3d from = at(outline[k]), edge = at(outline[(k + 1) % outline.size()]) - from;
      const Vector3d across = normal.cross(edge).normalized();
      const auto range = [&](std::span<const int> corners) {
        double low = INFINITY, high = -INFINITY;
        for (const int j : corners) {
          const double distance = across.dot(at(j) - from);
          low = std::min(low, distance);
          high = std::max(high, distance);
        }
        return std::pair(low, high);
      };
      const auto [p_low, p_high] = range(outline);
      const auto [q_low, q_high] = range(panels_[q]);
      if (p_low >= q_high - touch_ || q_low >= p_high - touch_) return true;
    }
    return false;
  }

  // Two common corners with no edge of both between them.
  bool share_a_chord(int p, int q) const {
    const auto a = panels_[p], b = panels_[q];
    size_t count = 0, first_a = 0, last_a = 0, first_b = 0, last_b = 0;
    for (size_t k = 0; k < a.size(); ++k)
      for (size_t l = 0; l < b.size(); ++l) {
        if (a[k] != b[l]) continue;
        if (count++ == 0) {
          first_a = k;
          first_b = l;
        }
        last_a = k;
        last_b = l;
      }
    const auto neighbours = [](size_t i, size_t k, size_t n) { return (i + 1) % n == k || (k + 1) % n == i; };
    return count > 2 ||
           (count == 2 && !(neighbours(first_a, last_a, a.size()) && neighbours(first_b, last_b, b.size())));
  }

  bool has_corner(int p, int point) const {
    const auto corners = panels_[p];
    return std::find(corners.begin(), corners.end(), point) != corners.end();
  }

  // Whether q's outline, `over` p's plane, goes through p.
  bool pierces(int q, const std::vector<double>& over, int p) const {
    const auto corners = panels_[q];
    for (size_t k = 0; k < corners.size(); ++k) {
      const size_t next = (k + 1) % corners.size();
      if (over[k] == 0.0) {
        if (!has_corner(p, corners[k]) && contains(p, at(corners[k]))) return true;
      } else if (over[k] * over[next] < 0.0) {
        const double t = over[k] / (over[k] - over[next]);
        const Vector3d from = at(corners[k]), to = at(corners[next]);
        if (contains(p, from + t * (to - from))) return true;
      }
    }
    return false;
  }

  // Whether a point in p's plane lies in p, or near its outline.
  bool contains(int p, const Vector3d& point) const {
    const Vector3d normal = normals_.row(p).cwiseAbs();
    Eigen::Index dropped = 0;
    normal.maxCoeff(&dropped);
    const int u = static_cast<int>(dropped + 1) % 3, v = static_cast<int>(dropped + 2) % 3;
    const auto corners = panels_[p];
    bool inside = false;
    Vector2d before(points_(corners[corners.size() - 1], u) - point[u],
                    points_(corners[corners.size() - 1], v) - point[v]);
    for (const int j : corners) {
      const Vector2d here(points_(j, u) - point[u], points_(j, v) - point[v]);
      if (near_segment(before, here)) return true;
      if ((before.y() > 0.0) != (here.y() > 0.0)) {
        const double x = before.x() - before.y() * (here.x() - before.x()) / (here.y() - before.y());
        if (x > 0.0) inside = !inside;
      }
      before = here;
    }
    return inside;
  }

  // Whether 0 lies within the slack of a segment.
  bool near_segment(const Vector2d& a, const Vector2d& b) const {
    const Vector2d along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0.0 ? std::clamp(-a.dot(along) / length, 0.0, 1.0) : 0.0;
    return (a + t * along).squaredNorm() <= slack_ * slack_;
  }

  const Points& points_;
  const Polygons& panels_;
  const Points& normals_;
  double touch_, slack_;
  std::vector<Box> boxes_;
  std::vector<double> over_p_, over_q_;  // buffers
};

}  // namespace

std::vector<std::array<int, 2>> crossing_suspects(const Points& points, const Polygons& panels,
                                                  const Points& normals, double touch, double slack) {
  return Suspects(points, panels, normals, touch, slack).find();
}

}  // namespace planewright
