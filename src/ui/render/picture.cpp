#include "ui/render/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "ui/render/egl_context.h"
#include "ui/render/gl_objects.h"
#include "ui/render/legend.h"
#include "ui/render/png.h"

namespace planewright::render {
namespace {

constexpr int kLargestSide = 16384;  // pixels; OpenGL may allow less
constexpr int kSamples = 4;

// Text and lines grow with the picture, but stay readable in a small one.
float pixel_scale_of(const PictureOptions& options) {
  return std::max(1.0f, static_cast<float>(std::min(options.width, options.height * 8 / 5)) / 1600.0f);
}

Result<void> check_size(int width, int height) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
  limit = std::min(limit, kLargestSide);
  if (width >= 1 && height >= 1 && width <= limit && height <= limit) return {};
  return fail(
      ErrorCode::Usage,
      "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels is not possible",
      {}, "take 1 to " + std::to_string(limit) + " pixels for each side");
}

// A framebuffer with colour and, if wanted, depth; the samples are those the driver has, up to four.
class Canvas {
 public:
  Canvas(int width, int height, int samples, bool with_depth) : framebuffer_(GlFramebuffer::create()) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    attach(colour_, GL_RGBA8, GL_COLOR_ATTACHMENT0, width, height, samples);
    if (with_depth) attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height, samples);
  }
  bool complete() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }
  GLuint get() const { return framebuffer_.get(); }

 private:
  static void attach(GlRenderbuffer& to, GLenum format, GLenum point, int width, int height, int samples) {
    to = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, to.get());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, to.get());
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
  }

  GlFramebuffer framebuffer_;
  GlRenderbuffer colour_, depth_;
};

// Puts framebuffer bindings and viewport back as they were.
class KeepFramebuffer {
 public:
  KeepFramebuffer() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  KeepFramebuffer(const KeepFramebuffer&) = delete;
  KeepFramebuffer& operator=(const KeepFramebuffer&) = delete;
  ~KeepFramebuffer() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }

 private:
  GLint draw_ = 0, read_ = 0, viewport_[4] = {};
};

Image read_pixels(int width, int height) {
  Image image{width, height, std::vector<std::uint8_t>(static_cast<size_t>(width) * height * 4)};
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  const size_t row = static_cast<size_t>(width) * 4;  // OpenGL's rows begin at the bottom
  for (int y = 0; y < height / 2; ++y) {
    std::swap_ranges(image.rgba.begin() + static_cast<std::ptrdiff_t>(row * y),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>(row * (y + 1)),
                     image.rgba.begin() + static_cast<std::ptrdiff_t>(row * (height - 1 - y)));
  }
  return image;
}

tl::unexpected<Error> no_canvas(const PictureOptions& options) {
  const std::string errors = take_gl_errors();
  return fail(ErrorCode::Unavailable,
              "OpenGL cannot draw a picture of " + std::to_string(options.width) + " x " +
                  std::to_string(options.height) + " pixels" + (errors.empty() ? "" : " (" + errors + ")"),
              {}, "take a smaller picture");
}

}  // namespace

Result<Image> draw_image(Renderer& renderer, const std::optional<ColourScale>& colours,
                         const PictureOptions& options) {
  if (auto size = check_size(options.width, options.height); !size) return tl::unexpected(size.error());
  const KeepFramebuffer keep;
  GLint samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &samples);
  const Canvas canvas(options.width, options.height, std::min<int>(samples, kSamples), true);
  const Canvas resolved(options.width, options.height, 0, false);
  if (!canvas.complete() || !resolved.complete()) return no_canvas(options);

  Camera camera = options.camera.value_or(Camera());
  camera.set_viewport(options.width, options.height);
  const float scale = pixel_scale_of(options);
  glBindFramebuffer(GL_FRAMEBUFFER, canvas.get());
  glEnable(GL_MULTISAMPLE);
  renderer.draw(camera, {0, 0, options.width, options.height, scale, true}, options.theme, options.ghost,
                options.what);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.get());
  glBlitFramebuffer(0, 0, options.width, options.height, 0, 0, options.width, options.height,
                    GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved.get());
  Image image = read_pixels(options.width, options.height);
  if (const std::string errors = take_gl_errors(); !errors.empty()) {
    return fail(ErrorCode::Unavailable, "OpenGL failed while drawing the picture: " + errors, {},
                "update the graphics driver");
  }

  if (!options.title.empty()) draw_title(image, options.title, options.theme, scale);
  if (options.legend && colours) draw_legend(image, *colours, options.theme, scale);
  return image;
}

Result<void> save_picture(Renderer& renderer, const std::optional<ColourScale>& colours,
                          const PictureOptions& options, const std::filesystem::path& png) {
  const auto image = draw_image(renderer, colours, options);
  if (!image) return tl::unexpected(image.error());
  return write_png(*image, png);
}

Result<Image> render_image(const Scene& scene, const PictureOptions& options) {
  const auto context = EglContext::create();
  if (!context) return tl::unexpected(context.error());
  auto renderer = Renderer::create();
  if (!renderer) return tl::unexpected(renderer.error());
  renderer->set_scene(scene);
  PictureOptions complete = options;
  if (!complete.camera) {
    Camera camera;
    camera.set_viewport(options.width, options.height);
    camera.reset_direction();
    camera.fit(points_of(scene));
    complete.camera = camera;
  }
  return draw_image(*renderer, scene.colours, complete);
}

Result<void> render_picture(const Scene& scene, const PictureOptions& options,
                            const std::filesystem::path& png) {
  const auto image = render_image(scene, options);
  if (!image) return tl::unexpected(image.error());
  return write_png(*image, png);
}

Points points_of(const Scene& scene) {
  std::vector<Vector3d> places;
  const auto add = [&](const PolygonLayer& layer) {
    // Only what a polygon uses is drawn.
    std::vector<char> used(static_cast<size_t>(layer.points.rows()), 0);
    for (int i : layer.polygons.indices()) used[i] = 1;
    for (size_t i = 0; i < used.size(); ++i) {
      if (used[i]) places.emplace_back(layer.points.row(static_cast<Eigen::Index>(i)).transpose());
    }
  };
  if (scene.panels) add(*scene.panels);
  if (scene.ghost) add(*scene.ghost);
  for (const FurtherLayer& further : scene.further) add(further.layer);
  for (const Marker& marker : scene.markers) places.push_back(marker.position);
  for (const Segment& segment : scene.segments) {
    places.push_back(segment.a);
    places.push_back(segment.b);
  }
  std::erase_if(places, [](const Vector3d& p) { return !p.allFinite(); });
  Points points(static_cast<Eigen::Index>(places.size()), 3);
  for (size_t i = 0; i < places.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = places[i].transpose();
  return points;
}

}  // namespace planewright::render
