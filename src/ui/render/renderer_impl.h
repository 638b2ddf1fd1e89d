// What a Renderer holds, and its passes: renderer.cpp uploads and says their order, render_passes.cpp draws
// panels, ghost, lines and marks, region_passes.cpp regions and panels over them. Internal to these three.
//
// Threads: the thread of the current OpenGL context, alone. Units: scene units; lines and marks in pixels.
#pragma once

#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "ui/render/colour_map.h"
#include "ui/render/gl_objects.h"
#include "ui/render/line_buffer.h"
#include "ui/render/marker_buffer.h"
#include "ui/render/palette.h"
#include "ui/render/panel_buffer.h"
#include "ui/render/renderer.h"
#include "ui/render/shader_program.h"

namespace planewright::render {

inline constexpr int kSegmentKinds = 5;    // of Segment::Kind
inline constexpr float kGhostLine = 1.0f;  // pixels

// What the shaders need to know of the camera and the rectangle that is drawn.
struct Frame {
  glm::mat4 view, projection, view_projection;
  glm::vec3 eye, key_light;
  glm::vec2 size;  // pixels
  float pixel_scale, pixels_per_unit, near;
  bool fine;

  Frame(const Camera& camera, const Viewport& viewport)
      : view(camera.view()),
        projection(camera.projection()),
        view_projection(projection * view),
        eye(camera.eye().x(), camera.eye().y(), camera.eye().z()),
        size(viewport.width, viewport.height),
        pixel_scale(viewport.pixel_scale),
        pixels_per_unit(0.5f * projection[1][1] * static_cast<float>(viewport.height)),
        near(projection[3][2] / (projection[2][2] - 1.0f)),
        fine(viewport.fine) {
    // From above, over the viewer's left shoulder: turns with the view, so that facets always differ in tone.
    const glm::vec3 up(0.0f, 0.0f, 1.0f), right(view[0][0], view[1][0], view[2][0]);
    key_light = glm::normalize(0.80f * up - 0.52f * right + 0.38f * glm::cross(right, up));
  }
};

struct Programs {
  ShaderProgram backdrop, shadow, panel, ghost, line, marker;

  // The embedded ones, or those of a folder. Fails as ShaderProgram::load() does.
  static Result<Programs> load(const std::filesystem::path& folder);
};

// Faces are drawn a little farther away than they are, so that lines in them lie on top.
inline void begin_lying_back() {
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 1.0f);
}

// Of the panels' program: how values become places in its colour map.
void set_scale(const ShaderProgram& p, const MapScale& scale);

struct Renderer::Impl {
  std::filesystem::path shader_folder;
  std::filesystem::file_time_type shaders_from;
  Programs programs;
  GlVertexArray no_attributes;  // for what the shaders make from the vertex's number
  GlTexture maps[3];            // by ColourScale::Map
  GlTexture region_maps[2];     // of the light and the dark palette

  PanelBuffer panels, ghost;
  std::vector<PanelBuffer> selected;
  struct SurfaceBuffer {
    Surface surface;  // what the buffer was made from
    PanelBuffer buffer;
  };
  std::vector<SurfaceBuffer> surfaces;
  std::shared_ptr<const RegionArrays> region_arrays;  // what `regions` was made from
  PanelBuffer regions, regions_selected, regions_hovered;
  LineBuffer region_outline;
  std::shared_ptr<const GhostArrays> ghost_arrays;  // what `ghost` was made from
  LineBuffer ghost_lines;
  std::optional<GroundShadow> panel_shadow,
      shadow;  // of the panels; as drawn: the ghost's where there are none
  GlTexture shadow_picture;
  LineBuffer segments[kSegmentKinds];  // by Segment::Kind
  MarkerBuffer markers;
  std::optional<ColourScale> colours;

  void update_shadow();
  void draw_backdrop(const Palette& palette) const;
  void draw_shadow(const Frame& frame, const Palette& palette) const;
  void draw_ghost_faces(const Frame& frame, const Palette& palette) const;
  void draw_panels(const Frame& frame, const Palette& palette) const;
  void begin_panels(const Frame& frame, const Palette& palette) const;
  void draw_regions(const Frame& frame, const Theme& theme, bool with_mesh) const;
  void draw_glass(const Frame& frame, const Palette& palette) const;
  void draw_film(const Frame& frame, const PanelBuffer& film, const glm::vec4& tint) const;
  void draw_selected(const Frame& frame, const Palette& palette) const;
  void draw_ghost_lines(const Frame& frame, const Palette& palette) const;
  void draw_segments(const Frame& frame, const Palette& palette) const;
  void draw_markers(const Frame& frame, const Palette& palette);
  void begin_lines(const Frame& frame) const;
};

}  // namespace planewright::render
