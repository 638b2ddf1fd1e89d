#include "core/diagnose/ill_determined_points.h"

#include "core/diagnose/ill_determined.h"

namespace planewright {

std::vector<Finding> find_ill_determined_points(const Subject& subject, double threshold) {
  const Vector moves = tilt_moves(subject.complex, subject.state);
  if (threshold <= 0.0) threshold = notable_tilt_move(moves);
  std::vector<Finding> found;
  for (int j = 0; j < subject.complex.point_count(); ++j) {
    if (!(moves[j] > threshold)) continue;
    found.push_back(make_finding(FindingKind::IllDetermined, {ElementKind::Point, j}, moves[j], threshold,
                                 1.0 - threshold / moves[j]));
    found.back().place = subject.absolute(subject.point(j));
    found.back().cause = "its planes are nearly parallel, so that a small tilt of one throws it far away";
    found.back().mesh_edges = subject.mesh.of_point(j);
  }
  return found;
}

}  // namespace planewright
