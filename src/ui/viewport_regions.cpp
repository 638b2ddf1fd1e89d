// The input in its regions' colours: what is marked on it, what the mouse is over, and the tools that split,
// merge and paint regions.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "ui/format.h"
#include "ui/viewport_impl.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

constexpr float kBorderReach = 8;   // pixels at scale 1 within which a border between two regions is hit
constexpr float kBrushStep = 0.8f;  // of the radius, between two places of a stroke

// Ascending.
std::vector<int> faces_of(const RegionView& view, const std::vector<int>& regions) {
  std::vector<int> faces;
  const std::vector<int>& region_of_face = view.clusters->regions.region_of_face;
  for (std::size_t f = 0; f < region_of_face.size(); ++f) {
    if (std::binary_search(regions.begin(), regions.end(), region_of_face[f]))
      faces.push_back(static_cast<int>(f));
  }
  return faces;
}

}  // namespace

void Viewport::Impl::upload_regions(const AppState& state) {
  if (regions != state.region_view()) {
    regions = state.region_view();
    renderer.set_regions(regions ? std::shared_ptr<const render::RegionArrays>(regions, &regions->arrays)
                                 : nullptr);
    border_ends.clear();
    border_faces.clear();
    if (regions) {
      const FaceGraph& graph = *regions->clusters->graph;
      const std::vector<int>& region_of_face = regions->clusters->regions.region_of_face;
      for (int c = 0; c < static_cast<int>(graph.beside.size()); ++c) {
        const int f = graph.face_of_corner[c], g = graph.beside[c];
        if (g < f || region_of_face[f] == region_of_face[g]) continue;  // each once; -1 beyond the border
        border_ends.emplace_back(graph.tail(c), graph.head(c));
        border_faces.emplace_back(f, g);
      }
    }
    region_hover = {};
    hover_probe = {-1, -1};
    region_marks_stale = pane_dirty[static_cast<int>(Pane::Regions)] = true;
  }
  upload_region_marks(state);
}

void Viewport::Impl::upload_region_marks(const AppState& state) {
  if (!regions) return;
  // Numbers of newer regions mean nothing on older ones.
  static const std::vector<int> kNone;
  const std::vector<int>& selected = regions->clusters == state.clusters() ? state.selected_regions() : kNone;
  const bool same_selected = !region_marks_stale && selected == regions_marked;
  if (same_selected && region_hover == region_hover_marked && state.tool == tool_marked) return;
  std::vector<int> hovered_ones;
  const auto region_of = [&](int face) {
    return face < 0 ? -1 : regions->clusters->regions.region_of_face[static_cast<std::size_t>(face)];
  };
  for (const int region : {region_of(region_hover.face), region_of(region_hover.other)}) {
    if (region >= 0 && (hovered_ones.empty() || hovered_ones.front() != region))
      hovered_ones.push_back(region);
  }
  std::sort(hovered_ones.begin(), hovered_ones.end());
  const bool outlines_hovered = changes_regions(state.tool) && region_hover.other < 0;
  std::vector<Vector3d> outline;
  for (std::size_t i = 0; i < border_faces.size(); ++i) {
    const int a = region_of(border_faces[i].first), b = region_of(border_faces[i].second);
    const bool round_selected = std::binary_search(selected.begin(), selected.end(), a) !=
                                std::binary_search(selected.begin(), selected.end(), b);
    const bool pointed_at = region_hover.other >= 0 && hovered_ones.size() == 2 &&
                            std::min(a, b) == hovered_ones[0] && std::max(a, b) == hovered_ones[1];
    const bool round_hovered =
        outlines_hovered && std::binary_search(hovered_ones.begin(), hovered_ones.end(), a) !=
                                std::binary_search(hovered_ones.begin(), hovered_ones.end(), b);
    if (!round_selected && !pointed_at && !round_hovered) continue;
    outline.emplace_back(regions->mesh->points.row(border_ends[i].first).transpose());
    outline.emplace_back(regions->mesh->points.row(border_ends[i].second).transpose());
  }
  renderer.set_region_marks(render::triangles_of(regions->arrays.faces, faces_of(*regions, selected)),
                            outline,
                            render::triangles_of(regions->arrays.faces, faces_of(*regions, hovered_ones)));
  region_marks_stale = false;
  regions_marked = selected;
  tool_marked = state.tool;
  region_hover_marked = region_hover;
  pane_dirty[static_cast<int>(Pane::Regions)] = true;
}

RegionHover Viewport::Impl::region_under(const AppState& state, ImVec2 at, float scale_factor) const {
  RegionHover found;
  if (!regions || regions->mesh != mesh) return found;
  if (state.tool == Tool::Merge) {
    const auto piece = render::pick_edge(mesh->points, border_ends, camera, to_picture(at),
                                         kBorderReach * scale_factor * pixel_ratio, &occluder);
    if (piece) {
      const auto [face, other] = border_faces[static_cast<std::size_t>(*piece)];
      return {face, other};
    }
  }
  if (const auto hit = render::pick_polygon(occluder, camera.ray(to_picture(at)))) found.face = hit->polygon;
  return found;
}

// The face under the mouse, and those round it whose middles are within the radius on the screen.
std::vector<int> Viewport::Impl::faces_in_brush(ImVec2 at, float radius) const {
  std::vector<int> faces;
  if (!regions || regions->mesh != mesh) return faces;
  const glm::vec2 pixel = to_picture(at);
  const auto hit = render::pick_polygon(occluder, camera.ray(pixel));
  if (!hit) return faces;
  const FaceGraph& graph = *regions->clusters->graph;
  const auto middle_of = [&](int face) { return centroid(mesh->points, mesh->faces[face]); };
  faces.push_back(hit->polygon);
  for (std::size_t next = 0; next < faces.size(); ++next) {
    const int face = faces[next];
    for (int c = graph.faces.offsets()[face]; c < graph.faces.offsets()[face + 1]; ++c) {
      const int beside = graph.beside[c];
      if (beside < 0 || std::find(faces.begin(), faces.end(), beside) != faces.end()) continue;
      if (glm::distance(camera.project(middle_of(beside)), pixel) <= radius) faces.push_back(beside);
    }
  }
  return faces;
}

bool Viewport::Impl::begin_painting(AppState& state, ImVec2 at, float scale_factor) {
  if (state.tool != Tool::Paint || pane != Pane::Regions) return false;
  const RegionHover under = region_under(state, at, scale_factor);
  if (under.face < 0 || !state.clusters()) return false;
  state.begin_painting(under.face);
  return true;
}

void Viewport::Impl::paint(AppState& state, ImVec2 from, ImVec2 to, float scale_factor) const {
  const float radius = kBrushRadius * scale_factor * pixel_ratio;
  const float length = std::hypot(to.x - from.x, to.y - from.y) * pixel_ratio;
  const int steps = std::max(1, static_cast<int>(std::ceil(length / (kBrushStep * radius))));
  for (int i = 1; i <= steps; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(steps);
    state.paint(faces_in_brush({from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}, radius));
  }
}

void Viewport::Impl::click_region(AppState& state, ImVec2 at, Combine how, float scale_factor) {
  const RegionHover under = region_under(state, at, scale_factor);
  if (under.face < 0 || !state.clusters()) {
    if (how == Combine::Replace) state.clear_selection();
    return;
  }
  // By the faces: what is drawn may be older than what there is.
  const std::vector<int>& now = state.clusters()->regions.region_of_face;
  const int region = now[static_cast<std::size_t>(under.face)];
  if (state.tool == Tool::Split) {
    state.split_region(region);
  } else if (state.tool == Tool::Merge) {
    const std::vector<int> selected = state.selected_regions();
    if (under.other >= 0) {
      state.merge_regions(region, now[static_cast<std::size_t>(under.other)]);
    } else if (selected.size() == 1 && selected.front() != region) {
      state.merge_regions(selected.front(), region);
      state.clear_selection();
    } else {
      state.select_region(region, Combine::Replace);
    }
  } else if (state.tool == Tool::Look) {
    state.select_region(region, how);
  }
}

// --- Over the picture ------------------------------------------------------------------------

void Viewport::Impl::explain_region(Ui& ui, const AppState& state) const {
  if (region_hover.face < 0 || !regions || !changes_regions(state.tool)) return;
  const auto number = [&](int face) {
    return format_count(regions->clusters->regions.region_of_face[static_cast<std::size_t>(face)]);
  };
  const std::string region = "region " + number(region_hover.face);
  std::string text;
  if (state.tool == Tool::Split) {
    text = "Split " + region + " in two";
  } else if (state.tool == Tool::Paint) {
    text = "Drag: " + region + " spreads";
  } else if (region_hover.other >= 0) {
    text = "Merge regions " + number(region_hover.face) + " and " + number(region_hover.other);
  } else {
    const std::vector<int>& selected = state.selected_regions();
    const bool second = selected.size() == 1 && regions->clusters == state.clusters() &&
                        format_count(selected.front()) != number(region_hover.face);
    text = second ? "Merge region " + format_count(selected.front()) + " with " + region
                  : "Merge " + region + " with the next one clicked";
  }
  ui.tooltip(text);
}

std::string Viewport::Impl::region_hint(const AppState& state) {
  switch (state.tool) {
    case Tool::Split:
      return "Click a region: it becomes two  ·  Esc leaves";
    case Tool::Merge:
      return "Click a border, or a region and a neighbour  ·  Esc leaves";
    case Tool::Paint:
      return "Drag from a region over its neighbours  ·  Esc leaves";
    default:
      return "";
  }
}

// The line between the panes, what the left one shows, and the brush.
void Viewport::Impl::draw_panes(Ui& ui, const AppState& state) const {
  if (!shows(Pane::Regions)) return;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Palette& p = ui.colours();
  const Rect left = rect_of(Pane::Regions);
  if (sight == ClusterSight::Beside)
    draw.AddLine(ImVec2(left.max.x - 0.5f, left.min.y), ImVec2(left.max.x - 0.5f, left.max.y), p.line);
  if (sight == ClusterSight::Beside && regions) {
    const int count = regions->clusters->regions.count();
    const std::string text = "Input in " + format_count(count, "region", "regions");
    draw_label(ui, left, text, state.clustering());
  }
  if (state.tool == Tool::Paint && (painting || region_hover.face >= 0) && pane == Pane::Regions) {
    draw.AddCircle(ImGui::GetIO().MousePos, ui.px(kBrushRadius), p.accent, 32, ui.px(1.5f));
  }
}

// --- Where things are ------------------------------------------------------------------------

Rect Viewport::panels_place() const {
  return impl_->rect_of(impl_->shows(Pane::Panels) ? Pane::Panels : Pane::Regions);
}

std::optional<int> Viewport::hovered_region() const {
  const Impl& v = *impl_;
  if (v.region_hover.face < 0 || !v.regions) return std::nullopt;
  return v.regions->clusters->regions.region_of_face[static_cast<std::size_t>(v.region_hover.face)];
}

std::optional<ImVec2> Viewport::clickable_place_of_region(const AppState& state, int region) const {
  const Impl& v = *impl_;
  if (!v.shows(Pane::Regions) || !v.regions || v.regions->mesh != v.mesh) return std::nullopt;
  const Impl::PaneScope scope(*impl_, Pane::Regions);
  const std::vector<int> faces = faces_of(*v.regions, {region});
  Vector3d middle = Vector3d::Zero();
  for (const int f : faces)
    middle += centroid(v.mesh->points, v.mesh->faces[f]) / static_cast<double>(faces.size());
  std::optional<ImVec2> best;
  double nearest = 0;
  for (const int f : faces) {
    const Vector3d at = centroid(v.mesh->points, v.mesh->faces[f]);
    const double away = (at - middle).norm();
    if ((best && away >= nearest) || v.camera.depth(at) <= 0) continue;
    const ImVec2 exact = v.to_window(v.camera.project(at));
    const ImVec2 whole(std::round(exact.x), std::round(exact.y));
    const RegionHover under = v.place.contains(whole) ? v.region_under(state, whole, 1.0f) : RegionHover();
    if (under.face < 0 || under.other >= 0 || !std::binary_search(faces.begin(), faces.end(), under.face))
      continue;
    best = whole;
    nearest = away;
  }
  return best;
}

std::optional<ImVec2> Viewport::clickable_place_of_border(const AppState& state, int a, int b) const {
  const Impl& v = *impl_;
  if (!v.shows(Pane::Regions) || !v.regions || v.regions->mesh != v.mesh) return std::nullopt;
  const Impl::PaneScope scope(*impl_, Pane::Regions);
  const std::vector<int>& regions = v.regions->clusters->regions.region_of_face;
  const auto joins = [&](int f, int g) {
    const int one = regions[static_cast<std::size_t>(f)], two = regions[static_cast<std::size_t>(g)];
    return (one == a && two == b) || (one == b && two == a);
  };
  for (std::size_t i = 0; i < v.border_ends.size(); ++i) {
    if (!joins(v.border_faces[i].first, v.border_faces[i].second)) continue;
    const auto [from, to] = v.border_ends[i];
    const Vector3d at = 0.5 * (v.mesh->points.row(from) + v.mesh->points.row(to)).transpose();
    if (v.camera.depth(at) <= 0) continue;
    const ImVec2 exact = v.to_window(v.camera.project(at));
    const ImVec2 whole(std::round(exact.x), std::round(exact.y));
    if (!v.place.contains(whole)) continue;
    const RegionHover under = v.region_under(state, whole, 1.0f);
    if (under.other >= 0 && joins(under.face, under.other)) return whole;
  }
  return std::nullopt;
}

}  // namespace planewright::ui
