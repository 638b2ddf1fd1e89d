// What of the findings the viewport shows: a mark at each, and the edges of the input that a click flips.
#include <algorithm>

#include "ui/finding_text.h"
#include "ui/format.h"
#include "ui/viewport_impl.h"

namespace planewright::ui {

void Viewport::Impl::take_flagged(const AppState& state) {
  flagged.clear();
  flagged_ends.clear();
  if (!markers || !shown || !mesh || mesh != state.mesh_view()) return;
  const FindingList& list = state.finding_list();
  const auto current = state.current_finding();
  for (const FlaggedEdge& of : list.flagged) {
    if (list.too_many_flagged() &&
        (!current || std::find(of.findings.begin(), of.findings.end(), *current) == of.findings.end())) {
      continue;
    }
    flagged.push_back(of.edge);
    flagged_ends.push_back(mesh->edges[static_cast<std::size_t>(of.edge)]);
  }
}

// Points: a disc. Edges: themselves, and a disc where they are too short to be seen. Panels: their outline,
// and a disc in the middle.
void Viewport::Impl::mark_findings(const AppState& state, std::vector<render::Marker>& marks,
                                   std::vector<render::Segment>& segments) const {
  const FindingList& list = state.finding_list();
  if (!markers || !shown || !list.from || list.from->iterate != shown->iterate) return;
  const TangentComplex& complex = shown->complex();
  const auto place_of = [&](int point) -> Vector3d { return shown->points.row(point).transpose(); };
  std::vector<double> of_edge(complex.panel_edges.size(), 0.0);
  std::vector<double> of_panel(static_cast<std::size_t>(complex.plane_count()), 0.0);
  std::vector<double> of_point(static_cast<std::size_t>(complex.point_count()), 0.0);
  const auto touch = [&](const ElementRef& element, double severity) {
    auto& list_of = element.kind == ElementKind::Point   ? of_point
                    : element.kind == ElementKind::Panel ? of_panel
                                                         : of_edge;
    double& worst = list_of[static_cast<std::size_t>(element.index)];
    worst = std::max(worst, severity);
  };
  for (int row = 0; row < list.size(); ++row) {
    const Finding& finding = list.finding(row);
    touch(finding.element, finding.severity);
    if (finding.second) touch(*finding.second, finding.severity);
  }
  const auto mark = [&](const Vector3d& at, double severity) {
    marks.push_back(
        {at, severity >= kNotToBeBuilt ? render::Marker::Kind::Error : render::Marker::Kind::Warning});
  };
  for (std::size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    double worst = of_edge[e];
    for (const int panel : {edge.left, edge.right}) {
      if (panel >= 0) worst = std::max(worst, of_panel[static_cast<std::size_t>(panel)]);
    }
    if (!(worst > 0)) continue;
    segments.push_back(
        {place_of(edge.a), place_of(edge.b),
         worst >= kNotToBeBuilt ? render::Segment::Kind::Error : render::Segment::Kind::Warning});
  }
  constexpr double kShort = 0.3;  // mean edges
  for (std::size_t e = 0; e < of_edge.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    const Vector3d a = place_of(edge.a), b = place_of(edge.b);
    if (of_edge[e] > 0 && (a - b).norm() < kShort * complex.mean_edge) mark(0.5 * (a + b), of_edge[e]);
  }
  for (int panel = 0; panel < complex.panels.size(); ++panel) {
    const double worst = of_panel[static_cast<std::size_t>(panel)];
    if (worst > 0 && !complex.panels[panel].empty())
      mark(centroid(shown->points, complex.panels[panel]), worst);
  }
  for (int point = 0; point < complex.point_count(); ++point) {
    const double worst = of_point[static_cast<std::size_t>(point)];
    if (worst > 0) mark(place_of(point), worst);
  }
  for (const auto& [a, b] : flagged_ends) {
    segments.push_back(
        {mesh->points.row(a).transpose(), mesh->points.row(b).transpose(), render::Segment::Kind::Suggested});
  }
}

// The point that a finding is about and that is nearest to the mouse, within `reach` pixels of the picture.
std::optional<int> Viewport::Impl::finding_under(const AppState& state, ImVec2 at, float reach) const {
  const FindingList& list = state.finding_list();
  std::optional<int> best;
  for (int row = 0; markers && row < list.size(); ++row) {
    const Finding& finding = list.finding(row);
    if (finding.element.kind != ElementKind::Point) continue;
    const Vector3d at_point = shown->points.row(finding.element.index).transpose();
    if (camera.depth(at_point) <= 0) continue;
    const float away = glm::distance(camera.project(at_point), to_picture(at));
    if (away > reach) continue;
    reach = away;
    best = row;
  }
  return best;
}

// What a click does, or why it does nothing; and what is bad there.
void Viewport::Impl::explain_edge(Ui& ui, const AppState& state, int edge) const {
  constexpr std::size_t kListed = 3;
  const Palette& p = ui.colours();
  const auto& ids = state.document().ids();
  const int number =
      ids && edge < static_cast<int>(ids->edges.size()) ? ids->edges[static_cast<std::size_t>(edge)] : edge;
  const std::string name = "Edge " + format_count(number);
  const Result<void> allowed = state.document().may_edit(MeshEdit::flip(edge));
  const FindingList& list = state.finding_list();
  const FlaggedEdge* of =
      std::binary_search(flagged.begin(), flagged.end(), edge) ? list.find_flagged(edge) : nullptr;
  if (allowed) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(7)));
  ImGui::BeginTooltip();
  ui.text(name, allowed ? p.accent : p.ink_soft);
  ImGui::SameLine();
  ui.text(allowed ? "click flips it" : allowed.error().what, allowed ? p.ink : p.ink_soft);
  explain_gain(ui, state, edge, allowed.has_value());
  if (of != nullptr) {
    ui.gap(3);
    const double mean_edge = shown->complex().mean_edge;
    for (std::size_t i = 0; i < std::min(of->findings.size(), kListed); ++i) {
      const Finding& finding = list.finding(of->findings[i]);
      ui.small_text(capitalised(kind_name(finding.kind)) + ": " +
                        place_name(state.document(), state.active_layer(), *shown, finding) + ", " +
                        measure_text(finding.measure, finding.unit, mean_edge, state.unit()),
                    finding.severity >= kNotToBeBuilt ? p.error : p.ink_soft);
    }
    if (!allowed) ui.small_text("Right click: other edits", p.ink_faint);
    if (of->findings.size() > kListed) {
      ui.small_text("and " + format_count(static_cast<std::int64_t>(of->findings.size() - kListed)) + " more",
                    p.ink_faint);
    }
  }
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

}  // namespace planewright::ui
