#include "ui/mesh_view.h"

namespace planewright::ui {

MeshView make_mesh_view(std::shared_ptr<const PolygonMesh> mesh, const Vector3d& scene_origin) {
  MeshView view;
  view.mesh = std::move(mesh);
  view.points = view.mesh->positions().rowwise() - scene_origin.transpose();
  view.faces = view.mesh->faces();
  view.edges.reserve(static_cast<std::size_t>(view.mesh->edge_count()));
  for (int e = 0; e < view.mesh->edge_count(); ++e) {
    const MeshEdge edge = view.mesh->edge(e);
    view.edges.emplace_back(edge.a, edge.b);
  }
  if (view.points.rows() > 0) {
    view.low = view.points.colwise().minCoeff().transpose();
    view.high = view.points.colwise().maxCoeff().transpose();
  }
  return view;
}

}  // namespace planewright::ui
