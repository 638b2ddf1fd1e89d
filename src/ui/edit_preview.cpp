#include "ui/edit_preview.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/complex/mapped_origin.h"

namespace planewright::ui {
namespace {

// A corner that moves less is not shown to move, mean edges.
constexpr double kStill = 0.02;

int opposite(const PolygonMesh& mesh, int face, const MeshEdge& edge) {
  for (const int v : mesh.corners(face))
    if (v != edge.a && v != edge.b) return v;
  return edge.a;
}

std::vector<std::vector<Vector3d>> changed_panels(const Advised& before, const Trial& after) {
  const TangentComplex &whole = *before.complex, &patch = *after.complex;
  std::map<std::pair<PointKind, int>, Vector3d> places;
  for (int j = 0; j < whole.point_count(); ++j) {
    const PointOrigin origin = whole.point_origin[static_cast<std::size_t>(j)];
    places[{origin.kind, origin.element}] = before.state.x.row(j).transpose() + whole.origin;
  }
  enum class Corner { Still, Moved, OfRim };
  std::vector<Corner> corners;
  std::vector<Vector3d> at;
  for (int j = 0; j < patch.point_count(); ++j) {
    const PointOrigin origin = patch.point_origin[static_cast<std::size_t>(j)];
    const int old =
        point_origins(after.from_whole, origin.kind).to_old[static_cast<std::size_t>(origin.element)];
    at.emplace_back(after.state.x.row(j).transpose() + patch.origin);
    const auto found = places.find({origin.kind, old});
    if (old < 0) {
      corners.push_back(Corner::Moved);
    } else if (found == places.end()) {
      corners.push_back(Corner::OfRim);  // where the patch was cut out
    } else {
      const bool still = (found->second - at.back()).norm() <= kStill * whole.mean_edge;
      corners.push_back(still ? Corner::Still : Corner::Moved);
    }
  }
  std::vector<std::vector<Vector3d>> outlines;
  for (int i = 0; i < patch.panels.size(); ++i) {
    const auto is = [&](Corner wanted) {
      return [&, wanted](int j) { return corners[static_cast<std::size_t>(j)] == wanted; };
    };
    const auto panel = patch.panels[i];
    if (std::none_of(panel.begin(), panel.end(), is(Corner::Moved)) ||
        std::any_of(panel.begin(), panel.end(), is(Corner::OfRim))) {
      continue;
    }
    std::vector<Vector3d>& outline = outlines.emplace_back();
    for (const int j : panel) outline.push_back(at[static_cast<std::size_t>(j)]);
  }
  return outlines;
}

}  // namespace

EditSketch sketch(const PolygonMesh& mesh, const MeshEdit& edit) {
  EditSketch lines;
  const auto at = [&](int vertex) -> Vector3d { return mesh.positions().row(vertex).transpose(); };
  switch (edit.kind) {
    case EditKind::Flip:
    case EditKind::Join:
    case EditKind::SplitEdge:
    case EditKind::Collapse: {
      const MeshEdge edge = mesh.edge(edit.element);
      const Vector3d a = at(edge.a), b = at(edge.b);
      lines.place = edit.to.value_or(0.5 * (a + b));
      if (edit.kind != EditKind::SplitEdge) lines.gone.push_back({a, b});
      if (edge.border()) break;
      const Vector3d left = at(opposite(mesh, edge.left, edge)), right = at(opposite(mesh, edge.right, edge));
      if (edit.kind == EditKind::Flip) lines.made.push_back({left, right});
      if (edit.kind == EditKind::SplitEdge) lines.made = {{lines.place, left}, {lines.place, right}};
      break;
    }
    case EditKind::MoveVertex: {
      const Vector3d from = at(edit.element), to = edit.to.value_or(from);
      lines.place = to;
      for (const int e : mesh.edges_around(edit.element)) {
        const MeshEdge edge = mesh.edge(e);
        const Vector3d other = at(edge.a == edit.element ? edge.b : edge.a);
        lines.gone.push_back({from, other});
        lines.made.push_back({to, other});
      }
      break;
    }
    case EditKind::SplitFace:
      lines.made.push_back({at(edit.corners[0]), at(edit.corners[1])});
      lines.place = 0.5 * (lines.made.front()[0] + lines.made.front()[1]);
      break;
    case EditKind::DeleteFace: {
      const std::vector<int> corners = mesh.corners(edit.element);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        lines.gone.push_back({at(corners[k]), at(corners[(k + 1) % corners.size()])});
        lines.place += at(corners[k]) / static_cast<double>(corners.size());
      }
      break;
    }
  }
  return lines;
}

EditPreview preview(const PatchSolver& solver, const MeshEdit& edit, std::optional<Candidate> candidate,
                    int radius, const std::stop_token& stop) {
  EditPreview out{edit, {}, {}};
  if (!candidate && (edit.kind == EditKind::Flip || edit.kind == EditKind::Join)) {
    for (Candidate& found : candidates_at(solver.advised(), edit.element, true))
      if (found.edit == edit) candidate = std::move(found);
  }
  if (!candidate) return out;
  const auto ground = solver.prepare(candidate->centre, radius, stop);
  if (!ground) return out;
  const auto trial = solver.attempt(*ground, edit, stop);
  if (!trial) return out;
  out.panels = changed_panels(solver.advised(), *trial);
  out.rated = Suggestion{*std::move(candidate), ground->as_it_is.score, trial->score,
                         trial->met && ground->as_it_is.met};
  return out;
}

}  // namespace planewright::ui
