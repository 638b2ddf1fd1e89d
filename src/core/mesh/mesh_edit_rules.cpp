#include "core/mesh/mesh_edit_rules.h"

#include <algorithm>
#include <utility>

#include "core/mesh/mesh_edits.h"

namespace planewright {
namespace {

using std::to_string;

Result<void> refuse(std::string what, std::string where, std::string remedy = {}) {
  return fail(ErrorCode::Refused, std::move(what), std::move(where), std::move(remedy));
}

bool contains(const std::vector<int>& list, int value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

int valence(const PolygonMesh& mesh, int v) {
  return static_cast<int>(mesh.edges_around(v).size());
}

std::vector<int> neighbours(const PolygonMesh& mesh, int v) {
  std::vector<int> result = mesh.edges_around(v);
  for (int& e : result) {
    const MeshEdge edge = mesh.edge(e);
    e = edge.a == v ? edge.b : edge.a;
  }
  return result;
}

// An inner vertex between two faces alone is a corner of nothing: its panel would have no area (dual), or its
// two faces would meet in one straight line of panels (planarize).
Result<void> too_few_left(int vertex, const std::string& where) {
  return refuse("vertex " + to_string(vertex) + " would be left with two edges inside the mesh", where,
                "Collapse an edge of that vertex first.");
}

Result<void> may_flip(const PolygonMesh& mesh, int edge) {
  if (mesh.can_flip(edge)) return {};
  const std::string where = "edge " + to_string(edge);
  const MeshEdge e = mesh.edge(edge);
  if (e.border()) return refuse("an edge of the border cannot be flipped", where, "Click an inner edge.");
  if (mesh.valence(e.left) != 3 || mesh.valence(e.right) != 3) {
    return refuse("only an edge between two triangles can be flipped", where,
                  "Triangulate the two faces first.");
  }
  const int c = opposite_corner(mesh, e.left, e), d = opposite_corner(mesh, e.right, e);
  if (c == d || mesh.find_edge(c, d) >= 0) {
    return refuse("the flipped edge exists already", where, "Flip a neighbouring edge first.");
  }
  return refuse("the flip would leave a vertex with too few faces", where, "Flip a neighbouring edge first.");
}

Result<void> may_join(const PolygonMesh& mesh, int edge) {
  const std::string where = "edge " + to_string(edge);
  const MeshEdge e = mesh.edge(edge);
  if (e.border()) {
    return refuse("an edge of the border has no second face to join", where, "Take an inner edge.");
  }
  for (const int v : {e.a, e.b}) {
    if (mesh.is_border_vertex(v) || valence(mesh, v) > 3) continue;
    if (valence(mesh, v) == 3) return too_few_left(v, where);
    return refuse("the two faces share more than this edge", where, "Collapse the edge instead.");
  }
  const std::vector<int> left = mesh.corners(e.left);
  for (const int v : mesh.corners(e.right)) {
    if (v == e.a || v == e.b || !contains(left, v)) continue;
    return refuse("the two faces also meet at vertex " + to_string(v) +
                      "; joined, they would run round it on both sides",
                  where, "Split one of the two faces first.");
  }
  return {};
}

Result<void> may_split_face(const PolygonMesh& mesh, const MeshEdit& edit) {
  const std::string where = "face " + to_string(edit.element);
  const std::vector<int> corners = mesh.corners(edit.element);
  const auto [a, b] = edit.corners;
  for (const int v : edit.corners) {
    if (!contains(corners, v)) {
      return refuse("vertex " + to_string(v) + " is no corner of the face", where,
                    "Name two of its corners.");
    }
  }
  if (corners.size() == 3) {
    return refuse("a triangle has no diagonal", where, "Split one of its edges instead.");
  }
  const auto at = std::find(corners.begin(), corners.end(), a) - corners.begin();
  const auto n = static_cast<std::ptrdiff_t>(corners.size());
  if (a == b || corners[static_cast<size_t>((at + 1) % n)] == b ||
      corners[static_cast<size_t>((at + n - 1) % n)] == b) {
    return refuse("the two corners are neighbours, no diagonal lies between them", where,
                  "Name two corners that no edge of the face joins.");
  }
  if (mesh.find_edge(a, b) >= 0) {
    return refuse("an edge joins the two corners already", where, "Take another diagonal.");
  }
  return {};
}

Result<void> may_collapse(const PolygonMesh& mesh, int edge) {
  const std::string where = "edge " + to_string(edge);
  const MeshEdge e = mesh.edge(edge);
  const bool border_a = mesh.is_border_vertex(e.a), border_b = mesh.is_border_vertex(e.b);
  if (!e.border() && border_a && border_b) {
    return refuse("the edge leads from border to border; its collapse would pinch the mesh", where,
                  "Collapse an edge of the border instead.");
  }
  std::vector<int> apexes;
  for (const int f : {e.left, e.right}) {
    if (f >= 0 && mesh.valence(f) == 3) apexes.push_back(opposite_corner(mesh, f, e));
  }
  const bool pillow = apexes.size() == 2 && apexes[0] == apexes[1];
  const bool last_triangle = std::any_of(apexes.begin(), apexes.end(), [&](int c) {
    return mesh.edge(mesh.find_edge(e.a, c)).border() && mesh.edge(mesh.find_edge(e.b, c)).border();
  });
  if (pillow || last_triangle) {
    return refuse("the collapse would leave edges without a face", where, "Delete the faces instead.");
  }
  const std::vector<int> at_a = mesh.faces_around(e.a);
  for (const int f : mesh.faces_around(e.b)) {
    if (f == e.left || f == e.right || !contains(at_a, f)) continue;
    return refuse("face " + to_string(f) + " has both ends as corners and would run through one vertex twice",
                  where, "Split that face first.");
  }
  const std::vector<int> near_a = neighbours(mesh, e.a), near_b = neighbours(mesh, e.b);
  for (const int c : near_b) {
    if (!contains(near_a, c) || contains(apexes, c)) continue;
    return refuse(
        "the edges from both ends to vertex " + to_string(c) + " would become one edge of four faces", where,
        "Flip or collapse one of them first.");
  }
  for (const int c : apexes) {
    if (!mesh.is_border_vertex(c) && valence(mesh, c) <= 3) return too_few_left(c, where);
  }
  if (!border_a && !border_b) {
    const auto m = static_cast<int>(near_a.size()), n = static_cast<int>(near_b.size());
    const int left = m + n - 2 - static_cast<int>(apexes.size());
    // A vertex of two edges that was there may stay one.
    if (left < std::min(3, std::max(m, n))) return too_few_left(collapsed_ends(mesh, e).survivor, where);
  }
  return {};
}

Result<void> may_delete(const PolygonMesh& mesh, int face) {
  const std::string where = "face " + to_string(face);
  if (mesh.face_count() == 1) {
    return refuse("it is the last face", where, "Open another mesh instead.");
  }
  for (const int v : mesh.corners(face)) {
    if (!mesh.is_border_vertex(v)) continue;
    const std::vector<int> fan = mesh.faces_around(v);
    if (fan.front() == face || fan.back() == face) continue;
    return refuse("the faces round vertex " + to_string(v) + " would touch each other only there", where,
                  "Delete a face beside it first, from the border on.");
  }
  return {};
}

// The kind's element, and how many of them the mesh has.
std::pair<const char*, int> named_elements(const PolygonMesh& mesh, EditKind kind) {
  switch (kind) {
    case EditKind::MoveVertex:
      return {"vertex", mesh.vertex_count()};
    case EditKind::SplitFace:
    case EditKind::DeleteFace:
      return {"face", mesh.face_count()};
    case EditKind::Flip:
    case EditKind::Join:
    case EditKind::SplitEdge:
    case EditKind::Collapse:
      break;
  }
  return {"edge", mesh.edge_count()};
}

}  // namespace

int opposite_corner(const PolygonMesh& mesh, int triangle, const MeshEdge& edge) {
  for (const int v : mesh.corners(triangle)) {
    if (v != edge.a && v != edge.b) return v;
  }
  return -1;
}

Collapsed collapsed_ends(const PolygonMesh& mesh, const MeshEdge& edge) {
  const bool border_a = mesh.is_border_vertex(edge.a), border_b = mesh.is_border_vertex(edge.b);
  if (border_a != border_b)
    return border_a ? Collapsed{edge.a, edge.b, true} : Collapsed{edge.b, edge.a, true};
  return {std::min(edge.a, edge.b), std::max(edge.a, edge.b), false};
}

Result<void> may_apply(const PolygonMesh& mesh, const MeshEdit& edit) {
  const auto [element, count] = named_elements(mesh, edit.kind);
  const std::string where = std::string(element) + " " + to_string(edit.element);
  if (edit.element < 0 || edit.element >= count) {
    return refuse(std::string("there is no such ") + element, where,
                  "The mesh has " + to_string(count) + " of them, from 0 on.");
  }
  if (edit.kind == EditKind::MoveVertex && !edit.to) {
    return refuse("the place to move to is missing", where, "Give three coordinates.");
  }
  if (edit.to && !edit.to->allFinite()) {
    return refuse("a coordinate is not a finite number", where, "Give three finite coordinates.");
  }
  switch (edit.kind) {
    case EditKind::Flip:
      return may_flip(mesh, edit.element);
    case EditKind::Join:
      return may_join(mesh, edit.element);
    case EditKind::SplitFace:
      return may_split_face(mesh, edit);
    case EditKind::Collapse:
      return may_collapse(mesh, edit.element);
    case EditKind::DeleteFace:
      return may_delete(mesh, edit.element);
    case EditKind::SplitEdge:
    case EditKind::MoveVertex:
      break;
  }
  return {};
}

}  // namespace planewright
