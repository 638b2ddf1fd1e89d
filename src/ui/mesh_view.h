// MeshView: the mesh being designed on, as arrays in scene coordinates.
//
// Units: model units; positions relative to the scene's origin. Threads: a plain value.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/mesh/polygon_mesh.h"

namespace planewright::ui {

// What the ghost is drawn from, and the edges that can be clicked.
struct MeshView {
  std::shared_ptr<const PolygonMesh> mesh;
  Points points;  // #V x 3, scene coordinates
  Polygons faces;
  std::vector<std::pair<int, int>> edges;                    // #E, ends by vertex; index = the mesh's edge
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero();  // bounding box, scene coordinates
};

MeshView make_mesh_view(std::shared_ptr<const PolygonMesh> mesh, const Vector3d& scene_origin);

}  // namespace planewright::ui
