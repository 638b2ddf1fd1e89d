#include "core/complex/cluster.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/complex/local_mesh.h"
#include "core/complex/meeting_point.h"

namespace planewright {
namespace {

// How far from its vertex a corner may be wanted, in mean sides of the regions. Measured: from 0.2 to 0.4
// panels are about as near to the mesh; without a limit nearly parallel planes send corners away.
constexpr double kReach = 0.3;

// Mean distance of corners that follow each other round a region.
double mean_side(const Points& positions, const Regions& regions) {
  double length = 0.0;
  int sides = 0;
  for (int r = 0; r < regions.count(); ++r) {
    const auto corners = regions.corners_of_region[r];
    for (size_t k = 0; k < corners.size(); ++k, ++sides)
      length += (positions.row(regions.corner_vertex[corners[k]]) -
                 positions.row(regions.corner_vertex[corners[(k + 1) % corners.size()]]))
                    .norm();
  }
  return sides > 0 ? length / sides : 0.0;
}

}  // namespace

Result<TangentComplex> build_cluster(const PolygonMesh& mesh, const Regions& regions,
                                     const ClusterPanelOptions& options) {
  if (!std::isfinite(options.offset))
    return fail(ErrorCode::Usage, "the offset is not a finite number", "offset",
                "Give a length in model units");
  const bool vertices_exist =
      std::all_of(regions.corner_vertex.begin(), regions.corner_vertex.end(),
                  [&](int v) { return v < mesh.vertex_count() && !mesh.is_isolated(v); });
  if (static_cast<int>(regions.region_of_face.size()) != mesh.face_count() || !vertices_exist)
    return fail(ErrorCode::Refused, "the regions are those of another mesh", "regions",
                "Cluster this mesh anew");

  const LocalMesh local(mesh);
  TangentComplex complex;
  complex.kind = ComplexKind::Cluster;
  complex.origin = local.origin;
  complex.anchors.resize(regions.count(), 3);
  complex.normals.resize(regions.count(), 3);
  complex.offsets = Vector::Constant(regions.count(), options.offset);
  const Vector3d shift = regions.origin - local.origin;
  for (int r = 0; r < regions.count(); ++r) {
    complex.anchors.row(r) = regions.proxies[r].centre + shift;
    complex.normals.row(r) = regions.proxies[r].normal;
    complex.plane_origin.push_back(r);
  }
  const int corners = static_cast<int>(regions.corner_vertex.size());
  complex.preferred.resize(corners, 3);
  const double reach = kReach * mean_side(local.positions, regions);
  std::vector<WantedPlane> planes;
  for (int j = 0; j < corners; ++j) {
    const int v = regions.corner_vertex[j];
    complex.point_origin.push_back({PointKind::Vertex, v});
    Vector3d wanted = local.positions.row(v);
    if (options.offset != 0.0) wanted += options.offset * local.vertex_normal(mesh, v);
    if (!mesh.is_border_vertex(v)) {
      planes.clear();
      for (const int r : regions.regions_of_corner[j]) {
        const Vector3d normal = complex.normals.row(r);
        planes.push_back({normal, normal.dot(complex.anchors.row(r)) + options.offset});
      }
      wanted = meeting_point(planes, wanted, reach);
    }
    complex.preferred.row(j) = wanted;
  }
  complex.planes_of_point = regions.regions_of_corner;
  complex.panels = regions.corners_of_region;
  complex.region_of_face = regions.region_of_face;
  finish(complex);
  complex.input = local.input_surface(mesh);
  complex.face_of_point.assign(complex.point_origin.size(), -1);
  complex.crossed_edge.assign(complex.panel_edges.size(), {-1, -1});
  return complex;
}

}  // namespace planewright
