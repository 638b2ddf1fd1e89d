#include "core/certify/solid_pairs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "core/certify/exact_signs.h"
#include "core/certify/solid_shape.h"
#include "core/diagnose/crossings.h"

namespace planewright {
namespace {

using Box = Eigen::AlignedBox3d;

// Three points of a plane; the positive side is where a, b, c run counter-clockwise.
struct Plane {
  Vector3d a, b, c;
  Plane moved(const Vector3d& by) const { return {a + by, b + by, c + by}; }
};

bool all_on_side(const Points& points, const Plane& plane, int side) {
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (orientation(plane.a, plane.b, plane.c, points.row(i).transpose()) * side < 0) return false;
  return true;
}

// Whether the plane has `above` on its positive side and `below` on the other, both but for `tolerance`.
bool parts(const Plane& plane, const Points& above, const Points& below, double tolerance) {
  const Vector3d normal = (plane.b - plane.a).cross(plane.c - plane.a);
  const double length = normal.norm();
  if (!(length > 0.0)) return false;
  const Vector3d step = normal * (tolerance / length);
  return all_on_side(above, plane.moved(-step), 1) && all_on_side(below, plane.moved(step), -1);
}

// Through the edge, halving the angle between both panels.
bool mitre_parts(const WorkshopModel& model, const WorkshopEdge& edge, const ThickPanels& solids,
                 double tolerance) {
  const Vector3d a = model.points.row(edge.a), b = model.points.row(edge.b);
  Vector3d middle = model.normals.row(edge.left) + model.normals.row(edge.right);
  if (middle.norm() < 1e-9) return false;  // folded back onto itself: no such plane
  middle *= (b - a).norm() / middle.norm();
  // `left` has the edge a -> b and lies to the left of it, seen from outside.
  const Plane plane{a, a + middle, b};
  const Points &left = solids.panels[static_cast<size_t>(edge.left)].points,
               &right = solids.panels[static_cast<size_t>(edge.right)].points;
  return parts(plane, left, right, tolerance);
}

// The plane of a face, from its first corner and the two that span most with it.
std::optional<Plane> plane_of(const ThickPanel& solid, int face) {
  const auto corners = solid.faces[face];
  const Vector3d a = solid.points.row(corners[0]), normal = newell_vector(solid.points, corners);
  Plane best{a, a, a};
  double largest = 0.0;
  for (size_t i = 1; i < corners.size(); ++i)
    for (size_t k = i + 1; k < corners.size(); ++k) {
      const Vector3d b = solid.points.row(corners[i]), c = solid.points.row(corners[k]);
      const double turn = (b - a).cross(c - a).dot(normal);
      if (std::abs(turn) > largest) {
        largest = std::abs(turn);
        best = turn > 0.0 ? Plane{a, b, c} : Plane{a, c, b};
      }
    }
  return largest > 0.0 ? std::optional(best) : std::nullopt;
}

// A face of `solid` that has the other outside of it.
bool face_parts(const ThickPanel& solid, const Points& other, double tolerance) {
  for (int f = 0; f < solid.faces.size(); ++f) {
    const auto plane = plane_of(solid, f);
    if (plane && parts(*plane, other, solid.points, tolerance)) return true;
  }
  return false;
}

// How often the surface winds round p: 1 inside, 0 outside.
double winding(const ThickPanel& solid, const Vector3d& p) {
  double angle = 0.0;
  for (const auto& t : fans(solid.faces, all_of(solid.faces))) {
    const Vector3d a = solid.points.row(t[0]).transpose() - p, b = solid.points.row(t[1]).transpose() - p,
                   c = solid.points.row(t[2]).transpose() - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle +=
        2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4.0 * std::numbers::pi);
}

// Whether a face of s has a place inside t: the middle of one of its triangles, moved into s by the
// tolerance. Finds what no crossing of triangles tells: solids that share planes, or lie in one another.
bool reaches_into(const ThickPanel& s, const ThickPanel& t, double tolerance) {
  Box box;
  for (Eigen::Index i = 0; i < t.points.rows(); ++i) box.extend(t.points.row(i).transpose());
  for (const auto& corners : fans(s.faces, all_of(s.faces))) {
    const Vector3d a = s.points.row(corners[0]), b = s.points.row(corners[1]), c = s.points.row(corners[2]);
    const Vector3d area = (b - a).cross(c - a);
    const double twice = area.norm();
    if (!(twice > 0.0)) continue;
    const Vector3d place = (a + b + c) / 3.0 - area * (tolerance / twice);
    // The fan of a concave face has triangles that lie outside of it.
    if (box.contains(place) && winding(s, place) > 0.5 && winding(t, place) > 0.5) return true;
  }
  return false;
}

bool penetrate(const ThickPanel& s, const ThickPanel& t, double tolerance) {
  return !find_crossings({s.points, s.faces}, {t.points, t.faces}, tolerance).empty() ||
         reaches_into(s, t, tolerance) || reaches_into(t, s, tolerance);
}

}  // namespace

SolidPairs examine_pairs(const WorkshopModel& model, const ThickPanels& solids, double tolerance) {
  std::map<std::pair<int, int>, std::vector<const WorkshopEdge*>> edges;
  for (const WorkshopEdge& e : model.edges)
    if (!e.border()) edges[std::minmax(e.left, e.right)].push_back(&e);

  std::vector<Box> boxes;
  std::vector<int> order;
  for (size_t p = 0; p < solids.panels.size(); ++p) {
    Box box;
    for (Eigen::Index i = 0; i < solids.panels[p].points.rows(); ++i)
      box.extend(solids.panels[p].points.row(i).transpose());
    boxes.push_back(box);
    if (!solids.panels[p].empty()) order.push_back(static_cast<int>(p));
  }
  const auto box = [&](int p) -> const Box& { return boxes[static_cast<size_t>(p)]; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return box(a).min().x() < box(b).min().x(); });

  SolidPairs pairs;
  for (size_t i = 0; i < order.size(); ++i)
    for (size_t k = i + 1; k < order.size() && box(order[k]).min().x() <= box(order[i]).max().x(); ++k) {
      if (!box(order[i]).intersects(box(order[k]))) continue;
      const auto [first, second] = std::minmax(order[i], order[k]);
      const ThickPanel &s = solids.panels[static_cast<size_t>(first)],
                       &t = solids.panels[static_cast<size_t>(second)];
      const auto shared = edges.find({first, second});
      if (shared != edges.end() &&
          std::any_of(shared->second.begin(), shared->second.end(),
                      [&](const WorkshopEdge* e) { return mitre_parts(model, *e, solids, tolerance); })) {
        ++pairs.parted_by_mitre;
      } else if (face_parts(s, t.points, tolerance) || face_parts(t, s.points, tolerance)) {
        ++pairs.parted_by_face;
      } else {
        ++pairs.tested;
        if (penetrate(s, t, tolerance)) pairs.penetrating.emplace_back(first, second);
      }
    }
  std::sort(pairs.penetrating.begin(), pairs.penetrating.end());
  return pairs;
}

}  // namespace planewright
