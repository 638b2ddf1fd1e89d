#include "core/diagnose/not_convex_panels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnose/panel_shape.h"

namespace planewright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kInputReflex = 0.1;  // degrees: what a face may have and still count as convex

struct Reflex {
  double degrees = 0.0;
  int corner = -1;  // position in the outline; -1: convex
};

// The worst corner, seen along `normal`. Steps without length (below `least`) are no corners.
Reflex worst_reflex(const Points& points, std::span<const int> outline, const Vector3d& normal,
                    double least) {
  Reflex worst;
  const size_t n = outline.size();
  if (n <= 3) return worst;
  Vector3d before = Vector3d::Zero();
  for (size_t k = n; k-- > 0 && before.isZero();) {
    const Vector3d step = points.row(outline[(k + 1) % n]) - points.row(outline[k]);
    if (step.squaredNorm() > least * least) before = step;
  }
  for (size_t k = 0; k < n; ++k) {
    const Vector3d step = points.row(outline[(k + 1) % n]) - points.row(outline[k]);
    if (!(step.squaredNorm() > least * least)) continue;
    const double turn = normal.dot(before.cross(step));
    if (turn < 0.0) {
      const double degrees = kDegrees * std::atan2(-turn, before.dot(step));
      if (degrees > worst.degrees) worst = {degrees, static_cast<int>(k)};
    }
    before = step;
  }
  return worst;
}

double angle_at(const InputSurface& input, int face, int vertex) {
  const auto corners = input.faces[face];
  const auto n = corners.size();
  const auto k = static_cast<size_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  if (k == n) return 0.0;
  const Vector3d at = input.vertices.row(vertex);
  const Vector3d a = input.vertices.row(corners[(k + 1) % n]).transpose() - at;
  const Vector3d b = input.vertices.row(corners[(k + n - 1) % n]).transpose() - at;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool could_be_convex(const TangentComplex& complex, int panel, double least_defect) {
  const int origin = complex.plane_origin[static_cast<size_t>(panel)];
  const InputSurface& input = complex.input;
  if (complex.kind == ComplexKind::Planarize)
    return worst_reflex(input.vertices, input.faces[origin], input.face_normals.row(origin), 0.0).degrees <
           kInputReflex;
  if (complex.kind == ComplexKind::Cluster)
    return worst_reflex(complex.preferred, complex.panels[panel], complex.normals.row(panel), 0.0).degrees <
           kInputReflex;
  double sum = 0.0;
  for (const int j : complex.panels[panel]) {
    const PointOrigin& point = complex.point_origin[static_cast<size_t>(j)];
    if (point.kind != PointKind::Face) return false;  // at the border
    sum += angle_at(input, point.element, origin);
  }
  return 360.0 - kDegrees * sum > least_defect;
}

}  // namespace

std::vector<Finding> find_not_convex_panels(const Subject& subject, double threshold, double least_defect) {
  const TangentComplex& complex = subject.complex;
  std::vector<Finding> found;
  for (int p = 0; p < complex.panels.size(); ++p) {
    const Reflex reflex = worst_reflex(subject.state.x, complex.panels[p], subject.state.n.row(p).transpose(),
                                       1e-9 * complex.mean_edge);
    if (!(reflex.degrees > threshold) || !could_be_convex(complex, p, least_defect) ||
        crosses_itself(subject.state.x, complex.panels[p]))
      continue;
    found.push_back(make_finding(FindingKind::NotConvex, {ElementKind::Panel, p}, reflex.degrees, threshold,
                                 (reflex.degrees - threshold) / 90.0));
    found.back().place =
        subject.absolute(subject.point(complex.panels[p][static_cast<size_t>(reflex.corner)]));
    found.back().cause =
        complex.kind == ComplexKind::Dual
            ? "it has a reflex corner, although the design bulges here and allows a convex one"
        : complex.kind == ComplexKind::Planarize
            ? "it has a reflex corner, although the face of the design is convex"
            : "it has a reflex corner, although the corners of its region are convex";
    found.back().mesh_edges = subject.mesh.of_panel(p);
  }
  return found;
}

}  // namespace planewright
