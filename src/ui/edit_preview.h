// EditPreview: what an edit of the mesh would look like before it is made: its lines on the mesh, and the
// panels that solving its neighbourhood leads to.
//
// Units: model units, absolute. Indices: of the mesh before the edit. Threads: pure functions, plain values.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/advise/advisor.h"

namespace planewright::ui {

// The edit alone, as lines.
struct EditSketch {
  std::vector<std::array<Vector3d, 2>> made, gone;
  Vector3d place = Vector3d::Zero();  // the middle of it
};
EditSketch sketch(const PolygonMesh& mesh, const MeshEdit& edit);

struct EditPreview {
  MeshEdit edit;
  // None: advice does not try it (candidates.h says what), or could not.
  std::optional<Suggestion> rated;
  std::vector<std::vector<Vector3d>> panels;  // outlines that the edit changes, as they would be
};
// candidate: none where the edit is none of the listed ones; it is then looked up.
EditPreview preview(const PatchSolver& solver, const MeshEdit& edit, std::optional<Candidate> candidate,
                    int radius, const std::stop_token& stop);

}  // namespace planewright::ui
