#include "ui/render/renderer.h"

#include <cmath>
#include <cstdio>
#include <iterator>

#include "ui/render/renderer_impl.h"

namespace planewright::render {
namespace {

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

Result<Programs> Programs::load(const std::filesystem::path& folder) {
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
  const ColourTable tables[] = {viridis_table(), severity_table(), verdict_table()};
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
  std::vector<Vector3d> ends[kSegmentKinds];
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
