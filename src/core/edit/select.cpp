#include "core/edit/select.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace planewright {
namespace {

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

std::vector<int> combined(const std::vector<int>& base, const std::vector<int>& other, Combine how) {
  std::vector<int> out;
  switch (how) {
    case Combine::Replace:
      return other;
    case Combine::Add:
      std::set_union(base.begin(), base.end(), other.begin(), other.end(), std::back_inserter(out));
      break;
    case Combine::Remove:
      std::set_difference(base.begin(), base.end(), other.begin(), other.end(), std::back_inserter(out));
      break;
  }
  return out;
}

std::vector<char> marked(const std::vector<int>& list, int count) {
  std::vector<char> in(static_cast<std::size_t>(count), 0);
  for (const int i : list) {
    if (i >= 0 && i < count) in[i] = 1;
  }
  return in;
}

std::vector<int> listed(const std::vector<char>& in) {
  std::vector<int> list;
  for (std::size_t i = 0; i < in.size(); ++i) {
    if (in[i]) list.push_back(static_cast<int>(i));
  }
  return list;
}

int other_end(const MeshEdge& edge, int vertex) {
  return edge.a == vertex ? edge.b : edge.a;
}

// The edge straight on from `edge` at `vertex`, -1 where there is none.
int straight_on(const PolygonMesh& mesh, int edge, int vertex) {
  if (mesh.is_border_vertex(vertex)) return -1;
  const std::vector<int> around = mesh.edges_around(vertex);
  if (around.size() % 2 != 0) return -1;
  const auto at = std::find(around.begin(), around.end(), edge) - around.begin();
  return around[(static_cast<std::size_t>(at) + around.size() / 2) % around.size()];
}

// The edge of `face` opposite `edge`, -1 where its valence is odd.
int opposite_edge(const PolygonMesh& mesh, std::span<const int> corners, const MeshEdge& edge) {
  const std::size_t n = corners.size();
  if (n % 2 != 0) return -1;
  for (std::size_t k = 0; k < n; ++k) {
    const int a = corners[k], b = corners[(k + 1) % n];
    if ((a == edge.a && b == edge.b) || (a == edge.b && b == edge.a)) {
      return mesh.find_edge(corners[(k + n / 2) % n], corners[(k + n / 2 + 1) % n]);
    }
  }
  return -1;
}

std::vector<int> ends_of(const PolygonMesh& mesh, const std::vector<int>& edges) {
  std::vector<int> vertices;
  for (const int e : edges) {
    const MeshEdge edge = mesh.edge(e);
    vertices.push_back(edge.a);
    vertices.push_back(edge.b);
  }
  sort_unique(vertices);
  return vertices;
}

}  // namespace

Selection combined(Selection base, const Selection& other, Combine how) {
  base.vertices = combined(base.vertices, other.vertices, how);
  base.edges = combined(base.edges, other.edges, how);
  base.faces = combined(base.faces, other.faces, how);
  return base;
}

int element_count(const Selection& selection) {
  return static_cast<int>(selection.vertices.size() + selection.edges.size() + selection.faces.size());
}

Selection named_panels(const TangentComplex& complex, const std::vector<int>& panels) {
  Selection out;
  if (complex.kind == ComplexKind::Cluster) {
    std::vector<char> in(static_cast<std::size_t>(complex.plane_count()), 0);
    for (const int panel : panels) in[static_cast<std::size_t>(panel)] = 1;
    for (std::size_t f = 0; f < complex.region_of_face.size(); ++f)
      if (in[static_cast<std::size_t>(complex.region_of_face[f])]) out.faces.push_back(static_cast<int>(f));
    return out;
  }
  auto& list = complex.kind == ComplexKind::Dual ? out.vertices : out.faces;
  for (const int panel : panels) list.push_back(complex.plane_origin[static_cast<std::size_t>(panel)]);
  sort_unique(list);
  return out;
}

Selection named_points(const TangentComplex& complex, const std::vector<int>& points) {
  Selection out;
  for (const int point : points) {
    const PointOrigin origin = complex.point_origin[static_cast<std::size_t>(point)];
    switch (origin.kind) {
      case PointKind::Face:
        out.faces.push_back(origin.element);
        break;
      case PointKind::BorderEdge:
        out.edges.push_back(origin.element);
        break;
      case PointKind::Vertex:
        out.vertices.push_back(origin.element);
        break;
      case PointKind::Corner:
        break;
    }
  }
  for (auto* list : {&out.vertices, &out.edges, &out.faces}) sort_unique(*list);
  return out;
}

std::vector<int> panels_named(const TangentComplex& complex, const Selection& selection) {
  std::vector<int> panels;
  if (complex.kind == ComplexKind::Cluster) {
    if (selection.faces.empty()) return panels;
    std::vector<char> whole(static_cast<std::size_t>(complex.plane_count()), 1);
    for (std::size_t f = 0; f < complex.region_of_face.size(); ++f)
      if (!std::binary_search(selection.faces.begin(), selection.faces.end(), static_cast<int>(f)))
        whole[static_cast<std::size_t>(complex.region_of_face[f])] = 0;
    for (int i = 0; i < complex.plane_count(); ++i)
      if (whole[static_cast<std::size_t>(i)]) panels.push_back(i);
    return panels;
  }
  const auto& list = complex.kind == ComplexKind::Dual ? selection.vertices : selection.faces;
  for (int i = 0; i < complex.plane_count() && !list.empty(); ++i) {
    if (std::binary_search(list.begin(), list.end(), complex.plane_origin[static_cast<std::size_t>(i)])) {
      panels.push_back(i);
    }
  }
  return panels;
}

std::vector<int> points_named(const TangentComplex& complex, const Selection& selection) {
  std::vector<int> points;
  for (int j = 0; j < complex.point_count(); ++j) {
    const PointOrigin origin = complex.point_origin[static_cast<std::size_t>(j)];
    const std::vector<int>* list = nullptr;
    if (origin.kind == PointKind::Face) list = &selection.faces;
    if (origin.kind == PointKind::BorderEdge) list = &selection.edges;
    if (origin.kind == PointKind::Vertex) list = &selection.vertices;
    if (list != nullptr && std::binary_search(list->begin(), list->end(), origin.element))
      points.push_back(j);
  }
  return points;
}

std::vector<int> edge_line(const PolygonMesh& mesh, int edge) {
  const MeshEdge first = mesh.edge(edge);
  if (first.border()) return border_loop(mesh, edge);
  std::vector<int> line{edge};
  std::vector<char> passed = marked(line, mesh.edge_count());
  // A line may cross itself in a vertex but runs through an edge only once, so this ends.
  const auto follow = [&](int vertex) {
    std::vector<int> way;
    for (int at = edge;;) {
      const int next = straight_on(mesh, at, vertex);
      if (next < 0 || passed[next]) return way;
      passed[next] = 1;
      way.push_back(next);
      vertex = other_end(mesh.edge(next), vertex);
      at = next;
    }
  };
  const std::vector<int> forward = follow(first.b), backward = follow(first.a);
  line.insert(line.end(), forward.begin(), forward.end());
  line.insert(line.begin(), backward.rbegin(), backward.rend());
  return line;
}

std::vector<int> face_strip(const PolygonMesh& mesh, int edge) {
  const Polygons faces = mesh.faces();
  const MeshEdge first = mesh.edge(edge);
  std::vector<char> crossed = marked({edge}, mesh.edge_count());
  const auto follow = [&](int face) {
    std::vector<int> way;
    for (int at = edge; face >= 0;) {
      way.push_back(face);
      const int next = opposite_edge(mesh, faces[face], mesh.edge(at));
      if (next < 0 || crossed[next]) break;
      crossed[next] = 1;
      const MeshEdge out = mesh.edge(next);
      face = out.left == face ? out.right : out.left;
      at = next;
    }
    return way;
  };
  const std::vector<int> forward = follow(first.left), backward = follow(first.right);
  std::vector<int> strip(backward.rbegin(), backward.rend());
  std::vector<char> in = marked(strip, mesh.face_count());
  for (const int face : forward) {
    if (!in[face]) strip.push_back(face);
    in[face] = 1;
  }
  return strip;
}

std::vector<int> border_loop(const PolygonMesh& mesh, int edge) {
  if (!mesh.edge(edge).border()) return {};
  std::vector<int> loop;
  int at = edge;
  do {
    loop.push_back(at);
    const MeshEdge e = mesh.edge(at);
    // Its face is at the left of the way from a to b, or of that from b to a. The border goes on with the
    // edge that leaves the end, which the faces round a border vertex begin at.
    const int end = e.left >= 0 ? e.b : e.a;
    at = mesh.edges_around(end).front();
  } while (at != edge && loop.size() <= static_cast<std::size_t>(mesh.edge_count()));
  return loop;
}

std::vector<int> border_edges(const PolygonMesh& mesh) {
  std::vector<int> all;
  std::vector<char> in(static_cast<std::size_t>(mesh.edge_count()), 0);
  for (int e = 0; e < mesh.edge_count(); ++e) {
    if (in[e]) continue;
    for (const int of_loop : border_loop(mesh, e)) {
      all.push_back(of_loop);
      in[of_loop] = 1;
    }
  }
  return all;
}

int mesh_edge_of(const PolygonMesh& mesh, const TangentComplex& complex, int panel_edge) {
  const PanelEdge& edge = complex.panel_edges[static_cast<std::size_t>(panel_edge)];
  const PointOrigin a = complex.point_origin[static_cast<std::size_t>(edge.a)];
  const PointOrigin b = complex.point_origin[static_cast<std::size_t>(edge.b)];
  if (complex.kind == ComplexKind::Planarize) return mesh.find_edge(a.element, b.element);
  const auto [i, j] = complex.crossed_edge[static_cast<std::size_t>(panel_edge)];
  if (i >= 0) return mesh.find_edge(i, j);
  for (const PointOrigin& origin : {a, b}) {
    if (origin.kind == PointKind::BorderEdge && origin.element < mesh.edge_count()) return origin.element;
  }
  return -1;
}

Selection along_border(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what,
                       const std::vector<int>& edges) {
  Selection out;
  const bool dual = kind == ComplexKind::Dual, panels = what == SelectWhat::Panels;
  if (dual == panels) {
    out.vertices = ends_of(mesh, edges);
  } else if (dual) {
    out.edges = edges;
    sort_unique(out.edges);
  } else {
    for (const int e : edges) {
      const MeshEdge edge = mesh.edge(e);
      out.faces.push_back(edge.left >= 0 ? edge.left : edge.right);
    }
    sort_unique(out.faces);
  }
  return out;
}

Selection loop_through(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what, int edge) {
  if (mesh.edge(edge).border()) return along_border(mesh, kind, what, border_loop(mesh, edge));
  Selection out;
  if ((kind == ComplexKind::Dual) == (what == SelectWhat::Panels)) {
    out.vertices = ends_of(mesh, edge_line(mesh, edge));
  } else {
    out.faces = face_strip(mesh, edge);
    sort_unique(out.faces);
  }
  return out;
}

Selection everything(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what) {
  Selection all;
  if ((kind == ComplexKind::Dual) == (what == SelectWhat::Panels)) {
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      if (!mesh.is_isolated(v)) all.vertices.push_back(v);
    }
    return all;
  }
  all.faces.resize(static_cast<std::size_t>(mesh.face_count()));
  std::iota(all.faces.begin(), all.faces.end(), 0);
  if (kind == ComplexKind::Dual) {
    all.edges = border_edges(mesh);
    sort_unique(all.edges);
  }
  return all;
}

Selection inverted(const PolygonMesh& mesh, ComplexKind kind, SelectWhat what, const Selection& selection) {
  return combined(everything(mesh, kind, what), selection, Combine::Remove);
}

Selection grown(const PolygonMesh& mesh, const Selection& selection) {
  const auto vertices = marked(selection.vertices, mesh.vertex_count());
  const auto edges = marked(selection.edges, mesh.edge_count());
  const auto faces = marked(selection.faces, mesh.face_count());
  auto more_vertices = vertices, more_edges = edges, more_faces = faces;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    if (vertices[edge.a] || vertices[edge.b]) more_vertices[edge.a] = more_vertices[edge.b] = 1;
    if (!edge.border() && (faces[edge.left] || faces[edge.right])) {
      more_faces[edge.left] = more_faces[edge.right] = 1;
    }
  }
  if (!selection.edges.empty()) {
    for (const int v : ends_of(mesh, listed(edges))) {
      const std::vector<int> around = mesh.edges_around(v);
      const bool inner_in = std::any_of(around.begin(), around.end(),
                                        [&](int e) { return edges[e] && !mesh.edge(e).border(); });
      for (const int e : around) {
        if (inner_in || mesh.edge(e).border()) more_edges[e] = 1;
      }
    }
  }
  return {selection.name, listed(more_vertices), listed(more_edges), listed(more_faces)};
}

Selection shrunk(const PolygonMesh& mesh, const Selection& selection) {
  const auto vertices = marked(selection.vertices, mesh.vertex_count());
  const auto edges = marked(selection.edges, mesh.edge_count());
  const auto faces = marked(selection.faces, mesh.face_count());
  auto less_vertices = vertices, less_edges = edges, less_faces = faces;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    if (vertices[edge.a] != vertices[edge.b]) less_vertices[edge.a] = less_vertices[edge.b] = 0;
    if (!edge.border() && faces[edge.left] != faces[edge.right]) {
      less_faces[edge.left] = less_faces[edge.right] = 0;
    }
  }
  for (const int v : ends_of(mesh, listed(edges))) {
    const std::vector<int> around = mesh.edges_around(v);
    bool outside = false, border_outside = false;
    for (const int e : around) {
      outside |= !edges[e];
      border_outside |= !edges[e] && mesh.edge(e).border();
    }
    for (const int e : around) {
      if (mesh.edge(e).border() ? border_outside : outside) less_edges[e] = 0;
    }
  }
  return {selection.name, listed(less_vertices), listed(less_edges), listed(less_faces)};
}

Selection whole_components(const PolygonMesh& mesh, const Selection& selection) {
  std::vector<int> root(static_cast<std::size_t>(mesh.vertex_count()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    root[find(edge.a)] = find(edge.b);
  }
  const Polygons faces = mesh.faces();
  std::vector<char> touched(root.size(), 0);
  for (const int v : selection.vertices) touched[find(v)] = 1;
  for (const int e : selection.edges) touched[find(mesh.edge(e).a)] = 1;
  for (const int f : selection.faces) touched[find(faces[f][0])] = 1;
  Selection out;
  out.name = selection.name;
  for (int v = 0; v < mesh.vertex_count() && !selection.vertices.empty(); ++v) {
    if (touched[find(v)]) out.vertices.push_back(v);
  }
  // Edges stand for points of border edges; so inner ones only come along with inner ones.
  const bool inner = std::any_of(selection.edges.begin(), selection.edges.end(),
                                 [&](int e) { return !mesh.edge(e).border(); });
  for (int e = 0; e < mesh.edge_count() && !selection.edges.empty(); ++e) {
    const MeshEdge edge = mesh.edge(e);
    if ((inner || edge.border()) && touched[find(edge.a)]) out.edges.push_back(e);
  }
  for (int f = 0; f < mesh.face_count() && !selection.faces.empty(); ++f) {
    if (touched[find(faces[f][0])]) out.faces.push_back(f);
  }
  return out;
}

}  // namespace planewright
