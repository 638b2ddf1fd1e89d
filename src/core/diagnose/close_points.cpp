#include "core/diagnose/close_points.h"

namespace planewright {

std::vector<Finding> find_close_points(const Subject& subject, double threshold) {
  const TangentComplex& complex = subject.complex;
  std::vector<Finding> found;
  for (size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    const double length = (subject.point(edge.a) - subject.point(edge.b)).norm() / complex.mean_edge;
    if (!(length < threshold)) continue;
    const int index = static_cast<int>(e);
    found.push_back(make_finding(FindingKind::ClosePoints, {ElementKind::PanelEdge, index}, length, threshold,
                                 1.0 - length / threshold));
    found.back().place = subject.absolute(subject.middle(edge));
    found.back().cause = "its two corners nearly coincide, so that it is too short to be built";
    found.back().mesh_edges = subject.mesh.of_panel_edge(index);
  }
  return found;
}

}  // namespace planewright
