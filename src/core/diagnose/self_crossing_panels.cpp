#include "core/diagnose/self_crossing_panels.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/diagnose/panel_shape.h"

namespace planewright {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

struct Loop {
  double share = 0.0;                 // of the outline
  Vector3d place = Vector3d::Zero();  // where it crosses, local
};

// The largest loop that the outline of a panel cuts off, seen along the panel's normal.
Loop largest_loop(const Subject& subject, int panel) {
  const auto corners = subject.complex.panels[panel];
  const size_t n = corners.size();
  const Vector3d normal = subject.state.n.row(panel);
  const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Vector2d> flat;
  std::vector<double> until{0.0};  // length of the outline up to each corner
  for (size_t k = 0; k < n; ++k) {
    const Vector3d arm = subject.point(corners[k]) - subject.point(corners[0]);
    flat.emplace_back(u.dot(arm), v.dot(arm));
    until.push_back(until[k] + (subject.point(corners[(k + 1) % n]) - subject.point(corners[k])).norm());
  }
  Loop largest;
  for (size_t i = 0; i < n; ++i)
    for (size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;  // neighbours over the end of the list
      const Vector2d along_i = flat[i + 1] - flat[i], along_k = flat[(k + 1) % n] - flat[k];
      const double area = cross(along_i, along_k);
      if (area == 0.0) continue;
      const double s = cross(flat[k] - flat[i], along_k) / area, t = cross(flat[k] - flat[i], along_i) / area;
      if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) continue;
      const double loop = until[k] + t * (until[k + 1] - until[k]) - until[i] - s * (until[i + 1] - until[i]);
      const double share = std::min(loop, until[n] - loop) / until[n];
      if (share > largest.share)
        largest = {share, subject.point(corners[i]) +
                              s * (subject.point(corners[i + 1]) - subject.point(corners[i]))};
    }
  return largest;
}

}  // namespace

std::vector<Finding> find_self_crossing_panels(const Subject& subject, double threshold) {
  std::vector<Finding> found;
  for (const int panel : find_self_crossing(subject.state.x, subject.complex.panels)) {
    const Loop loop = largest_loop(subject, panel);
    if (!(loop.share > threshold)) continue;
    found.push_back(make_finding(FindingKind::SelfCrossing, {ElementKind::Panel, panel}, loop.share,
                                 threshold, 2.0 * (loop.share - threshold)));
    found.back().place = subject.absolute(loop.place);
    found.back().cause = "its outline crosses itself, because its corners change their order";
    found.back().mesh_edges = subject.mesh.of_panel(panel);
  }
  return found;
}

}  // namespace planewright
