// Pictures as pixels: what render_picture() of renderer.h writes, and the same out of the window's own
// context.
//
// Threads: as render_picture(); draw_image and save_picture: the thread of the current OpenGL context, alone.
#pragma once

#include <utility>

#include "ui/render/image.h"
#include "ui/render/renderer.h"

namespace planewright::render {

// render_picture() without the file.
Result<Image> render_image(const Scene& scene, const PictureOptions& options);

// What `renderer` shows, seen from options.camera (needed), drawn into a framebuffer of its own in the
// current context; framebuffer and viewport are put back. `colours`: what the legend says.
Result<Image> draw_image(Renderer& renderer, const std::optional<ColourScale>& colours,
                         const PictureOptions& options);
Result<void> save_picture(Renderer& renderer, const std::optional<ColourScale>& colours,
                          const PictureOptions& options, const std::filesystem::path& png);

// Everything in the scene that has a place and is finite (#N x 3), to fit a camera to.
Points points_of(const Scene& scene);

}  // namespace planewright::render
