#include "core/complex/state.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/complex/mapped_origin.h"

namespace planewright {

State initial_state(const TangentComplex& complex) {
  return {complex.preferred, complex.normals, complex.offsets};
}

State transfer(const TangentComplex& from, const State& state, const TangentComplex& to,
               const ElementMap* edited) {
  State result = initial_state(to);
  if (from.kind != to.kind) return result;
  const Vector3d shift = from.origin - to.origin;

  std::unordered_map<int, int> plane_by_origin;
  for (int i = 0; i < from.plane_count(); ++i) {
    const int origin = from.plane_origin[i];
    plane_by_origin.emplace(edited ? mapped(plane_origins(*edited, from.kind), origin) : origin, i);
  }
  std::vector<int> source_plane(static_cast<size_t>(to.plane_count()), -1);
  for (int i = 0; i < to.plane_count(); ++i) {
    const auto found = plane_by_origin.find(to.plane_origin[i]);
    if (found == plane_by_origin.end()) continue;
    const int k = found->second;
    source_plane[i] = k;
    result.n.row(i) = state.n.row(k);
    // The same plane seen from the new anchor (the mesh, and with it anchors, may have changed in between).
    const Vector3d moved = from.anchors.row(k).transpose() + shift - to.anchors.row(i).transpose();
    result.h[i] = state.h[k] + state.n.row(k).dot(moved);
  }

  std::map<std::pair<PointKind, int>, int> point_by_origin;
  for (int j = 0; j < from.point_count(); ++j) {
    const auto [kind, element] = from.point_origin[j];
    point_by_origin.emplace(
        std::pair(kind, edited ? mapped(point_origins(*edited, kind), element) : element), j);
  }
  for (int j = 0; j < to.point_count(); ++j) {
    const auto found = point_by_origin.find({to.point_origin[j].kind, to.point_origin[j].element});
    if (found == point_by_origin.end()) continue;
    const auto before = from.planes_of_point[found->second];
    const auto now = to.planes_of_point[j];
    const bool same_planes = std::equal(now.begin(), now.end(), before.begin(), before.end(),
                                        [&](int i, int k) { return source_plane[i] == k; });
    if (same_planes) result.x.row(j) = state.x.row(found->second) + shift.transpose();
  }
  return result;
}

Vector incidence_residuals(const TangentComplex& complex, const State& state) {
  Vector residuals(complex.incidence_count());
  int row = 0;
  for (int j = 0; j < complex.point_count(); ++j)
    for (int i : complex.planes_of_point[j])
      residuals[row++] = state.n.row(i).dot(state.x.row(j) - complex.anchors.row(i)) - state.h[i];
  return residuals;
}

Panels panels_of(const TangentComplex& complex, const State& state) {
  return {state.x.rowwise() + complex.origin.transpose(), complex.panels};
}

}  // namespace planewright
