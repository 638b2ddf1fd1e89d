#include "ui/render/renderer.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <glm/geometric.hpp>
#include <iterator>

#include "ui/render/colour_map.h"
#include "ui/render/gl_objects.h"
#include "ui/render/line_buffer.h"
#include "ui/render/palette.h"
#include "ui/render/panel_buffer.h"
#include "ui/render/shader_program.h"

namespace planewright::render {
namespace {

constexpr float kPanelLine = 1.2f, kGhostLine = 1.0f;             // pixels
constexpr float kSegmentLine[] = {2.4f, 2.8f, 4.4f, 4.4f, 4.0f};  // by Segment::Kind
constexpr float kMarkerRadius[] = {2.9f, 3.3f, 4.6f, 3.4f};       // by Marker::Kind, pixels
constexpr float kLeastRadius[] = {1.1f, 1.3f, 4.6f, 2.6f};        // where panels are small on the screen
constexpr float kSelectedTint = 0.30f;
constexpr float kHoveredTint = 0.20f;
constexpr float kRegionLine = 1.9f;        // pixels
constexpr float kRegionOutline = 3.2f;     // round what is selected
constexpr float kMeshOverRegions = 0.16f;  // strength of the mesh's own edges
constexpr float kGlass = 0.42f;            // opacity of panels over regions
constexpr float kGhostLift = 0.35f;        // of an edge, by which the input's lines are drawn nearer
constexpr float kMarkerPart = 0.13f;       // of an edge that a mark's radius may take
constexpr float kThrough = 0.22f;          // strength of marks behind geometry

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

  static Result<Programs> load(const std::filesystem::path& folder) {
    Programs programs;
    const std::pair<const char*, ShaderProgram*> all[] = {
        {"backdrop", &programs.backdrop}, {"shadow", &programs.shadow}, {"panel", &programs.panel},
        {"ghost", &programs.ghost},       {"line", &programs.line},     {"marker", &programs.marker}};
    for (const auto& [name, program] : all) {
      auto loaded = ShaderProgram::load(name, folder);
      if (!loaded) return tl::unexpected(loaded.error());
      *program = std::move(*loaded);
    }
    return programs;
  }
};

struct MarkerVertex {
  float x, y, z;
  float r, g, b;
  float radius, least;
};

// Discs; their colours hang on the theme, so the buffer is filled when the theme changes.
class MarkerBuffer {
 public:
  void set(const std::vector<Marker>& markers) {
    markers_ = markers;
    filled_for_ = nullptr;
  }

  void draw(const Palette& palette) {
    if (markers_.empty()) return;
    if (filled_for_ != &palette) fill(palette);
    glBindVertexArray(arrays_.get());
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(markers_.size()));
    glBindVertexArray(0);
  }
  bool empty() const { return markers_.empty(); }

 private:
  void fill(const Palette& palette) {
    std::vector<MarkerVertex> vertices;
    vertices.reserve(markers_.size());
    for (const Marker& marker : markers_) {
      const glm::vec3& c = marker.kind == Marker::Kind::Warning ? palette.warning
                           : marker.kind == Marker::Kind::Error ? palette.error
                                                                : palette.selected;
      const auto& p = marker.position;
      vertices.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()),
                          c.x, c.y, c.z, kMarkerRadius[static_cast<int>(marker.kind)],
                          kLeastRadius[static_cast<int>(marker.kind)]});
    }
    if (!arrays_) {
      arrays_ = GlVertexArray::create();
      buffer_ = GlBuffer::create();
    }
    glBindVertexArray(arrays_.get());
    glBindBuffer(GL_ARRAY_BUFFER, buffer_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizeof(MarkerVertex) * vertices.size()),
                 vertices.data(), GL_DYNAMIC_DRAW);
    const size_t offsets[] = {offsetof(MarkerVertex, x), offsetof(MarkerVertex, r),
                              offsetof(MarkerVertex, radius)};
    const GLint sizes[] = {3, 3, 2};
    for (GLuint i = 0; i < 3; ++i) {
      glVertexAttribPointer(i, sizes[i], GL_FLOAT, GL_FALSE, sizeof(MarkerVertex),
                            reinterpret_cast<const void*>(offsets[i]));
      glVertexAttribDivisor(i, 1);
      glEnableVertexAttribArray(i);
    }
    glBindVertexArray(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    check_gl("uploading markers");
    filled_for_ = &palette;
  }

  std::vector<Marker> markers_;
  const Palette* filled_for_ = nullptr;
  GlVertexArray arrays_;
  GlBuffer buffer_;
};

GlTexture make_texture(GLint format, GLenum pixels, int width, int height, const void* data) {
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, pixels, GL_UNSIGNED_BYTE, data);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

// Faces are drawn a little farther away than they are, so that lines in them lie on top.
void begin_lying_back() {
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0f, 1.0f);
}

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

void set_scale(const ShaderProgram& p, const MapScale& scale) {
  p.set("low", scale.low);
  p.set("tolerance", scale.tolerance);
  p.set("per_unit_below", scale.per_unit_below);
  p.set("per_unit_above", scale.per_unit_above);
  p.set("below_end", scale.below_end);
  p.set("above_start", scale.above_start);
}

// Each of the colours as long a stretch of the table as the others.
ColourTable region_table(const Palette& palette) {
  ColourTable table{};
  for (std::size_t i = 0; i < table.size() / 4; ++i) {
    const glm::vec3& colour = palette.regions[i * kRegionColours / (table.size() / 4)];
    for (int k = 0; k < 3; ++k)
      table[4 * i + static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::lround(255.0f * colour[k]));
    table[4 * i + 3] = 255;
  }
  return table;
}

// The time of the latest change among the files of a folder.
std::filesystem::file_time_type latest_change(const std::filesystem::path& folder) {
  auto latest = std::filesystem::file_time_type::min();
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code unreadable;
    const auto time = it->last_write_time(unreadable);
    if (!unreadable && time > latest) latest = time;
  }
  return latest;
}

}  // namespace

struct Renderer::Impl {
  std::filesystem::path shader_folder;
  std::filesystem::file_time_type shaders_from;
  Programs programs;
  GlVertexArray no_attributes;  // for what the shaders make from the vertex's number
  GlTexture maps[2];            // by ColourScale::Map
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
  LineBuffer segments[std::size(kSegmentLine)];  // by Segment::Kind
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
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_BLEND);
  panels.draw();
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
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
  for (int kind = 0; kind < static_cast<int>(std::size(kSegmentLine)); ++kind) {
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

Result<Renderer> Renderer::create(const std::filesystem::path& shader_folder) {
  if (epoxy_is_desktop_gl() ? epoxy_gl_version() < 33 : true) {
    return fail(ErrorCode::Unavailable, "the current OpenGL context is older than version 3.3", {},
                "update the graphics driver");
  }
  if (const std::string before = take_gl_errors(); !before.empty()) {
    std::fprintf(stderr, "OpenGL had errors before the renderer began: %s\n", before.c_str());
  }
  auto impl = std::make_unique<Impl>();
  impl->shader_folder = shader_folder;
  if (!shader_folder.empty()) impl->shaders_from = latest_change(shader_folder);
  auto programs = Programs::load(shader_folder);
  if (!programs) return tl::unexpected(programs.error());
  impl->programs = std::move(*programs);
  impl->no_attributes = GlVertexArray::create();
  const ColourTable tables[] = {viridis_table(), severity_table()};
  for (std::size_t i = 0; i < std::size(tables); ++i) {
    impl->maps[i] =
        make_texture(GL_RGBA8, GL_RGBA, static_cast<int>(tables[i].size() / 4), 1, tables[i].data());
  }
  for (const bool dark : {false, true}) {
    const ColourTable table = region_table(palette_of({dark}));
    impl->region_maps[dark ? 1 : 0] =
        make_texture(GL_RGBA8, GL_RGBA, static_cast<int>(table.size() / 4), 1, table.data());
  }
  if (const std::string errors = take_gl_errors(); !errors.empty()) {
    return fail(ErrorCode::Unavailable, "OpenGL cannot be set up: " + errors, {},
                "update the graphics driver");
  }
  return Renderer(std::move(impl));
}

Renderer::Renderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::Impl::update_shadow() {
  shadow = panel_shadow;
  if (!shadow && ghost_arrays) shadow = ghost_arrays->faces.shadow;
  if (!shadow) return;
  shadow_picture =
      make_texture(GL_R8, GL_RED, GroundShadow::kCells, GroundShadow::kCells, shadow->darkness.data());
}

void Renderer::set_scene(const Scene& scene) {
  if (const auto& layer = scene.ghost) {
    set_ghost(std::make_shared<const GhostArrays>(make_ghost_arrays(layer->points, layer->polygons)));
  } else {
    set_ghost(nullptr);
  }
  std::vector<Surface> surfaces;
  if (const auto& layer = scene.panels) {
    const PanelArrays panels = make_panel_arrays(layer->points, layer->polygons);
    set_panels(panels, layer->polygon_values, layer->point_values);
    set_selected({triangles_of(panels, scene.selected)});
    // Over the panels: the same triangles have the same depth, so what is drawn last shows.
    if (!scene.crossing.empty())
      surfaces.push_back(
          {Tone::Crossing, std::make_shared<const PanelArrays>(triangles_of(panels, scene.crossing))});
  } else {
    set_panels({}, {}, {});
    set_selected({});
  }
  for (const FurtherLayer& further : scene.further) {
    surfaces.push_back({further.tone, std::make_shared<const PanelArrays>(
                                          make_panel_arrays(further.layer.points, further.layer.polygons))});
  }
  set_surfaces(surfaces);
  set_markers(scene.markers, scene.segments);
  set_colours(scene.colours);
  check_gl("uploading the scene");
}

void Renderer::set_panels(const PanelArrays& panels, const Vector& polygon_values,
                          const Vector& point_values) {
  impl_->panels.set(panels);
  impl_->panels.set_values(polygon_values, point_values);
  impl_->panel_shadow = panels.shadow;
  impl_->update_shadow();
}

void Renderer::set_panel_values(const Vector& polygon_values, const Vector& point_values) {
  impl_->panels.set_values(polygon_values, point_values);
}

void Renderer::set_ghost(std::shared_ptr<const GhostArrays> ghost) {
  if (ghost == impl_->ghost_arrays) return;
  impl_->ghost_arrays.reset();  // should an upload fail
  impl_->ghost.set(ghost ? ghost->faces : PanelArrays());
  impl_->ghost_lines = ghost ? LineBuffer(ghost->lines) : LineBuffer();
  impl_->ghost_arrays = std::move(ghost);
  impl_->update_shadow();
}

void Renderer::set_regions(std::shared_ptr<const RegionArrays> regions) {
  if (regions == impl_->region_arrays) return;
  impl_->region_arrays.reset();  // should an upload fail
  impl_->regions.set(regions ? regions->faces : PanelArrays());
  if (regions) impl_->regions.set_values(regions->colours.array() + 0.5, {});  // the middle of a stretch
  impl_->region_arrays = std::move(regions);
}

void Renderer::set_region_marks(const PanelArrays& selected, const std::vector<Vector3d>& outline,
                                const PanelArrays& hovered) {
  impl_->regions_selected.set(selected);
  impl_->regions_hovered.set(hovered);
  impl_->region_outline = LineBuffer(make_line_arrays(outline));
}

void Renderer::set_surfaces(const std::vector<Surface>& surfaces) {
  auto& buffers = impl_->surfaces;
  buffers.resize(surfaces.size());
  for (size_t i = 0; i < surfaces.size(); ++i) {
    if (buffers[i].surface.arrays != surfaces[i].arrays) {
      buffers[i].surface.arrays.reset();  // should an upload fail
      buffers[i].buffer.set(*surfaces[i].arrays);
    }
    buffers[i].surface = surfaces[i];
  }
}

void Renderer::set_selected(const std::vector<PanelArrays>& selected) {
  impl_->selected.resize(selected.size());
  for (size_t i = 0; i < selected.size(); ++i) impl_->selected[i].set(selected[i]);
}

void Renderer::set_markers(const std::vector<Marker>& markers, const std::vector<Segment>& segments) {
  impl_->markers.set(markers);
  std::vector<Vector3d> ends[std::size(kSegmentLine)];
  for (const Segment& segment : segments) {
    auto& list = ends[static_cast<int>(segment.kind)];
    list.push_back(segment.a);
    list.push_back(segment.b);
  }
  for (size_t kind = 0; kind < std::size(ends); ++kind)
    impl_->segments[kind] = LineBuffer(make_line_arrays(ends[kind]));
}

void Renderer::set_colours(const std::optional<ColourScale>& colours) {
  impl_->colours = colours;
}

void Renderer::draw(const Camera& camera, const Viewport& viewport, const Theme& theme, bool show_ghost,
                    What what) {
#ifndef NDEBUG
  if (const std::string before = take_gl_errors(); !before.empty()) {
    std::fprintf(stderr, "OpenGL had errors before the scene was drawn: %s\n", before.c_str());
  }
#endif
  if (viewport.width <= 0 || viewport.height <= 0) return;
  const Palette& palette = palette_of(theme);
  const Frame frame(camera, viewport);

  glViewport(viewport.x, viewport.y, viewport.width, viewport.height);
  glScissor(viewport.x, viewport.y, viewport.width, viewport.height);
  glEnable(GL_SCISSOR_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_BLEND);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glDepthRange(0.0, 1.0);
  glClearDepth(1.0);
  glClear(GL_DEPTH_BUFFER_BIT);
  glActiveTexture(GL_TEXTURE0);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);

  impl_->draw_backdrop(palette);
  impl_->draw_shadow(frame, palette);
  if (what != What::Panels) {
    impl_->draw_regions(frame, theme, show_ghost);
    if (what == What::Over) impl_->draw_glass(frame, palette);
  } else {
    if (show_ghost) impl_->draw_ghost_faces(frame, palette);
    impl_->draw_panels(frame, palette);
    impl_->draw_selected(frame, palette);
    if (show_ghost) impl_->draw_ghost_lines(frame, palette);
    impl_->draw_segments(frame, palette);
    impl_->draw_markers(frame, palette);
  }

  glDepthMask(GL_TRUE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
  glUseProgram(0);
#ifndef NDEBUG
  check_gl("drawing the scene");
#endif
}

Result<void> Renderer::reload_changed_shaders() {
  if (impl_->shader_folder.empty()) return {};
  const auto latest = latest_change(impl_->shader_folder);
  if (latest == impl_->shaders_from) return {};
  impl_->shaders_from = latest;
  auto programs = Programs::load(impl_->shader_folder);
  if (!programs) return tl::unexpected(programs.error());
  impl_->programs = std::move(*programs);
  return {};
}

}  // namespace planewright::render
