#include "core/problem/demands/pins.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>

#include "core/problem/demands/linear_rows.h"

namespace planewright {
namespace {

// Two pins nearer than this agree, edges.
constexpr double kSame = 1e-9;

std::string describe(const PointOrigin& origin) {
  const std::string number = std::to_string(origin.element);
  switch (origin.kind) {
    case PointKind::Face:
      return "the point of face " + number;
    case PointKind::BorderEdge:
      return "the point of border edge " + number;
    case PointKind::Corner:
      return "the corner at vertex " + number;
    case PointKind::Vertex:
      return "vertex " + number;
  }
  return number;
}

}  // namespace

Result<std::unique_ptr<Constraint>> make_pin_constraint(const TangentComplex& complex, const Layout& layout,
                                                        const Demands& demands, const PinFrame& frame) {
  auto rows = std::make_unique<LinearRows>("pin", "edges");
  std::map<std::pair<int, int>, int> point_of;
  for (int j = 0; j < complex.point_count(); ++j) {
    const PointOrigin& origin = complex.point_origin[static_cast<size_t>(j)];
    point_of[{static_cast<int>(origin.kind), origin.element}] = j;
  }
  struct Held {
    double value;
    size_t pin;
  };
  std::map<int, Held> held;  // by variable
  for (size_t p = 0; p < demands.pins.size(); ++p) {
    const Pin& pin = demands.pins[p];
    const std::string where = std::string("pin ").append(std::to_string(p + 1));
    const auto point = point_of.find({static_cast<int>(pin.point.kind), pin.point.element});
    if (point == point_of.end())
      return fail(ErrorCode::Usage, "a pin holds " + describe(pin.point) + ", which these panels do not have",
                  where, "Remove the pin, or name a point of this design");
    if (!pin.at[0] && !pin.at[1] && !pin.at[2])
      return fail(ErrorCode::Usage, "the pin of " + describe(pin.point) + " holds no coordinate", where,
                  "Give at least one of x, y, z");
    for (int axis = 0; axis < 3; ++axis) {
      if (!pin.at[static_cast<size_t>(axis)]) continue;
      if (!std::isfinite(*pin.at[static_cast<size_t>(axis)]))
        return fail(ErrorCode::Usage, "the pin of " + describe(pin.point) + " holds it at no finite number",
                    where);
      const double value = (*pin.at[static_cast<size_t>(axis)] - frame.centre[axis]) / frame.scale;
      const int variable = layout.x(point->second, axis);
      if (const auto before = held.find(variable); before != held.end()) {
        if (std::abs(before->second.value - value) > kSame)
          return fail(ErrorCode::Infeasible,
                      std::string("pin ") + std::to_string(before->second.pin + 1) + " and " + where +
                          " hold " + describe(pin.point) + " at different places",
                      where, "Remove one of the two");
        continue;
      }
      held[variable] = {value, p};
      rows->add(std::array{variable}, std::array{1.0}, {value, value}, {ElementKind::Point, point->second});
    }
  }
  return std::unique_ptr<Constraint>(std::move(rows));
}

Result<std::unique_ptr<Constraint>> make_plane_pin_constraint(const TangentComplex& complex,
                                                              const Layout& layout, const Demands& demands,
                                                              const PinFrame& frame) {
  auto rows = std::make_unique<LinearRows>("plane pin", "edges");
  std::map<int, int> plane_of;
  for (int i = 0; i < complex.plane_count(); ++i) plane_of[complex.plane_origin[static_cast<size_t>(i)]] = i;
  struct Held {
    Vector3d normal;
    double offset;
    size_t pin;
  };
  std::map<int, Held> held;
  for (size_t p = 0; p < demands.plane_pins.size(); ++p) {
    const PlanePin& pin = demands.plane_pins[p];
    const std::string where = std::string("plane pin ").append(std::to_string(p + 1));
    const std::string panel = (complex.kind == ComplexKind::Dual        ? "the panel of vertex "
                               : complex.kind == ComplexKind::Planarize ? "face "
                                                                        : "region ") +
                              std::to_string(pin.panel_origin);
    const auto plane = plane_of.find(pin.panel_origin);
    if (plane == plane_of.end())
      return fail(ErrorCode::Usage, "a plane pin holds " + panel + ", which this design does not have", where,
                  "Remove the pin, or name a panel of this design");
    const int i = plane->second;
    Vector3d normal = complex.normals.row(i);
    double offset = complex.offsets[i];
    if (pin.plane) {
      const Vector3d given(pin.plane->normal[0], pin.plane->normal[1], pin.plane->normal[2]);
      if (!given.allFinite() || !(given.norm() > 0.0) || !std::isfinite(pin.plane->distance))
        return fail(ErrorCode::Usage, "the plane for " + panel + " has no direction", where,
                    "Give a normal of positive length and a finite distance");
      normal = given.normalized();
      // normal . X = distance, with X = centre + scale x and the anchor v: h = normal . (x - v).
      offset =
          (pin.plane->distance - normal.dot(frame.centre)) / frame.scale - normal.dot(complex.anchors.row(i));
      if (normal.dot(complex.normals.row(i)) < 0.0) {  // the same plane, seen from the panel's own side
        normal = -normal;
        offset = -offset;
      }
    }
    if (const auto before = held.find(i); before != held.end()) {
      if ((before->second.normal - normal).norm() > kSame || std::abs(before->second.offset - offset) > kSame)
        return fail(ErrorCode::Infeasible,
                    "plane pin " + std::to_string(before->second.pin + 1) + " and " + where + " hold " +
                        panel + " in different planes",
                    where, "Remove one of the two");
      continue;
    }
    held[i] = {normal, offset, p};
    const ElementRef element{ElementKind::Panel, i};
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
    rows->add_point(layout.n(i), u, {0.0, 0.0}, element);
    rows->add_point(layout.n(i), v, {0.0, 0.0}, element);
    rows->add(std::array{layout.h(i)}, std::array{1.0}, {offset, offset}, element);
  }
  return std::unique_ptr<Constraint>(std::move(rows));
}

}  // namespace planewright
