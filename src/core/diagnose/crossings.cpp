#include "core/diagnose/crossings.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel/global_functions.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <unsupported/Eigen/BVH>

#include "core/mesh/triangulate.h"

namespace planewright {
namespace {

using Box = Eigen::AlignedBox3d;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// What rounding makes of a touch, relative to the size of the two triangles.
constexpr double kRounding = 1e-13;

struct Triangle {
  int polygon;
  std::array<int, 3> corners;
  std::array<Vector3d, 3> at;
};

std::vector<Triangle> triangles_of(const Surface& surface) {
  std::vector<Triangle> triangles;
  for (int p = 0; p < surface.polygons.size(); ++p)
    for (const auto& c : triangulate(surface.points, surface.polygons[p])) {
      const Triangle t{p, c, {surface.points.row(c[0]), surface.points.row(c[1]), surface.points.row(c[2])}};
      // What is nowhere cannot be sorted into the tree either.
      if (t.at[0].allFinite() && t.at[1].allFinite() && t.at[2].allFinite()) triangles.push_back(t);
    }
  return triangles;
}

// --- Exact predicates -------------------------------------------------------------------------------------

Kernel::Point_3 exact(const Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}
Kernel::Triangle_3 exact(const Triangle& t) {
  return {exact(t.at[0]), exact(t.at[1]), exact(t.at[2])};
}

// The segment that a triangle is whose corners lie on one line, if they do. On a line the order of the
// coordinates is the order of the points.
std::optional<Kernel::Segment_3> as_segment(const Triangle& t) {
  const auto [a, b, c] = std::tuple(exact(t.at[0]), exact(t.at[1]), exact(t.at[2]));
  if (!CGAL::collinear(a, b, c)) return {};
  return Kernel::Segment_3(std::min({a, b, c}), std::max({a, b, c}));
}

// Positions of the corners of s that t has too, as bits 0..2.
int shared_with(const Triangle& s, const Triangle& t) {
  int bits = 0;
  for (int k = 0; k < 3; ++k)
    if (std::find(t.corners.begin(), t.corners.end(), s.corners[k]) != t.corners.end()) bits |= 1 << k;
  return bits;
}

// The edge opposite the only corner in `bits`; none if there are more of them.
std::optional<Kernel::Segment_3> opposite_edge(const Triangle& t, int bits) {
  for (int k = 0; k < 3; ++k)
    if (bits == 1 << k) return Kernel::Segment_3(exact(t.at[(k + 1) % 3]), exact(t.at[(k + 2) % 3]));
  return {};
}

// Whether two triangles, not both in one plane, have a point in common besides shared corners and edges.
bool intersect(const Triangle& s, const Triangle& t, bool share_points) {
  const int in_s = share_points ? shared_with(s, t) : 0;
  const auto s_segment = as_segment(s), t_segment = as_segment(t);
  if (s_segment || t_segment) {
    // Two segments part at a touch, and so do a segment and a triangle that meet in a corner of both.
    if ((s_segment && t_segment) || in_s != 0) return false;
    const Kernel::Segment_3& segment = s_segment ? *s_segment : *t_segment;
    return !segment.is_degenerate() && CGAL::do_intersect(segment, exact(s_segment ? t : s));
  }
  if (in_s == 0) return CGAL::do_intersect(exact(s), exact(t));
  // The planes meet in a line through the shared corner. If the triangles have more of it in common, the
  // nearer end of what they have is where the opposite edge of one meets the other.
  const auto s_edge = opposite_edge(s, in_s), t_edge = opposite_edge(t, shared_with(t, s));
  return s_edge && t_edge && (CGAL::do_intersect(*s_edge, exact(t)) || CGAL::do_intersect(*t_edge, exact(s)));
}

// --- Depth ------------------------------------------------------------------------------------------------

// The smallest translation found so far that parts two triangles.
class Parting {
 public:
  // Coordinates relative to a corner, so that differences lose no digits, and divided by a power of two, so
  // that triangles of any size are of the order of 1.
  Parting(const Triangle& s, const Triangle& t) {
    double size = 0.0;
    for (int k = 0; k < 3; ++k) {
      s_[k] = s.at[k] - s.at[0];
      t_[k] = t.at[k] - s.at[0];
      size = std::max({size, s_[k].cwiseAbs().maxCoeff(), t_[k].cwiseAbs().maxCoeff()});
    }
    if (size > 0.0) unit_ = std::exp2(std::ilogb(size));
    for (int k = 0; k < 3; ++k) {
      s_[k] /= unit_;
      t_[k] /= unit_;
    }
    for (int k = 0; k < 3; ++k) {
      s_edge_[k] = s_[(k + 1) % 3] - s_[k];
      t_edge_[k] = t_[(k + 1) % 3] - t_[k];
    }
    s_normal_ = direction(s_edge_[0].cross(s_edge_[1]));
    t_normal_ = direction(t_edge_[0].cross(t_edge_[1]));
  }

  // The longest coordinate difference, to a factor of 2.
  double size() const { return unit_; }

  // Whether each triangle lies within `tolerance` of the other's plane. Not so for triangles without area.
  bool in_one_plane(double tolerance) const {
    if (s_normal_.isZero() || t_normal_.isZero()) return false;
    for (int k = 0; k < 3; ++k)
      if (std::max(std::abs(s_normal_.dot(t_[k])), std::abs(t_normal_.dot(s_[k] - t_[0]))) * unit_ >
          tolerance)
        return false;
    return true;
  }

  // Both return false as soon as one move of at most `enough` parts the triangles.
  bool deeper_in_space(double enough) {
    // Normals first: they part most pairs.
    if (!overlap(t_normal_, enough) || !overlap(s_normal_, enough)) return false;
    for (const Vector3d& e : s_edge_)
      for (const Vector3d& f : t_edge_)
        if (!overlap(direction(e.cross(f)), enough)) return false;
    // Where edges of both are parallel their product is none; what would be in its place lies across the
    // edge. Elsewhere these are moves like any other, never shorter than the smallest.
    return deeper_in_plane(enough);
  }
  bool deeper_in_plane(double enough) {
    for (const Vector3d& e : s_edge_)
      if (!overlap(direction(s_normal_.cross(e)), enough)) return false;
    for (const Vector3d& f : t_edge_)
      if (!overlap(direction(t_normal_.cross(f)), enough)) return false;
    return depth_ < std::numeric_limits<double>::infinity();
  }

  double depth() const { return depth_ * unit_; }
  const Vector3d& apart() const { return apart_; }

 private:
  // Unit; zero where the vector is nothing but rounding.
  static Vector3d direction(const Vector3d& v) {
    const double length = v.norm();
    return length > 1e-14 ? Vector3d(v / length) : Vector3d(Vector3d::Zero());
  }

  bool overlap(const Vector3d& axis, double enough) {
    if (axis.isZero()) return true;
    const auto [s_low, s_high] = std::minmax({axis.dot(s_[0]), axis.dot(s_[1]), axis.dot(s_[2])});
    const auto [t_low, t_high] = std::minmax({axis.dot(t_[0]), axis.dot(t_[1]), axis.dot(t_[2])});
    if (t_high - s_low < depth_) {
      depth_ = t_high - s_low;
      apart_ = axis;
    }
    if (s_high - t_low < depth_) {
      depth_ = s_high - t_low;
      apart_ = -axis;
    }
    return depth() > enough;
  }

  double unit_ = 1.0;  // model units per unit of the rest
  std::array<Vector3d, 3> s_, t_, s_edge_, t_edge_;
  Vector3d s_normal_, t_normal_;
  double depth_ = std::numeric_limits<double>::infinity();
  Vector3d apart_ = Vector3d::Zero();
};

// --- Pairs ------------------------------------------------------------------------------------------------

// What Eigen's BVIntersect asks for: which boxes of both trees overlap, and what to do with pairs of
// triangles.
struct Pairs {
  const std::vector<Triangle>&first, &second;
  const std::vector<Box>&first_boxes, &second_boxes;
  double touch;
  bool within;  // first and second are the same surface
  std::vector<Crossing> found = {};

  bool intersectVolumeVolume(const Box& a, const Box& b) const { return a.intersects(b); }
  bool intersectVolumeObject(const Box& a, int t) const {
    return a.intersects(second_boxes[static_cast<size_t>(t)]);
  }
  bool intersectObjectVolume(int s, const Box& b) const {
    return first_boxes[static_cast<size_t>(s)].intersects(b);
  }
  bool intersectObjectObject(int s, int t) {
    if (first_boxes[static_cast<size_t>(s)].intersects(second_boxes[static_cast<size_t>(t)]))
      test(first[static_cast<size_t>(s)], second[static_cast<size_t>(t)]);
    return false;  // go on
  }

  void test(const Triangle& s, const Triangle& t) {
    // One of the two orders in which the tree meets itself.
    if (within && s.polygon >= t.polygon) return;
    Parting parting(s, t);
    const double enough = std::max(touch, kRounding * parting.size());
    // Most pairs have an axis that parts them, which is cheap to see. The exact predicates have the last word
    // on the others: the axes of needles are inexact themselves, and may miss the one that parts them.
    const bool crosses = within && parting.in_one_plane(enough)
                             ? parting.deeper_in_plane(enough)
                             : parting.deeper_in_space(enough) && intersect(s, t, within);
    if (crosses)
      found.push_back({s.polygon, t.polygon, parting.depth(), parting.apart(), s.corners, t.corners});
  }
};

std::vector<Box> boxes_of(const std::vector<Triangle>& triangles, double margin) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    const Vector3d low = t.at[0].cwiseMin(t.at[1]).cwiseMin(t.at[2]);
    const Vector3d high = t.at[0].cwiseMax(t.at[1]).cwiseMax(t.at[2]);
    boxes.emplace_back(low.array() - margin, high.array() + margin);
  }
  return boxes;
}

using Tree = Eigen::KdBVH<double, 3, int>;
Tree tree_of(const std::vector<Box>& boxes) {
  std::vector<int> indices(boxes.size());
  for (size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<int>(i);
  return Tree(indices.begin(), indices.end(), boxes.begin(), boxes.end());
}

// The deepest pair of triangles of each pair of polygons.
std::vector<Crossing> deepest(std::vector<Crossing> all) {
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) {
    // Equal depths by their corners, so that the answer does not depend on the order of the search.
    return std::tuple(a.first, a.second, -a.depth, a.first_corners, a.second_corners) <
           std::tuple(b.first, b.second, -b.depth, b.first_corners, b.second_corners);
  });
  all.erase(std::unique(all.begin(), all.end(),
                        [](const Crossing& a, const Crossing& b) {
                          return a.first == b.first && a.second == b.second;
                        }),
            all.end());
  return all;
}

}  // namespace

std::vector<Crossing> find_crossings(const Surface& first, const Surface& second, double touch) {
  const std::vector<Triangle> first_triangles = triangles_of(first), second_triangles = triangles_of(second);
  if (first_triangles.empty() || second_triangles.empty()) return {};
  const std::vector<Box> first_boxes = boxes_of(first_triangles, 0.0),
                         second_boxes = boxes_of(second_triangles, 0.0);
  Pairs pairs{first_triangles, second_triangles, first_boxes, second_boxes, touch, false};
  Eigen::BVIntersect(tree_of(first_boxes), tree_of(second_boxes), pairs);
  return deepest(std::move(pairs.found));
}

std::vector<Crossing> find_crossings_within(const Surface& surface, double touch) {
  const std::vector<Triangle> triangles = triangles_of(surface);
  if (triangles.empty()) return {};
  // Triangles that lie on one another may be `touch` apart.
  const std::vector<Box> boxes = boxes_of(triangles, 0.5 * touch);
  const Tree tree = tree_of(boxes);
  Pairs pairs{triangles, triangles, boxes, boxes, touch, true};
  Eigen::BVIntersect(tree, tree, pairs);
  return deepest(std::move(pairs.found));
}

}  // namespace planewright
