#include "core/diagnose/crossing_panels.h"

#include <algorithm>
#include <cmath>

#include "core/diagnose/crossing_suspects.h"
#include "core/diagnose/crossings.h"
#include "core/diagnose/panel_shape.h"

namespace planewright {
namespace {

constexpr double kWorstDepth = 0.5;  // mean edges: about the middle of a panel

// The exact test, of suspects alone.
std::vector<Crossing> confirmed(const Subject& subject, const std::vector<std::array<int, 2>>& suspects,
                                double touch) {
  if (suspects.empty()) return {};
  std::vector<int> panels;
  for (const auto& pair : suspects) panels.insert(panels.end(), pair.begin(), pair.end());
  std::sort(panels.begin(), panels.end());
  panels.erase(std::unique(panels.begin(), panels.end()), panels.end());
  Polygons polygons;
  for (const int p : panels) polygons.push_back(subject.complex.panels[p]);
  std::vector<Crossing> crossings = find_crossings_within({subject.state.x, polygons}, touch);
  for (Crossing& crossing : crossings) {
    crossing.first = panels[static_cast<size_t>(crossing.first)];
    crossing.second = panels[static_cast<size_t>(crossing.second)];
  }
  return crossings;
}

bool neighbours(const Polygons& panels, int p, int q) {
  const auto a = panels[p], b = panels[q];
  return std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end();
}

// The mesh edges between two panels; where there are none, all at both.
std::vector<int> edges_between(const MeshPlaces& mesh, int p, int q) {
  const std::vector<int> of_p = mesh.of_panel(p), of_q = united(mesh.of_panel(q), {});
  std::vector<int> common;
  for (const int edge : of_p)
    if (std::binary_search(of_q.begin(), of_q.end(), edge)) common.push_back(edge);
  return common.empty() ? united(of_p, of_q) : common;
}

Vector3d middle(const Points& points, const Crossing& crossing) {
  return 0.5 * (centroid(points, crossing.first_corners) + centroid(points, crossing.second_corners));
}

void add_turned_over(const Subject& subject, double threshold, std::vector<Finding>& found) {
  const TangentComplex& complex = subject.complex;
  const Points& outwards = complex.kind == ComplexKind::Dual        ? complex.input.vertex_normals
                           : complex.kind == ComplexKind::Planarize ? complex.input.face_normals
                                                                    : complex.normals;
  for (int p = 0; p < complex.panels.size(); ++p) {
    const Vector3d normal = subject.state.n.row(p);
    const double area = 0.5 * normal.dot(newell_vector(subject.state.x, complex.panels[p]));
    const bool backwards = normal.dot(outwards.row(complex.plane_origin[static_cast<size_t>(p)])) < 0.0;
    if (area >= 0.0 && !backwards) continue;
    const double size = std::sqrt(std::abs(area)) / complex.mean_edge;
    if (!(size > threshold) || crosses_itself(subject.state.x, complex.panels[p])) continue;
    found.push_back(make_finding(FindingKind::FoldedOver, {ElementKind::Panel, p}, size, threshold,
                                 (size - threshold) / kWorstDepth));
    found.back().place = subject.absolute(subject.centre(p));
    found.back().cause = "it is turned over and lies on its neighbours";
    found.back().mesh_edges = subject.mesh.of_panel(p);
  }
}

}  // namespace

std::vector<Finding> find_crossing_panels(const Subject& subject, const FindingSettings& settings) {
  const TangentComplex& complex = subject.complex;
  const auto &folded = settings[FindingKind::FoldedOver], &crossing = settings[FindingKind::CrossingPanels];
  std::vector<Finding> found;
  if (folded.on) add_turned_over(subject, folded.threshold, found);
  if (!folded.on && !crossing.on) return found;
  const double touch =
      std::min(folded.on ? folded.threshold : INFINITY, crossing.on ? crossing.threshold : INFINITY);
  const double edge = complex.mean_edge;
  const auto suspects = crossing_suspects(subject.state.x, complex.panels, subject.state.n, touch * edge,
                                          settings.planar * edge);
  for (const Crossing& pair : confirmed(subject, suspects, touch * edge)) {
    // The exact test looks at all pairs of the panels that it is given.
    if (!std::binary_search(suspects.begin(), suspects.end(), std::array{pair.first, pair.second})) continue;
    const bool meet = neighbours(complex.panels, pair.first, pair.second);
    const double threshold = (meet ? folded : crossing).threshold, depth = pair.depth / edge;
    if (!(meet ? folded : crossing).on || !(depth > threshold)) continue;
    found.push_back(make_finding(meet ? FindingKind::FoldedOver : FindingKind::CrossingPanels,
                                 {ElementKind::Panel, pair.first}, depth, threshold,
                                 (depth - threshold) / kWorstDepth));
    found.back().second = ElementRef{ElementKind::Panel, pair.second};
    found.back().place = subject.absolute(middle(subject.state.x, pair));
    found.back().cause = meet ? "it folds over a neighbour" : "it goes through another panel of the layer";
    found.back().mesh_edges = edges_between(subject.mesh, pair.first, pair.second);
  }
  return found;
}

}  // namespace planewright
