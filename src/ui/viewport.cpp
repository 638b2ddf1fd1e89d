#include "ui/viewport.h"

#include <epoxy/gl.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>

#include "ui/format.h"
#include "ui/viewport_impl.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

constexpr double kFlightSeconds = 0.35;
constexpr double kSlowPicture = 28;  // milliseconds above which a moving picture is drawn coarser

render::ColourScale colour_scale(const AppState& state) {
  render::ColourScale scale;
  scale.low = 0;
  scale.high = state.colour_range();
  if (state.view_options.colours == ColourMap::Findings) {
    scale.quantity = "Findings";
    scale.map = render::ColourScale::Map::Severity;
    return scale;
  }
  if (state.view_options.colours == ColourMap::Tolerances) {
    const auto kind = state.view_options.tolerance;
    scale.quantity = kind ? capitalised(std::string(tolerance_name(*kind))) : "Tolerances";
    scale.map = render::ColourScale::Map::Verdict;
    scale.tolerance = 1.0;
    return scale;
  }
  scale.unit = state.unit();
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
  return !a || (a->low == b->low && a->high == b->high && a->quantity == b->quantity && a->map == b->map &&
                a->unit == b->unit && a->tolerance == b->tolerance);
}

}  // namespace

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
int Viewport::names_drawn() const {
  return impl_->names_drawn;
}
bool Viewport::take_redrawn() {
  return std::exchange(impl_->redrawn, false);
}

// --- Upload ----------------------------------------------------------------------------------

void Viewport::upload(AppState& state, bool dark) {
  Impl& v = *impl_;
  const Stopwatch watch;
  bool streamed = false;

  const bool new_mesh = v.mesh != state.mesh_view();
  const Layer& active = state.document().design().layers[static_cast<std::size_t>(state.active_layer())];
  const auto view = active.visible ? state.shown() : nullptr;
  const bool new_view = v.shown != view;
  const auto coloured =
      state.view_options.colours == ColourMap::Findings && view ? state.findings() : nullptr;
  const auto judged =
      state.view_options.colours == ColourMap::Tolerances && view ? state.workshop() : nullptr;
  const bool new_colours = v.colours != state.view_options.colours || v.coloured != coloured ||
                           v.coloured_hidden != state.view_options.hidden_findings || v.judged != judged ||
                           v.judged_kind != state.view_options.tolerance;
  v.colours = state.view_options.colours;
  v.coloured = coloured;
  v.judged = judged;
  v.judged_kind = state.view_options.tolerance;
  v.coloured_hidden = state.view_options.hidden_findings;

  if (new_mesh) {
    v.mesh = state.mesh_view();
    v.occluder = {};
    if (v.mesh) {
      v.occluder.points = v.mesh->points;
      v.occluder.polygons = v.mesh->faces;
    }
    v.hover_probe = {-1, -1};
    v.dirty = true;
  }
  if (v.drawn_ghost != state.ghost()) {
    v.drawn_ghost = state.ghost();
    v.renderer.set_ghost(
        v.drawn_ghost ? std::shared_ptr<const render::GhostArrays>(v.drawn_ghost, &v.drawn_ghost->arrays)
                      : nullptr);
    v.dirty = streamed = true;
  }
  if (new_view) {
    v.show(view);
    streamed = true;
  } else if (new_colours && v.shown) {
    const auto [per_panel, per_point] = v.values();
    v.renderer.set_panel_values(per_panel, per_point);
  }
  if (new_mesh || new_view || new_colours)
    v.marks_stale = v.pane_dirty[static_cast<int>(Pane::Panels)] = true;

  std::optional<render::ColourScale> scale;
  if (v.shown && v.colours != ColourMap::None && (v.colours != ColourMap::Findings || v.coloured) &&
      (v.colours != ColourMap::Tolerances || v.judged)) {
    scale = colour_scale(state);
  }
  if (!same(scale, v.scale)) {
    v.scale = scale;
    v.renderer.set_colours(scale);
    v.pane_dirty[static_cast<int>(Pane::Panels)] = true;
  }
  if (v.dark != dark || v.ghost != state.view_options.ghost) {
    v.dark = dark;
    v.ghost = state.view_options.ghost;
    v.dirty = true;
  }
  v.upload_surfaces(state);
  v.upload_marks(state);
  v.upload_regions(state);
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

// The other layers, the back of thick panels, and beams.
void Viewport::Impl::upload_surfaces(const AppState& state) {
  using render::Tone;
  std::vector<render::Surface> wanted;
  const auto add = [&](Tone tone, const auto& owner, const render::PanelArrays& arrays) {
    if (arrays.geometry && arrays.geometry->vertex_count() > 0) {
      wanted.push_back({tone, std::shared_ptr<const render::PanelArrays>(owner, &arrays)});
    }
  };
  const auto& layers = state.document().design().layers;
  for (int i = 0; i < state.layer_count() && !state.document().empty(); ++i) {
    const auto& view = state.shown(i);
    if (!layers[static_cast<std::size_t>(i)].visible || !view) continue;
    const bool active = i == state.active_layer();
    if (!active) add(Tone::OtherLayer, view, view->panels);
    if (view->thickness) {
      add(active ? Tone::Back : Tone::OtherLayer, view, view->thickness->back);
      add(Tone::Beam, view, view->thickness->sides.arrays);
    }
    if (view->beams) add(Tone::Beam, view, view->beams->arrays);
  }
  const bool same =
      std::equal(wanted.begin(), wanted.end(), surfaces.begin(), surfaces.end(),
                 [](const auto& a, const auto& b) { return a.tone == b.tone && a.arrays == b.arrays; });
  if (same) return;
  surfaces = std::move(wanted);
  renderer.set_surfaces(surfaces);
  dirty = true;
}

// --- Camera ----------------------------------------------------------------------------------

void Viewport::fit(const AppState& state) {
  if (!state.mesh_view()) return;
  Vector3d low = state.mesh_view()->low, high = state.mesh_view()->high;
  // The panels may stand off the design, but a point thrown far away must not shrink the view to nothing.
  const auto& layers = state.document().design().layers;
  for (int i = 0; i < state.layer_count(); ++i) {
    const auto& view = state.shown(i);
    if (!layers[static_cast<std::size_t>(i)].visible || !view || !view->points.allFinite()) continue;
    const Vector3d reach = 0.5 * (high - low).norm() * Vector3d::Ones();
    low = low.cwiseMin(view->low.cwiseMax(low - reach));
    high = high.cwiseMax(view->high.cwiseMin(high + reach));
  }
  impl_->flight.reset();
  impl_->camera.fit(low, high);
  impl_->framed = true;
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

// Seen at a slant, what is to be looked at turns its outside to the camera, which stays above the ground;
// unless it cannot be seen from there.
void Viewport::Impl::turn_to_face(const LookAt& wish) {
  constexpr double kSlant = 0.35;  // sine of the angle between the view and the surface
  if (wish.outside.isZero() || wish.outside.dot((camera.eye() - wish.point).normalized()) > kSlant) return;
  render::Camera turned = camera;
  const bool upright = std::hypot(wish.outside.x(), wish.outside.y()) > 1e-3;
  const Vector3d back = upright ? wish.outside : Vector3d(-camera.forward());
  turned.set_direction(std::atan2(back.y(), back.x()),
                       std::clamp(std::asin(std::clamp(wish.outside.z(), -1.0, 1.0)), 0.2, 1.2));
  if (turned.depth(wish.point) <= 0) return;
  turned.pan(middle() - turned.project(wish.point), wish.point);
  if (in_sight(turned, wish.point)) camera = turned;
}

void Viewport::look_at(const LookAt& wish) {
  Impl& v = *impl_;
  const Vector3d& scene_point = wish.point;
  const double radius = wish.radius;
  if (v.flight) v.camera = v.flight->to;
  const render::Camera from = v.camera;
  v.turn_to_face(wish);
  v.turn_towards(scene_point);
  v.camera.pan(v.middle() - v.camera.project(scene_point), scene_point);
  const double shown_radius = 0.5 * v.camera.height() * v.camera.pixel_size_at(scene_point);
  if (radius > 0 && shown_radius > 0) v.camera.zoom(shown_radius / radius, scene_point);
  v.flight = Impl::Flight{from, v.camera, Clock::now()};
  v.framed = false;
  v.camera = from;
  v.dirty = true;
}

bool Viewport::flying() const {
  return impl_->flight.has_value();
}

void Viewport::Impl::fly() {
  if (!flight) return;
  const double seconds = std::chrono::duration<double>(Clock::now() - flight->begin).count();
  const double t = std::min(seconds / kFlightSeconds, 1.0);
  flight->to.set_viewport(camera.width(), camera.height());
  camera = render::Camera::between(flight->from, flight->to, t * t * (3 - 2 * t));
  if (t >= 1.0) flight.reset();
  moving = flight.has_value();
  hover_probe = {-1, -1};
  dirty = true;
}

std::optional<EditTarget> Viewport::take_context_request() {
  return std::exchange(impl_->context_request, std::nullopt);
}

std::optional<ImVec2> Viewport::clickable_place_of_edge(const AppState& state, int edge) const {
  const Impl& v = *impl_;
  const Impl::PaneScope scope(*impl_, Pane::Panels);
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

std::optional<ImVec2> Viewport::clickable_place_of_panel(const AppState& state, int panel) const {
  const Impl& v = *impl_;
  const Impl::PaneScope scope(*impl_, Pane::Panels);
  if (!v.shown || panel < 0 || panel >= v.panel_layer.polygons.size()) return std::nullopt;
  const auto corners = v.panel_layer.polygons[panel];
  if (corners.empty()) return std::nullopt;
  const Vector3d middle = centroid(v.shown->points, corners);
  // The middle, or a place beside it where no pin, corner or edge is in the way.
  for (const double part : {0.0, 0.3, 0.5}) {
    for (const int corner : corners) {
      const Vector3d at = middle + part * (v.shown->points.row(corner).transpose() - middle);
      if (v.camera.depth(at) <= 0) continue;
      const ImVec2 exact = v.to_window(v.camera.project(at));
      const ImVec2 whole(std::round(exact.x), std::round(exact.y));
      if (!v.place.contains(whole) || v.edge_under(whole, 1.0f) || v.corner_under(whole, 1.0f) ||
          v.pin_under(state, whole, 1.0f)) {
        continue;
      }
      const auto hit = render::pick_polygon(v.panel_layer, v.camera.ray(v.to_picture(whole)));
      if (hit && hit->polygon == panel) return whole;
    }
  }
  return std::nullopt;
}

std::optional<ImVec2> Viewport::clickable_place_of_corner(const AppState& state, int point) const {
  const Impl& v = *impl_;
  const Impl::PaneScope scope(*impl_, Pane::Panels);
  if (!v.shown || point < 0 || point >= v.shown->points.rows()) return std::nullopt;
  const Vector3d at = v.shown->points.row(point).transpose();
  if (v.camera.depth(at) <= 0) return std::nullopt;
  const ImVec2 exact = v.to_window(v.camera.project(at));
  const ImVec2 whole(std::round(exact.x), std::round(exact.y));
  if (!v.place.contains(whole) || v.pin_under(state, whole, 1.0f)) return std::nullopt;
  const auto hit = v.corner_under(whole, 1.0f);
  return hit && *hit == point ? std::optional(whole) : std::nullopt;
}

std::optional<ImVec2> Viewport::place_of_pin(const AppState& state, int pin) const {
  const auto& pins = state.document().settings().demands.pins;
  if (pin < 0 || pin >= static_cast<int>(pins.size())) return std::nullopt;
  const auto at = state.pin_place(pins[static_cast<std::size_t>(pin)]);
  if (!at) return std::nullopt;
  const Impl::PaneScope scope(*impl_, Pane::Panels);
  const ImVec2 exact = impl_->to_window(impl_->camera.project(*at));
  const ImVec2 whole(std::round(exact.x), std::round(exact.y));
  const auto hit = impl_->pin_under(state, whole, 1.0f);
  return hit && *hit == pin ? std::optional(whole) : std::nullopt;
}

// --- The frame -------------------------------------------------------------------------------

void Viewport::draw(Ui& ui, AppState& state, const Rect& place) {
  Impl& v = *impl_;
  const float ratio = ImGui::GetIO().DisplayFramebufferScale.x;
  if (v.arrange(place, state.cluster_sight(), ratio > 0 ? ratio : 1.0f) && v.framed) fit(state);

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
  v.fly();
  v.upload_marks(state);

  const Stopwatch watch;
  v.picture(ui, state);
  if (v.redrawn) state.timings.scene.add(watch.milliseconds());
  for (const Pane pane : {Pane::Regions, Pane::Panels}) {
    if (!v.shows(pane)) continue;
    const Rect rect = v.rect_of(pane);
    ImGui::GetWindowDrawList()->AddImage(v.targets[static_cast<int>(pane)].texture(), rect.min, rect.max,
                                         ImVec2(0, 1), ImVec2(1, 0));
  }
  v.draw_panes(ui, state);
  if (v.shows(Pane::Panels)) {
    const Impl::PaneScope scope(v, Pane::Panels);
    v.draw_suggestions(ui, state);
    v.draw_names(ui, state);
    if (v.scale && v.shown) draw_legend(ui, v.place, *v.scale, v.colours);
  }
  draw_axes(ui, v.whole, v.camera);
  if (v.boxing && v.dragging) v.draw_box(ui, ImGui::GetIO().MousePos);
  if (state.tool == Tool::Box) draw_tool_hint(ui, v.rect_of(Pane::Panels), box_hint(state));
  if (changes_regions(state.tool)) draw_tool_hint(ui, v.rect_of(Pane::Regions), Impl::region_hint(state));
  ImGui::End();
}

// Where the panes are, and the camera's picture, which has the size of one. What fills the picture goes on to
// fill it when there are two panes instead of one, or the other way round.
bool Viewport::Impl::arrange(const Rect& all, ClusterSight how, float ratio) {
  const bool panes_change = (sight == ClusterSight::Beside) != (how == ClusterSight::Beside);
  if (sight != how) dirty = true;
  whole = all;
  sight = how;
  pixel_ratio = ratio;
  if (!pressed) pane = pane_at(ImGui::GetIO().MousePos);
  if (!shows(pane)) pane = pane_at(whole.min);
  enter(pane);
  const int width = std::max(1, static_cast<int>(place.width() * pixel_ratio));
  const int height = std::max(1, static_cast<int>(place.height() * pixel_ratio));
  if (camera.width() == width && camera.height() == height) return panes_change;
  const double before = std::min(camera.width(), camera.height()), after = std::min(width, height);
  camera.set_viewport(width, height);
  if (panes_change && before > 1) camera.zoom(after / before, camera.target());
  dirty = true;
  return panes_change;
}

void Viewport::Impl::picture(Ui& ui, AppState& state) {
  const bool coarse = moving && full_ms > kSlowPicture;
  // The small things come when the picture stands still.
  const bool fine = !moving && (!state.solving() || state.polishing());
  if (fine && !fine_picture) pane_dirty[static_cast<int>(Pane::Panels)] = true;
  const int divisor = coarse ? 2 : 1;
  const int width = std::max(1, camera.width() / divisor), height = std::max(1, camera.height() / divisor);
  coarse_picture = coarse;
  redrawn = false;
  const Stopwatch watch;
  if (sight == ClusterSight::Over && std::exchange(pane_dirty[static_cast<int>(Pane::Panels)], false))
    pane_dirty[static_cast<int>(Pane::Regions)] = true;
  for (const Pane each : {Pane::Regions, Pane::Panels}) {
    if (!shows(each)) continue;
    RenderTarget& target = targets[static_cast<int>(each)];
    bool& stale = pane_dirty[static_cast<int>(each)];
    if (!target.resize(width, height) && !dirty && !stale) continue;
    stale = false;
    redrawn = true;
    if (each == Pane::Panels || sight == ClusterSight::Over) fine_picture = fine;
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
    render::Viewport view;
    view.width = width;
    view.height = height;
    view.pixel_scale = ui.theme().scale() * pixel_ratio / static_cast<float>(divisor);
    view.fine = fine;
    render::Theme look;
    look.dark = dark;
    using What = render::Renderer::What;
    const What what = each == Pane::Panels                   ? What::Panels
                      : sight == ClusterSight::Over && shown ? What::Over
                                                             : What::Regions;
    renderer.draw(camera, view, look, state.view_options.ghost || (each == Pane::Panels && !shown), what);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
  }
  dirty = false;
  if (!redrawn) return;
  if (!coarse && moving) glFinish();  // only while moving: to know whether coarse is worth it
  if (!coarse) full_ms = watch.milliseconds();
}

}  // namespace planewright::ui
