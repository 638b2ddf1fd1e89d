#include "core/mesh/element_map.h"

#include <numeric>
#include <utility>

namespace planewright {
namespace {

IndexMap identity(int count) {
  IndexMap map;
  map.to_new.resize(static_cast<size_t>(count));
  std::iota(map.to_new.begin(), map.to_new.end(), 0);
  map.to_old = map.to_new;
  return map;
}

std::vector<int> composed(std::vector<int> first, const std::vector<int>& second) {
  for (int& i : first)
    if (i >= 0) i = second[static_cast<size_t>(i)];
  return first;
}

}  // namespace

ElementMap identity_map(const PolygonMesh& mesh) {
  return {identity(mesh.vertex_count()), identity(mesh.edge_count()), identity(mesh.face_count())};
}

IndexMap composed(const IndexMap& first, const IndexMap& second) {
  return {composed(first.to_new, second.to_new), composed(second.to_old, first.to_old)};
}

ElementMap composed(const ElementMap& first, const ElementMap& second) {
  return {composed(first.vertices, second.vertices), composed(first.edges, second.edges),
          composed(first.faces, second.faces)};
}

IndexMap inverse(IndexMap map) {
  std::swap(map.to_new, map.to_old);
  return map;
}

ElementMap inverse(ElementMap map) {
  return {inverse(std::move(map.vertices)), inverse(std::move(map.edges)), inverse(std::move(map.faces))};
}

IndexMap index_map(std::vector<int> to_old, int old_count) {
  IndexMap map;
  map.to_new.assign(static_cast<size_t>(old_count), -1);
  map.to_old = std::move(to_old);
  for (size_t i = 0; i < map.to_old.size(); ++i)
    if (map.to_old[i] >= 0) map.to_new[static_cast<size_t>(map.to_old[i])] = static_cast<int>(i);
  return map;
}

}  // namespace planewright
