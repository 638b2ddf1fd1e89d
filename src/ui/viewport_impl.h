// Viewport::Impl: what the viewport holds between frames and how it finds what is under the mouse. Internal
// to viewport.cpp (uploading, camera, drawing), viewport_marks.cpp (marks), viewport_findings.cpp (what is
// bad, and edges to click), viewport_suggestions.cpp (ghosts of edits), viewport_regions.cpp (the input in
// its regions' colours, and the tools that change them) and viewport_mouse.cpp (what the mouse does).
// Threads: the window's.
#pragma once

#include <imgui_internal.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/workshop/tolerance_share.h"
#include "ui/render/picking.h"
#include "ui/render_target.h"
#include "ui/viewport.h"

namespace planewright::ui {

inline constexpr float kEdgeReach = 7;    // pixels at scale 1 within which an edge is hit
inline constexpr float kCornerReach = 7;  // likewise a corner, but not more than this part of a panel's edge:
inline constexpr float kCornerPart = 0.2f;
inline constexpr float kPinReach = 9;
inline constexpr float kVertexReach = 14;  // of a menu, which lists what is near beside each other
inline constexpr float kBrushRadius = 10;  // pixels at scale 1
inline constexpr float kFlaggedReach = 9;  // of an edge that a finding flags, which goes before others
// Ends of an edge belong to the panels that meet there; only the middle of it flips.
inline constexpr float kEdgeEnds = 0.2f;

// Where on a segment of the screen the nearest place to a pixel is, 0..1, and how far away.
struct OnSegment {
  float t, pixels;
};
inline OnSegment nearest_on_segment(glm::vec2 a, glm::vec2 b, glm::vec2 pixel) {
  const glm::vec2 along = b - a;
  const float squared = glm::dot(along, along);
  const float t = squared > 0 ? std::clamp(glm::dot(pixel - a, along) / squared, 0.0f, 1.0f) : 0.0f;
  return {t, glm::distance(a + t * along, pixel)};
}

// Side by side the viewport has two panes of the same size, which one camera looks into.
enum class Pane { Regions, Panels };

// The face of the input under the mouse, and the one across the border between two regions, if one was hit;
// -1: nothing.
struct RegionHover {
  int face = -1, other = -1;
  bool operator==(const RegionHover&) const = default;
};

struct Viewport::Impl {
  explicit Impl(render::Renderer r) : renderer(std::move(r)) {}

  render::Renderer renderer;
  render::Camera camera;
  RenderTarget targets[2];  // by Pane
  Rect whole{};             // on the window
  ClusterSight sight = ClusterSight::Panels;
  Pane pane = Pane::Panels;  // that the mouse is over, or was pressed in
  Rect place{};              // that pane's, on the window
  float pixel_ratio = 1;     // framebuffer pixels per window pixel

  // What the renderer holds.
  std::shared_ptr<const MeshView> mesh;
  std::shared_ptr<const PreparedView> shown;
  std::shared_ptr<const PreparedGhost> drawn_ghost;
  render::PolygonLayer occluder;     // the ghost's faces, for picking
  render::PolygonLayer panel_layer;  // the panels as shown, for picking
  ColourMap colours = ColourMap::None;
  std::optional<render::ColourScale> scale;
  bool dark = false, ghost = true, markers = true;
  // What the marks were made for.
  struct Marked {
    std::optional<int> point, panel, edge, hovered_edge, hovered_corner;
    std::uint64_t selection = 0, revision = 0;
    int layer = 0;
    std::shared_ptr<const PreparedFindings> findings;
    HiddenFindings hidden;
    std::optional<int> finding;
    bool operator==(const Marked&) const = default;
  };
  Marked marked;
  std::shared_ptr<const PreparedFindings> coloured;  // whose severities the panels have
  HiddenFindings coloured_hidden;                    // without these
  std::shared_ptr<const PreparedWorkshop> judged;    // whose shares of their limits the panels have
  std::optional<ToleranceKind> judged_kind;          // of this one; none: of all
  // The flagged edges that are drawn, as indices into mesh->edges and as their ends.
  std::vector<int> flagged;
  std::vector<std::pair<int, int>> flagged_ends;
  std::vector<render::Surface> surfaces;
  bool marks_stale = true;
  std::uint64_t fitted = 0;

  bool dirty = true, coarse_picture = false, fine_picture = false, redrawn = false;
  bool pane_dirty[2] = {false, false};  // by Pane: that one alone is to be drawn anew
  bool moving = false;                  // the camera, in this frame
  struct Flight {
    render::Camera from, to;
    Clock::time_point begin;
  };
  std::optional<Flight> flight;
  bool framed = false;  // the whole model is in the picture, as fit() shows it; it may be turned
  double full_ms = 0;   // what a full picture took lately

  // The mouse.
  std::optional<int> hovered, hovered_corner, hovered_pin;
  std::optional<int> dragged_pin;
  Vector3d pin_from = Vector3d::Zero();  // where it was taken up
  bool left_press = false, boxing = false;
  bool pressed = false, dragging = false, pans = false, flipped_by_click = false;
  ImVec2 press_at{}, last_at{};
  Vector3d pivot = Vector3d::Zero();
  glm::vec2 hover_probe{-1, -1};
  std::shared_ptr<const EditPreview> previewed;  // of the edit whose ghost is shown
  bool right_press = false;
  std::optional<EditTarget> context_request;

  // Names of the panels: which panels could be seen, and from where that was found out.
  struct NamesSeen {
    std::shared_ptr<const PreparedView> view;
    Vector3d eye = Vector3d::Zero(), forward = Vector3d::Zero();
    int width = 0, height = 0;
    bool operator==(const NamesSeen&) const = default;
  };
  NamesSeen names_seen;
  std::vector<char> names_in_sight;  // #panels
  int names_drawn = 0;               // in the newest frame

  // Regions, as the renderer holds them.
  std::shared_ptr<const RegionView> regions;
  std::vector<std::pair<int, int>> border_ends;   // of mesh edges between two regions
  std::vector<std::pair<int, int>> border_faces;  // beside each
  std::vector<int> regions_marked;                // that are shown as selected
  RegionHover region_hover, region_hover_marked;
  bool region_marks_stale = true;
  Tool tool_marked = Tool::Look;
  bool painting = false;

  glm::vec2 to_picture(ImVec2 window) const {
    return {(window.x - place.min.x) * pixel_ratio, (window.y - place.min.y) * pixel_ratio};
  }
  glm::vec2 middle() const {
    return {0.5f * static_cast<float>(camera.width()), 0.5f * static_cast<float>(camera.height())};
  }
  ImVec2 to_window(glm::vec2 picture) const {
    return {place.min.x + picture.x / pixel_ratio, place.min.y + picture.y / pixel_ratio};
  }

  Rect rect_of(Pane of) const {
    if (sight != ClusterSight::Beside) return whole;
    const float middle_x = std::round(0.5f * (whole.min.x + whole.max.x));
    return of == Pane::Regions ? Rect{whole.min, {middle_x, whole.max.y}}
                               : Rect{{middle_x, whole.min.y}, whole.max};
  }
  bool shows(Pane of) const {
    return sight == ClusterSight::Beside || (of == Pane::Panels) == (sight == ClusterSight::Panels);
  }
  Pane pane_at(ImVec2 window) const {
    if (sight == ClusterSight::Beside)
      return rect_of(Pane::Regions).contains(window) ? Pane::Regions : Pane::Panels;
    return sight == ClusterSight::Panels ? Pane::Panels : Pane::Regions;
  }
  void enter(Pane of) {
    pane = of;
    place = rect_of(of);
  }
  // For as long as it lives, places of the window are of that pane.
  class PaneScope {
   public:
    PaneScope(Impl& impl, Pane pane) : impl_(impl), before_(impl.pane) { impl_.enter(pane); }
    ~PaneScope() { impl_.enter(before_); }
    PaneScope(const PaneScope&) = delete;
    PaneScope& operator=(const PaneScope&) = delete;

   private:
    Impl& impl_;
    Pane before_;
  };
  bool any_dirty() const { return dirty || pane_dirty[0] || pane_dirty[1]; }

  const render::PolygonLayer* pick_layer() const {
    if (pane == Pane::Regions) return mesh ? &occluder : nullptr;
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
    const auto pick = [&](const std::vector<std::pair<int, int>>& edges, float reach) {
      return render::pick_edge(mesh->points, edges, camera, to_picture(window),
                               reach * scale_factor * pixel_ratio, &occluder);
    };
    auto edge = pick(flagged_ends, kFlaggedReach);
    edge = edge ? std::optional(flagged[static_cast<std::size_t>(*edge)]) : pick(mesh->edges, kEdgeReach);
    if (!edge) return edge;
    const float t = edge_place(*edge, window).t;
    return t >= kEdgeEnds && t <= 1 - kEdgeEnds ? edge : std::nullopt;
  }
  OnSegment edge_place(int edge, ImVec2 window) const {
    const auto [a, b] = mesh->edges[static_cast<std::size_t>(edge)];
    return nearest_on_segment(camera.project(mesh->points.row(a).transpose()),
                              camera.project(mesh->points.row(b).transpose()), to_picture(window));
  }
  std::optional<int> corner_under(ImVec2 window, float scale_factor) const {
    if (!shown) return std::nullopt;
    const glm::vec2 pixel = to_picture(window);
    const auto point = render::pick_point(shown->points, camera, pixel,
                                          kCornerReach * scale_factor * pixel_ratio, &panel_layer);
    if (!point) return point;
    const Vector3d at = shown->points.row(*point).transpose();
    const auto reach =
        kCornerPart * static_cast<float>(shown->complex().mean_edge / camera.pixel_size_at(at));
    return glm::distance(camera.project(at), pixel) <= reach ? point : std::nullopt;
  }
  std::optional<int> pin_under(const AppState& state, ImVec2 window, float scale_factor) const {
    if (!shown) return std::nullopt;
    const auto& pins = state.document().settings().demands.pins;
    std::optional<int> best;
    float nearest = kPinReach * scale_factor * pixel_ratio;
    for (std::size_t i = 0; i < pins.size(); ++i) {
      const auto held = state.pin_place(pins[i]);
      if (!held || camera.depth(*held) <= 0) continue;
      const float away = glm::distance(camera.project(*held), to_picture(window));
      if (away > nearest || !in_sight(camera, *held)) continue;
      nearest = away;
      best = static_cast<int>(i);
    }
    return best;
  }

  // Whether there are more or fewer panes than before.
  bool arrange(const Rect& all, ClusterSight how, float ratio);
  void show(std::shared_ptr<const PreparedView> view);
  // Per panel and per point; what the colours do not ask for, or is not known yet, is empty.
  std::pair<Vector, Vector> values() const {
    if (colours == ColourMap::Findings && coloured) {
      return {panel_severity(shown->complex(), coloured->diagnosis.findings, coloured_hidden), Vector()};
    }
    if (colours == ColourMap::Tolerances && judged) {
      return {
          tolerance_shares(judged->passports, judged->verdicts, judged->job.contract.tolerances, judged_kind),
          Vector()};
    }
    if (colours == ColourMap::Planarity) return {shown->planarity.per_panel, Vector()};
    if (colours == ColourMap::Displacement) return {Vector(), shown->displacement.per_point};
    return {};
  }

  bool in_sight(const render::Camera& from, const Vector3d& point) const;
  void turn_towards(const Vector3d& point);
  void turn_to_face(const LookAt& wish);
  void upload_marks(const AppState& state);
  void take_flagged(const AppState& state);
  void mark_findings(const AppState& state, std::vector<render::Marker>& marks,
                     std::vector<render::Segment>& segments) const;
  void explain_edge(Ui& ui, const AppState& state, int edge) const;
  std::optional<MeshEdit> edit_pointed_at(const AppState& state) const;
  void draw_edit(Ui& ui, const AppState& state, const MeshEdit& edit, const EditPreview* known) const;
  bool edit_in_sight(const AppState& state, const Vector3d& at) const;
  void ring_edit(Ui& ui, const AppState& state, const MeshEdit& edit) const;
  void draw_suggestions(Ui& ui, AppState& state);
  void look_for_names();
  void draw_names(Ui& ui, const AppState& state);
  void explain_gain(Ui& ui, const AppState& state, int edge, bool may_flip) const;

  std::optional<int> edge_of_corner(const AppState& state, std::optional<int> corner) const;
  std::optional<int> finding_under(const AppState& state, ImVec2 at, float reach) const;
  void fly();
  EditTarget target_under(ImVec2 at, float scale_factor) const;
  void mouse(Ui& ui, AppState& state, bool hovered_now);
  void hover(Ui& ui, const AppState& state, ImVec2 at);
  void explain_hovered(Ui& ui, const AppState& state) const;
  void drag_pin(AppState& state, ImVec2 at);
  void click(Ui& ui, AppState& state, ImVec2 at);
  void click_loop(AppState& state, ImVec2 at, Combine how);
  void select_box(AppState& state, ImVec2 from, ImVec2 to) const;
  void draw_box(const Ui& ui, ImVec2 at) const;
  void upload_surfaces(const AppState& state);
  void picture(Ui& ui, AppState& state);

  void upload_regions(const AppState& state);
  void upload_region_marks(const AppState& state);
  RegionHover region_under(const AppState& state, ImVec2 at, float scale_factor) const;
  std::vector<int> faces_in_brush(ImVec2 at, float radius) const;
  // Whether a stroke has begun.
  bool begin_painting(AppState& state, ImVec2 at, float scale_factor);
  void paint(AppState& state, ImVec2 from, ImVec2 to, float scale_factor) const;
  void click_region(AppState& state, ImVec2 at, Combine how, float scale_factor);
  void explain_region(Ui& ui, const AppState& state) const;
  static std::string region_hint(const AppState& state);
  void draw_panes(Ui& ui, const AppState& state) const;
};

}  // namespace planewright::ui
