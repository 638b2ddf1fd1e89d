#include "core/advise/adopt.h"

#include <map>
#include <utility>

#include "core/complex/mapped_origin.h"

namespace planewright {

State adopt(const Advised& advised, const Trial& trial, const TangentComplex& edited, const ElementMap& map) {
  State state = transfer(*advised.complex, advised.state, edited, &map);
  const ElementMap onwards = composed(inverse(trial.from_whole), map);  // from the patch
  const TangentComplex& patch = *trial.complex;
  const Vector3d shift = patch.origin - edited.origin;

  std::map<int, int> plane_of_origin;
  for (int i = 0; i < edited.plane_count(); ++i)
    plane_of_origin[edited.plane_origin[static_cast<size_t>(i)]] = i;
  for (int i = 0; i < patch.plane_count(); ++i) {
    const auto found = plane_of_origin.find(
        mapped(plane_origins(onwards, patch.kind), patch.plane_origin[static_cast<size_t>(i)]));
    if (found == plane_of_origin.end()) continue;
    const int k = found->second;
    state.n.row(k) = trial.state.n.row(i);
    const Vector3d moved = patch.anchors.row(i).transpose() + shift - edited.anchors.row(k).transpose();
    state.h[k] = trial.state.h[i] + trial.state.n.row(i).dot(moved);
  }
  std::map<std::pair<PointKind, int>, int> point_of_origin;
  for (int j = 0; j < edited.point_count(); ++j) {
    const PointOrigin origin = edited.point_origin[static_cast<size_t>(j)];
    point_of_origin[{origin.kind, origin.element}] = j;
  }
  for (int j = 0; j < patch.point_count(); ++j) {
    const PointOrigin origin = patch.point_origin[static_cast<size_t>(j)];
    const auto found =
        point_of_origin.find({origin.kind, mapped(point_origins(onwards, origin.kind), origin.element)});
    if (found != point_of_origin.end()) state.x.row(found->second) = trial.state.x.row(j) + shift.transpose();
  }
  return state;
}

}  // namespace planewright
