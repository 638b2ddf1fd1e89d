#include "ui/edit_choices.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/edit/select.h"
#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

// The shortest diagonal that the mesh allows; else any, to be told why not.
MeshEdit split_face(const Document& document, int face) {
  const PolygonMesh& mesh = *document.mesh();
  const std::span<const int> corners = mesh.faces()[face];
  MeshEdit best = MeshEdit::split_face(face, corners[0], corners[2 % corners.size()]);
  double shortest = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 2; j < corners.size(); ++j) {
      if (i == 0 && j + 1 == corners.size()) continue;
      const MeshEdit edit = MeshEdit::split_face(face, corners[i], corners[j]);
      const double length = (mesh.positions().row(corners[i]) - mesh.positions().row(corners[j])).norm();
      if (length >= shortest || !document.may_edit(edit)) continue;
      shortest = length;
      best = edit;
    }
  }
  return best;
}

MeshEdit even_out(const PolygonMesh& mesh, int vertex) {
  const bool along_border = mesh.is_border_vertex(vertex);
  Vector3d middle = Vector3d::Zero();
  int count = 0;
  for (const int e : mesh.edges_around(vertex)) {
    const MeshEdge edge = mesh.edge(e);
    if (along_border && !edge.border()) continue;
    middle += mesh.positions().row(edge.a == vertex ? edge.b : edge.a).transpose();
    ++count;
  }
  return MeshEdit::move_vertex(vertex, middle / std::max(count, 1));
}

// The edge that two faces share; -1: none.
int edge_between(const PolygonMesh& mesh, int first, int second) {
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    if ((edge.left == first && edge.right == second) || (edge.left == second && edge.right == first))
      return e;
  }
  return -1;
}

}  // namespace

std::vector<EditChoice> edit_choices(const Document& document, const EditTarget& target) {
  std::vector<EditChoice> choices;
  const auto add = [&](std::string name, const std::string& verb, const char* what,
                       const std::optional<int>& element, const std::vector<int>& numbers, auto make) {
    EditChoice choice;
    choice.name = std::move(name);
    choice.label = verb;
    if (!element) {
      choice.refused.append("Point at ").append(what).append(", or select one, first.");
    } else {
      choice.label.append(" ").append(format_count(numbers[static_cast<std::size_t>(*element)]));
      const MeshEdit edit = make(*element);
      if (const Result<void> allowed = document.may_edit(edit); allowed) {
        choice.edit = edit;
      } else {
        choice.refused = capitalised(allowed.error().what);
        choice.refused.append(". ").append(allowed.error().remedy);
      }
    }
    choices.push_back(std::move(choice));
  };
  static const ElementIds none;
  const ElementIds& ids = document.ids() ? *document.ids() : none;
  const EditTarget valid = document.empty() ? EditTarget{} : target;
  const auto& [edge, face, vertex] = valid;
  add("flip", "Flip edge", "an edge", edge, ids.edges, [](int e) { return MeshEdit::flip(e); });
  add("join", "Join the faces at edge", "an edge", edge, ids.edges, [](int e) { return MeshEdit::join(e); });
  add("split edge", "Split edge", "an edge", edge, ids.edges, [](int e) { return MeshEdit::split_edge(e); });
  add("collapse", "Collapse edge", "an edge", edge, ids.edges, [](int e) { return MeshEdit::collapse(e); });
  add("split face", "Split face", "a face", face, ids.faces, [&](int f) { return split_face(document, f); });
  add("delete face", "Delete face", "a face", face, ids.faces,
      [](int f) { return MeshEdit::delete_face(f); });
  add("move vertex", "Even out vertex", "a vertex", vertex, ids.vertices,
      [&](int v) { return even_out(*document.mesh(), v); });
  return choices;
}

EditTarget target_of_selection(const AppState& state) {
  EditTarget target;
  if (state.document().empty()) return target;
  const PolygonMesh& mesh = *state.document().mesh();
  const Selection& selection = state.selection();
  const auto take_edge = [&](int edge) {
    if (edge >= 0) target.edge = edge;
  };
  const auto& view = state.shown();
  if (view && state.selected_edge && (view->ids == state.document().ids())) {
    take_edge(mesh_edge_of(mesh, view->complex(), *state.selected_edge));
  } else if (selection.edges.size() == 1) {
    take_edge(selection.edges.front());
  } else if (selection.vertices.size() == 2) {
    take_edge(mesh.find_edge(selection.vertices[0], selection.vertices[1]));
  } else if (selection.faces.size() == 2) {
    take_edge(edge_between(mesh, selection.faces[0], selection.faces[1]));
  }
  if (selection.vertices.size() == 1) target.vertex = selection.vertices.front();
  if (selection.faces.size() == 1) {
    target.face = selection.faces.front();
  } else if (view && state.selected_point && view->ids == state.document().ids()) {
    const PointOrigin& origin = view->complex().point_origin[static_cast<std::size_t>(*state.selected_point)];
    if (origin.kind == PointKind::Face) target.face = origin.element;
  }
  return target;
}

}  // namespace planewright::ui
