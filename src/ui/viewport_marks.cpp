// The marks over the model: findings, what is selected, pins, and what is under the mouse.
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/viewport_impl.h"

namespace planewright::ui {

void Viewport::Impl::upload_marks(const AppState& state) {
  const Marked now{state.selected_point,
                   state.selected_panel,
                   state.selected_edge,
                   hovered,
                   hovered_corner,
                   state.selection_changes(),
                   state.document().revision(),
                   state.active_layer(),
                   state.findings(),
                   state.view_options.hidden_findings,
                   state.current_finding()};
  if (!marks_stale && markers == state.view_options.markers && marked == now) return;
  const bool film_stale = marks_stale || marked.selection != now.selection || marked.panel != now.panel;
  marks_stale = false;
  markers = state.view_options.markers;
  marked = now;
  take_flagged(state);

  std::vector<render::Marker> marks;
  std::vector<render::Segment> segments;
  mark_findings(state, marks, segments);
  if (shown) {
    if (markers && shown->thickness) {
      for (const auto& blunted : shown->thickness->blunted) {
        marks.push_back({shown->points.row(blunted.point).transpose(), render::Marker::Kind::Warning});
      }
    }
    const TangentComplex& complex = shown->complex();
    const auto place_of = [&](int point) -> Vector3d { return shown->points.row(point).transpose(); };
    // Panels: a film over them, and their outline.
    std::vector<int> panels = panels_named(complex, state.of_shown(state.selection()));
    if (now.panel && *now.panel < panel_layer.polygons.size() &&
        !std::binary_search(panels.begin(), panels.end(), *now.panel)) {
      panels.insert(std::lower_bound(panels.begin(), panels.end(), *now.panel), *now.panel);
    }
    if (film_stale) {
      std::vector<render::PanelArrays> films{render::triangles_of(shown->panels, panels)};
      if (shown->thickness) films.push_back(render::triangles_of(shown->thickness->back, panels));
      renderer.set_selected(films);
    }
    std::vector<char> in(static_cast<std::size_t>(complex.plane_count()), 0);
    for (const int panel : panels) in[static_cast<std::size_t>(panel)] = 1;
    const auto selected = [&](int panel) { return panel >= 0 && in[static_cast<std::size_t>(panel)] != 0; };
    for (std::size_t e = 0; e < complex.panel_edges.size(); ++e) {
      const PanelEdge& edge = complex.panel_edges[e];
      const bool outline = selected(edge.left) != selected(edge.right);
      const bool shown_edge = now.edge && *now.edge == static_cast<int>(e);
      if (outline || shown_edge) {
        segments.push_back({place_of(edge.a), place_of(edge.b), render::Segment::Kind::Selected});
      }
    }
    for (const int point : points_named(complex, state.of_shown(state.selection()))) {
      marks.push_back({place_of(point), render::Marker::Kind::Selected});
    }
    for (const auto& point : {now.point, now.hovered_corner}) {
      if (point && *point < shown->points.rows()) {
        marks.push_back({place_of(*point), render::Marker::Kind::Selected});
      }
    }
    const Demands& demands = state.document().settings().demands;
    for (const Pin& pin : demands.pins) {
      if (const auto at = state.pin_place(pin)) marks.push_back({*at, render::Marker::Kind::Pinned});
    }
    for (const PlanePin& pin : demands.plane_pins) {
      const auto panel = state.shown_panel(pin.panel_origin);
      if (panel && !complex.panels[*panel].empty()) {
        marks.push_back({centroid(shown->points, complex.panels[*panel]), render::Marker::Kind::Pinned});
      }
    }
  } else {
    renderer.set_selected({});
  }
  if (mesh && hovered && *hovered < static_cast<int>(mesh->edges.size())) {
    const auto [a, b] = mesh->edges[static_cast<std::size_t>(*hovered)];
    segments.push_back(
        {mesh->points.row(a).transpose(), mesh->points.row(b).transpose(), render::Segment::Kind::Hovered});
  }
  renderer.set_markers(marks, segments);
  pane_dirty[static_cast<int>(Pane::Panels)] = true;
}

}  // namespace planewright::ui
