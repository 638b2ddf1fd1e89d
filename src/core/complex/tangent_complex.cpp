#include "core/complex/tangent_complex.h"

#include <algorithm>
#include <array>

namespace planewright {
namespace {

// One step along a panel's outline, with its ends in ascending order so that both panels of an edge sort
// together.
struct OutlineStep {
  int low, high, panel;
  bool ascending;
};

}  // namespace

void finish(TangentComplex& complex) {
  std::vector<OutlineStep> steps;
  steps.reserve(complex.panels.indices().size());
  for (int p = 0; p < complex.panels.size(); ++p) {
    const auto corners = complex.panels[p];
    for (size_t k = 0; k < corners.size(); ++k) {
      const int a = corners[k], b = corners[(k + 1) % corners.size()];
      if (a == b) continue;
      steps.push_back({std::min(a, b), std::max(a, b), p, a < b});
    }
  }
  std::stable_sort(steps.begin(), steps.end(), [](const OutlineStep& s, const OutlineStep& t) {
    return std::pair(s.low, s.high) < std::pair(t.low, t.high);
  });

  // Panels of a manifold mesh meet in pairs of opposite steps. In a dual, two panels can share more than one
  // edge between the same two points only if the primal has valence-2 vertices; then each pair is kept as its
  // own edge.
  complex.panel_edges.clear();
  for (size_t i = 0; i < steps.size();) {
    size_t end = i;
    while (end < steps.size() && steps[end].low == steps[i].low && steps[end].high == steps[i].high) ++end;
    std::vector<int> forward, backward;
    for (size_t k = i; k < end; ++k) (steps[k].ascending ? forward : backward).push_back(steps[k].panel);
    for (size_t k = 0; k < std::max(forward.size(), backward.size()); ++k)
      complex.panel_edges.push_back({steps[i].low, steps[i].high, k < forward.size() ? forward[k] : -1,
                                     k < backward.size() ? backward[k] : -1});
    i = end;
  }

  double sum = 0.0;
  for (const PanelEdge& e : complex.panel_edges)
    sum += (complex.preferred.row(e.a) - complex.preferred.row(e.b)).norm();
  const double mean =
      complex.panel_edges.empty() ? 0.0 : sum / static_cast<double>(complex.panel_edges.size());
  complex.mean_edge = mean > 0.0 ? mean : 1.0;
}

Polygons TangentComplex::fairing_neighbours() const {
  // A point of the outline has neighbours along the border and inwards; only the former count for it.
  std::vector<std::vector<int>> all(static_cast<size_t>(point_count())), along_border(all.size());
  for (const PanelEdge& e : panel_edges) {
    all[e.a].push_back(e.b);
    all[e.b].push_back(e.a);
    if (!e.border()) continue;
    along_border[e.a].push_back(e.b);
    along_border[e.b].push_back(e.a);
  }
  Polygons neighbours;
  neighbours.reserve(point_count(), 2 * static_cast<int>(panel_edges.size()));
  for (size_t j = 0; j < all.size(); ++j) {
    auto& list = along_border[j].empty() ? all[j] : along_border[j];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    neighbours.push_back(list);
  }
  return neighbours;
}

}  // namespace planewright
