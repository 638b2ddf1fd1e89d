#include "core/complex/local_mesh.h"

#include <limits>

namespace planewright {
namespace {

// Below this share of the squared size of what was added up, a sum of area vectors has no direction of its
// own.
constexpr double kNoDirection = 1e-10;

Vector3d middle_of_used_vertices(const PolygonMesh& mesh, const Polygons& faces) {
  const Points& p = mesh.positions();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3d low = Vector3d::Constant(infinity), high = Vector3d::Constant(-infinity);
  for (int v : faces.indices()) {
    low = low.cwiseMin(p.row(v).transpose());
    high = high.cwiseMax(p.row(v).transpose());
  }
  if (faces.indices().empty()) return Vector3d::Zero();
  return low + 0.5 * (high - low);
}

}  // namespace

LocalMesh::LocalMesh(const PolygonMesh& mesh) {
  const Polygons faces = mesh.faces();
  origin = middle_of_used_vertices(mesh, faces);
  positions = mesh.positions().rowwise() - origin.transpose();

  face_areas.resize(faces.size(), 3);
  face_normals_.resize(faces.size(), 3);
  std::vector<int> without_area;
  for (int f = 0; f < faces.size(); ++f) {
    const Vector3d area = newell_vector(positions, faces[f]);
    face_areas.row(f) = area;
    double perimeter = 0.0;
    for (size_t k = 0; k < faces[f].size(); ++k)
      perimeter += (positions.row(faces[f][k]) - positions.row(faces[f][(k + 1) % faces[f].size()])).norm();
    if (area.norm() > kNoDirection * perimeter * perimeter)
      face_normals_.row(f) = area.normalized();
    else
      without_area.push_back(f);
  }
  // A sliver takes the mean direction of the faces round its corners.
  for (int f : without_area) {
    Vector3d sum = Vector3d::Zero();
    for (int v : faces[f])
      for (int g : mesh.faces_around(v)) sum += face_areas.row(g);
    face_normals_.row(f) = sum.norm() > 0.0 ? Vector3d(sum.normalized()) : Vector3d::UnitZ();
  }
}

Vector3d LocalMesh::vertex_normal(const PolygonMesh& mesh, int v) const {
  Vector3d sum = Vector3d::Zero();
  double total = 0.0, largest = -1.0;
  int largest_face = -1;
  for (int f : mesh.faces_around(v)) {
    const Vector3d area = face_areas.row(f);
    sum += area;
    total += area.norm();
    if (area.norm() > largest) {
      largest = area.norm();
      largest_face = f;
    }
  }
  if (sum.norm() > kNoDirection * total) return sum.normalized();
  return largest_face >= 0 ? face_normal(largest_face) : Vector3d::UnitZ();
}

InputSurface LocalMesh::input_surface(const PolygonMesh& mesh) const {
  InputSurface input{positions, Points(positions.rows(), 3), mesh.faces(), face_normals_, {}};
  for (int v = 0; v < mesh.vertex_count(); ++v) input.vertex_normals.row(v) = vertex_normal(mesh, v);
  for (int e = 0; e < mesh.edge_count(); ++e) input.edges.push_back({mesh.edge(e).a, mesh.edge(e).b});
  return input;
}

}  // namespace planewright
