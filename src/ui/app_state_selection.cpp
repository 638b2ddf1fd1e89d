// AppState's selection and pins: what of the mesh is selected, and what of it is held where.
#include <algorithm>

#include "core/complex/mapped_origin.h"
#include "core/edit/design_edits.h"
#include "ui/app_state.h"
#include "ui/format.h"

namespace planewright::ui {
namespace {

bool holds_something(const Pin& pin) {
  return pin.at[0] || pin.at[1] || pin.at[2];
}

}  // namespace

void AppState::select(Selection selection, Combine how) {
  selection_ = combined(std::move(selection_), selection, how);
  ++selection_changes_;
}

void AppState::select_panel(int panel, Combine how) {
  if (!shown() || panel < 0 || panel >= shown()->complex().plane_count()) return;
  select(of_present(named_panels(shown()->complex(), {panel})), how);
  selected_point.reset();
  selected_edge.reset();
  current_finding_.reset();
  current_suggestion_.reset();
  selected_panel = how == Combine::Remove ? std::nullopt : std::optional(panel);
}

void AppState::select_point(int point, Combine how) {
  if (!shown() || point < 0 || point >= shown()->complex().point_count()) return;
  select(of_present(named_points(shown()->complex(), {point})), how);
  selected_panel.reset();
  selected_edge.reset();
  current_finding_.reset();
  current_suggestion_.reset();
  selected_point = how == Combine::Remove ? std::nullopt : std::optional(point);
}

void AppState::clear_selection() {
  selection_ = {};
  ++selection_changes_;
  selected_panel.reset();
  selected_point.reset();
  selected_edge.reset();
  current_finding_.reset();
  current_suggestion_.reset();
}

// What was pointed at, in the next state's complex: the same elements of the mesh, as far as they are left.
void AppState::follow_pointed_at(const PreparedView& before, const PreparedView& next) {
  if (before.iterate->complex == next.iterate->complex) return;
  const TangentComplex &from = before.complex(), &to = next.complex();
  std::optional<ElementMap> edited;
  if (before.ids && next.ids && *before.ids != *next.ids) edited = map_between(*before.ids, *next.ids);
  const auto index_in = [](const auto& origins, const auto& origin) -> std::optional<int> {
    const auto found = std::find(origins.begin(), origins.end(), origin);
    return found == origins.end() ? std::nullopt : std::optional(static_cast<int>(found - origins.begin()));
  };
  const auto next_point = [&](int point) {
    PointOrigin origin = from.point_origin[static_cast<std::size_t>(point)];
    if (edited) origin.element = mapped(point_origins(*edited, origin.kind), origin.element);
    return index_in(to.point_origin, origin);
  };
  if (from.kind != to.kind) {
    selected_panel.reset();
    selected_point.reset();
    selected_edge.reset();
  }
  if (selected_panel) {
    int origin = from.plane_origin[static_cast<std::size_t>(*selected_panel)];
    if (from.kind == ComplexKind::Cluster) {
      origin = mapped(
          same_regions(from.region_of_face, from.plane_count(), to.region_of_face, to.plane_count()), origin);
    } else if (edited) {
      origin = mapped(plane_origins(*edited, from.kind), origin);
    }
    selected_panel = index_in(to.plane_origin, origin);
  }
  if (selected_point) selected_point = next_point(*selected_point);
  if (selected_edge) {
    const PanelEdge& edge = from.panel_edges[static_cast<std::size_t>(*selected_edge)];
    const auto a = next_point(edge.a), b = next_point(edge.b);
    selected_edge.reset();
    for (std::size_t e = 0; a && b && e < to.panel_edges.size(); ++e) {
      const PanelEdge& other = to.panel_edges[e];
      if ((other.a == *a && other.b == *b) || (other.a == *b && other.b == *a)) {
        selected_edge = static_cast<int>(e);
      }
    }
  }
}

void AppState::show_element(const ElementRef& element) {
  const auto& view = shown();
  if (!view || element.index < 0) return;
  const TangentComplex& complex = view->complex();
  Vector3d place = Vector3d::Zero();
  switch (element.kind) {
    case ElementKind::Point:
      if (element.index >= complex.point_count()) return;
      place = view->points.row(element.index).transpose();
      select_point(element.index, Combine::Replace);
      break;
    case ElementKind::Panel:
      if (element.index >= complex.panels.size() || complex.panels[element.index].empty()) return;
      place = centroid(view->points, complex.panels[element.index]);
      select_panel(element.index, Combine::Replace);
      break;
    case ElementKind::PanelEdge: {
      if (element.index >= static_cast<int>(complex.panel_edges.size())) return;
      const PanelEdge& edge = complex.panel_edges[static_cast<std::size_t>(element.index)];
      place = 0.5 * (view->points.row(edge.a) + view->points.row(edge.b)).transpose();
      clear_selection();
      selected_edge = element.index;
      break;
    }
  }
  look_at_ = LookAt{place, 5.0 * complex.mean_edge};
}

void AppState::store_selection(std::string name) {
  if (document_.empty()) return;
  if (selection_.empty()) {
    post(Message::Kind::Warning, "nothing is selected that could be stored", {},
         "Click panels, or draw a box round them (B).");
    return;
  }
  Selection stored = selection_;
  stored.name = name.empty() ? free_selection_name(document_.design()) : std::move(name);
  const std::string what = "Store " + stored.name;
  change_design(with_selection_stored(document_.design(), std::move(stored)), what);
}

bool AppState::rename_selection(const std::string& from, const std::string& to) {
  auto renamed = with_selection_renamed(document_.design(), from, to);
  if (!renamed) {
    post(renamed.error());
    return false;
  }
  change_design(std::move(*renamed), "Rename " + from);
  return true;
}

void AppState::remove_selection(const std::string& name) {
  const int demands = demands_on(document_.design(), name);
  change_design(with_selection_removed(document_.design(), name), "Delete " + name);
  if (demands > 0) {
    post(Message::Kind::Info, format_count(demands, "demand", "demands") + " on " + name +
                                  " went with it (Ctrl Z brings all back)");
  }
}

// --- Pins ------------------------------------------------------------------------------------

std::optional<int> AppState::shown_point(const PointOrigin& origin) const {
  if (!shown()) return std::nullopt;
  PointOrigin then = origin;
  if (const auto map = since_shown()) {
    then.element = mapped(point_origins(inverse(*map), origin.kind), origin.element);
  }
  const auto& origins = shown()->complex().point_origin;
  const auto found = std::find(origins.begin(), origins.end(), then);
  return found == origins.end() ? std::nullopt : std::optional(static_cast<int>(found - origins.begin()));
}

std::optional<int> AppState::shown_panel(int plane_origin) const {
  if (!shown()) return std::nullopt;
  const TangentComplex& complex = shown()->complex();
  if (const auto map = since_shown()) {
    plane_origin = mapped(plane_origins(inverse(*map), complex.kind), plane_origin);
  }
  const auto& origins = complex.plane_origin;
  const auto found = std::find(origins.begin(), origins.end(), plane_origin);
  return found == origins.end() ? std::nullopt : std::optional(static_cast<int>(found - origins.begin()));
}

std::optional<Vector3d> AppState::pin_place(const Pin& pin) const {
  const auto point = shown_point(pin.point);
  if (!point) return std::nullopt;
  Vector3d place = shown()->points.row(*point).transpose();
  for (int axis = 0; axis < 3; ++axis) {
    if (const auto& held = pin.at[static_cast<std::size_t>(axis)]) place[axis] = *held - scene_origin_[axis];
  }
  return place;
}

int AppState::pin_selection() {
  if (!shown()) return 0;
  const TangentComplex& complex = shown()->complex();
  const State& state = shown()->iterate->state;
  const auto edited = since_shown();
  const Selection selection = of_shown(selection_);
  std::vector<int> points = points_named(complex, selection);
  // A corner of the outline has no name in a selection; it is pinned when it is pointed at.
  if (selected_point && *selected_point < complex.point_count() &&
      !std::binary_search(points.begin(), points.end(), *selected_point)) {
    points.push_back(*selected_point);
  }
  const std::vector<int> panels = panels_named(complex, selection);
  LayerSettings settings = document_.settings();
  for (const int j : points) {
    const Vector3d at = state.x.row(j).transpose() + complex.origin;
    PointOrigin point = complex.point_origin[static_cast<std::size_t>(j)];
    if (edited) point.element = mapped(point_origins(*edited, point.kind), point.element);
    if (point.element >= 0) set_pin(settings.demands, {point, {{at.x(), at.y(), at.z()}}});
  }
  for (const int i : panels) {
    const Vector3d n = state.n.row(i).transpose().normalized();
    const double distance = state.h[i] + n.dot(complex.anchors.row(i)) + n.dot(complex.origin);
    int origin = complex.plane_origin[static_cast<std::size_t>(i)];
    if (edited) origin = mapped(plane_origins(*edited, complex.kind), origin);
    set_plane_pin(settings.demands, {origin, PlanePin::Equation{{n.x(), n.y(), n.z()}, distance}});
  }
  const auto count = static_cast<int>(points.size() + panels.size());
  if (count == 0) {
    post(Message::Kind::Info, "nothing is selected that could be pinned", {},
         "Click a corner or a panel first, then P.");
    return 0;
  }
  std::string what = "Pin ";
  if (points.empty()) {
    what += format_count(static_cast<int>(panels.size()), "panel", "panels");
  } else {
    what += format_count(static_cast<int>(points.size()), "point", "points");
    if (!panels.empty()) what += " and " + format_count(static_cast<int>(panels.size()), "panel", "panels");
  }
  change_settings(std::move(settings), std::move(what));
  return count;
}

int AppState::unpin_selection() {
  if (!shown()) return 0;
  const TangentComplex& complex = shown()->complex();
  LayerSettings settings = document_.settings();
  std::vector<PointOrigin> points;
  for (const int j : points_named(complex, of_shown(selection_))) {
    points.push_back(complex.point_origin[static_cast<std::size_t>(j)]);
  }
  if (selected_point && *selected_point < complex.point_count()) {
    points.push_back(complex.point_origin[static_cast<std::size_t>(*selected_point)]);
  }
  if (const auto edited = since_shown()) {
    for (PointOrigin& point : points) {
      point.element = mapped(point_origins(*edited, point.kind), point.element);
    }
  }
  const auto& panels = complex.kind == ComplexKind::Dual ? selection_.vertices : selection_.faces;
  auto count = std::erase_if(settings.demands.pins, [&](const Pin& pin) {
    return std::find(points.begin(), points.end(), pin.point) != points.end();
  });
  count += std::erase_if(settings.demands.plane_pins, [&](const PlanePin& pin) {
    return std::binary_search(panels.begin(), panels.end(), pin.panel_origin);
  });
  if (count > 0) change_settings(std::move(settings), "Unpin " + format_count(static_cast<int>(count)));
  return static_cast<int>(count);
}

void AppState::change_pin(int pin, Pin changed, std::string what, std::string merge_key) {
  LayerSettings settings = document_.settings();
  auto& pins = settings.demands.pins;
  if (pin < 0 || pin >= static_cast<int>(pins.size())) return;
  if (holds_something(changed)) {
    pins[static_cast<std::size_t>(pin)] = changed;
  } else {
    pins.erase(pins.begin() + pin);  // it holds nothing any more
  }
  change_settings(std::move(settings), std::move(what), std::move(merge_key));
}

void AppState::move_pin(int pin, const Vector3d& place) {
  const auto& pins = document_.settings().demands.pins;
  if (pin < 0 || pin >= static_cast<int>(pins.size()) || !place.allFinite()) return;
  Pin moved = pins[static_cast<std::size_t>(pin)];
  for (int axis = 0; axis < 3; ++axis) {
    auto& held = moved.at[static_cast<std::size_t>(axis)];
    if (held) held = place[axis] + scene_origin_[axis];
  }
  change_pin(pin, moved, "Move pin", "move pin " + std::to_string(pin));
}

void AppState::remove_pin(int pin) {
  LayerSettings settings = document_.settings();
  auto& pins = settings.demands.pins;
  if (pin < 0 || pin >= static_cast<int>(pins.size())) return;
  pins.erase(pins.begin() + pin);
  change_settings(std::move(settings), "Remove pin");
}

void AppState::remove_plane_pin(int pin) {
  LayerSettings settings = document_.settings();
  auto& pins = settings.demands.plane_pins;
  if (pin < 0 || pin >= static_cast<int>(pins.size())) return;
  pins.erase(pins.begin() + pin);
  change_settings(std::move(settings), "Remove pin");
}

}  // namespace planewright::ui
