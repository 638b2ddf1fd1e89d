#include "core/mesh/mesh_edits.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <span>
#include <utility>

#include "core/mesh/mesh_edit_rules.h"

namespace planewright {
namespace {

// A mesh taken apart to be put together otherwise. Faces name vertices by their old indices, a new one by the
// number of old ones.
class Rebuild {
 public:
  explicit Rebuild(const PolygonMesh& before)
      : before_(before), faces_(before.faces()), merged_into_(static_cast<size_t>(before.vertex_count())) {
    std::iota(merged_into_.begin(), merged_into_.end(), 0);
    replaced_.resize(static_cast<size_t>(faces_.size()));
    face_gone_.assign(replaced_.size(), 0);
    vertex_gone_.assign(merged_into_.size(), 0);
  }

  std::vector<int> corners(int face) const { return {faces_[face].begin(), faces_[face].end()}; }
  void replace(int face, std::vector<int> corners) {
    replaced_[static_cast<size_t>(face)] = std::move(corners);
  }
  void add_face(std::vector<int> corners) { added_.push_back(std::move(corners)); }
  void remove_face(int face) { face_gone_[static_cast<size_t>(face)] = 1; }
  void remove_vertex(int vertex) { vertex_gone_[static_cast<size_t>(vertex)] = 1; }
  // Edges of `gone` become those of `survivor`.
  void merge(int gone, int survivor) {
    merged_into_[static_cast<size_t>(gone)] = survivor;
    remove_vertex(gone);
  }
  void move(int vertex, const Vector3d& to) { moved_ = {vertex, to}; }
  int add_vertex(const Vector3d& at) {
    new_vertex_ = at;
    return before_.vertex_count();
  }
  // The old edge is the new one between these vertices.
  void rename_edge(int edge, int a, int b) { renamed_ = {edge, {a, b}}; }

  Result<EditedMesh> build() {
    ElementMap map;
    map.vertices = surviving(vertex_gone_, new_vertex_ ? 1 : 0);
    map.faces = surviving(face_gone_, static_cast<int>(added_.size()));
    Polygons faces;
    faces.reserve(static_cast<int>(map.faces.to_old.size()), static_cast<int>(faces_.indices().size()) + 8);
    for (const int f : map.faces.to_old) {
      if (f < 0) break;
      const std::vector<int>& replaced = replaced_[static_cast<size_t>(f)];
      push(faces, replaced.empty() ? std::as_const(faces_)[f] : std::span<const int>(replaced), map.vertices);
    }
    for (const std::vector<int>& added : added_) push(faces, added, map.vertices);
    auto mesh = PolygonMesh::from_polygons(positions(map.vertices), faces);
    if (!mesh) return tl::unexpected(mesh.error());
    map.edges = edge_map(*mesh, map.vertices);
    return EditedMesh{std::move(*mesh), std::move(map)};
  }

 private:
  // Survivors in their order, and then the new ones.
  static IndexMap surviving(const std::vector<char>& gone, int added) {
    std::vector<int> to_old;
    for (size_t i = 0; i < gone.size(); ++i)
      if (!gone[i]) to_old.push_back(static_cast<int>(i));
    to_old.insert(to_old.end(), static_cast<size_t>(added), -1);
    return index_map(std::move(to_old), static_cast<int>(gone.size()));
  }

  int new_index(int vertex, const IndexMap& vertices) const {
    if (vertex == before_.vertex_count()) return static_cast<int>(vertices.to_old.size()) - 1;
    return vertices.to_new[static_cast<size_t>(merged_into_[static_cast<size_t>(vertex)])];
  }

  void push(Polygons& faces, std::span<const int> corners, const IndexMap& vertices) {
    scratch_.clear();
    for (const int v : corners) scratch_.push_back(new_index(v, vertices));
    faces.push_back(scratch_);
  }

  Points positions(const IndexMap& vertices) const {
    Points result(static_cast<Eigen::Index>(vertices.to_old.size()), 3);
    for (size_t v = 0; v < vertices.to_old.size(); ++v) {
      const int old = vertices.to_old[v];
      const auto row = static_cast<Eigen::Index>(v);
      if (old < 0) {
        result.row(row) = new_vertex_->transpose();
      } else if (old == moved_.first) {
        result.row(row) = moved_.second.transpose();
      } else {
        result.row(row) = before_.positions().row(old);
      }
    }
    return result;
  }

  // An edge is what joins its two vertices. Of two that become one, the one at the surviving vertex stays.
  IndexMap edge_map(const PolygonMesh& mesh, const IndexMap& vertices) const {
    std::vector<int> to_old(static_cast<size_t>(mesh.edge_count()), -1);
    for (const bool of_gone : {false, true}) {
      for (int e = 0; e < before_.edge_count(); ++e) {
        const auto [a, b] =
            e == renamed_.first ? renamed_.second : std::array<int, 2>{before_.edge(e).a, before_.edge(e).b};
        if ((is_merged(a) || is_merged(b)) != of_gone) continue;
        const int i = new_index(a, vertices), j = new_index(b, vertices);
        const int now = i == j ? -1 : mesh.find_edge(i, j);
        if (now >= 0 && to_old[static_cast<size_t>(now)] < 0) to_old[static_cast<size_t>(now)] = e;
      }
    }
    return index_map(std::move(to_old), before_.edge_count());
  }

  bool is_merged(int vertex) const {
    return vertex < before_.vertex_count() && merged_into_[static_cast<size_t>(vertex)] != vertex;
  }

  const PolygonMesh& before_;
  Polygons faces_;
  std::vector<std::vector<int>> replaced_;  // by face; empty: as it was
  std::vector<std::vector<int>> added_;
  std::vector<char> face_gone_, vertex_gone_;
  std::vector<int> merged_into_;
  std::optional<Vector3d> new_vertex_;
  std::pair<int, Vector3d> moved_{-1, Vector3d::Zero()};
  std::pair<int, std::array<int, 2>> renamed_{-1, {-1, -1}};
  std::vector<int> scratch_;
};

// The corners from `first` to `last` in the direction of the face.
std::vector<int> part(const std::vector<int>& corners, int first, int last) {
  std::vector<int> result;
  auto at = std::find(corners.begin(), corners.end(), first);
  while (true) {
    result.push_back(*at);
    if (*at == last) return result;
    if (++at == corners.end()) at = corners.begin();
  }
}

Vector3d midpoint(const PolygonMesh& mesh, const MeshEdge& edge) {
  return 0.5 * mesh.positions().row(edge.a).transpose() + 0.5 * mesh.positions().row(edge.b).transpose();
}

EditedMesh flipped(const PolygonMesh& mesh, int edge) {
  EditedMesh result{mesh, identity_map(mesh)};
  [[maybe_unused]] const bool done = result.mesh.flip(edge);
  assert(done);
  return result;
}

EditedMesh moved(const PolygonMesh& mesh, int vertex, const Vector3d& to) {
  EditedMesh result{mesh, identity_map(mesh)};
  [[maybe_unused]] const bool done = result.mesh.move_vertex(vertex, to);
  assert(done);
  return result;
}

// The corners of the one face from b round to a, and then those of the other from a round to b.
Result<EditedMesh> joined(const PolygonMesh& mesh, const MeshEdge& edge) {
  Rebuild rebuild(mesh);
  std::vector<int> corners = part(rebuild.corners(edge.left), edge.b, edge.a);
  const std::vector<int> rest = part(rebuild.corners(edge.right), edge.a, edge.b);
  corners.insert(corners.end(), rest.begin() + 1, rest.end() - 1);
  rebuild.replace(std::min(edge.left, edge.right), std::move(corners));
  rebuild.remove_face(std::max(edge.left, edge.right));
  return rebuild.build();
}

Result<EditedMesh> with_edge_split(const PolygonMesh& mesh, const MeshEdit& edit) {
  const MeshEdge edge = mesh.edge(edit.element);
  Rebuild rebuild(mesh);
  const int middle = rebuild.add_vertex(edit.to ? *edit.to : midpoint(mesh, edge));
  for (const int f : {edge.left, edge.right}) {
    if (f < 0) continue;
    std::vector<int> corners = rebuild.corners(f);
    if (corners.size() == 3) {
      std::vector<int> at_b = corners;
      std::replace(corners.begin(), corners.end(), edge.b, middle);
      std::replace(at_b.begin(), at_b.end(), edge.a, middle);
      rebuild.add_face(std::move(at_b));
    } else {
      const auto second = std::find(corners.begin(), corners.end(), f == edge.left ? edge.b : edge.a);
      corners.insert(second, middle);
    }
    rebuild.replace(f, std::move(corners));
  }
  rebuild.rename_edge(edit.element, edge.a, middle);
  return rebuild.build();
}

Result<EditedMesh> with_face_split(const PolygonMesh& mesh, const MeshEdit& edit) {
  Rebuild rebuild(mesh);
  const std::vector<int> corners = rebuild.corners(edit.element);
  const auto [a, b] = edit.corners;
  rebuild.replace(edit.element, part(corners, a, b));
  rebuild.add_face(part(corners, b, a));
  return rebuild.build();
}

Result<EditedMesh> collapsed(const PolygonMesh& mesh, const MeshEdit& edit) {
  const MeshEdge edge = mesh.edge(edit.element);
  const Collapsed ends = collapsed_ends(mesh, edge);
  Rebuild rebuild(mesh);
  for (const int f : {edge.left, edge.right}) {
    if (f < 0) continue;
    std::vector<int> corners = rebuild.corners(f);
    if (corners.size() == 3) {
      rebuild.remove_face(f);
    } else {
      std::erase(corners, ends.gone);
      rebuild.replace(f, std::move(corners));
    }
  }
  if (edit.to) {
    rebuild.move(ends.survivor, *edit.to);
  } else if (!ends.keeps_place) {
    rebuild.move(ends.survivor, midpoint(mesh, edge));
  }
  rebuild.merge(ends.gone, ends.survivor);
  return rebuild.build();
}

Result<EditedMesh> without_face(const PolygonMesh& mesh, int face) {
  Rebuild rebuild(mesh);
  for (const int v : rebuild.corners(face))
    if (mesh.faces_around(v).size() == 1) rebuild.remove_vertex(v);
  rebuild.remove_face(face);
  return rebuild.build();
}

}  // namespace

const char* name(EditKind kind) {
  switch (kind) {
    case EditKind::Flip:
      return "flip";
    case EditKind::Join:
      return "join";
    case EditKind::SplitEdge:
      return "split-edge";
    case EditKind::SplitFace:
      return "split-face";
    case EditKind::Collapse:
      return "collapse";
    case EditKind::MoveVertex:
      return "move-vertex";
    case EditKind::DeleteFace:
      return "delete-face";
  }
  return "";
}

std::string describe(const MeshEdit& edit) {
  const std::string element = std::to_string(edit.element);
  switch (edit.kind) {
    case EditKind::Flip:
      return "Flip edge " + element;
    case EditKind::Join:
      return "Join faces at edge " + element;
    case EditKind::SplitEdge:
      return "Split edge " + element;
    case EditKind::SplitFace:
      return "Split face " + element;
    case EditKind::Collapse:
      return "Collapse edge " + element;
    case EditKind::MoveVertex:
      return "Move vertex " + element;
    case EditKind::DeleteFace:
      return "Delete face " + element;
  }
  return "";
}

MeshEdit renumbered(const MeshEdit& edit, const ElementMap& map) {
  const auto now = [](const IndexMap& list, int element) {
    return element < 0 ? -1 : list.to_new[static_cast<size_t>(element)];
  };
  MeshEdit result = edit;
  switch (edit.kind) {
    case EditKind::MoveVertex:
      result.element = now(map.vertices, edit.element);
      break;
    case EditKind::SplitFace:
      for (int& corner : result.corners) corner = now(map.vertices, corner);
      [[fallthrough]];
    case EditKind::DeleteFace:
      result.element = now(map.faces, edit.element);
      break;
    case EditKind::Flip:
    case EditKind::Join:
    case EditKind::SplitEdge:
    case EditKind::Collapse:
      result.element = now(map.edges, edit.element);
  }
  return result;
}

Result<EditedMesh> apply(const PolygonMesh& mesh, const MeshEdit& edit) {
  if (auto allowed = may_apply(mesh, edit); !allowed) return tl::unexpected(allowed.error());
  switch (edit.kind) {
    case EditKind::Flip:
      return flipped(mesh, edit.element);
    case EditKind::Join:
      return joined(mesh, mesh.edge(edit.element));
    case EditKind::SplitEdge:
      return with_edge_split(mesh, edit);
    case EditKind::SplitFace:
      return with_face_split(mesh, edit);
    case EditKind::Collapse:
      return collapsed(mesh, edit);
    case EditKind::MoveVertex:
      return moved(mesh, edit.element, *edit.to);
    case EditKind::DeleteFace:
      break;
  }
  return without_face(mesh, edit.element);
}

}  // namespace planewright
