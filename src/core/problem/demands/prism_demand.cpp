#include "core/problem/demands/prism_demand.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

#include "core/problem/demands/linear_rows.h"

namespace planewright {
namespace {

// Edges: shorter sides and thinner outlines are rounding.
constexpr double kNoLength = 1e-9;

using Flat = std::array<double, 2>;

double turn(const Flat& a, const Flat& b, const Flat& c) {
  return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

// Counter-clockwise, without corners on straight sides; fewer than 3 corners if there is no area.
std::vector<Flat> convex_hull(std::vector<Flat> points) {
  std::sort(points.begin(), points.end());
  std::vector<Flat> hull;
  // Andrew's chain: the lower side from left to right, then the upper one back.
  for (int side = 0; side < 2; ++side) {
    const size_t first = hull.size();
    for (const Flat& p : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

class PrismRows {
 public:
  explicit PrismRows(const DemandContext& context) : context_(context), input_(context.complex.input) {}

  // A row per side of the face's outline, for point j.
  void inside_face(int j, int face) {
    const Vector3d m = input_.face_normals.row(face);
    const Vector3d u = m.unitOrthogonal(), v = m.cross(u);
    std::vector<Flat> corners;
    for (int corner : input_.faces[face]) {
      const Vector3d p = input_.vertices.row(corner);
      corners.push_back({u.dot(p), v.dot(p)});
    }
    const std::vector<Flat> outline = convex_hull(corners);
    Flat middle{0.0, 0.0};
    for (const Flat& p : outline)
      for (size_t c = 0; c < 2; ++c) middle[c] += p[c] / static_cast<double>(outline.size());
    struct Side {
      Vector3d inwards;
      double low, room;
    };
    std::vector<Side> sides;
    for (size_t k = 0; k < outline.size(); ++k) {
      const Flat &a = outline[k], &b = outline[(k + 1) % outline.size()];
      const double x = b[0] - a[0], y = b[1] - a[1], length = std::hypot(x, y);
      if (!(length > kNoLength)) continue;
      const double low = (x * a[1] - y * a[0]) / length;
      sides.push_back({(x * v - y * u) / length, low, (x * middle[1] - y * middle[0]) / length - low});
    }
    if (std::any_of(sides.begin(), sides.end(), [](const Side& s) { return !(s.room > kNoLength); })) return;
    for (const Side& s : sides)
      add(j, s.inwards, s.low + std::min(context_.margin, 0.25 * s.room), kUnbounded);
  }

  // Between the ends of a border edge.
  void between_ends(int j, int edge) {
    const auto [a, b] = input_.edges[static_cast<size_t>(edge)];
    const Vector3d start = input_.vertices.row(a);
    const Vector3d along = input_.vertices.row(b).transpose() - start;
    const double length = along.norm();
    if (!(length > kNoLength)) return;
    const double margin = std::min(context_.margin, 0.25 * length), low = along.dot(start) / length;
    add(j, along / length, low + margin, low + length - margin);
  }

  Constraints take() {
    Constraints constraints;
    constraints.push_back(std::move(rows_));
    return constraints;
  }

 private:
  void add(int j, const Vector3d& normal, double low, double high) {
    rows_->add_point(context_.layout.x(j), normal, {low, high}, {ElementKind::Point, j});
  }

  const DemandContext& context_;
  const InputSurface& input_;
  std::unique_ptr<LinearRows> rows_ = std::make_unique<LinearRows>("prism", "edges");
};

}  // namespace

Result<Constraints> make_prism_demand(const DemandContext& context) {
  PrismRows rows(context);
  for (int j = 0; j < context.complex.point_count(); ++j) {
    if (!context.where.points[static_cast<size_t>(j)]) continue;
    const PointOrigin& origin = context.complex.point_origin[static_cast<size_t>(j)];
    if (origin.kind == PointKind::Face) rows.inside_face(j, origin.element);
    if (origin.kind == PointKind::BorderEdge) rows.between_ends(j, origin.element);
  }
  return rows.take();
}

}  // namespace planewright
