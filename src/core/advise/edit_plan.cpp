#include "core/advise/edit_plan.h"

#include <algorithm>
#include <utility>

namespace planewright {
namespace {

int other_end(const MeshEdge& edge, int v) {
  return edge.a == v ? edge.b : edge.a;
}

// Marks all vertices within `rings` edges of the centre.
void mark(const PolygonMesh& mesh, const std::vector<int>& centre, int rings, std::vector<char>& marked) {
  std::vector<int> seen = centre, front = centre;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<int> next;
    for (const int v : front)
      for (const int e : mesh.edges_around(v)) next.push_back(other_end(mesh.edge(e), v));
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    seen.insert(seen.end(), next.begin(), next.end());
    front = std::move(next);
  }
  for (const int v : seen) marked[static_cast<size_t>(v)] = 1;
}

}  // namespace

std::vector<int> choose_apart(const PolygonMesh& mesh, const std::vector<Suggestion>& ranked) {
  std::vector<char> taken(static_cast<size_t>(mesh.vertex_count()), 0);
  std::vector<int> chosen;
  for (size_t k = 0; k < ranked.size(); ++k) {
    const std::vector<int>& centre = ranked[k].candidate.centre;
    if (std::any_of(centre.begin(), centre.end(), [&](int v) { return taken[static_cast<size_t>(v)] != 0; }))
      continue;
    chosen.push_back(static_cast<int>(k));
    mark(mesh, centre, kApart - 1, taken);
  }
  return chosen;
}

std::vector<MeshEdit> in_order(const PolygonMesh& mesh, const std::vector<MeshEdit>& edits) {
  std::vector<MeshEdit> ordered;
  EditedMesh present{mesh, identity_map(mesh)};
  for (const MeshEdit& edit : edits) {
    const MeshEdit now = renumbered(edit, present.map);
    auto next = apply(present.mesh, now);
    if (!next) break;
    present = {std::move(next->mesh), composed(present.map, next->map)};
    ordered.push_back(now);
  }
  return ordered;
}

}  // namespace planewright
