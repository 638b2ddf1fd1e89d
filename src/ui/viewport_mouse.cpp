// What the mouse does in the viewport: orbiting, hovering, clicking, boxes and dragged pins.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/format.h"
#include "ui/viewport_impl.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

constexpr float kClickSlop = 4;  // pixels at scale 1 that a click may wander
constexpr double kZoomPerNotch = 1.15;

Combine combine_of(const ImGuiIO& io) {
  return io.KeyShift ? Combine::Add : io.KeyCtrl ? Combine::Remove : Combine::Replace;
}

}  // namespace

void Viewport::Impl::mouse(Ui& ui, AppState& state, bool hovered_now) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 at = io.MousePos;
  const float scale_factor = ui.theme().scale();
  moving = false;

  if (ImGui::IsItemActivated()) {
    pressed = true;
    dragging = false;
    press_at = last_at = at;
    left_press = io.MouseDown[0] && !io.MouseDown[1] && !io.MouseDown[2];
    right_press = io.MouseDown[1] && !io.MouseDown[0] && !io.MouseDown[2];
    flight.reset();
    const bool on_panels = pane == Pane::Panels;
    boxing = left_press && state.tool == Tool::Box && on_panels && shown != nullptr;
    const bool plain = !io.KeyShift && !io.KeyCtrl && !io.KeyAlt;
    painting = left_press && plain && begin_painting(state, at, scale_factor);
    dragged_pin =
        left_press && plain && on_panels && !boxing ? pin_under(state, at, scale_factor) : std::nullopt;
    if (dragged_pin) {
      const auto& pins = state.document().settings().demands.pins;
      pin_from = *state.pin_place(pins[static_cast<std::size_t>(*dragged_pin)]);
    }
    pans = io.KeyShift || !left_press;
    pivot = pivot_under(at);
    const bool tool_clicks = !on_panels && changes_regions(state.tool);
    if (plain && !boxing && !dragged_pin && !tool_clicks &&
        ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !flipped_by_click) {
      camera.pan(middle() - to_picture(at), pivot);
      pressed = framed = false;
      dirty = true;
    }
  }
  if (pressed && ImGui::IsItemActive()) {
    const ImVec2 moved(at.x - press_at.x, at.y - press_at.y);
    if (!dragging && std::hypot(moved.x, moved.y) > kClickSlop * scale_factor) {
      dragging = true;
      last_at = press_at;
    }
    if (dragging && (at.x != last_at.x || at.y != last_at.y)) {
      const glm::vec2 step((at.x - last_at.x) * pixel_ratio, (at.y - last_at.y) * pixel_ratio);
      if (dragged_pin) {
        drag_pin(state, at);
      } else if (painting) {
        paint(state, last_at, at, scale_factor);
      } else if (boxing) {
        // The box is drawn over the picture, which stays as it is.
      } else if (pans) {
        camera.pan(step, pivot);
        framed = false;
        dirty = true;
      } else {
        camera.orbit(step, pivot);
        dirty = true;
      }
      last_at = at;
    }
    moving = dragging && !boxing && !dragged_pin && !painting;
  }
  if (pressed && ImGui::IsItemDeactivated()) {
    pressed = false;
    if (dragging && boxing) select_box(state, press_at, at);
    if (dragging && dragged_pin) state.end_merge();
    if (boxing) state.tool = Tool::Look;
    if (painting) {
      state.end_painting();
      painting = false;
    } else if (!dragging && left_press && !io.MouseDown[0]) {
      click(ui, state, press_at);
    }
    if (!dragging && right_press && !io.MouseDown[1]) context_request = target_under(press_at, scale_factor);
    dragging = boxing = false;
    dragged_pin.reset();
    if (coarse_picture) dirty = true;
  }
  if (hovered_now && io.MouseWheel != 0) {
    flight.reset();
    camera.zoom(std::pow(kZoomPerNotch, static_cast<double>(io.MouseWheel)), to_picture(at));
    framed = false;
    dirty = true;
    hover_probe = {-1, -1};
  }

  // Hover: asked anew only when the mouse or the view has moved.
  if (!hovered_now || pressed || state.tool == Tool::Box) {
    if (!hovered_now || (pressed && dragging && !painting)) region_hover = {};
    if (!pressed || dragging) {
      hovered.reset();
      hovered_corner.reset();
      hovered_pin.reset();
    }
    hover_probe = {-1, -1};
    if (hovered_now && state.tool == Tool::Box) ImGui::SetMouseCursor(ImGuiMouseCursor_Arrow);
  } else {
    const glm::vec2 probe = to_picture(at);
    if (probe != hover_probe || any_dirty()) {
      hover_probe = probe;
      hover(ui, state, at);
    }
  }
  if (hovered_now && pane == Pane::Regions && !pressed) explain_region(ui, state);
  explain_hovered(ui, state);
}

// The pin under the mouse, else the corner, else the edge, unless the edge is nearer and can be flipped.
void Viewport::Impl::hover(Ui& ui, const AppState& state, ImVec2 at) {
  const float scale_factor = ui.theme().scale();
  hovered.reset();
  hovered_corner.reset();
  hovered_pin.reset();
  region_hover = {};
  if (pane == Pane::Regions) {
    region_hover = region_under(state, at, scale_factor);
    return;
  }
  hovered_pin = pin_under(state, at, scale_factor);
  if (hovered_pin) return;
  // The mesh is much finer than panels of clusters: its edges are in the way of these.
  if (state.document().settings().mode != ComplexKind::Cluster) hovered = edge_under(at, scale_factor);
  hovered_corner = corner_under(at, scale_factor);
  if (!hovered || !hovered_corner) return;
  const float to_corner =
      glm::distance(camera.project(shown->points.row(*hovered_corner).transpose()), to_picture(at));
  if (state.document().may_edit(MeshEdit::flip(*hovered)) && edge_place(*hovered, at).pixels < to_corner) {
    hovered_corner.reset();
  } else {
    hovered.reset();
  }
}

// The edge of the border that a corner stands on: the corner hides its middle, where one would click.
std::optional<int> Viewport::Impl::edge_of_corner(const AppState& state, std::optional<int> corner) const {
  if (!corner || !shown || *corner >= shown->complex().point_count()) return std::nullopt;
  const auto& now = state.document().ids();
  if (!shown->ids || !now || *shown->ids != *now) return std::nullopt;
  const PointOrigin& origin = shown->complex().point_origin[static_cast<std::size_t>(*corner)];
  return origin.kind == PointKind::BorderEdge ? std::optional(origin.element) : std::nullopt;
}

void Viewport::Impl::explain_hovered(Ui& ui, const AppState& state) const {
  if (!hovered && !hovered_pin) {
    if (const auto edge = edge_of_corner(state, hovered_corner)) explain_edge(ui, state, *edge);
    return;
  }
  if (hovered_pin) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(7)));
    ImGui::BeginTooltip();
    ui.text("Pin " + format_count(*hovered_pin + 1), ui.colours().accent);
    ImGui::SameLine();
    ui.text("drag to move");
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  } else {
    explain_edge(ui, state, *hovered);
  }
}

// The mesh edge under the mouse, the face, and the vertex.
EditTarget Viewport::Impl::target_under(ImVec2 at, float scale_factor) const {
  EditTarget found;
  if (!mesh) return found;
  found.edge = edge_under(at, scale_factor);
  if (const auto hit = render::pick_polygon(occluder, camera.ray(to_picture(at)))) found.face = hit->polygon;
  found.vertex = render::pick_point(mesh->points, camera, to_picture(at),
                                    kVertexReach * scale_factor * pixel_ratio, &occluder);
  return found;
}

// In the plane of the view through the place where it was taken up.
void Viewport::Impl::drag_pin(AppState& state, ImVec2 at) {
  const glm::vec2 pixel = camera.project(pin_from) + to_picture(at) - to_picture(press_at);
  const render::Ray ray = camera.ray(pixel);
  const double along = ray.direction.dot(camera.forward());
  if (!(along > 0)) return;
  state.move_pin(*dragged_pin,
                 ray.origin + (pin_from - ray.origin).dot(camera.forward()) / along * ray.direction);
}

void Viewport::Impl::click(Ui& ui, AppState& state, ImVec2 at) {
  const ImGuiIO& io = ImGui::GetIO();
  const Combine how = combine_of(io);
  if (pane == Pane::Regions) return click_region(state, at, how, ui.theme().scale());
  if (io.KeyAlt) return click_loop(state, at, how);
  hover(ui, state, at);
  const auto edge = std::exchange(hovered, std::nullopt);
  const auto corner = std::exchange(hovered_corner, std::nullopt);
  const auto pin = std::exchange(hovered_pin, std::nullopt);
  hover_probe = {-1, -1};
  const bool again =
      std::exchange(flipped_by_click, false) && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (!again && how == Combine::Replace && edge) {
    const bool flagged_edge = std::binary_search(flagged.begin(), flagged.end(), *edge);
    if (const Result<void> allowed = state.document().may_edit(MeshEdit::flip(*edge)); allowed) {
      state.edit_mesh(MeshEdit::flip(*edge));
      flipped_by_click = true;
      return;
    } else {
      const Error& why = allowed.error();
      state.post(Message::Kind::Refused, why.what, why.where, why.remedy);
      if (flagged_edge) return;
    }
  }
  if (how == Combine::Replace) state.clear_selection();
  if (!shown) return;
  if (const auto of = edge_of_corner(state, corner); of && how == Combine::Replace) {
    if (const Result<void> allowed = state.document().may_edit(MeshEdit::flip(*of)); !allowed) {
      const Error& why = allowed.error();
      state.post(Message::Kind::Refused, why.what, why.where, why.remedy);
    }
  }
  if (pin) {
    const auto& pins = state.document().settings().demands.pins;
    if (const auto point = state.shown_point(pins[static_cast<std::size_t>(*pin)].point)) {
      state.select_point(*point, how);
    }
    return;
  }
  if (const auto row = finding_under(state, at, kEdgeReach * ui.theme().scale() * pixel_ratio)) {
    const Finding finding = state.finding_list().finding(*row);
    state.select_point(finding.element.index, how);
    return;
  }
  if (corner) {
    state.select_point(*corner, how);
  } else if (const auto hit = render::pick_polygon(panel_layer, camera.ray(to_picture(at)))) {
    state.select_panel(hit->polygon, how);
  }
}

// Through the panel edge that is nearest to the mouse, of the panel under it.
void Viewport::Impl::click_loop(AppState& state, ImVec2 at, Combine how) {
  if (!shown || state.document().empty()) return;
  const auto hit = render::pick_polygon(panel_layer, camera.ray(to_picture(at)));
  if (!hit) return;
  const TangentComplex& complex = shown->complex();
  std::optional<int> best;
  float nearest = 0;
  for (std::size_t e = 0; e < complex.panel_edges.size(); ++e) {
    const PanelEdge& edge = complex.panel_edges[e];
    if (edge.left != hit->polygon && edge.right != hit->polygon) continue;
    const OnSegment on =
        nearest_on_segment(camera.project(shown->points.row(edge.a).transpose()),
                           camera.project(shown->points.row(edge.b).transpose()), to_picture(at));
    if (best && on.pixels >= nearest) continue;
    best = static_cast<int>(e);
    nearest = on.pixels;
  }
  if (!best) return;
  const PolygonMesh& mesh_now = *state.document().mesh();
  const int edge = mesh_edge_of(mesh_now, complex, *best);
  if (edge < 0) return;
  if (how == Combine::Replace) state.clear_selection();
  state.select(loop_through(mesh_now, complex.kind, state.select_what, edge), how);
}

void Viewport::Impl::select_box(AppState& state, ImVec2 from, ImVec2 to) const {
  if (!shown) return;
  const ImGuiIO& io = ImGui::GetIO();
  const TangentComplex& complex = shown->complex();
  std::vector<char> in_sight_panels;
  if (io.KeyAlt) in_sight_panels = render::polygons_in_sight(panel_layer, camera);
  const auto seen = [&](int panel) {
    return in_sight_panels.empty() || in_sight_panels[static_cast<std::size_t>(panel)] != 0;
  };
  Selection inside;
  if (state.select_what == SelectWhat::Panels) {
    auto panels = render::polygons_in_box(panel_layer, camera, to_picture(from), to_picture(to));
    std::erase_if(panels, [&](int panel) { return !seen(panel); });
    inside = named_panels(complex, panels);
  } else {
    std::vector<char> corner_seen(static_cast<std::size_t>(complex.point_count()), io.KeyAlt ? 0 : 1);
    for (int panel = 0; io.KeyAlt && panel < complex.panels.size(); ++panel) {
      if (!seen(panel)) continue;
      for (const int corner : complex.panels[panel]) corner_seen[static_cast<std::size_t>(corner)] = 1;
    }
    auto points = render::points_in_box(shown->points, camera, to_picture(from), to_picture(to));
    std::erase_if(points, [&](int point) { return !corner_seen[static_cast<std::size_t>(point)]; });
    inside = named_points(complex, points);
  }
  const Combine how = combine_of(io);
  if (how == Combine::Replace) state.clear_selection();
  state.select(state.of_present(inside), how);
}

void Viewport::Impl::draw_box(const Ui& ui, ImVec2 at) const {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 low(std::min(press_at.x, at.x), std::min(press_at.y, at.y));
  const ImVec2 high(std::max(press_at.x, at.x), std::max(press_at.y, at.y));
  draw.AddRectFilled(low, high, with_alpha(ui.colours().accent, 0.12f));
  draw.AddRect(low, high, ui.colours().accent, 0, 0, ui.px(1.5f));
}

}  // namespace planewright::ui
