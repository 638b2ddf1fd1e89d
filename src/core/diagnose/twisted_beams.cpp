#include "core/diagnose/twisted_beams.h"

#include <numbers>

#include "core/layers/beams.h"

namespace planewright {

std::vector<Finding> find_twisted_beams(const Subject& subject, const NeighbourLayer& other,
                                        double threshold) {
  std::vector<Finding> found;
  const auto beams = make_beams(subject.complex, subject.state, *other.complex, other.state);
  if (!beams) return found;
  for (size_t k = 0; k < beams->edge.size(); ++k) {
    const double twist = beams->twist[k] * 180.0 / std::numbers::pi;
    if (!(twist > threshold)) continue;
    found.push_back(make_finding(FindingKind::TwistedBeam, {ElementKind::PanelEdge, beams->edge[k]}, twist,
                                 threshold, (twist - threshold) / 90.0));
    found.back().place = subject.absolute(centroid(beams->points, beams->quads[static_cast<int>(k)]));
    found.back().cause = twist > 90.0 ? "the panel edges of the two layers run against each other here"
                                      : "the panel edges of the two layers are not parallel here";
    found.back().mesh_edges = subject.mesh.of_panel_edge(beams->edge[k]);
  }
  return found;
}

}  // namespace planewright
