#include "core/complex/planarize.h"

#include <algorithm>
#include <cmath>

#include "core/complex/local_mesh.h"

namespace planewright {

Result<TangentComplex> build_planarize(const PolygonMesh& mesh, const PlanarizeOptions& options) {
  if (!std::isfinite(options.offset))
    return fail(ErrorCode::Usage, "the offset is not a finite number", "offset",
                "Give a length in model units");
  if (mesh.face_count() == 0)
    return fail(ErrorCode::Refused, "the mesh has no faces", {}, "Open a mesh with at least one face");

  const LocalMesh local(mesh);
  const Polygons faces = mesh.faces();
  TangentComplex complex;
  complex.kind = ComplexKind::Planarize;
  complex.origin = local.origin;
  complex.anchors.resize(faces.size(), 3);
  complex.normals.resize(faces.size(), 3);
  complex.offsets = Vector::Constant(faces.size(), options.offset);
  for (int f = 0; f < faces.size(); ++f) {
    complex.anchors.row(f) = centroid(local.positions, faces[f]);
    complex.normals.row(f) = local.face_normal(f);
    complex.plane_origin.push_back(f);
  }

  std::vector<int> point_of_vertex(static_cast<size_t>(mesh.vertex_count()), -1);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.is_isolated(v)) continue;
    point_of_vertex[v] = static_cast<int>(complex.point_origin.size());
    complex.point_origin.push_back({PointKind::Vertex, v});
    auto planes = mesh.faces_around(v);  // plane index = face index
    std::sort(planes.begin(), planes.end());
    complex.planes_of_point.push_back(planes);
  }
  complex.preferred.resize(static_cast<Eigen::Index>(complex.point_origin.size()), 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (point_of_vertex[v] < 0) continue;
    Vector3d wanted = local.positions.row(v);
    if (options.offset != 0.0) wanted += options.offset * local.vertex_normal(mesh, v);
    complex.preferred.row(point_of_vertex[v]) = wanted;
  }
  complex.panels.reserve(faces.size(), static_cast<int>(faces.indices().size()));
  for (int f = 0; f < faces.size(); ++f) {
    std::vector<int> panel;
    for (int v : faces[f]) panel.push_back(point_of_vertex[v]);
    complex.panels.push_back(panel);
  }
  finish(complex);
  complex.input = local.input_surface(mesh);
  complex.face_of_point.assign(complex.point_origin.size(), -1);
  complex.crossed_edge.assign(complex.panel_edges.size(), {-1, -1});
  return complex;
}

}  // namespace planewright
