#include "core/advise/patch.h"

#include <algorithm>
#include <unordered_map>

namespace planewright {
namespace {

// Whether the faces round a vertex that are taken lie side by side, so that they form one fan.
bool is_fan(const PolygonMesh& mesh, int vertex, const std::unordered_map<int, int>& taken) {
  const std::vector<int> round = mesh.faces_around(vertex);
  int starts = 0, inside = 0;
  for (size_t k = 0; k < round.size(); ++k) {
    const bool here = taken.contains(round[k]);
    const bool cyclic = !mesh.is_border_vertex(vertex);
    const bool before = (k > 0 || cyclic) && taken.contains(round[(k + round.size() - 1) % round.size()]);
    inside += here;
    starts += here && !before;
  }
  return inside == 0 || starts <= 1;
}

}  // namespace

Result<Patch> cut_patch(const PolygonMesh& mesh, const std::vector<int>& centre, int radius) {
  std::unordered_map<int, int> ring;  // by vertex
  std::vector<int> front;
  for (const int v : centre)
    if (ring.emplace(v, 0).second) front.push_back(v);
  std::unordered_map<int, int> taken;  // faces
  for (int distance = 0; distance <= radius + 1; ++distance) {
    std::vector<int> next;
    for (const int v : front)
      for (const int f : mesh.faces_around(v)) taken.emplace(f, 0);
    for (const int v : front)
      for (const int e : mesh.edges_around(v)) {
        const MeshEdge edge = mesh.edge(e);
        const int other = edge.a == v ? edge.b : edge.a;
        if (ring.emplace(other, distance + 1).second) next.push_back(other);
      }
    front = std::move(next);
  }
  // Corners of polygons that no edge of a nearer vertex leads to; and vertices where two fans meet.
  for (bool grown = true; grown;) {
    grown = false;
    std::vector<int> faces;
    for (const auto& [f, unused] : taken) faces.push_back(f);
    std::sort(faces.begin(), faces.end());
    for (const int f : faces)
      for (const int v : mesh.corners(f)) {
        ring.emplace(v, radius + 2);
        if (is_fan(mesh, v, taken)) continue;
        for (const int other : mesh.faces_around(v)) grown = taken.emplace(other, 0).second || grown;
      }
  }

  std::vector<int> faces;
  for (const auto& [f, unused] : taken) faces.push_back(f);
  std::sort(faces.begin(), faces.end());
  std::vector<int> vertices;
  for (const int f : faces)
    for (const int v : mesh.corners(f)) vertices.push_back(v);
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());

  Patch patch;
  patch.from_whole.vertices = index_map(vertices, mesh.vertex_count());
  patch.from_whole.faces = index_map(faces, mesh.face_count());
  Points positions(static_cast<Eigen::Index>(vertices.size()), 3);
  for (size_t k = 0; k < vertices.size(); ++k) {
    positions.row(static_cast<Eigen::Index>(k)) = mesh.positions().row(vertices[k]);
    const auto found = ring.find(vertices[k]);
    patch.rings.push_back(found != ring.end() ? found->second : radius + 2);
  }
  Polygons polygons;
  for (const int f : faces) {
    std::vector<int> corners = mesh.corners(f);
    for (int& v : corners) v = patch.from_whole.vertices.to_new[static_cast<size_t>(v)];
    polygons.push_back(corners);
  }
  patch.radius = radius;
  auto made = PolygonMesh::from_polygons(positions, polygons);
  if (!made) return tl::unexpected(made.error());
  patch.mesh = std::move(*made);
  std::vector<int> edges;
  for (int e = 0; e < patch.mesh.edge_count(); ++e) {
    const MeshEdge edge = patch.mesh.edge(e);
    edges.push_back(
        mesh.find_edge(vertices[static_cast<size_t>(edge.a)], vertices[static_cast<size_t>(edge.b)]));
  }
  patch.from_whole.edges = index_map(std::move(edges), mesh.edge_count());
  return patch;
}

}  // namespace planewright
