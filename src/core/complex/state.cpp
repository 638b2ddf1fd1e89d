#include "core/complex/state.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "core/complex/mapped_origin.h"

namespace planewright {

namespace {

// For each plane of `to`, the plane of `from` that it goes on with; -1: none.
std::vector<int> sources_by_origin(const TangentComplex& from, const TangentComplex& to,
                                   const ElementMap* edited) {
  std::unordered_map<int, int> plane_by_origin;
  for (int i = 0; i < from.plane_count(); ++i) {
    const int origin = from.plane_origin[i];
    plane_by_origin.emplace(edited ? mapped(plane_origins(*edited, from.kind), origin) : origin, i);
  }
  std::vector<int> source(static_cast<size_t>(to.plane_count()), -1);
  for (int i = 0; i < to.plane_count(); ++i)
    if (const auto found = plane_by_origin.find(to.plane_origin[i]); found != plane_by_origin.end())
      source[i] = found->second;
  return source;
}

// Regions change their numbers and their shape from one clustering to the next: that one is meant which has
// more than half of a panel's corners. Of equal ones the first.
std::vector<int> sources_by_corners(const TangentComplex& from, const TangentComplex& to,
                                    const ElementMap* edited) {
  std::unordered_map<int, int> point_by_vertex;
  for (int j = 0; j < from.point_count(); ++j) {
    const int vertex = from.point_origin[j].element;
    point_by_vertex.emplace(edited ? mapped(edited->vertices, vertex) : vertex, j);
  }
  std::vector<int> source(static_cast<size_t>(to.plane_count()), -1);
  for (int i = 0; i < to.plane_count(); ++i) {
    std::map<int, int> shared;  // corners, by plane
    for (const int j : to.panels[i])
      if (const auto found = point_by_vertex.find(to.point_origin[j].element); found != point_by_vertex.end())
        for (const int k : from.planes_of_point[found->second]) ++shared[k];
    int most = to.panels.valence(i) / 2;
    for (const auto& [k, count] : shared)
      if (count > most) {
        most = count;
        source[i] = k;
      }
  }
  return source;
}

}  // namespace

State initial_state(const TangentComplex& complex) {
  return {complex.preferred, complex.normals, complex.offsets};
}

State transfer(const TangentComplex& from, const State& state, const TangentComplex& to,
               const ElementMap* edited) {
  State result = initial_state(to);
  if (from.kind != to.kind) return result;
  const Vector3d shift = from.origin - to.origin;

  const std::vector<int> source_plane = to.kind == ComplexKind::Cluster ? sources_by_corners(from, to, edited)
                                                                        : sources_by_origin(from, to, edited);
  for (int i = 0; i < to.plane_count(); ++i) {
    const int k = source_plane[i];
    if (k < 0) continue;
    result.n.row(i) = state.n.row(k);
    // The same plane seen from the new anchor (the mesh, and with it anchors, may have changed in between).
    const Vector3d moved = from.anchors.row(k).transpose() + shift - to.anchors.row(i).transpose();
    result.h[i] = state.h[k] + state.n.row(k).dot(moved);
  }

  std::map<std::pair<PointKind, int>, int> point_by_origin;
  for (int j = 0; j < from.point_count(); ++j) {
    const auto [kind, element] = from.point_origin[j];
    point_by_origin.emplace(std::pair(kind, edited ? mapped(point_origins(*edited, kind), element) : element),
                            j);
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
