// Passes of the renderer: backdrop, shadow, ghost, panels, segments, marks.
#include <iterator>

#include "ui/render/renderer_impl.h"

namespace planewright::render {
namespace {

constexpr float kPanelLine = 1.2f;                                // pixels
constexpr float kSegmentLine[] = {2.4f, 2.8f, 4.4f, 4.4f, 4.0f};  // by Segment::Kind
static_assert(std::size(kSegmentLine) == kSegmentKinds);
constexpr float kGhostLift = 0.35f;   // of an edge, by which the input's lines are drawn nearer
constexpr float kMarkerPart = 0.13f;  // of an edge that a mark's radius may take
constexpr float kThrough = 0.22f;     // strength of marks behind geometry

struct ToneColours {
  glm::vec3 card, edge;
};
ToneColours colours_of(Tone tone, const Palette& palette) {
  switch (tone) {
    case Tone::OtherLayer:
      return {palette.other_card, palette.edge};
    case Tone::Beam:
      return {palette.beam, palette.beam_edge};
    case Tone::Second:
      return {palette.second_card, palette.second_edge};
    case Tone::Crossing:
      return {palette.crossing_card, palette.edge};
    case Tone::Back:
      break;
  }
  return {palette.back_card, palette.edge};
}

}  // namespace

void set_scale(const ShaderProgram& p, const MapScale& scale) {
  p.set("low", scale.low);
  p.set("tolerance", scale.tolerance);
  p.set("per_unit_below", scale.per_unit_below);
  p.set("per_unit_above", scale.per_unit_above);
  p.set("below_end", scale.below_end);
  p.set("above_start", scale.above_start);
}

void Renderer::Impl::draw_backdrop(const Palette& palette) const {
  glDisable(GL_DEPTH_TEST);
  programs.backdrop.use();
  programs.backdrop.set("top", palette.ground_top);
  programs.backdrop.set("bottom", palette.ground_bottom);
  glBindVertexArray(no_attributes.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::Impl::draw_shadow(const Frame& frame, const Palette& palette) const {
  if (!shadow || frame.eye.z <= static_cast<float>(shadow->low.z())) return;
  const auto as_float = [](const Vector3d& v) { return glm::vec3(v.x(), v.y(), v.z()); };
  programs.shadow.use();
  programs.shadow.set("view_projection", frame.view_projection);
  programs.shadow.set("low", as_float(shadow->low));
  programs.shadow.set("high", as_float(shadow->high));
  programs.shadow.set("darkness", 0);
  programs.shadow.set("shadow", palette.shadow);
  programs.shadow.set("strength", palette.shadow_strength);
  glBindTexture(GL_TEXTURE_2D, shadow_picture.get());
  glBindVertexArray(no_attributes.get());
  glEnable(GL_BLEND);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_BLEND);
  glBindTexture(GL_TEXTURE_2D, 0);
}

// Drawn before the panels, which then cover them: where both nearly coincide a tint over the panels would be
// blotched. Alone, only the nearest layer is tinted, so that the ghost reads as a surface.
void Renderer::Impl::draw_ghost_faces(const Frame& frame, const Palette& palette) const {
  programs.ghost.use();
  programs.ghost.set("view_projection", frame.view_projection);
  programs.ghost.set("eye", frame.eye);
  const bool alone = panels.empty();
  if (alone) {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    begin_lying_back();
    ghost.draw();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  programs.ghost.set("tint", glm::vec4(palette.ghost, alone ? 0.13f : 0.05f));
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  ghost.draw();
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDepthMask(GL_TRUE);
}

void Renderer::Impl::begin_panels(const Frame& frame, const Palette& palette) const {
  glEnable(GL_DEPTH_TEST);
  const ShaderProgram& p = programs.panel;
  p.use();
  p.set("view_projection", frame.view_projection);
  p.set("eye", frame.eye);
  p.set("key_light", frame.key_light);
  p.set("back_tint", palette.back_tint);
  p.set("pixels_per_unit", frame.pixels_per_unit / frame.pixel_scale);
  p.set("card", palette.card);
  p.set("edge", palette.edge);
  p.set("line_width", kPanelLine * frame.pixel_scale);
  p.set("fine", frame.fine ? 1 : 0);
  p.set("shade", 0.45f);
  p.set("opacity", 1.0f);
  p.set("map", 0);
}

void Renderer::Impl::draw_panels(const Frame& frame, const Palette& palette) const {
  begin_panels(frame, palette);
  const ShaderProgram& p = programs.panel;
  p.set("coloured", colours ? 1 : 0);
  if (colours) set_scale(p, map_scale(*colours));
  glBindTexture(GL_TEXTURE_2D, maps[colours ? static_cast<int>(colours->map) : 0].get());
  begin_lying_back();
  panels.draw();
  p.set("coloured", 0);
  for (const SurfaceBuffer& further : surfaces) {
    const auto [card, edge] = colours_of(further.surface.tone, palette);
    p.set("card", card);
    p.set("edge", edge);
    further.buffer.draw();
  }
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void Renderer::Impl::begin_lines(const Frame& frame) const {
  const ShaderProgram& p = programs.line;
  p.use();
  p.set("view", frame.view);
  p.set("projection", frame.projection);
  p.set("viewport", frame.size);
  p.set("pixels_per_unit", frame.pixels_per_unit);
  p.set("near", frame.near);
  p.set("lift", 0.0f);
  p.set("fade_below", 0.0f);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
}

// Over panels the lines are drawn as if they lay a third of an edge nearer: design edges just beneath the
// panels stay legible, while the far side of the model does not shine through. One pass does for both; lines
// are what costs most on a software renderer.
void Renderer::Impl::draw_ghost_lines(const Frame& frame, const Palette& palette) const {
  if (!ghost_arrays || ghost_lines.empty()) return;
  begin_lines(frame);
  const ShaderProgram& p = programs.line;
  const bool alone = panels.empty();
  p.set("line_width", kGhostLine * frame.pixel_scale);
  p.set("fade_below", 24.0f * frame.pixel_scale);
  p.set("lift_pixels", 0.5f * frame.pixel_scale);
  p.set("lift", alone ? 0.0f : kGhostLift * ghost_arrays->mean_edge);
  p.set("tint", glm::vec4(palette.ghost, alone ? 0.75f : 0.42f));
  ghost_lines.draw();
}

void Renderer::Impl::draw_segments(const Frame& frame, const Palette& palette) const {
  const glm::vec3 tints[] = {palette.warning, palette.error, palette.warning, palette.selected,
                             palette.selected};
  const ShaderProgram& p = programs.line;
  begin_lines(frame);
  p.set("lift_pixels", 3.0f * frame.pixel_scale);
  for (int kind = 0; kind < kSegmentKinds; ++kind) {
    if (segments[kind].empty()) continue;
    const float width = kSegmentLine[kind] * frame.pixel_scale;
    const bool hovered = kind == static_cast<int>(Segment::Kind::Hovered);
    // Edges of the input lie beneath the panels; see draw_ghost_lines().
    const bool of_input = hovered || kind == static_cast<int>(Segment::Kind::Suggested);
    p.set("lift", of_input && ghost_arrays && !panels.empty() ? kGhostLift * ghost_arrays->mean_edge : 0.0f);
    glDepthFunc(GL_GREATER);
    p.set("line_width", width);
    p.set("tint", glm::vec4(tints[kind], kThrough));
    segments[kind].draw();
    glDepthFunc(GL_LEQUAL);
    p.set("line_width", width + 2.0f * frame.pixel_scale);
    p.set("tint", glm::vec4(palette.outline, 0.75f));
    segments[kind].draw();
    p.set("line_width", width);
    p.set("tint", glm::vec4(tints[kind], hovered ? 0.75f : 1.0f));
    segments[kind].draw();
  }
}

void Renderer::Impl::draw_markers(const Frame& frame, const Palette& palette) {
  if (markers.empty()) return;
  const ShaderProgram& p = programs.marker;
  p.use();
  p.set("view", frame.view);
  p.set("projection", frame.projection);
  p.set("viewport", frame.size);
  p.set("pixel_scale", frame.pixel_scale);
  p.set("pixels_per_unit", frame.pixels_per_unit);
  p.set("largest", ghost_arrays ? kMarkerPart * ghost_arrays->mean_edge : 0.0f);
  p.set("outline", palette.outline);
  p.set("rim", palette.edge);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glDepthFunc(GL_GREATER);
  p.set("strength", kThrough);
  markers.draw(palette);
  glDepthFunc(GL_LEQUAL);
  p.set("strength", 1.0f);
  markers.draw(palette);
}

}  // namespace planewright::render
