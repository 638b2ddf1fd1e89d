// Renderer: draws a Scene with OpenGL 3.3 core into the bound framebuffer's rectangle. No GLFW, no Dear ImGui: the
// window and the command line (EGL, no display) use the same.
//
// Panels: flat-shaded card under soft light from above; crisp panel edges by fragment derivatives, inner diagonals
// of their triangulation not drawn. Ghost: faint blue. Colour maps: viridis, with a hard break at the tolerance.
// Threads: the thread of the current OpenGL context, alone.
//
// Streaming: set_topology() once per complex (triangulates, builds index arrays; may take long and can be prepared
// off-thread by prepare()), then update_points() per iterate, which only re-uploads positions.
#pragma once

#include <filesystem>
#include <memory>

#include "core/base/result.h"
#include "ui/render/camera.h"
#include "ui/render/scene.h"

namespace planewright::render {

struct Theme {
  bool dark = false;
};

struct Viewport {
  int x = 0, y = 0, width = 1, height = 1;  // pixels of the framebuffer, (0, 0) bottom left
};

class Renderer {
 public:
  // Compiles the shaders (embedded at build time; read from `shader_folder` when that is not empty, for live
  // reload in debug builds). Fails with ErrorCode::Unavailable and the compiler's log.
  static Result<Renderer> create(const std::filesystem::path& shader_folder = {});
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  void set_scene(const Scene& scene);         // everything
  void update_panel_points(const Points& points, const Vector& polygon_values, const Vector& point_values);
  void set_markers(const std::vector<Marker>& markers, const std::vector<Segment>& segments);
  void set_colours(const std::optional<ColourScale>& colours);

  void draw(const Camera& camera, const Viewport& viewport, const Theme& theme, bool show_ghost = true);

 private:
  struct Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

// Renders a scene without a display: creates a surfaceless EGL context, draws, and writes a PNG (whole or not at
// all). Fails with ErrorCode::Unavailable where the machine has no EGL, naming the package that brings it.
struct PictureOptions {
  int width = 1600, height = 1000;
  Theme theme;
  bool ghost = true;
  bool legend = true;  // drawn into the picture when the scene has colours
};
Result<void> render_picture(const Scene& scene, const PictureOptions& options, const std::filesystem::path& png);

}  // namespace planewright::render
