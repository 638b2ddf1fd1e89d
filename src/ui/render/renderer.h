// Renderer: draws a Scene with OpenGL 3.3 core into the bound framebuffer's rectangle. No GLFW, no Dear
// ImGui: the window and the command line (EGL, no display) use the same.
//
// Panels: flat-shaded card under soft light from above; crisp panel edges by fragment derivatives, inner
// diagonals of their triangulation not drawn. Ghost: faint blue. Colour maps: viridis, with a hard break at
// the tolerance. Threads: the thread of the current OpenGL context, alone; the renderer must die before its
// context. Failure: std::runtime_error when the GPU has no memory left for an upload; in debug builds also
// when drawing raised an OpenGL error.
//
// Streaming: set_scene() triangulates, which is for still pictures. A window makes PanelArrays and
// GhostArrays on another thread; set_panels() and set_ghost() copy them and nothing more.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "ui/render/camera.h"
#include "ui/render/panel_arrays.h"
#include "ui/render/scene.h"

namespace planewright::render {

struct Theme {
  bool dark = false;
};

struct Viewport {
  int x = 0, y = 0, width = 1, height = 1;  // pixels of the framebuffer, (0, 0) bottom left
  float pixel_scale = 1.0f;                 // of line widths and markers: 2 on a hi-dpi screen
  bool fine = false;  // also the small things that only a still picture shows, for a third more time
};

struct Surface {
  Tone tone;
  std::shared_ptr<const PanelArrays> arrays;  // not null
};

class Renderer {
 public:
  // Compiles the shaders (embedded at build time; read from `shader_folder` when that is not empty, for live
  // reload in debug builds). Fails with ErrorCode::Unavailable and the compiler's log.
  static Result<Renderer> create(const std::filesystem::path& shader_folder = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  void set_scene(const Scene& scene);  // everything
  // The panels in another state, with or without other polygons; arrays without geometry: no panels. Empty
  // values: plain card. Triangles go to the GPU only where panels.geometry is another object than before.
  void set_panels(const PanelArrays& panels, const Vector& polygon_values, const Vector& point_values);
  void set_panel_values(const Vector& polygon_values, const Vector& point_values);
  // Null: none. Handing over the same object again costs nothing.
  void set_ghost(std::shared_ptr<const GhostArrays> ghost);
  // Further surfaces, in plain card. One that is the same object as before in its place costs nothing.
  void set_surfaces(const std::vector<Surface>& surfaces);
  // The input with its regions in colours, drawn instead of all else by What::Regions and Over. Null: none.
  // Handing over the same object again costs nothing.
  void set_regions(std::shared_ptr<const RegionArrays> regions);
  // Over it: a film, and lines (two ends each) round what is selected, and a fainter film.
  void set_region_marks(const PanelArrays& selected, const std::vector<Vector3d>& outline,
                        const PanelArrays& hovered);
  // What is to be tinted as selected: triangles_of() the panels shown, and of their other side.
  void set_selected(const std::vector<PanelArrays>& selected);
  void set_markers(const std::vector<Marker>& markers, const std::vector<Segment>& segments);
  void set_colours(const std::optional<ColourScale>& colours);

  // Clears and draws the viewport's rectangle of the bound framebuffer, which needs a depth buffer. Leaves
  // depth test, blending, culling and scissor off, and no program, vertex array or texture (unit 0) bound.
  // Over: the regions, and the panels over them as if they were of frosted glass.
  enum class What { Panels, Regions, Over };
  void draw(const Camera& camera, const Viewport& viewport, const Theme& theme, bool show_ghost = true,
            What what = What::Panels);

  // With a shader folder: looks for changed files and takes them over; keeps the old shaders and returns why
  // when they do not compile. Cheap enough to be asked once a second. Without a folder: does nothing.
  Result<void> reload_changed_shaders();

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// Renders a scene without a display: creates a surfaceless EGL context, draws, and writes a PNG (whole or not
// at all). Deterministic: the same scene and options give the same bytes on the same driver. Threads: any
// that has no OpenGL context of its own (one that has uses save_picture() of picture.h). Fails with
// ErrorCode::Unavailable where the machine has no EGL, naming the package that brings it; with
// ErrorCode::Usage for a size that cannot be, with ErrorCode::Unwritable when the file cannot be written.
struct PictureOptions {
  int width = 1600, height = 1000;
  Theme theme;
  bool ghost = true;
  Renderer::What what = Renderer::What::Panels;  // a scene has no regions: for set_regions()
  bool legend = true;                            // drawn into the picture when the scene has colours
  std::string title = {};                        // top left; empty: none. UTF-8
  std::optional<Camera> camera = {};  // its direction and place; empty: the standard view of the whole scene
};
Result<void> render_picture(const Scene& scene, const PictureOptions& options,
                            const std::filesystem::path& png);

}  // namespace planewright::render
