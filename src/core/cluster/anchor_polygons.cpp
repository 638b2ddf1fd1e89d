#include "core/cluster/anchor_polygons.h"

namespace planewright {

Points anchor_points(const PolygonMesh& mesh, const Regions& regions) {
  Points points(regions.regions_of_corner.size(), 3);
  for (int c = 0; c < regions.regions_of_corner.size(); ++c) {
    const Vector3d at = mesh.positions().row(regions.corner_vertex[c]).transpose() - regions.origin;
    Vector3d move = Vector3d::Zero();
    for (const int r : regions.regions_of_corner[c]) {
      const Proxy& proxy = regions.proxies[r];
      move += proxy.normal * proxy.normal.dot(proxy.centre - at);
    }
    points.row(c) = regions.origin + at + move / static_cast<double>(regions.regions_of_corner.valence(c));
  }
  return points;
}

}  // namespace planewright
