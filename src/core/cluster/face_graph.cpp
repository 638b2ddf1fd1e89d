#include "core/cluster/face_graph.h"

#include <Eigen/Geometry>
#include <cmath>

namespace planewright {
namespace {

SecondMoments outer(const Vector3d& v) {
  SecondMoments m;
  m << v.x() * v.x(), v.x() * v.y(), v.x() * v.z(), v.y() * v.y(), v.y() * v.z(), v.z() * v.z();
  return m;
}

void place(FaceGraph& graph, const Points& positions) {
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();
  bool first = true;
  for (const int v : graph.faces.indices()) {
    const Vector3d p = positions.row(v);
    low = first ? p : low.cwiseMin(p);
    high = first ? p : high.cwiseMax(p);
    first = false;
  }
  graph.origin = 0.5 * (low + high);
  graph.vertices = positions.rowwise() - graph.origin.transpose();
  // Vertices that no face has may lie anywhere, and are in nobody's way here.
  const double size = (high - low).norm();
  graph.length = size > 0.0 ? size : 1.0;
  graph.vertices /= graph.length;
}

// Area and normal by Newell's vector; centre and moments over the triangles from the mean of the corners, as
// a polygon that is not planar has no area of its own.
FaceShape measure(const Points& vertices, std::span<const int> face, SecondMoments& moments) {
  const Vector3d middle = centroid(vertices, face);
  Vector3d vector = Vector3d::Zero(), sum = Vector3d::Zero();
  double all = 0.0;
  SecondMoments about_middle = SecondMoments::Zero();
  for (size_t k = 0; k < face.size(); ++k) {
    const Vector3d a = vertices.row(face[k]).transpose() - middle;
    const Vector3d b = vertices.row(face[(k + 1) % face.size()]).transpose() - middle;
    const Vector3d twice = a.cross(b);
    vector += twice;
    const double area = 0.5 * twice.norm();
    all += area;
    sum += area / 3.0 * (a + b);
    // Of a triangle with corners 0, a, b: area / 12 (a a + b b + (a + b)(a + b)).
    about_middle += area / 12.0 * (outer(a) + outer(b) + outer(a + b));
  }
  const double newell = vector.norm();
  FaceShape shape{Vector3d::Zero(), middle, 0.5 * newell};
  if (newell > 0.0) shape.normal = vector / newell;
  moments.setZero();
  if (all > 0.0) {
    shape.centre += sum / all;
    moments = (about_middle - all * outer(sum / all)) * (shape.area / all);
  }
  return shape;
}

// Every corner's partner: at the end of its edge, the corner there that leads back.
void link(FaceGraph& graph) {
  const auto& indices = graph.faces.indices();
  const size_t vertices = static_cast<size_t>(graph.vertices.rows());
  std::vector<int> first(vertices + 1, 0), leaving(indices.size());
  for (const int v : indices) ++first[static_cast<size_t>(v) + 1];
  for (size_t v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<int> filled(first.begin(), first.end() - 1);
  for (size_t c = 0; c < indices.size(); ++c) leaving[filled[indices[c]]++] = static_cast<int>(c);

  graph.across.assign(indices.size(), -1);
  graph.beside.assign(indices.size(), -1);
  graph.corner_of_vertex.assign(vertices, -1);
  graph.on_border.assign(vertices, 0);
  for (size_t c = 0; c < indices.size(); ++c) {
    const int from = indices[c], to = graph.head(static_cast<int>(c));
    for (int k = first[to]; k < first[to + 1]; ++k)
      if (graph.head(leaving[k]) == from) graph.across[c] = leaving[k];
    if (graph.across[c] >= 0) {
      graph.beside[c] = graph.face_of_corner[graph.across[c]];
    } else {
      graph.on_border[from] = graph.on_border[to] = 1;
      graph.corner_of_vertex[from] = static_cast<int>(c);
    }
    graph.edge_count += graph.across[c] < 0 || graph.across[c] > static_cast<int>(c) ? 1 : 0;
    if (graph.corner_of_vertex[from] < 0) graph.corner_of_vertex[from] = static_cast<int>(c);
  }
}

void find_components(FaceGraph& graph) {
  graph.component_of_face.assign(static_cast<size_t>(graph.face_count()), -1);
  std::vector<int> stack;
  for (int start = 0; start < graph.face_count(); ++start) {
    if (graph.component_of_face[start] >= 0) continue;
    const int number = graph.component_count();
    graph.closed.push_back(1);
    graph.component_of_face[start] = number;
    stack.push_back(start);
    while (!stack.empty()) {
      const int f = stack.back();
      stack.pop_back();
      for (int c = graph.faces.offsets()[f]; c < graph.faces.offsets()[f + 1]; ++c) {
        const int g = graph.beside[c];
        if (g < 0) graph.closed.back() = 0;
        if (g < 0 || graph.component_of_face[g] >= 0) continue;
        graph.component_of_face[g] = number;
        stack.push_back(g);
      }
    }
  }
}

}  // namespace

Result<FaceGraph> FaceGraph::create(const PolygonMesh& mesh) {
  if (mesh.face_count() == 0)
    return fail(ErrorCode::Refused, "the mesh has no faces", {}, "Open a mesh with at least one face");
  FaceGraph graph;
  graph.faces = mesh.faces();
  graph.face_of_corner.reserve(graph.faces.indices().size());
  for (int f = 0; f < graph.faces.size(); ++f)
    graph.face_of_corner.insert(graph.face_of_corner.end(), static_cast<size_t>(graph.faces.valence(f)), f);
  place(graph, mesh.positions());
  graph.shapes.resize(static_cast<size_t>(graph.face_count()));
  graph.moments.resize(graph.shapes.size());
  double area = 0.0;
  for (int f = 0; f < graph.face_count(); ++f) {
    graph.shapes[f] = measure(graph.vertices, graph.faces[f], graph.moments[f]);
    area += graph.shapes[f].area;
  }
  if (!(area > 0.0))
    return fail(ErrorCode::Refused, "no face of the mesh has an area", {}, "Open a mesh with proper faces");
  // From units of the diagonal to units of the square root of the area.
  const double unit = std::sqrt(area);
  graph.length *= unit;
  graph.vertices /= unit;
  for (FaceShape& shape : graph.shapes) {
    shape.centre /= unit;
    shape.area /= area;
  }
  for (SecondMoments& moments : graph.moments) moments /= area * area;
  link(graph);
  find_components(graph);
  return graph;
}

int FaceGraph::euler_characteristic() const {
  int used = 0;
  for (const int c : corner_of_vertex) used += c >= 0 ? 1 : 0;
  return used - edge_count + face_count();
}

}  // namespace planewright
