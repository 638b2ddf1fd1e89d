#include "core/advise/adopt.h"

#include <map>
#include <utility>

#include "core/complex/mapped_origin.h"

namespace planewright {

namespace {

// Where the complex has its planes and points, by what they stand for in the mesh.
struct Places {
  std::map<int, int> plane;
  std::map<std::pair<PointKind, int>, int> point;

  explicit Places(const TangentComplex& complex) {
    for (int i = 0; i < complex.plane_count(); ++i) plane[complex.plane_origin[static_cast<size_t>(i)]] = i;
    for (int j = 0; j < complex.point_count(); ++j) {
      const PointOrigin origin = complex.point_origin[static_cast<size_t>(j)];
      point[{origin.kind, origin.element}] = j;
    }
  }
};

// What was free in the trial.
void take_over(const Trial& trial, const ElementMap& map, const TangentComplex& edited, const Places& places,
               State& state) {
  const ElementMap onwards = composed(inverse(trial.from_whole), map);  // from the patch
  const TangentComplex& patch = *trial.complex;
  const Vector3d shift = patch.origin - edited.origin;
  for (int i = 0; i < patch.plane_count(); ++i) {
    if (!trial.free_planes[static_cast<size_t>(i)]) continue;
    const auto found = places.plane.find(
        mapped(plane_origins(onwards, patch.kind), patch.plane_origin[static_cast<size_t>(i)]));
    if (found == places.plane.end()) continue;
    const int k = found->second;
    state.n.row(k) = trial.state.n.row(i);
    const Vector3d moved = patch.anchors.row(i).transpose() + shift - edited.anchors.row(k).transpose();
    state.h[k] = trial.state.h[i] + trial.state.n.row(i).dot(moved);
  }
  for (int j = 0; j < patch.point_count(); ++j) {
    if (!trial.free_points[static_cast<size_t>(j)]) continue;
    const PointOrigin origin = patch.point_origin[static_cast<size_t>(j)];
    const auto found =
        places.point.find({origin.kind, mapped(point_origins(onwards, origin.kind), origin.element)});
    if (found != places.point.end()) state.x.row(found->second) = trial.state.x.row(j) + shift.transpose();
  }
}

}  // namespace

State adopt(const Advised& advised, const std::vector<Trial>& trials, const TangentComplex& edited,
            const ElementMap& map) {
  State state = transfer(*advised.complex, advised.state, edited, &map);
  const Places places(edited);
  for (auto trial = trials.rbegin(); trial != trials.rend(); ++trial)
    take_over(*trial, map, edited, places, state);
  return state;
}

}  // namespace planewright
