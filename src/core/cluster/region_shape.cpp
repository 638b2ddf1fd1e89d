#include "core/cluster/region_shape.h"

namespace planewright {

RegionShapes::RegionShapes(const FaceGraph& graph, const std::vector<int>& region_of_face)
    : graph_(graph),
      region_of_face_(region_of_face),
      seen_vertex_(static_cast<size_t>(graph.vertices.rows()), 0),
      seen_corner_(graph.across.size(), 0),
      left_(seen_vertex_.size(), 0) {}

int RegionShapes::fans_at(int v) const {
  const int start = graph_.corner_of_vertex[v];
  if (start < 0) return 0;
  // Round an inner vertex the first run may have begun before the start.
  int fans = graph_.on_border[v] ? 1 : 0;
  for (int c = start;;) {
    const int next = graph_.turn_left(c);
    if (next < 0) return fans;
    if (region_of_face_[graph_.face_of_corner[next]] != region_of_face_[graph_.face_of_corner[c]]) ++fans;
    if (next == start) return fans == 0 ? 1 : fans;
    c = next;
  }
}

int RegionShapes::next_on_outline(int c) const {
  for (c = graph_.next(c); !on_outline(c);) c = graph_.next(graph_.across[c]);
  return c;
}

RegionShape RegionShapes::of(std::span<const int> faces) {
  RegionShape shape;
  ++stamp_;
  int inner_halves = 0, vertices = 0, on_outline_vertices = 0;
  for (const int f : faces)
    for (int c = graph_.faces.offsets()[f]; c < graph_.faces.offsets()[f + 1]; ++c) {
      inner_halves += on_outline(c) ? 0 : 1;
      int& seen = seen_vertex_[graph_.tail(c)];
      vertices += seen == stamp_ ? 0 : 1;
      seen = stamp_;
    }
  for (const int f : faces)
    for (int start = graph_.faces.offsets()[f]; start < graph_.faces.offsets()[f + 1]; ++start) {
      if (!on_outline(start) || seen_corner_[start] == stamp_) continue;
      std::vector<int> loop;
      int c = start;
      do {
        seen_corner_[c] = stamp_;
        loop.push_back(c);
        const int v = graph_.tail(c);
        if (left_[v] == stamp_) {
          if (shape.touching < 0) shape.touching = v;
        } else {
          left_[v] = stamp_;
          ++on_outline_vertices;
          shape.corners += is_corner(v) ? 1 : 0;
        }
        c = next_on_outline(c);
      } while (c != start);
      shape.loops.push_back(std::move(loop));
    }
  // The outline has as many fans as edges.
  shape.euler = vertices - on_outline_vertices - inner_halves / 2 + static_cast<int>(faces.size());
  return shape;
}

Polygons faces_of_regions(const std::vector<int>& region_of_face, int count) {
  std::vector<std::vector<int>> lists(static_cast<size_t>(count));
  for (size_t f = 0; f < region_of_face.size(); ++f) lists[region_of_face[f]].push_back(static_cast<int>(f));
  Polygons faces;
  faces.reserve(count, static_cast<int>(region_of_face.size()));
  for (const auto& list : lists) faces.push_back(list);
  return faces;
}

}  // namespace planewright
