#include "core/workshop/panel_passport.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnose/panel_shape.h"
#include "core/workshop/panel_plane.h"
#include "core/workshop/panel_rectangle.h"

namespace planewright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kKilogramsPerCubicMillimetre = 1e-9;  // of 1 kg/m^3

// From `from` to `to`, anticlockwise seen against `normal`, 0..360.
double turn_degrees(const Vector3d& from, const Vector3d& to, const Vector3d& normal) {
  const double degrees = kDegrees * std::atan2(normal.dot(from.cross(to)), from.dot(to));
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

// Side k's step to the next corner, for all sides.
std::vector<Vector3d> side_steps(const Points& points, std::span<const int> corners) {
  std::vector<Vector3d> steps;
  for (size_t k = 0; k < corners.size(); ++k)
    steps.push_back((points.row(corners[(k + 1) % corners.size()]) - points.row(corners[k])).transpose());
  return steps;
}

double interior_angle(const std::vector<Vector3d>& steps, size_t corner, const Vector3d& normal) {
  if (steps[corner].isZero(0.0)) return 180.0;
  size_t before = corner;
  do before = (before + steps.size() - 1) % steps.size();
  while (before != corner && steps[before].isZero(0.0));
  return turn_degrees(steps[corner], -steps[before], normal);
}

// Positive: the neighbour turns away from the outside, a ridge.
double ridge_degrees(const WorkshopModel& model, int panel, int neighbour, const Vector3d& side) {
  const Vector3d n = model.normals.row(panel), m = model.normals.row(neighbour);
  return kDegrees * std::atan2(side.stableNormalized().dot(n.cross(m)), n.dot(m));
}

std::vector<SidePassport> measure_sides(const WorkshopModel& model, int panel) {
  const std::vector<Vector3d> steps = side_steps(model.points, model.panels[panel]);
  const Vector3d normal = model.normals.row(panel);
  std::vector<SidePassport> sides(steps.size());
  for (size_t k = 0; k < steps.size(); ++k) {
    SidePassport& side = sides[k];
    side.neighbour = model.neighbour(panel, static_cast<int>(k));
    side.length = steps[k].norm();
    side.interior = interior_angle(steps, k, normal);
    if (side.neighbour < 0) continue;
    const double ridge = ridge_degrees(model, panel, side.neighbour, steps[k]);
    side.dihedral = 180.0 + ridge;
    side.bevel = 0.5 * ridge;
  }
  return sides;
}

// mm, of each point that panels use; 0 of the others.
Vector reference_distances(const WorkshopModel& model, const ReferenceSurface& reference) {
  const double factor = millimetres_per(model.model_unit);
  const Vector3d origin = model.origin / factor;
  std::vector<bool> done(static_cast<size_t>(model.points.rows()), false);
  Vector distances = Vector::Zero(model.points.rows());
  for (const int v : model.panels.indices()) {
    if (done[static_cast<size_t>(v)]) continue;
    done[static_cast<size_t>(v)] = true;
    distances[v] =
        factor * std::abs(reference.closest(model.points.row(v).transpose() / factor, origin).distance);
  }
  return distances;
}

}  // namespace

std::vector<PanelPassport> make_passports(const WorkshopModel& model, const PassportOptions& options) {
  const Vector distances =
      options.reference == nullptr ? Vector() : reference_distances(model, *options.reference);
  std::vector<PanelPassport> passports(static_cast<size_t>(model.panel_count()));
  for (int p = 0; p < model.panel_count(); ++p) {
    PanelPassport& passport = passports[static_cast<size_t>(p)];
    const auto corners = model.panels[p];
    const Vector3d normal = model.normals.row(p);
    passport.panel = p;
    passport.area = 0.5 * newell_vector(model.points, corners).norm();
    passport.sides = measure_sides(model, p);
    for (const SidePassport& side : passport.sides) passport.perimeter += side.length;
    // Three corners have a plane of their own, exactly.
    if (corners.size() > 3)
      for (const int v : corners)
        passport.planarity =
            std::max(passport.planarity, std::abs(normal.dot(model.points.row(v)) - model.plane_offsets[p]));
    const SmallestRectangle rectangle = smallest_rectangle(flat_outline(model.points, corners, normal));
    passport.width = rectangle.width;
    passport.height = rectangle.height;
    if (options.reference != nullptr) {
      passport.distance = 0.0;
      for (const int v : corners) passport.distance = std::max(*passport.distance, distances[v]);
    }
    if (options.thickness > 0.0 && options.density > 0.0)
      passport.weight = passport.area * options.thickness * options.density * kKilogramsPerCubicMillimetre;
    passport.crosses_itself = crosses_itself(model.points, corners);
  }
  return passports;
}

}  // namespace planewright
