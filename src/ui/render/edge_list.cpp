#include "ui/render/edge_list.h"

#include <algorithm>

namespace planewright::render {

EdgeList list_edges(const Polygons& polygons) {
  const auto& indices = polygons.indices();
  const int point_count = indices.empty() ? 0 : *std::max_element(indices.begin(), indices.end()) + 1;

  // Edges with the same lower end form a linked list; few meet in one point, so it is searched from end to
  // end.
  std::vector<int> first(static_cast<size_t>(point_count), -1), next;
  EdgeList list;
  list.edges.reserve(indices.size());
  next.reserve(indices.size());
  list.edge_of_corner.reserve(indices.size());
  for (int p = 0; p < polygons.size(); ++p) {
    const auto polygon = polygons[p];
    for (size_t k = 0; k < polygon.size(); ++k) {
      const auto [a, b] = std::minmax({polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0]});
      int e = first[a];
      while (e >= 0 && list.edges[e].b != b) e = next[e];
      if (e < 0) {
        e = static_cast<int>(list.edges.size());
        list.edges.push_back({a, b, 0});
        next.push_back(first[a]);
        first[a] = e;
      }
      ++list.edges[e].polygons;
      list.edge_of_corner.push_back(e);
    }
  }
  return list;
}

}  // namespace planewright::render
