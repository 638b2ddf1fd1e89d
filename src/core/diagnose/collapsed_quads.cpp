#include "core/diagnose/collapsed_quads.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace planewright {
namespace {

struct Corner {
  double share;  // 2 * area of its triangle / area of the quad
  size_t index;
};

Corner flattest_corner(const Subject& subject, int panel) {
  const auto corners = subject.complex.panels[panel];
  const Vector3d normal = subject.state.n.row(panel);
  const double twice_area = normal.dot(newell_vector(subject.state.x, corners));
  Corner flattest{1.0, 0};
  for (size_t k = 0; k < 4; ++k) {
    const Vector3d at = subject.point(corners[k]);
    const Vector3d ahead = subject.point(corners[(k + 1) % 4]) - at,
                   back = subject.point(corners[(k + 3) % 4]) - at;
    const double twice_corner = normal.dot(ahead.cross(back));
    // Turned over or without area: all corners are as bad.
    const double share = twice_area > 0.0 ? 2.0 * twice_corner / twice_area : -1.0;
    if (share < flattest.share) flattest = {share, k};
  }
  return flattest;
}

size_t shortest_step(const Subject& subject, std::span<const int> corners) {
  const auto length = [&](size_t k) {
    return (subject.point(corners[(k + 1) % 4]) - subject.point(corners[k])).squaredNorm();
  };
  size_t shortest = 0;
  for (size_t k = 1; k < 4; ++k)
    if (length(k) < length(shortest)) shortest = k;
  return shortest;
}

}  // namespace

std::vector<Finding> find_collapsed_quads(const Subject& subject, double threshold) {
  const TangentComplex& complex = subject.complex;
  std::vector<Finding> found;
  if (complex.kind != ComplexKind::Planarize) return found;
  for (int p = 0; p < complex.panels.size(); ++p) {
    const auto corners = complex.panels[p];
    if (corners.size() != 4) continue;
    const Corner flattest = flattest_corner(subject, p);
    if (!(flattest.share < threshold)) continue;
    found.push_back(make_finding(FindingKind::CollapsedQuad, {ElementKind::Panel, p}, flattest.share,
                                 threshold, threshold - flattest.share));
    found.back().place = subject.absolute(subject.point(corners[flattest.index]));
    found.back().cause = "its strip turns here, and the quad has become a triangle";
    const size_t k = shortest_step(subject, corners);
    const auto vertex = [&](size_t corner) {
      return complex.point_origin[static_cast<size_t>(corners[corner % 4])].element;
    };
    if (const int edge = subject.mesh.find_edge(vertex(k), vertex(k + 1)); edge >= 0)
      found.back().mesh_edges = {edge};
  }
  return found;
}

}  // namespace planewright
