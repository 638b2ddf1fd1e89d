#include "core/pattern/thick_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/diagnose/panel_shape.h"
#include "core/pattern/line_contour.h"
#include "core/pattern/mitred_solid.h"

namespace planewright {
namespace {

SolidContour in_space(const LineContour& contour, const PanelFrame& frame, double height) {
  SolidContour result{{}, contour.start, contour.end};
  result.points.resize(static_cast<Eigen::Index>(contour.points.size()), 3);
  for (size_t k = 0; k < contour.points.size(); ++k)
    result.points.row(static_cast<Eigen::Index>(k)) = frame.point(contour.points[k], height).transpose();
  return result;
}

// The panel's own corners, bit for bit.
SolidContour own_corners(const WorkshopModel& model, int panel) {
  const auto corners = model.panels[panel];
  const int n = static_cast<int>(corners.size());
  SolidContour result{Points(n, 3), {}, {}};
  for (int k = 0; k < n; ++k) {
    result.points.row(k) = model.points.row(corners[static_cast<size_t>(k)]);
    result.start.push_back(k);
    result.end.push_back((k + 1) % n);
  }
  return result;
}

// Whether the corner belongs to three panels all round: their mitre planes have a line in common, and so the
// three solids have the inner corner.
bool mitres_meet(const WorkshopModel& model, int panel, int corner) {
  const int n = model.panels.valence(panel);
  const int before = model.neighbour(panel, (corner + n - 1) % n), after = model.neighbour(panel, corner);
  if (before < 0 || after < 0) return false;
  const int vertex = model.panels[panel][static_cast<size_t>(corner)];
  for (int side = 0; side < model.panels.valence(before); ++side) {
    const auto e = static_cast<size_t>(model.edges_of_panel[before][static_cast<size_t>(side)]);
    const WorkshopEdge& edge = model.edges[e];
    if (model.neighbour(before, side) == after && (edge.a == vertex || edge.b == vertex)) return true;
  }
  return false;
}

class Thickening {
 public:
  Thickening(const WorkshopModel& model, const ThicknessSettings& settings, int panel,
             std::vector<ThicknessFinding>& findings)
      : model_(model), settings_(settings), panel_(panel), findings_(findings) {}

  ThickPanel solid() {
    if (crosses_itself(model_.points, model_.panels[panel_])) return refused(ThicknessTrouble::Crosses);
    const PanelFrame frame = panel_frame(model_, panel_);
    const std::vector<Vector2d> corners = outline(model_, panel_, frame);
    // Nothing is left of an outline that is nothing: without area, or turned against its normal.
    double around = 0.0;
    for (size_t k = 0; k < corners.size(); ++k)
      around += (corners[(k + 1) % corners.size()] - corners[k]).norm();
    if (!(signed_area(corners) > 1e-12 * around * around)) return refused(ThicknessTrouble::Collapsed);

    SolidContour outer = own_corners(model_, panel_);
    std::vector<int> lost;
    if (settings_.gap > 0.0) {
      const auto lines = mitre_lines(model_, panel_, frame, corners, settings_.gap, 0.0);
      if (!lines) return refused(ThicknessTrouble::Collapsed);
      const LineContour contour = line_contour(*lines, corners, std::numeric_limits<double>::infinity());
      if (contour.empty()) return refused(ThicknessTrouble::Collapsed);
      outer = in_space(contour, frame, 0.0);
      lost = contour.lost;
    }

    // Spikes are measured from the outer corners that there are.
    const double t = settings_.thickness;
    std::vector<Vector2d> from = corners;
    for (size_t k = 0; k < from.size(); ++k)
      from[k] = frame.flat(outer.points.row(outer.start[k]).transpose());
    const auto lines = mitre_lines(model_, panel_, frame, corners, settings_.gap, t);
    if (!lines) return refused(ThicknessTrouble::Collapsed);
    const double limit = t * std::sqrt(kBluntAt * kBluntAt - 1.0);  // within the inner plane
    std::vector<bool> meets;
    for (size_t k = 0; k < corners.size(); ++k)
      meets.push_back(mitres_meet(model_, panel_, static_cast<int>(k)));
    const LineContour inner = line_contour(*lines, from, limit, meets);
    if (inner.empty()) return refused(ThicknessTrouble::Collapsed);

    lost.insert(lost.end(), inner.lost.begin(), inner.lost.end());
    std::sort(lost.begin(), lost.end());
    lost.erase(std::unique(lost.begin(), lost.end()), lost.end());
    for (const FarCorner& far : inner.far)
      findings_.push_back(
          {panel_, ThicknessTrouble::Spike, far.corner, std::hypot(far.distance, t), far.cut, t});
    for (const int side : lost) findings_.push_back({panel_, ThicknessTrouble::LostSide, side, 0.0, true, t});
    return mitred_solid(panel_, outer, in_space(inner, frame, -t));
  }

 private:
  ThickPanel refused(ThicknessTrouble trouble) {
    findings_.push_back({panel_, trouble, -1, 0.0, true, settings_.thickness});
    ThickPanel none;
    none.panel = panel_;
    return none;
  }

  const WorkshopModel& model_;
  const ThicknessSettings& settings_;
  int panel_;
  std::vector<ThicknessFinding>& findings_;
};

std::string millimetres(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
}

}  // namespace

Result<ThickPanels> thicken(const WorkshopModel& model, const ThicknessSettings& settings) {
  if (!std::isfinite(settings.thickness) || !(settings.thickness > 0.0))
    return fail(ErrorCode::Refused, "the thickness is not above 0 mm", "thickness",
                "give the thickness of the panels in millimetres, or leave it out for sheets without one");
  if (!std::isfinite(settings.gap) || settings.gap < 0.0)
    return fail(ErrorCode::Refused, "the gap between panels is below 0 mm", "gap",
                "give a gap of 0 mm or more");
  ThickPanels result;
  for (int i = 0; i < model.panel_count(); ++i)
    result.panels.push_back(Thickening(model, settings, i, result.findings).solid());
  return result;
}

std::string describe(const ThicknessFinding& finding, const WorkshopModel& model) {
  const std::string name = model.names[static_cast<size_t>(finding.panel)] + ": ";
  const std::string thickness = " (thickness " + millimetres(finding.thickness) + ")";
  switch (finding.trouble) {
    case ThicknessTrouble::Spike:
      return name + "the inner corner " + std::to_string(finding.corner + 1) +
             (finding.cut
                  ? " would lie " + millimetres(finding.wanted) + " away" + thickness + " and is cut off"
                  : " lies " + millimetres(finding.wanted) + " away" + thickness +
                        ", inside the panel, and is left there");
    case ThicknessTrouble::LostSide:
      return name + "side " + std::to_string(finding.corner + 1) + " has no length left on the inner face" +
             thickness + "; the sides beside it meet";
    case ThicknessTrouble::Collapsed:
      return name + "nothing is left of the inner or the outer face" + thickness + "; it has no solid";
    case ThicknessTrouble::Crosses:
      return name + "the outline crosses itself; it has no solid";
  }
  return name;
}

}  // namespace planewright
