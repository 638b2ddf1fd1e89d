#include "ui/viewport.h"

#include <epoxy/gl.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "ui/format.h"
#include "ui/render/picking.h"
#include "ui/render_target.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

constexpr float kClickSlop = 4;      // pixels at scale 1 that a click may wander
constexpr float kEdgeReach = 7;      // pixels at scale 1 within which an edge is hit
constexpr double kSlowPicture = 28;  // milliseconds above which a moving picture is drawn coarser
constexpr double kZoomPerNotch = 1.15;

render::ColourScale colour_scale(const AppState& state, const std::string& unit) {
  render::ColourScale scale;
  scale.low = 0;
  scale.high = state.colour_range();
  scale.unit = unit;
  if (state.view_options.colours == ColourMap::Planarity) {
    scale.quantity = "Planarity";
    if (const double tolerance = state.planarity_tolerance(); tolerance > 0 && tolerance < scale.high) {
      scale.tolerance = tolerance;
    }
  } else {
    scale.quantity = "Displacement";
  }
  return scale;
}

bool same(const std::optional<render::ColourScale>& a, const std::optional<render::ColourScale>& b) {
  if (a.has_value() != b.has_value()) return false;
  return !a || (a->low == b->low && a->high == b->high && a->quantity == b->quantity && a->unit == b->unit &&
                a->tolerance == b->tolerance);
}

}  // namespace

struct Viewport::Impl {
  explicit Impl(render::Renderer r) : renderer(std::move(r)) {}

  render::Renderer renderer;
  render::Camera camera;
  RenderTarget target;
  Rect place{};           // on the window
  float pixel_ratio = 1;  // framebuffer pixels per window pixel

  // What the renderer holds.
  std::shared_ptr<const MeshView> mesh;
  std::shared_ptr<const PreparedView> shown;
  std::shared_ptr<const PreparedGhost> drawn_ghost;
  render::PolygonLayer occluder;     // the ghost's faces, for picking
  render::PolygonLayer panel_layer;  // the panels as shown, for picking
  ColourMap colours = ColourMap::None;
  std::optional<render::ColourScale> scale;
  bool dark = false, ghost = true, markers = true;
  std::optional<int> marked_point, marked_panel, marked_edge;
  bool marks_stale = true;
  std::uint64_t fitted = 0;

  bool dirty = true, coarse_picture = false, fine_picture = false, redrawn = false;
  bool moving = false;  // the camera, by the mouse, in this frame
  double full_ms = 0;   // what a full picture took lately

  // The mouse.
  std::optional<int> hovered;
  bool pressed = false, dragging = false, pans = false, flipped_by_click = false;
  ImVec2 press_at{}, last_at{};
  Vector3d pivot = Vector3d::Zero();
  glm::vec2 hover_probe{-1, -1};
  std::uint64_t hover_revision = 0;

  glm::vec2 to_picture(ImVec2 window) const {
    return {(window.x - place.min.x) * pixel_ratio, (window.y - place.min.y) * pixel_ratio};
  }
  glm::vec2 middle() const {
    return {0.5f * static_cast<float>(camera.width()), 0.5f * static_cast<float>(camera.height())};
  }
  ImVec2 to_window(glm::vec2 picture) const {
    return {place.min.x + picture.x / pixel_ratio, place.min.y + picture.y / pixel_ratio};
  }

  const render::PolygonLayer* pick_layer() const {
    if (shown && panel_layer.points.rows() > 0) return &panel_layer;
    return mesh ? &occluder : nullptr;
  }
  Vector3d pivot_under(ImVec2 window) const {
    const auto ray = camera.ray(to_picture(window));
    if (const render::PolygonLayer* layer = pick_layer()) {
      if (const auto hit = render::pick_polygon(*layer, ray)) return hit->position;
    }
    return camera.target();
  }
  std::optional<int> edge_under(ImVec2 window, float scale_factor) const {
    if (!mesh) return std::nullopt;
    return render::pick_edge(mesh->points, mesh->edges, camera, to_picture(window),
                             kEdgeReach * scale_factor * pixel_ratio, &occluder);
  }

  void show(std::shared_ptr<const PreparedView> view);
  // Per panel and per point; what the colours do not ask for is empty.
  std::pair<Vector, Vector> values() const {
    if (colours == ColourMap::Planarity) return {shown->planarity.per_panel, Vector()};
    if (colours == ColourMap::Displacement) return {Vector(), shown->displacement.per_point};
    return {};
  }

  bool in_sight(const render::Camera& from, const Vector3d& point) const;
  void turn_towards(const Vector3d& point);
  void upload_marks(const AppState& state);
  void mouse(Ui& ui, AppState& state, bool hovered_now);
  void click(Ui& ui, AppState& state, ImVec2 at);
  void picture(Ui& ui, AppState& state);
};

Result<Viewport> Viewport::create() {
  return render::Renderer::create().map(
      [](render::Renderer&& renderer) { return Viewport(std::make_unique<Impl>(std::move(renderer))); });
}
Viewport::Viewport(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Viewport::Viewport(Viewport&&) noexcept = default;
Viewport& Viewport::operator=(Viewport&&) noexcept = default;
Viewport::~Viewport() = default;

std::optional<int> Viewport::hovered_edge() const {
  return impl_->hovered;
}
const render::Camera& Viewport::camera() const {
  return impl_->camera;
}
bool Viewport::take_redrawn() {
  return std::exchange(impl_->redrawn, false);
}

// --- Upload ----------------------------------------------------------------------------------

void Viewport::upload(AppState& state, bool dark, const std::string& unit) {
  Impl& v = *impl_;
  const Stopwatch watch;
  bool streamed = false;

  const bool new_mesh = v.mesh != state.mesh_view();
  const bool new_view = v.shown != state.shown();
  const bool new_colours = v.colours != state.view_options.colours;
  v.colours = state.view_options.colours;

  if (new_mesh) {
    v.mesh = state.mesh_view();
    v.occluder = {};
    if (v.mesh) {
      v.occluder.points = v.mesh->points;
      v.occluder.polygons = v.mesh->faces;
    }
    v.hover_probe = {-1, -1};
  }
  if (v.drawn_ghost != state.ghost()) {
    v.drawn_ghost = state.ghost();
    v.renderer.set_ghost(
        v.drawn_ghost ? std::shared_ptr<const render::GhostArrays>(v.drawn_ghost, &v.drawn_ghost->arrays)
                      : nullptr);
    v.dirty = streamed = true;
  }
  if (new_view) {
    v.show(state.shown());
    streamed = true;
  } else if (new_colours && v.shown) {
    const auto [per_panel, per_point] = v.values();
    v.renderer.set_panel_values(per_panel, per_point);
  }
  if (new_mesh || new_view || new_colours) v.marks_stale = v.dirty = true;

  std::optional<render::ColourScale> scale;
  if (v.shown && v.colours != ColourMap::None) scale = colour_scale(state, unit);
  if (!same(scale, v.scale)) {
    v.scale = scale;
    v.renderer.set_colours(scale);
    v.dirty = true;
  }
  if (v.dark != dark || v.ghost != state.view_options.ghost) {
    v.dark = dark;
    v.ghost = state.view_options.ghost;
    v.dirty = true;
  }
  v.upload_marks(state);
  if (v.fitted != state.opened_count() && v.mesh && v.place.width() > 1) {
    v.fitted = state.opened_count();
    v.camera.reset_direction();
    fit(state);
  }
  if (streamed) state.timings.upload.add(watch.milliseconds());
}

void Viewport::Impl::show(std::shared_ptr<const PreparedView> view) {
  const auto cut_before = shown ? shown->panels.geometry : nullptr;
  shown = std::move(view);
  if (!shown) {
    panel_layer = {};
    renderer.set_panels({}, {}, {});
    return;
  }
  panel_layer.points = shown->points;
  if (shown->panels.geometry != cut_before) panel_layer.polygons = shown->panels.geometry->polygons;
  const auto [per_panel, per_point] = values();
  renderer.set_panels(shown->panels, per_panel, per_point);
}

void Viewport::Impl::upload_marks(const AppState& state) {
  const bool stale = marks_stale || markers != state.view_options.markers ||
                     marked_point != state.selected_point || marked_panel != state.selected_panel ||
                     marked_edge != hovered;
  if (!stale) return;
  marks_stale = false;
  markers = state.view_options.markers;
  marked_point = state.selected_point;
  marked_panel = state.selected_panel;
  marked_edge = hovered;

  std::vector<render::Marker> marks;
  std::vector<render::Segment> segments;
  if (shown) {
    if (markers) {
      for (const IllDetermined& point : shown->ill_determined) {
        marks.push_back({shown->points.row(point.point).transpose(), render::Marker::Kind::Warning});
      }
    }
    if (marked_point && *marked_point < shown->points.rows()) {
      marks.push_back({shown->points.row(*marked_point).transpose(), render::Marker::Kind::Selected});
    }
    if (marked_panel && *marked_panel < panel_layer.polygons.size()) {
      const auto corners = panel_layer.polygons[*marked_panel];
      for (std::size_t k = 0; k < corners.size(); ++k) {
        segments.push_back({shown->points.row(corners[k]).transpose(),
                            shown->points.row(corners[(k + 1) % corners.size()]).transpose(),
                            render::Segment::Kind::Selected});
      }
    }
  }
  if (mesh && hovered && *hovered < static_cast<int>(mesh->edges.size())) {
    const auto [a, b] = mesh->edges[static_cast<std::size_t>(*hovered)];
    segments.push_back(
        {mesh->points.row(a).transpose(), mesh->points.row(b).transpose(), render::Segment::Kind::Hovered});
  }
  renderer.set_markers(marks, segments);
  dirty = true;
}

// --- Camera ----------------------------------------------------------------------------------

void Viewport::fit(const AppState& state) {
  if (!state.mesh_view()) return;
  Vector3d low = state.mesh_view()->low, high = state.mesh_view()->high;
  if (state.shown() && state.shown()->points.allFinite()) {
    // The panels may stand off the design, but a point thrown far away must not shrink the view to nothing.
    const Vector3d reach = 0.5 * (high - low).norm() * Vector3d::Ones();
    low = low.cwiseMin(state.shown()->low.cwiseMax(low - reach));
    high = high.cwiseMax(state.shown()->high.cwiseMin(high + reach));
  }
  impl_->camera.fit(low, high);
  impl_->dirty = true;
}

void Viewport::reset_direction(const AppState& state) {
  impl_->camera.reset_direction();
  fit(state);
}

bool Viewport::Impl::in_sight(const render::Camera& from, const Vector3d& point) const {
  const render::PolygonLayer* layer = pick_layer();
  if (layer == nullptr) return true;
  const Vector3d way = point - from.eye();
  const double distance = way.norm();
  if (!(distance > 0)) return true;
  // The point's own panels meet in it; so a hit counts only well before it.
  const auto hit = render::pick_polygon(*layer, {from.eye(), way / distance});
  return !hit || hit->distance > 0.995 * distance;
}

// Turns the camera until nothing hides the point, as little as may be; not at all where that is in vain.
void Viewport::Impl::turn_towards(const Vector3d& point) {
  if (in_sight(camera, point)) return;
  const Vector3d back = -camera.forward();
  const double azimuth = std::atan2(back.y(), back.x());
  const double elevation = std::asin(std::clamp(back.z(), -1.0, 1.0));
  constexpr double kStep = std::numbers::pi / 6;
  for (int steps = 0; steps <= 6; ++steps) {
    for (const double side : {1.0, -1.0}) {
      for (const double height : {elevation, 1.0, 0.3}) {
        render::Camera turned = camera;
        turned.set_direction(azimuth + side * steps * kStep, height);
        if (turned.depth(point) <= 0) continue;
        turned.pan(middle() - turned.project(point), point);
        if (!in_sight(turned, point)) continue;
        camera = turned;
        return;
      }
    }
  }
}

void Viewport::look_at(const Vector3d& scene_point, double radius) {
  impl_->turn_towards(scene_point);
  impl_->camera.pan(impl_->middle() - impl_->camera.project(scene_point), scene_point);
  const double shown_radius = 0.5 * impl_->camera.height() * impl_->camera.pixel_size_at(scene_point);
  if (radius > 0 && shown_radius > 0) impl_->camera.zoom(shown_radius / radius, scene_point);
  impl_->dirty = true;
}

std::optional<ImVec2> Viewport::clickable_place_of_edge(const AppState& state, int edge) const {
  const Impl& v = *impl_;
  if (!v.mesh || v.mesh != state.mesh_view() || edge < 0 || edge >= static_cast<int>(v.mesh->edges.size())) {
    return std::nullopt;
  }
  const auto [a, b] = v.mesh->edges[static_cast<std::size_t>(edge)];
  const Vector3d middle = 0.5 * (v.mesh->points.row(a) + v.mesh->points.row(b)).transpose();
  if (v.camera.depth(middle) <= 0) return std::nullopt;
  const ImVec2 at = v.to_window(v.camera.project(middle));
  const ImVec2 whole(std::round(at.x), std::round(at.y));
  const float margin = 12;
  if (whole.x < v.place.min.x + margin || whole.x > v.place.max.x - margin ||
      whole.y < v.place.min.y + margin || whole.y > v.place.max.y - margin) {
    return std::nullopt;
  }
  const auto hit = v.edge_under(whole, 1.0f);
  return hit && *hit == edge ? std::optional(whole) : std::nullopt;
}

// --- The frame -------------------------------------------------------------------------------

void Viewport::draw(Ui& ui, AppState& state, const Rect& place, const std::string& unit) {
  Impl& v = *impl_;
  const float ratio = ImGui::GetIO().DisplayFramebufferScale.x;
  v.place = place;
  v.pixel_ratio = ratio > 0 ? ratio : 1.0f;
  const int width = std::max(1, static_cast<int>(place.width() * v.pixel_ratio));
  const int height = std::max(1, static_cast<int>(place.height() * v.pixel_ratio));
  if (v.camera.width() != width || v.camera.height() != height) {
    v.camera.set_viewport(width, height);
    v.dirty = true;
  }

  ImGui::SetNextWindowPos(place.min);
  ImGui::SetNextWindowSize(ImVec2(place.width(), place.height()));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("##model", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(place.min);
  ImGui::InvisibleButton("model", ImVec2(std::max(1.0f, place.width()), std::max(1.0f, place.height())),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  ui.record("model", place.min, place.max);
  v.mouse(ui, state, ImGui::IsItemHovered());
  v.upload_marks(state);

  const Stopwatch watch;
  v.picture(ui, state);
  if (v.redrawn) state.timings.scene.add(watch.milliseconds());
  ImGui::GetWindowDrawList()->AddImage(v.target.texture(), place.min, place.max, ImVec2(0, 1), ImVec2(1, 0));
  draw_badge(ui, state, v.place, unit, v.shown ? std::optional(v.shown->planarity.max) : std::nullopt);
  if (v.scale && v.shown) draw_legend(ui, v.place, *v.scale, v.colours);
  draw_axes(ui, v.place, v.camera);
  ImGui::End();
}

void Viewport::Impl::mouse(Ui& ui, AppState& state, bool hovered_now) {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 at = io.MousePos;
  const float scale_factor = ui.theme().scale();
  moving = false;

  if (ImGui::IsItemActivated()) {
    pressed = true;
    dragging = false;
    press_at = last_at = at;
    pans = io.KeyShift || io.MouseDown[1] || io.MouseDown[2];
    pivot = pivot_under(at);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !flipped_by_click) {
      camera.pan(middle() - to_picture(at), pivot);
      pressed = false;
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
      if (pans) {
        camera.pan(step, pivot);
      } else {
        camera.orbit(step, pivot);
      }
      last_at = at;
      dirty = true;
    }
    moving = dragging;
  }
  if (pressed && ImGui::IsItemDeactivated()) {
    pressed = false;
    if (!dragging && !pans && !io.MouseDown[0]) click(ui, state, press_at);
    dragging = false;
    if (coarse_picture) dirty = true;
  }
  if (hovered_now && io.MouseWheel != 0) {
    camera.zoom(std::pow(kZoomPerNotch, static_cast<double>(io.MouseWheel)), to_picture(at));
    dirty = true;
    hover_probe = {-1, -1};
  }

  // Hover: asked anew only when the mouse or the view has moved.
  if (!hovered_now || pressed) {
    if (!pressed || dragging) hovered.reset();
    hover_probe = {-1, -1};
  } else {
    const glm::vec2 probe = to_picture(at);
    if (probe != hover_probe || dirty) {
      hover_probe = probe;
      hovered = edge_under(at, scale_factor);
    }
  }
  if (hovered) {
    const Result<void> allowed = state.document().may_flip(*hovered);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(10), ui.px(7)));
    ImGui::BeginTooltip();
    ui.text("Edge " + format_count(*hovered), allowed ? ui.colours().accent : ui.colours().ink_soft);
    ImGui::SameLine();
    ui.text(allowed ? "click to flip" : allowed.error().what,
            allowed ? ui.colours().ink : ui.colours().ink_soft);
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
    if (allowed) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
}

void Viewport::Impl::click(Ui& ui, AppState& state, ImVec2 at) {
  if (!std::exchange(flipped_by_click, false) || !ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    const auto edge = edge_under(at, ui.theme().scale());
    if (edge && state.document().may_flip(*edge)) {
      state.flip_edge(*edge);
      flipped_by_click = true;
      hovered.reset();
      return;
    }
  }
  state.selected_point.reset();
  state.selected_panel.reset();
  if (!shown) return;
  const render::PolygonLayer& layer = panel_layer;
  for (const IllDetermined& point : shown->ill_determined) {
    const glm::vec2 pixel = camera.project(shown->points.row(point.point).transpose());
    if (glm::distance(pixel, to_picture(at)) <= kEdgeReach * ui.theme().scale() * pixel_ratio) {
      state.selected_point = point.point;
      return;
    }
  }
  if (const auto hit = render::pick_polygon(layer, camera.ray(to_picture(at))))
    state.selected_panel = hit->polygon;
}

void Viewport::Impl::picture(Ui& ui, AppState& state) {
  const bool coarse = moving && full_ms > kSlowPicture;
  // The small things come when the picture stands still.
  const bool fine = !moving && !state.solving();
  if (fine && !fine_picture) dirty = true;
  const int divisor = coarse ? 2 : 1;
  const int width = std::max(1, camera.width() / divisor), height = std::max(1, camera.height() / divisor);
  if (target.resize(width, height)) dirty = true;
  coarse_picture = coarse;
  redrawn = false;
  if (!dirty) return;
  dirty = false;
  redrawn = true;
  fine_picture = fine;

  const Stopwatch watch;
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
  render::Viewport view;
  view.width = width;
  view.height = height;
  view.pixel_scale = ui.theme().scale() * pixel_ratio / static_cast<float>(divisor);
  view.fine = fine;
  render::Theme look;
  look.dark = dark;
  renderer.draw(camera, view, look, state.view_options.ghost || !shown);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  if (!coarse && moving) glFinish();  // only while moving: to know whether coarse is worth it
  if (!coarse) full_ms = watch.milliseconds();
}

}  // namespace planewright::ui
