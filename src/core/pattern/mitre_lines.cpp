#include "core/pattern/mitre_lines.h"

namespace planewright {
namespace {

constexpr double kNoLength = 1e-9;  // of the outline
// Cosine of the bevel (half of the sine of the fold) at which a mitre plane counts as parallel to the panel.
constexpr double kFolded = 1e-6;

const WorkshopEdge& edge_of(const WorkshopModel& model, int panel, int side) {
  return model.edges[static_cast<size_t>(model.edges_of_panel[panel][static_cast<size_t>(side)])];
}

}  // namespace

std::vector<SideLine> outline_lines(const std::vector<Vector2d>& corners) {
  const size_t n = corners.size();
  double around = 0.0;
  for (size_t k = 0; k < n; ++k) around += (corners[(k + 1) % n] - corners[k]).norm();
  std::vector<SideLine> lines;
  for (size_t k = 0; k < n; ++k) {
    const Vector2d side = corners[(k + 1) % n] - corners[k];
    if (!(side.norm() > kNoLength * around)) {
      lines.push_back({Vector2d::Zero(), 0.0});
      continue;
    }
    const Vector2d normal = Vector2d(side.y(), -side.x()).normalized();
    lines.push_back({normal, normal.dot(corners[k] + corners[(k + 1) % n]) / 2});
  }
  return lines;
}

std::vector<SideLine> gap_lines(const WorkshopModel& model, int panel, const std::vector<Vector2d>& corners,
                                double gap) {
  std::vector<SideLine> lines = outline_lines(corners);
  for (size_t k = 0; k < lines.size(); ++k)
    if (!edge_of(model, panel, static_cast<int>(k)).border()) lines[k].offset -= gap / 2;
  return lines;
}

std::optional<std::vector<SideLine>> mitre_lines(const WorkshopModel& model, int panel,
                                                 const PanelFrame& frame,
                                                 const std::vector<Vector2d>& corners, double gap,
                                                 double depth) {
  std::vector<SideLine> lines = outline_lines(corners);
  for (size_t k = 0; k < lines.size(); ++k) {
    const WorkshopEdge& edge = edge_of(model, panel, static_cast<int>(k));
    if (!lines[k].exists() || edge.border()) continue;
    // Both panels of the edge compute the same plane bit for bit, turned round: its normal is square to the
    // edge and to the sum of their normals.
    const Vector3d a = model.points.row(edge.a), b = model.points.row(edge.b);
    const Vector3d sum = model.normals.row(edge.left) + model.normals.row(edge.right);
    if (!(sum.norm() > kFolded)) return std::nullopt;
    const Vector3d mitre = (edge.left == panel ? 1.0 : -1.0) * (b - a).cross(sum).normalized();
    const Vector2d within(frame.x.dot(mitre), frame.y.dot(mitre));
    const double cosine = within.norm();
    if (!(cosine > kFolded)) return std::nullopt;
    lines[k].normal = within / cosine;
    lines[k].offset = (mitre.dot((a + b) / 2 - frame.origin) - gap / 2 + depth * frame.n.dot(mitre)) / cosine;
  }
  return lines;
}

}  // namespace planewright
