#include "core/diagnose/far_points.h"

namespace planewright {

std::vector<Finding> find_far_points(const Subject& subject, double threshold) {
  const TangentComplex& complex = subject.complex;
  std::vector<Finding> found;
  for (int j = 0; j < complex.point_count(); ++j) {
    const double distance = (subject.state.x.row(j) - complex.preferred.row(j)).norm() / complex.mean_edge;
    if (!(distance > threshold)) continue;
    found.push_back(make_finding(FindingKind::FarPoint, {ElementKind::Point, j}, distance, threshold,
                                 1.0 - threshold / distance));
    found.back().place = subject.absolute(subject.point(j));
    found.back().cause = "the planes that meet here have their common point far from the design";
    found.back().mesh_edges = subject.mesh.of_point(j);
  }
  return found;
}

}  // namespace planewright
