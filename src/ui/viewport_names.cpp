// Names of the panels, written over those that are in sight and large enough.
#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/viewport_impl.h"
#include "ui/viewport_overlays.h"

namespace planewright::ui {
namespace {

// The text with a rim of the panels' colour, to be read on whatever colours they have.
void draw_rimmed(ImDrawList& draw, ImFont* font, ImVec2 at, ImU32 ink, ImU32 rim, const std::string& text) {
  for (const auto& [x, y] : {std::pair{-1.0f, 0.0f}, {1.0f, 0.0f}, {0.0f, -1.0f}, {0.0f, 1.0f}})
    draw.AddText(font, font->FontSize, ImVec2(at.x + x, at.y + y), rim, text.c_str());
  draw.AddText(font, font->FontSize, at, ink, text.c_str());
}

}  // namespace

// Which panels can be seen takes longer than a frame may while the camera moves; those seen before do until
// it rests.
void Viewport::Impl::look_for_names() {
  const NamesSeen now{shown, camera.eye(), camera.forward(), camera.width(), camera.height()};
  const bool same_panels =
      names_seen.view && names_in_sight.size() == static_cast<std::size_t>(panel_layer.polygons.size());
  if (now == names_seen || (moving && same_panels)) return;
  names_seen = now;
  names_in_sight = render::polygons_in_sight(panel_layer, camera);
}

void Viewport::Impl::draw_names(Ui& ui, const AppState& state) {
  names_drawn = 0;
  if (!state.view_options.names || !shown || panel_layer.points.rows() == 0) return;
  const auto workshop = state.workshop();
  if (!workshop || workshop->model->panel_count() != panel_layer.polygons.size()) return;
  look_for_names();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  ImFont* font = ui.theme().small();
  const ImU32 rim = dark ? IM_COL32(217, 212, 201, 210) : IM_COL32(251, 248, 242, 210);
  const ImU32 ink = IM_COL32(40, 36, 31, 255), bad = IM_COL32(170, 30, 20, 255);
  draw.PushClipRect(place.min, place.max, true);
  for (int panel = 0; panel < panel_layer.polygons.size(); ++panel) {
    const auto index = static_cast<std::size_t>(panel);
    const auto corners = panel_layer.polygons[panel];
    if (corners.size() < 3 || names_in_sight[index] == 0) continue;
    const Vector3d middle = centroid(panel_layer.points, corners);
    if (camera.depth(middle) <= 0) continue;
    ImVec2 low(FLT_MAX, FLT_MAX), high(-FLT_MAX, -FLT_MAX);
    for (const int corner : corners) {
      const ImVec2 at = to_window(camera.project(panel_layer.points.row(corner).transpose()));
      low = ImVec2(std::min(low.x, at.x), std::min(low.y, at.y));
      high = ImVec2(std::max(high.x, at.x), std::max(high.y, at.y));
    }
    // A polygon fills about two thirds of its box, and the name shall not touch its sides.
    const std::string& name = workshop->model->names[index];
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, name.c_str());
    if (high.x - low.x < 1.5f * size.x || high.y - low.y < 1.35f * size.y) continue;
    const ImVec2 at = to_window(camera.project(middle));
    draw_rimmed(draw, font, ImVec2(std::round(at.x - 0.5f * size.x), std::round(at.y - 0.5f * size.y)),
                workshop->verdicts.pass[index] || colours == ColourMap::Tolerances ? ink : bad, rim, name);
    ++names_drawn;
  }
  draw.PopClipRect();
  if (names_drawn == 0) draw_tool_hint(ui, place, "Names stand on panels that are large enough: zoom in.");
}

}  // namespace planewright::ui
