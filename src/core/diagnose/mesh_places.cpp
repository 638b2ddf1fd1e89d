#include "core/diagnose/mesh_places.h"

#include <algorithm>

namespace planewright {

MeshPlaces::MeshPlaces(const TangentComplex& complex) : complex_(complex) {
  const auto& edges = complex.input.edges;
  first_.assign(static_cast<size_t>(complex.input.vertices.rows()) + 1, 0);
  for (const auto& edge : edges)
    for (const int v : edge) ++first_[static_cast<size_t>(v) + 1];
  for (size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  spokes_.resize(2 * edges.size());
  for (size_t e = 0; e < edges.size(); ++e)
    for (const size_t end : {0, 1})
      spokes_[static_cast<size_t>(next[static_cast<size_t>(edges[e][end])]++)] = {edges[e][1 - end],
                                                                                  static_cast<int>(e)};
  if (complex.kind != ComplexKind::Cluster) return;
  std::vector<std::array<int, 2>> regions(edges.size(), {-1, -1});
  for (int f = 0; f < complex.input.faces.size(); ++f)
    for (const int edge : round_face(f)) {
      auto& [first, second] = regions[static_cast<size_t>(edge)];
      (first < 0 ? first : second) = complex.region_of_face[static_cast<size_t>(f)];
    }
  for (size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = regions[e];
    if (a == b) continue;
    if (a >= 0) outlines_.push_back({a, b, static_cast<int>(e)});
    if (b >= 0) outlines_.push_back({b, a, static_cast<int>(e)});
  }
  std::sort(outlines_.begin(), outlines_.end());
}

std::vector<int> MeshPlaces::between_regions(int a, int b) const {
  std::vector<int> edges;
  for (auto at = std::lower_bound(outlines_.begin(), outlines_.end(), Outline{a, b, -1});
       at != outlines_.end() && at->region == a && at->beside == b; ++at)
    edges.push_back(at->edge);
  return edges;
}

int MeshPlaces::find_edge(int a, int b) const {
  for (int k = first_[static_cast<size_t>(a)]; k < first_[static_cast<size_t>(a) + 1]; ++k)
    if (spokes_[static_cast<size_t>(k)].other == b) return spokes_[static_cast<size_t>(k)].edge;
  return -1;
}

std::vector<int> MeshPlaces::round_vertex(int v) const {
  std::vector<int> edges;
  for (int k = first_[static_cast<size_t>(v)]; k < first_[static_cast<size_t>(v) + 1]; ++k)
    edges.push_back(spokes_[static_cast<size_t>(k)].edge);
  return edges;
}

std::vector<int> MeshPlaces::round_face(int f) const {
  const auto face = complex_.input.faces[f];
  std::vector<int> edges;
  for (size_t k = 0; k < face.size(); ++k)
    if (const int edge = find_edge(face[k], face[(k + 1) % face.size()]); edge >= 0) edges.push_back(edge);
  return united(std::move(edges), {});
}

std::vector<int> MeshPlaces::of_panel_edge(int panel_edge) const {
  if (complex_.kind == ComplexKind::Cluster) {
    const PanelEdge& edge = complex_.panel_edges[static_cast<size_t>(panel_edge)];
    return edge.left >= 0 ? between_regions(edge.left, edge.right) : between_regions(edge.right, edge.left);
  }
  std::array<int, 2> ends = complex_.crossed_edge[static_cast<size_t>(panel_edge)];
  if (complex_.kind == ComplexKind::Planarize) {
    const PanelEdge& edge = complex_.panel_edges[static_cast<size_t>(panel_edge)];
    ends = {complex_.point_origin[static_cast<size_t>(edge.a)].element,
            complex_.point_origin[static_cast<size_t>(edge.b)].element};
  }
  if (ends[0] < 0) return {};
  const int edge = find_edge(ends[0], ends[1]);
  return edge < 0 ? std::vector<int>{} : std::vector<int>{edge};
}

std::vector<int> MeshPlaces::of_panel(int panel) const {
  const int origin = complex_.plane_origin[static_cast<size_t>(panel)];
  if (complex_.kind == ComplexKind::Dual) return round_vertex(origin);
  if (complex_.kind == ComplexKind::Planarize) return round_face(origin);
  std::vector<int> edges;
  for (auto at = std::lower_bound(outlines_.begin(), outlines_.end(), Outline{origin, -1, -1});
       at != outlines_.end() && at->region == origin; ++at)
    edges.push_back(at->edge);
  return united(std::move(edges), {});
}

std::vector<int> MeshPlaces::of_point(int point) const {
  const PointOrigin& origin = complex_.point_origin[static_cast<size_t>(point)];
  switch (origin.kind) {
    case PointKind::Face:
      return round_face(origin.element);
    case PointKind::BorderEdge:
      return {origin.element};
    case PointKind::Vertex:
      return round_vertex(origin.element);
    case PointKind::Corner:
      return {};
  }
  return {};
}

std::vector<int> united(std::vector<int> edges, const std::vector<int>& others) {
  edges.insert(edges.end(), others.begin(), others.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace planewright
