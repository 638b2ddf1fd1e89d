// Passes of the renderer for panels of clusters: the mesh in its regions' colours, panels as glass over it,
// and films that mark what is selected.
#include "ui/render/renderer_impl.h"

namespace planewright::render {
namespace {

constexpr float kSelectedTint = 0.30f;
constexpr float kHoveredTint = 0.20f;
constexpr float kRegionLine = 1.9f;        // pixels
constexpr float kRegionOutline = 3.2f;     // round what is selected
constexpr float kMeshOverRegions = 0.16f;  // strength of the mesh's own edges
constexpr float kGlass = 0.42f;            // opacity of panels over regions

}  // namespace

// The whole mesh in its regions' colours. Not fine: the corners of its triangles are no corners of regions.
void Renderer::Impl::draw_regions(const Frame& frame, const Theme& theme, bool with_mesh) const {
  const Palette& palette = palette_of(theme);
  begin_panels(frame, palette);
  const ShaderProgram& p = programs.panel;
  ColourScale entries;
  entries.high = kRegionColours;
  set_scale(p, map_scale(entries));
  p.set("coloured", 1);
  p.set("fine", 0);
  p.set("shade", 0.85f);
  p.set("line_width", kRegionLine * frame.pixel_scale);
  glBindTexture(GL_TEXTURE_2D, region_maps[theme.dark ? 1 : 0].get());
  begin_lying_back();
  regions.draw();
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindTexture(GL_TEXTURE_2D, 0);
  draw_film(frame, regions_selected, glm::vec4(palette.selected, kSelectedTint));
  draw_film(frame, regions_hovered, glm::vec4(palette.selected, kHoveredTint));
  const ShaderProgram& line = programs.line;
  if (with_mesh && !ghost_lines.empty()) {
    begin_lines(frame);
    line.set("line_width", kGhostLine * frame.pixel_scale);
    line.set("fade_below", 24.0f * frame.pixel_scale);
    line.set("lift_pixels", 0.5f * frame.pixel_scale);
    line.set("tint", glm::vec4(palette.edge, kMeshOverRegions));
    ghost_lines.draw();
  }
  if (!region_outline.empty()) {
    begin_lines(frame);
    line.set("lift_pixels", 2.0f * frame.pixel_scale);
    line.set("line_width", (kRegionOutline + 2.0f) * frame.pixel_scale);
    line.set("tint", glm::vec4(palette.outline, 0.75f));
    region_outline.draw();
    line.set("line_width", kRegionOutline * frame.pixel_scale);
    line.set("tint", glm::vec4(palette.selected, 1.0f));
    region_outline.draw();
  }
}

// The panels over all that is drawn; of panels behind each other the nearest alone.
void Renderer::Impl::draw_glass(const Frame& frame, const Palette& palette) const {
  if (panels.empty()) return;
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glClear(GL_DEPTH_BUFFER_BIT);
  begin_panels(frame, palette);
  const ShaderProgram& p = programs.panel;
  p.set("coloured", 0);
  p.set("opacity", kGlass);
  glBindTexture(GL_TEXTURE_2D, maps[0].get());
  begin_lying_back();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  panels.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  panels.draw();
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindTexture(GL_TEXTURE_2D, 0);
}

// A film over faces that are drawn already; nearer by what they lie back.
void Renderer::Impl::draw_film(const Frame& frame, const PanelBuffer& film, const glm::vec4& tint) const {
  if (film.empty()) return;
  programs.ghost.use();
  programs.ghost.set("view_projection", frame.view_projection);
  programs.ghost.set("eye", frame.eye);
  programs.ghost.set("tint", tint);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  film.draw();
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

void Renderer::Impl::draw_selected(const Frame& frame, const Palette& palette) const {
  for (const PanelBuffer& film : selected) draw_film(frame, film, glm::vec4(palette.selected, kSelectedTint));
}

}  // namespace planewright::render
