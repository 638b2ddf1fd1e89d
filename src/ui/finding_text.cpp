#include "ui/finding_text.h"

#include <cmath>

#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

int number_in(const std::vector<int>& numbers, int index) {
  return index >= 0 && index < static_cast<int>(numbers.size()) ? numbers[static_cast<std::size_t>(index)]
                                                                : index;
}

}  // namespace

std::string corner_name(const PointOrigin& origin, const ElementIds* ids) {
  static const ElementIds none;
  if (ids == nullptr) ids = &none;
  switch (origin.kind) {
    case PointKind::Face:
      return "Corner in face " + format_count(number_in(ids->faces, origin.element));
    case PointKind::BorderEdge:
      return "Corner on edge " + format_count(number_in(ids->edges, origin.element));
    case PointKind::Corner:
      return "Outline at vertex " + format_count(number_in(ids->vertices, origin.element));
    case PointKind::Vertex:
      return "Vertex " + format_count(number_in(ids->vertices, origin.element));
  }
  return {};
}

int panel_number(const Document& document, int layer, const PreparedView& shown, int panel) {
  const TangentComplex& complex = shown.complex();
  if (panel < 0 || panel >= complex.plane_count()) return -1;
  const auto& layers = document.design().layers;
  if (!shown.ids || layer < 0 || layer >= static_cast<int>(layers.size())) return panel;
  return document.panel_number(complex.kind, layers[static_cast<std::size_t>(layer)].settings.border,
                               *shown.ids, complex.plane_origin[static_cast<std::size_t>(panel)]);
}

std::string element_name(const Document& document, int layer, const PreparedView& shown,
                         const ElementRef& element) {
  const TangentComplex& complex = shown.complex();
  const auto number = [&](int panel) { return format_count(panel_number(document, layer, shown, panel)); };
  switch (element.kind) {
    case ElementKind::Point:
      return corner_name(complex.point_origin[static_cast<std::size_t>(element.index)], shown.ids.get());
    case ElementKind::Panel:
      return "Panel " + number(element.index);
    case ElementKind::PanelEdge: {
      const PanelEdge& edge = complex.panel_edges[static_cast<std::size_t>(element.index)];
      if (edge.border()) return "Outer edge of panel " + number(edge.left >= 0 ? edge.left : edge.right);
      return "Edge of panels " + number(edge.left) + ", " + number(edge.right);
    }
  }
  return {};
}

std::string place_name(const Document& document, int layer, const PreparedView& shown,
                       const Finding& finding) {
  const auto number = [&](int panel) { return format_count(panel_number(document, layer, shown, panel)); };
  if (finding.element.kind == ElementKind::PanelEdge) {
    const PanelEdge& edge = shown.complex().panel_edges[static_cast<std::size_t>(finding.element.index)];
    if (edge.border()) return "Panel " + number(edge.left >= 0 ? edge.left : edge.right) + ", outside";
    return "Panels " + number(edge.left) + ", " + number(edge.right);
  }
  if (!finding.second) return element_name(document, layer, shown, finding.element);
  if (finding.element.kind == ElementKind::Panel && finding.second->kind == ElementKind::Panel) {
    return "Panels " + number(finding.element.index) + ", " + number(finding.second->index);
  }
  return element_name(document, layer, shown, finding.element) + ", " +
         element_name(document, layer, shown, *finding.second);
}

std::string measure_text(double measure, const std::string& finding_unit, double mean_edge,
                         const std::string& unit) {
  if (!std::isfinite(measure)) return "no number";
  if (finding_unit == "edges") return format_with_unit(measure * mean_edge, unit);
  constexpr double kNotHeld = 1e4;  // edges per degree: nothing but rounding holds the corner
  if (finding_unit == "edges per degree" && measure >= kNotHeld) return "not held";
  if (finding_unit == "edges per degree") return format_with_unit(measure * mean_edge, unit + "/°");
  if (finding_unit == "degrees") return format_number(measure) + "°";
  if (finding_unit.starts_with("of ")) return format_number(100 * measure) + " %";
  return format_number(measure);
}

std::string limit_text(const Finding& finding) {
  const bool part = finding.unit.starts_with("of ");
  const auto as_measured = [&](double value) {
    if (part) return format_number(100 * value) + " % " + finding.unit;
    return format_with_unit(value, finding.unit);
  };
  return as_measured(finding.measure) + ", the limit is " + as_measured(finding.threshold);
}

const char* severity_word(double severity) {
  return severity < kHardToBuild    ? "blemish"
         : severity < kNotToBeBuilt ? "hard to build"
                                    : "not to be built as it is";
}

std::string kind_title(FindingKind kind) {
  switch (kind) {
    case FindingKind::IllDetermined:
      return "Ill-determined corners";
    case FindingKind::ClosePoints:
      return "Corners too close";
    case FindingKind::ReversedEdge:
      return "Reversed edges";
    case FindingKind::SelfCrossing:
      return "Panels that cross themselves";
    case FindingKind::FoldedOver:
      return "Panels that fold over";
    case FindingKind::CrossingPanels:
      return "Panels that cross";
    case FindingKind::NotConvex:
      return "Panels not convex";
    case FindingKind::FarPoint:
      return "Corners far from their place";
    case FindingKind::CollapsedQuad:
      return "Quads become triangles";
    case FindingKind::TwistedBeam:
      return "Beams that twist";
  }
  return {};
}

std::string kind_name(FindingKind kind) {
  std::string title = info(kind).title;
  if (const auto at = title.find("point"); at != std::string::npos) title.replace(at, 5, "corner");
  return title;
}

FindingsStanding findings_standing(const AppState& state) {
  FindingsStanding standing;
  standing.panels = state.shown() != nullptr;
  standing.solving = state.solving();
  standing.finished = state.report() != nullptr;
  if (const auto findings = state.findings()) standing.diagnosis = &findings->diagnosis;
  standing.mean_edge = state.mean_edge();
  return standing;
}

std::string why_no_findings(const FindingsStanding& standing, const std::string& unit) {
  if (!standing.panels) return "Not solved yet. Known after the first step of a solve.";
  if (standing.diagnosis == nullptr) return "Looking for bad places…";
  if (standing.diagnosis->solved) return {};
  const std::string how_far = "corners lie up to " +
                              format_with_unit(standing.diagnosis->off_planes * standing.mean_edge, unit) +
                              " off their planes";
  if (standing.solving) return "Not solved yet: " + how_far + ".";
  if (!standing.finished) return "Not solved yet: " + how_far + ". Space solves.";
  return "Stopped before planar: " + how_far + ", so these are no panels to judge. Space goes on.";
}

}  // namespace planewright::ui
