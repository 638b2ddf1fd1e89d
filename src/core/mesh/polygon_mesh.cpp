#include "core/mesh/polygon_mesh.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cmath>
#include <string>
#include <utility>

#include "core/mesh/edge_table.h"

namespace planewright {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using HalfedgeMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using VertexHandle = OpenMesh::VertexHandle;
using HalfedgeHandle = OpenMesh::HalfedgeHandle;
using EdgeHandle = OpenMesh::EdgeHandle;
using FaceHandle = OpenMesh::FaceHandle;

// OpenMesh counts half-edges, two for an edge, in an int.
constexpr size_t kMaxCorners = size_t{1} << 30;

tl::unexpected<Error> refuse(std::string what, std::string where, std::string remedy) {
  return fail(ErrorCode::Refused, std::move(what), std::move(where), std::move(remedy));
}

std::string face_name(int f) {
  return "face " + std::to_string(f);
}
std::string vertex_name(int v) {
  return "vertex " + std::to_string(v);
}

// The conditions that a single vertex or face can break.
Result<void> check_elements(const Points& positions, const Polygons& faces) {
  for (Eigen::Index v = 0; v < positions.rows(); ++v)
    if (!positions.row(v).allFinite())
      return refuse("a coordinate is not a finite number", vertex_name(static_cast<int>(v)),
                    "Correct or remove the vertex");
  if (faces.indices().size() > kMaxCorners)
    return refuse("the mesh has too many corners to work on", {}, "Split it into smaller parts");

  std::vector<int> seen_in(static_cast<size_t>(positions.rows()), -1);
  for (int f = 0; f < faces.size(); ++f) {
    if (faces.valence(f) < 3)
      return refuse("the face has fewer than 3 corners", face_name(f), "Remove the face");
    for (int v : faces[f]) {
      if (v < 0 || v >= positions.rows())
        return refuse("the face names vertex " + std::to_string(v) + ", but the mesh has " +
                          std::to_string(positions.rows()) + " vertices",
                      face_name(f), "Correct or remove the face");
      if (seen_in[v] == f)
        return refuse("the face names vertex " + std::to_string(v) + " twice", face_name(f),
                      "Correct or remove the face");
      seen_in[v] = f;
    }
  }
  return {};
}

// The conditions on the edges: two faces at most, in opposite directions.
Result<void> check_edges(const Polygons& faces, const EdgeTable& table) {
  const std::vector<int>& indices = faces.indices();
  for (int e = 0; e < table.size(); ++e) {
    if (table.corner_count(e) == 1) continue;
    const int c = table.corner(e, 0), d = table.corner(e, 1);
    const int f = table.face_of_corner[c], g = table.face_of_corner[d];
    auto where = [&] {
      return "edge (" + std::to_string(indices[c]) + ", " +
             std::to_string(indices[next_corner(faces, f, c)]) + ")";
    };
    if (table.corner_count(e) > 2)
      return refuse(std::to_string(table.corner_count(e)) + " faces share the edge; a surface has at most 2",
                    where(), "Separate the faces there");
    if (indices[c] == indices[d])
      return refuse("faces " + std::to_string(f) + " and " + std::to_string(g) +
                        " run through the edge in the same direction",
                    where(), "Turn one of them round");
  }
  return {};
}

Result<EdgeTable> checked_edges(const Points& positions, const Polygons& faces) {
  if (auto ok = check_elements(positions, faces); !ok) return tl::unexpected(ok.error());
  EdgeTable table = build_edge_table(faces, static_cast<int>(positions.rows()));
  if (auto ok = check_edges(faces, table); !ok) return tl::unexpected(ok.error());
  return table;
}

}  // namespace

struct PolygonMesh::Impl {
  HalfedgeMesh mesh;
  Points positions = Points(0, 3);  // what OpenMesh holds, as the array that the rest of the core reads

  static Result<PolygonMesh> make(const Points& positions, const Polygons& faces, const EdgeTable& table);

  // Half-edges of faces, the links round each face, and what belongs to them. Edge e runs in the direction of
  // its first corner (half-edge 0); so the numbering of edges is the table's.
  void build(const Polygons& faces, const EdgeTable& table) {
    const std::vector<int>& indices = faces.indices();
    mesh.resize(static_cast<size_t>(positions.rows()), static_cast<size_t>(table.size()),
                static_cast<size_t>(faces.size()));
    for (int v = 0; v < positions.rows(); ++v)
      mesh.set_point(VertexHandle(v), {positions(v, 0), positions(v, 1), positions(v, 2)});
    auto halfedge = [&](int c) {
      const int e = table.edge_of_corner[c];
      return HalfedgeHandle(table.corner(e, 0) == c ? 2 * e : 2 * e + 1);
    };
    for (int f = 0; f < faces.size(); ++f) {
      for (int c = faces.offsets()[f]; c < faces.offsets()[f + 1]; ++c) {
        const int next = next_corner(faces, f, c);
        const HalfedgeHandle h = halfedge(c);
        mesh.set_vertex_handle(h, VertexHandle(indices[next]));
        mesh.set_next_halfedge_handle(h, halfedge(next));
        mesh.set_face_handle(h, FaceHandle(f));
        mesh.set_halfedge_handle(VertexHandle(indices[c]), h);
        if (table.corner_count(table.edge_of_corner[c]) == 1)
          mesh.set_vertex_handle(mesh.opposite_halfedge_handle(h), VertexHandle(indices[c]));
      }
      mesh.set_halfedge_handle(FaceHandle(f), halfedge(faces.offsets()[f]));
    }
  }

  // Joins the half-edges without a face to loops, and lets every border vertex name the one that leaves it,
  // as OpenMesh wants. Refuses a vertex that two border half-edges leave.
  Result<void> link_border() {
    std::vector<char> on_border(mesh.n_vertices(), 0);
    for (const HalfedgeHandle h : mesh.halfedges()) {
      if (!mesh.is_boundary(h)) continue;
      const VertexHandle from = mesh.from_vertex_handle(h);
      if (on_border[from.idx()]) return not_one_fan(from);
      on_border[from.idx()] = 1;
      mesh.set_halfedge_handle(from, h);
    }
    for (const HalfedgeHandle h : mesh.halfedges())
      if (mesh.is_boundary(h))
        mesh.set_next_halfedge_handle(h, mesh.halfedge_handle(mesh.to_vertex_handle(h)));
    return {};
  }

  // Every face at a vertex must be reached by turning round it.
  Result<void> check_fans(const Polygons& faces) const {
    std::vector<int> corners(mesh.n_vertices(), 0);
    for (int v : faces.indices()) ++corners[v];
    for (const VertexHandle v : mesh.vertices()) {
      if (mesh.is_isolated(v)) continue;
      int reached = 0;
      HalfedgeHandle h = mesh.halfedge_handle(v);
      const HalfedgeHandle start = h;
      do {
        if (!mesh.is_boundary(h)) ++reached;
        h = turn_left(h);
      } while (h != start);
      if (reached != corners[v.idx()]) return not_one_fan(v);
    }
    return {};
  }

  static tl::unexpected<Error> not_one_fan(VertexHandle v) {
    return refuse("the faces round the vertex touch each other only there", vertex_name(v.idx()),
                  "Give each group of faces a vertex of its own");
  }

  // The next half-edge that leaves the same vertex, counter-clockwise.
  HalfedgeHandle turn_left(HalfedgeHandle h) const {
    return mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(h));
  }

  // Where the turn round v begins, see faces_around() in the header. Invalid for an isolated vertex.
  HalfedgeHandle first_halfedge(VertexHandle v) const {
    const HalfedgeHandle h = mesh.halfedge_handle(v);
    return h.is_valid() && mesh.is_boundary(h) ? turn_left(h) : h;
  }

  bool is_triangle(HalfedgeHandle h) const {
    return mesh.next_halfedge_handle(mesh.next_halfedge_handle(mesh.next_halfedge_handle(h))) == h;
  }

  // Whether v keeps its least valence when it loses one edge.
  bool can_lose_edge(VertexHandle v) const {
    const HalfedgeHandle start = mesh.halfedge_handle(v);
    const int least = mesh.is_boundary(start) ? 2 : 3;
    HalfedgeHandle h = start;
    for (int valence = 0; valence <= least; ++valence) {
      h = turn_left(h);
      if (h == start) return valence + 1 > least;
    }
    return true;
  }
};

PolygonMesh::PolygonMesh() : impl_(std::make_unique<Impl>()) {}
PolygonMesh::PolygonMesh(const PolygonMesh& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
PolygonMesh::PolygonMesh(PolygonMesh&&) noexcept = default;
PolygonMesh& PolygonMesh::operator=(const PolygonMesh& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
PolygonMesh& PolygonMesh::operator=(PolygonMesh&&) noexcept = default;
PolygonMesh::~PolygonMesh() = default;

Result<PolygonMesh> PolygonMesh::Impl::make(const Points& positions, const Polygons& faces,
                                            const EdgeTable& table) {
  // Built straight into OpenMesh's arrays: its add_face() searches round a vertex for every face, which takes
  // quadratic time at a hub of many faces, and refuses some orders of faces that are fine in the end.
  PolygonMesh result;
  result.impl_->positions = positions;
  result.impl_->build(faces, table);
  if (auto ok = result.impl_->link_border(); !ok) return tl::unexpected(ok.error());
  if (auto ok = result.impl_->check_fans(faces); !ok) return tl::unexpected(ok.error());
  return result;
}

Result<PolygonMesh> PolygonMesh::from_polygons(const Points& positions, const Polygons& faces) {
  const auto table = checked_edges(positions, faces);
  if (!table) return tl::unexpected(table.error());
  return Impl::make(positions, faces, *table);
}

Result<PolygonMesh> PolygonMesh::from_polygons(const Points& positions, const Polygons& faces,
                                               std::span<const std::array<int, 2>> edges) {
  auto table = checked_edges(positions, faces);
  if (!table) return tl::unexpected(table.error());
  if (edges.size() != static_cast<size_t>(table->size()))
    return refuse("the faces have " + std::to_string(table->size()) + " edges, but " +
                      std::to_string(edges.size()) + " are listed",
                  "edges", "List each edge once, or leave the list out");
  if (const int wrong = renumber(*table, faces, edges); wrong >= 0) {
    const auto [a, b] = edges[static_cast<size_t>(wrong)];
    return refuse("no face runs from vertex " + std::to_string(a) + " to vertex " + std::to_string(b) +
                      ", or the edge is listed twice",
                  "edge " + std::to_string(wrong), "List each edge once, or leave the list out");
  }
  return Impl::make(positions, faces, *table);
}

int PolygonMesh::vertex_count() const {
  return static_cast<int>(impl_->mesh.n_vertices());
}
int PolygonMesh::face_count() const {
  return static_cast<int>(impl_->mesh.n_faces());
}
int PolygonMesh::edge_count() const {
  return static_cast<int>(impl_->mesh.n_edges());
}
const Points& PolygonMesh::positions() const {
  return impl_->positions;
}

Polygons PolygonMesh::faces() const {
  const HalfedgeMesh& mesh = impl_->mesh;
  Polygons result;
  result.reserve(face_count(), 2 * edge_count());
  std::vector<int> corners;
  for (const FaceHandle f : mesh.faces()) {
    corners.clear();
    const HalfedgeHandle start = mesh.halfedge_handle(f);
    HalfedgeHandle h = start;
    do {
      corners.push_back(mesh.from_vertex_handle(h).idx());
      h = mesh.next_halfedge_handle(h);
    } while (h != start);
    result.push_back(corners);
  }
  return result;
}

std::vector<int> PolygonMesh::corners(int f) const {
  const HalfedgeMesh& mesh = impl_->mesh;
  std::vector<int> result;
  const HalfedgeHandle start = mesh.halfedge_handle(FaceHandle(f));
  HalfedgeHandle h = start;
  do {
    result.push_back(mesh.from_vertex_handle(h).idx());
    h = mesh.next_halfedge_handle(h);
  } while (h != start);
  return result;
}

int PolygonMesh::valence(int f) const {
  const HalfedgeMesh& mesh = impl_->mesh;
  int count = 0;
  const HalfedgeHandle start = mesh.halfedge_handle(FaceHandle(f));
  HalfedgeHandle h = start;
  do {
    ++count;
    h = mesh.next_halfedge_handle(h);
  } while (h != start);
  return count;
}

MeshEdge PolygonMesh::edge(int e) const {
  const HalfedgeMesh& mesh = impl_->mesh;
  const HalfedgeHandle h(2 * e), opposite(2 * e + 1);
  return {mesh.to_vertex_handle(opposite).idx(), mesh.to_vertex_handle(h).idx(), mesh.face_handle(h).idx(),
          mesh.face_handle(opposite).idx()};
}

int PolygonMesh::find_edge(int a, int b) const {
  const HalfedgeMesh& mesh = impl_->mesh;
  if (a < 0 || b < 0 || a >= vertex_count() || b >= vertex_count() || is_isolated(a) || is_isolated(b))
    return -1;
  // Turns round both ends at once, so that a hub of very many faces costs no more than its neighbour.
  const HalfedgeHandle start_a = mesh.halfedge_handle(VertexHandle(a)),
                       start_b = mesh.halfedge_handle(VertexHandle(b));
  HalfedgeHandle at_a = start_a, at_b = start_b;
  do {
    if (mesh.to_vertex_handle(at_a).idx() == b) return mesh.edge_handle(at_a).idx();
    if (mesh.to_vertex_handle(at_b).idx() == a) return mesh.edge_handle(at_b).idx();
    at_a = impl_->turn_left(at_a);
    at_b = impl_->turn_left(at_b);
  } while (at_a != start_a && at_b != start_b);
  return -1;
}

std::vector<int> PolygonMesh::faces_around(int v) const {
  std::vector<int> result;
  const HalfedgeHandle start = impl_->first_halfedge(VertexHandle(v));
  if (!start.is_valid()) return result;
  HalfedgeHandle h = start;
  do {
    if (!impl_->mesh.is_boundary(h)) result.push_back(impl_->mesh.face_handle(h).idx());
    h = impl_->turn_left(h);
  } while (h != start);
  return result;
}

std::vector<int> PolygonMesh::edges_around(int v) const {
  std::vector<int> result;
  const HalfedgeHandle start = impl_->first_halfedge(VertexHandle(v));
  if (!start.is_valid()) return result;
  HalfedgeHandle h = start;
  do {
    result.push_back(impl_->mesh.edge_handle(h).idx());
    h = impl_->turn_left(h);
  } while (h != start);
  return result;
}

bool PolygonMesh::is_border_vertex(int v) const {
  const HalfedgeHandle h = impl_->mesh.halfedge_handle(VertexHandle(v));
  return h.is_valid() && impl_->mesh.is_boundary(h);
}

bool PolygonMesh::is_isolated(int v) const {
  return !impl_->mesh.halfedge_handle(VertexHandle(v)).is_valid();
}

bool PolygonMesh::can_flip(int e) const {
  if (e < 0 || e >= edge_count()) return false;
  const HalfedgeMesh& mesh = impl_->mesh;
  const HalfedgeHandle h(2 * e), opposite(2 * e + 1);
  if (mesh.is_boundary(h) || mesh.is_boundary(opposite)) return false;
  if (!impl_->is_triangle(h) || !impl_->is_triangle(opposite)) return false;
  const VertexHandle c = mesh.to_vertex_handle(mesh.next_halfedge_handle(h));
  const VertexHandle d = mesh.to_vertex_handle(mesh.next_halfedge_handle(opposite));
  if (c == d || find_edge(c.idx(), d.idx()) >= 0) return false;
  return impl_->can_lose_edge(mesh.to_vertex_handle(h)) &&
         impl_->can_lose_edge(mesh.to_vertex_handle(opposite));
}

bool PolygonMesh::flip(int e) {
  if (!can_flip(e)) return false;
  HalfedgeMesh& mesh = impl_->mesh;

  // Turns the edge a -> b counter-clockwise inside its two triangles, until it runs from d to c:
  //
  //        b              b
  //      / | \          /   \        left:  (a, b, c) becomes (d, c, a)
  //     c  |  d   ->   c --- d       right: (b, a, d) becomes (c, d, b)
  //      \ | /          \   /
  //        a              a
  const HalfedgeHandle h(2 * e), opposite(2 * e + 1);
  const HalfedgeHandle b_to_c = mesh.next_halfedge_handle(h), c_to_a = mesh.next_halfedge_handle(b_to_c);
  const HalfedgeHandle a_to_d = mesh.next_halfedge_handle(opposite),
                       d_to_b = mesh.next_halfedge_handle(a_to_d);
  const VertexHandle a = mesh.to_vertex_handle(opposite), b = mesh.to_vertex_handle(h);
  const VertexHandle c = mesh.to_vertex_handle(b_to_c), d = mesh.to_vertex_handle(a_to_d);
  const FaceHandle left = mesh.face_handle(h), right = mesh.face_handle(opposite);

  mesh.set_vertex_handle(h, c);
  mesh.set_vertex_handle(opposite, d);
  mesh.set_next_halfedge_handle(h, c_to_a);
  mesh.set_next_halfedge_handle(c_to_a, a_to_d);
  mesh.set_next_halfedge_handle(a_to_d, h);
  mesh.set_next_halfedge_handle(opposite, d_to_b);
  mesh.set_next_halfedge_handle(d_to_b, b_to_c);
  mesh.set_next_halfedge_handle(b_to_c, opposite);
  mesh.set_face_handle(a_to_d, left);
  mesh.set_face_handle(b_to_c, right);
  mesh.set_halfedge_handle(left, h);
  mesh.set_halfedge_handle(right, opposite);
  // A border vertex names its border half-edge, which is none of these, and keeps it.
  if (mesh.halfedge_handle(a) == h) mesh.set_halfedge_handle(a, a_to_d);
  if (mesh.halfedge_handle(b) == opposite) mesh.set_halfedge_handle(b, b_to_c);
  return true;
}

bool PolygonMesh::move_vertex(int v, const Vector3d& to) {
  if (!to.allFinite()) return false;
  impl_->positions.row(v) = to.transpose();
  impl_->mesh.set_point(VertexHandle(v), {to.x(), to.y(), to.z()});
  return true;
}

}  // namespace planewright
