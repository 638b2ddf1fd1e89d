#include "core/pattern/flat_pattern.h"

#include <limits>

#include "core/diagnose/panel_shape.h"
#include "core/pattern/contours.h"
#include "core/pattern/line_contour.h"

namespace planewright {
namespace {

Contour contour_of(const std::vector<Vector2d>& points) {
  Contour contour(static_cast<Eigen::Index>(points.size()), 2);
  for (size_t k = 0; k < points.size(); ++k)
    contour.row(static_cast<Eigen::Index>(k)) = points[k].transpose();
  return contour;
}

Contour laid_flat(const ThickPanel& solid, int from, int to, const PanelFrame& frame) {
  Contour contour(to - from, 2);
  for (int k = from; k < to; ++k)
    contour.row(k - from) = frame.flat(solid.points.row(k).transpose()).transpose();
  return contour;
}

// Which side each segment of the solid's outer face belongs to.
std::vector<int> sides_of_segments(const ThickPanel& solid) {
  std::vector<int> side(static_cast<size_t>(solid.outer), -1);
  for (int f = 2; f < solid.faces.size(); ++f) {
    const auto face = solid.faces[f];
    for (size_t k = 0; k < face.size(); ++k) {
      const int from = face[k], to = face[(k + 1) % face.size()];
      if (from < solid.outer && to < solid.outer)
        side[static_cast<size_t>(to)] = solid.side_of_face[static_cast<size_t>(f)];
    }
  }
  return side;
}

// Outer contour of a sheet without thickness.
void leave_gap(const WorkshopModel& model, double gap, const std::vector<Vector2d>& corners,
               FlatPattern& pattern) {
  const LineContour contour = line_contour(gap_lines(model, pattern.panel, corners, gap), corners,
                                           std::numeric_limits<double>::infinity());
  pattern.outer = contour_of(contour.points);
  pattern.side_of_segment.assign(contour.points.size(), -1);
  for (size_t k = 0; k < contour.start.size(); ++k)
    if (contour.start[k] != contour.end[k])
      pattern.side_of_segment[static_cast<size_t>(contour.start[k])] = static_cast<int>(k);
}

void move(FlatPattern& pattern, const PanelFrame& frame) {
  const Contour& box = pattern.empty() ? pattern.nominal : pattern.cut;
  const Eigen::RowVector2d low = box.colwise().minCoeff();
  for (Contour* contour : {&pattern.nominal, &pattern.outer, &pattern.inner, &pattern.cut})
    contour->rowwise() -= low;
  pattern.frame.linear() << frame.x, frame.y, frame.n;
  pattern.frame.translation() = frame.point(low.transpose());
}

FlatPattern flatten(const WorkshopModel& model, int panel, const ThickPanel* solid, double gap) {
  FlatPattern pattern;
  pattern.panel = panel;
  pattern.lies_flat = lies_flat(model, panel);
  const PanelFrame frame = panel_frame(model, panel);
  const std::vector<Vector2d> corners = outline(model, panel, frame);
  pattern.nominal = contour_of(corners);
  if (solid && !solid->empty()) {
    pattern.outer = laid_flat(*solid, 0, solid->outer, frame);
    pattern.inner = laid_flat(*solid, solid->outer, static_cast<int>(solid->points.rows()), frame);
    pattern.side_of_segment = sides_of_segments(*solid);
    pattern.cut = united(pattern.outer, pattern.inner);
  } else if (!solid && !crosses_itself(model.points, model.panels[panel])) {
    if (gap > 0.0) {
      leave_gap(model, gap, corners, pattern);
    } else if (signed_area(pattern.nominal) > 0.0) {
      pattern.outer = pattern.nominal;
      for (size_t k = 0; k < corners.size(); ++k) pattern.side_of_segment.push_back(static_cast<int>(k));
    }
    pattern.cut = pattern.outer;
  }
  move(pattern, frame);
  if (pattern.empty()) return pattern;

  DeepestPoint deepest{Vector2d::Zero(), 0.0};
  if (pattern.inner.rows() > 0) deepest = deepest_point({&pattern.outer, &pattern.inner});
  if (!(deepest.depth > 0.0)) deepest = deepest_point({&pattern.outer});
  pattern.label = deepest.point;
  pattern.label_room = deepest.depth;
  return pattern;
}

}  // namespace

double signed_area(const Contour& contour) {
  double twice = 0.0;
  for (Eigen::Index k = 1; k + 1 < contour.rows(); ++k)
    twice += cross(Vector2d((contour.row(k) - contour.row(0)).transpose()),
                   Vector2d((contour.row(k + 1) - contour.row(0)).transpose()));
  return twice / 2;
}

std::vector<FlatPattern> flatten(const WorkshopModel& model, const ThickPanels* solids, double gap) {
  std::vector<FlatPattern> patterns;
  for (int i = 0; i < model.panel_count(); ++i)
    patterns.push_back(flatten(model, i, solids ? &solids->panels[static_cast<size_t>(i)] : nullptr, gap));
  return patterns;
}

}  // namespace planewright
