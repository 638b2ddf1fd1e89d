// Draws without a display (EGL) and looks at pixels.
#include "ui/render/renderer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "test_layers.h"
#include "ui/render/colour_map.h"
#include "ui/render/egl_context.h"
#include "ui/render/gl_objects.h"
#include "ui/render/palette.h"
#include "ui/render/picture.h"
#include "ui/render/shader_program.h"

namespace planewright::render {
namespace {

class RendererTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto context = EglContext::create();
    if (!context) GTEST_SKIP() << context.error().text();
  }

  // Looks straight down on everything.
  static PictureOptions from_above(const Scene& scene, int width = 400, int height = 300) {
    PictureOptions options;
    options.width = width;
    options.height = height;
    Camera camera;
    camera.set_viewport(width, height);
    camera.set_direction(-1.5707963, 1.55);
    camera.fit(points_of(scene));
    options.camera = camera;
    return options;
  }

  static Image drawn(const Scene& scene, const PictureOptions& options) {
    auto image = render_image(scene, options);
    EXPECT_TRUE(image) << (image ? "" : image.error().text());
    return image ? std::move(*image) : Image{};
  }

  static glm::vec3 pixel(const Image& image, glm::vec2 at) {
    const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
    if (x < 0 || y < 0 || x >= image.width || y >= image.height) {
      ADD_FAILURE() << "pixel " << x << ", " << y << " is outside";
      return {};
    }
    const std::uint8_t* p = image.rgba.data() + 4 * (static_cast<size_t>(y) * image.width + x);
    return glm::vec3(p[0], p[1], p[2]) / 255.0f;
  }
  static glm::vec3 at(const Image& image, const PictureOptions& options, const Vector3d& point) {
    return pixel(image, options.camera->project(point));
  }
  static float grey(const glm::vec3& c) { return 0.3f * c.x + 0.59f * c.y + 0.11f * c.z; }
  static float distance(const glm::vec3& a, const glm::vec3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
  }
};

TEST_F(RendererTest, AnEmptySceneIsTheGround) {
  for (bool dark : {false, true}) {
    PictureOptions options;
    options.width = 120;
    options.height = 80;
    options.theme.dark = dark;
    const Image image = drawn({}, options);
    const Palette& palette = palette_of(options.theme);
    EXPECT_LT(distance(pixel(image, {60, 1}), palette.ground_top), 0.02f);
    EXPECT_LT(distance(pixel(image, {60, 78}), palette.ground_bottom), 0.02f);
  }
}

TEST_F(RendererTest, PanelsAreCardAndTheirEdgesDarkWithoutDiagonals) {
  Scene scene;
  scene.panels = two_squares();
  const PictureOptions options = from_above(scene);
  const Image image = drawn(scene, options);
  const glm::vec3 card = palette_of({}).card;
  const glm::vec3 face = at(image, options, {0.3, 0.6, 0});
  EXPECT_LT(distance(face, card), 0.2f);
  // Flat: the same all over, also where a diagonal of the square would be.
  for (double t = 0.1; t < 0.95; t += 0.05) {
    EXPECT_LT(distance(at(image, options, {t, t, 0}), face), 0.01f);
    EXPECT_LT(distance(at(image, options, {t, 1 - t, 0}), face), 0.01f);
  }
  // The common edge: dark, thin, of one width along its length.
  const glm::vec2 middle = options.camera->project({1, 0.5, 0});
  float darkest = 1.0f;
  for (int dx = -2; dx <= 2; ++dx) darkest = std::min(darkest, grey(pixel(image, middle + glm::vec2(dx, 0))));
  EXPECT_LT(darkest, 0.6f * grey(face));
  EXPECT_LT(distance(pixel(image, middle + glm::vec2(4, 0)), face), 0.01f);
  EXPECT_LT(distance(pixel(image, middle - glm::vec2(4, 0)), face), 0.01f);
}

TEST_F(RendererTest, FacetsDifferInToneAndBackSidesAreDarker) {
  Scene scene;
  scene.panels = cube();
  PictureOptions options;
  options.width = 300;
  options.height = 300;
  Camera camera;
  camera.set_viewport(300, 300);
  camera.set_direction(-0.9, 0.6);
  camera.fit(scene.panels->points);
  options.camera = camera;
  const Image image = drawn(scene, options);
  const float top = grey(at(image, options, {0, 0, 1}));
  const float right = grey(at(image, options, {1, 0, 0})), left = grey(at(image, options, {0, -1, 0}));
  EXPECT_GT(top, left + 0.03f);
  EXPECT_GT(left, right + 0.03f);

  Scene square;
  square.panels = unit_square();
  const PictureOptions above = from_above(square);
  const float front = grey(at(drawn(square, above), above, {0.4, 0.7, 0}));
  square.panels->polygons = {{3, 2, 1, 0}};
  const glm::vec3 back = at(drawn(square, above), above, {0.4, 0.7, 0});
  EXPECT_LT(grey(back), front - 0.05f);
  EXPECT_GT(back.z, back.x);  // cooler
}

TEST_F(RendererTest, ColoursFollowTheValues) {
  Scene scene;
  scene.panels = two_squares();
  scene.panels->polygon_values = Vector(2);
  scene.panels->polygon_values << 0.9, 1.1;
  scene.colours = ColourScale{0.0, 2.0, "Planarity", "mm", 1.0};
  PictureOptions options = from_above(scene);
  options.legend = false;
  const Image image = drawn(scene, options);
  for (int i : {0, 1}) {
    const glm::vec3 seen = at(image, options, {i + 0.3, 0.6, 0});
    const glm::vec3 wanted = colour_of(*scene.colours, scene.panels->polygon_values[i]);
    // Light scales the colour as a whole.
    const float light = grey(seen) / grey(wanted);
    EXPECT_GT(light, 0.7f);
    EXPECT_LT(light, 1.05f);
    EXPECT_LT(distance(seen, light * wanted), 0.03f) << i;
  }

  scene.panels->polygon_values[1] = std::nan("");  // no value: plain card
  EXPECT_LT(distance(at(drawn(scene, options), options, {1.3, 0.6, 0}), palette_of({}).card), 0.2f);
}

TEST_F(RendererTest, PointValuesBlendOverThePanelAndBreakAtTheTolerance) {
  Scene scene;
  scene.panels = unit_square();
  scene.panels->point_values = Vector(4);
  scene.panels->point_values << 0, 2, 2, 0;
  scene.colours = ColourScale{0.0, 2.0, "Displacement", "mm", 1.0};
  PictureOptions options = from_above(scene);
  options.legend = false;
  const Image image = drawn(scene, options);
  const float before = grey(at(image, options, {0.47, 0.3, 0})),
              after = grey(at(image, options, {0.53, 0.3, 0}));
  EXPECT_GT(after - before, 0.12f);
  EXPECT_LT(grey(at(image, options, {0.1, 0.3, 0})), before);
  EXPECT_GT(grey(at(image, options, {0.9, 0.3, 0})), after);
}

TEST_F(RendererTest, TheGhostShowsAndCanBeHidden) {
  Scene scene;
  scene.panels = unit_square();
  scene.ghost = PolygonLayer{
      rows({{0.5, -0.5, 0.2}, {1.5, -0.5, 0.2}, {1.5, 0.7, 0.2}, {0.5, 0.7, 0.2}}), {{0, 1, 2, 3}}, {}, {}};
  PictureOptions options = from_above(scene);
  const Image with = drawn(scene, options);
  options.ghost = false;
  const Image without = drawn(scene, options);
  const auto bluer = [&](const Vector3d& p) {
    float most = 0.0f;
    const glm::vec2 middle = options.camera->project(p);
    for (int dx = -1; dx <= 1; ++dx) {
      const glm::vec3 a = pixel(with, middle + glm::vec2(dx, 0)),
                      b = pixel(without, middle + glm::vec2(dx, 0));
      most = std::max(most, (a.z - a.x) - (b.z - b.x));
    }
    return most;
  };
  EXPECT_GT(bluer({0.5, 0.4, 0.2}), 0.05f);    // a line over the panel
  EXPECT_GT(bluer({0.5, -0.25, 0.2}), 0.05f);  // and beside it
  EXPECT_GT(bluer({1.3, 0.2, 0.2}), 0.005f);   // a tint between the lines

  // Just beneath the panel the line still shows, fainter.
  scene.ghost->points.col(2).array() = -0.2;
  options.ghost = true;
  const Image beneath = drawn(scene, options);
  float change = 0.0f;
  const glm::vec2 middle = options.camera->project({0.5, 0.4, -0.2});
  for (int dx = -2; dx <= 2; ++dx) {
    change = std::max(change, distance(pixel(beneath, middle + glm::vec2(dx, 0)),
                                       pixel(without, middle + glm::vec2(dx, 0))));
  }
  EXPECT_GT(change, 0.03f);
}

TEST_F(RendererTest, MarkersShowTheirKindAndShineThroughFaintly) {
  Scene scene;
  scene.panels = unit_square();
  scene.markers = {{{0.25, 0.5, 0}, Marker::Kind::Warning},
                   {{0.5, 0.5, 0}, Marker::Kind::Error},
                   {{0.75, 0.5, 0}, Marker::Kind::Selected},
                   {{0.5, 0.25, -1.0}, Marker::Kind::Error}};
  PictureOptions options = from_above(scene);
  const Image image = drawn(scene, options);
  const Palette& palette = palette_of({});
  EXPECT_LT(distance(at(image, options, {0.25, 0.5, 0}), palette.warning), 0.02f);
  EXPECT_LT(distance(at(image, options, {0.5, 0.5, 0}), palette.error), 0.02f);
  EXPECT_LT(distance(at(image, options, {0.75, 0.5, 0}), palette.selected), 0.02f);
  const glm::vec3 hidden = at(image, options, {0.5, 0.25, -1.0}), card = at(image, options, {0.1, 0.9, 0});
  EXPECT_GT(distance(hidden, card), 0.05f);
  EXPECT_GT(distance(hidden, palette.error), 0.2f);

  // Of the same size in pixels whatever the distance.
  Camera nearer = *options.camera;
  nearer.zoom(3.0, Vector3d(0.5, 0.5, 0));
  options.camera = nearer;
  const Image near_image = drawn(scene, options);
  const glm::vec2 middle = nearer.project({0.5, 0.5, 0});
  EXPECT_LT(distance(pixel(near_image, middle + glm::vec2(2, 0)), palette.error), 0.05f);
  EXPECT_GT(distance(pixel(near_image, middle + glm::vec2(10, 0)), palette.error), 0.3f);
}

TEST_F(RendererTest, SegmentsAreThickLinesInTheirColours) {
  Scene scene;
  scene.panels = unit_square();
  scene.segments = {{{0.1, 0.25, 0}, {0.9, 0.25, 0}, Segment::Kind::Suggested},
                    {{0.1, 0.5, 0}, {0.9, 0.5, 0}, Segment::Kind::Selected},
                    {{0.1, 0.75, 0}, {0.9, 0.75, 0}, Segment::Kind::Hovered}};
  const PictureOptions options = from_above(scene);
  const Image image = drawn(scene, options);
  const Palette& palette = palette_of({});
  EXPECT_LT(distance(at(image, options, {0.3, 0.25, 0}), palette.warning), 0.05f);
  EXPECT_LT(distance(at(image, options, {0.3, 0.5, 0}), palette.selected), 0.05f);
  EXPECT_LT(distance(at(image, options, {0.3, 0.75, 0}), palette.selected), 0.35f);
  EXPECT_GT(distance(at(image, options, {0.3, 0.62, 0}), palette.selected), 0.35f);
}

TEST_F(RendererTest, TheSamePictureTwiceIsTheSameBytes) {
  Scene scene;
  scene.panels = torus(24, 12);
  scene.ghost = torus(12, 6);
  scene.markers = {{{1, 0, 0.4}, Marker::Kind::Error}};
  scene.panels->polygon_values = Vector::LinSpaced(24 * 12, 0.0, 1.0);
  scene.colours = ColourScale{0.0, 1.0, "Planarity", "m", 0.5};
  PictureOptions options;
  options.width = 320;
  options.height = 200;
  options.title = "Torus";
  const auto folder = std::filesystem::path(testing::TempDir());
  std::string bytes[2];
  for (int i : {0, 1}) {
    const auto path = folder / ("planewright_same_" + std::to_string(i) + ".png");
    const auto written = render_picture(scene, options, path);
    ASSERT_TRUE(written) << written.error().text();
    std::ifstream file(path, std::ios::binary);
    bytes[i] = {std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
  }
  EXPECT_GT(bytes[0].size(), 1000u);
  EXPECT_TRUE(bytes[0] == bytes[1]);
}

TEST_F(RendererTest, UpdatedPointsAreWhereTheyAreDrawn) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer) << renderer.error().text();
  Scene scene;
  scene.panels = two_squares();
  PictureOptions options = from_above(scene);
  options.legend = false;
  renderer->set_scene(scene);
  const auto before = draw_image(*renderer, {}, options);
  ASSERT_TRUE(before);
  Points moved = scene.panels->points;
  moved(2, 0) = moved(5, 0) = 1.2;
  renderer->set_panels(make_panel_arrays(moved, scene.panels->polygons), {}, {});
  const auto after = draw_image(*renderer, {}, options);
  ASSERT_TRUE(after);
  EXPECT_LT(distance(at(*before, options, {1.6, 0.5, 0}), palette_of({}).card), 0.2f);
  EXPECT_GT(distance(at(*after, options, {1.6, 0.5, 0}), at(*before, options, {1.6, 0.5, 0})), 0.02f);
  EXPECT_LT(distance(at(*after, options, {1.1, 0.4, 0}), palette_of({}).card), 0.2f);

  Vector values(2);
  values << 0.0, 1.0;
  renderer->set_colours(ColourScale{0.0, 1.0, "Planarity", "mm", {}});
  renderer->set_panels(make_panel_arrays(scene.panels->points, scene.panels->polygons), values, {});
  const auto coloured = draw_image(*renderer, {}, options);
  ASSERT_TRUE(coloured);
  EXPECT_LT(grey(at(*coloured, options, {0.5, 0.4, 0})), 0.35f);
  EXPECT_GT(grey(at(*coloured, options, {1.5, 0.4, 0})), 0.6f);
  std::swap(values[0], values[1]);
  renderer->set_panel_values(values, {});
  const auto swapped = draw_image(*renderer, {}, options);
  ASSERT_TRUE(swapped);
  EXPECT_GT(grey(at(*swapped, options, {0.5, 0.4, 0})), 0.6f);
  EXPECT_LT(grey(at(*swapped, options, {1.5, 0.4, 0})), 0.35f);
}

TEST_F(RendererTest, ArraysFromElsewhereDrawTheSamePictureAsAScene) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto whole = Renderer::create(), parts = Renderer::create();
  ASSERT_TRUE(whole && parts);
  Scene scene;
  scene.panels = torus(9, 7);
  scene.ghost = torus(11, 8);
  const PictureOptions options = from_above(scene);

  // Other panels, then none, and another ghost come first: nothing of them may stay.
  const PolygonLayer other = letter_l();
  parts->set_panels(make_panel_arrays(other.points, other.polygons), {}, {});
  parts->set_ghost(std::make_shared<const GhostArrays>(make_ghost_arrays(other.points, other.polygons)));
  parts->set_panels({}, {}, {});
  parts->set_ghost(nullptr);
  const auto nothing = draw_image(*parts, {}, options);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->rgba == drawn({}, options).rgba);

  whole->set_scene(scene);
  parts->set_ghost(
      std::make_shared<const GhostArrays>(make_ghost_arrays(scene.ghost->points, scene.ghost->polygons)));
  parts->set_panels(make_panel_arrays(scene.panels->points, scene.panels->polygons), {}, {});
  const auto a = draw_image(*whole, {}, options), b = draw_image(*parts, {}, options);
  ASSERT_TRUE(a && b);
  EXPECT_TRUE(a->rgba == b->rgba);
  EXPECT_FALSE(a->rgba == nothing->rgba);
}

TEST_F(RendererTest, HandsTenThousandPanelsOverInLittleTime) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer);
  const PolygonLayer layer = torus(100, 100), turned = torus(100, 101);
  const PanelArrays arrays[] = {make_panel_arrays(layer.points, layer.polygons),
                                make_panel_arrays(turned.points, turned.polygons)};
  double best = 1e9;
  for (int i = 0; i < 6; ++i) {
    const auto start = std::chrono::steady_clock::now();
    renderer->set_panels(arrays[i % 2], {}, {});  // other polygons each time
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
    best = std::min(best, taken.count());
  }
  EXPECT_LT(best, 5.0);  // milliseconds
}

TEST_F(RendererTest, PanelsThatBecomeConcaveKeepTheirOutline) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer);
  Scene scene;
  scene.panels = letter_l();
  PictureOptions options = from_above(scene);
  renderer->set_scene(scene);
  // The notch moves from the upper right to the upper left.
  const Points moved = rows({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}});
  renderer->set_panels(
      make_panel_arrays(moved, scene.panels->polygons,
                        make_panel_arrays(scene.panels->points, scene.panels->polygons).geometry),
      {}, {});
  const auto image = draw_image(*renderer, {}, options);
  ASSERT_TRUE(image);
  const glm::vec3 face = at(*image, options, {0.7, 0.4, 0});
  for (const auto& [x, y] :
       {std::pair{1.5, 1.5}, std::pair{1.2, 0.9}, std::pair{0.3, 0.8}, std::pair{1.7, 0.3}}) {
    EXPECT_LT(distance(at(*image, options, {x, y, 0}), face), 0.01f);
  }
  EXPECT_GT(distance(at(*image, options, {0.5, 1.5, 0}), face), 0.02f);
}

TEST_F(RendererTest, DrawsOnlyIntoItsRectangle) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer);
  const GlFramebuffer framebuffer = GlFramebuffer::create();
  const GlRenderbuffer colour = GlRenderbuffer::create(), depth = GlRenderbuffer::create();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glBindRenderbuffer(GL_RENDERBUFFER, colour.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 100, 80);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour.get());
  glBindRenderbuffer(GL_RENDERBUFFER, depth.get());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 100, 80);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth.get());
  glClearColor(1.0f, 0.0f, 1.0f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT);

  Scene scene;
  scene.panels = cube();
  renderer->set_scene(scene);
  Camera camera;
  camera.set_viewport(50, 40);
  camera.fit(scene.panels->points);
  camera.zoom(4.0, glm::vec2(25, 20));
  renderer->draw(camera, {20, 10, 50, 40}, {});
  EXPECT_EQ(take_gl_errors(), "");
  EXPECT_FALSE(glIsEnabled(GL_SCISSOR_TEST));
  EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST));

  std::vector<std::uint8_t> rgba(100 * 80 * 4);
  glReadPixels(0, 0, 100, 80, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool untouched = rgba[4 * (y * 100 + x) + 1] == 0 && rgba[4 * (y * 100 + x)] == 255;
      const bool inside = x >= 20 && x < 70 && y >= 10 && y < 50;
      ASSERT_EQ(untouched, !inside) << x << ", " << y;
    }
  }
}

TEST_F(RendererTest, SurvivesOddScenes) {
  PictureOptions options;
  options.width = 64;
  options.height = 48;
  Scene scene;
  scene.panels = PolygonLayer{};
  scene.ghost = PolygonLayer{};
  drawn(scene, options);
  scene.panels = unit_square();
  scene.panels->points(0, 0) = std::nan("");
  scene.markers = {{{std::nan(""), 0, 0}, Marker::Kind::Error}};
  scene.segments = {{{0, 0, 0}, {0, 0, 0}, Segment::Kind::Selected}};
  drawn(scene, options);
}

TEST_F(RendererTest, RefusesPicturesThatCannotBe) {
  for (const auto& [width, height] : {std::pair{0, 100}, std::pair{100, -3}, std::pair{1000000, 100}}) {
    PictureOptions options;
    options.width = width;
    options.height = height;
    const auto image = render_image({}, options);
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, ErrorCode::Usage);
  }
  const auto written = render_picture({}, {}, "/no/such/folder/a.png");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::Unwritable);
}

TEST_F(RendererTest, ReadsShadersFromAFolderAndReloadsThem) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  const auto missing = Renderer::create("/no/such/folder");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::Unreadable);

  const auto folder = std::filesystem::path(testing::TempDir()) / "planewright_shaders";
  std::filesystem::create_directories(folder);
  for (const char* name : {"backdrop", "shadow", "panel", "ghost", "line", "marker"}) {
    for (const char* stage : {".vert", ".frag"}) {
      std::ofstream(folder / (std::string(name) + stage)) << embedded_shader(std::string(name) + stage);
    }
  }
  auto renderer = Renderer::create(folder);
  ASSERT_TRUE(renderer) << renderer.error().text();
  EXPECT_TRUE(renderer->reload_changed_shaders());

  std::ofstream(folder / "panel.frag") << "#version 330 core\nthis is no shader\n";
  std::filesystem::last_write_time(folder / "panel.frag",
                                   std::filesystem::file_time_type::clock::now() + std::chrono::seconds(2));
  const auto broken = renderer->reload_changed_shaders();
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().where, "panel.frag");
  EXPECT_TRUE(renderer->reload_changed_shaders());  // said once
  PictureOptions options = from_above({}, 32, 32);
  EXPECT_TRUE(draw_image(*renderer, {}, options));  // the old ones still draw
  std::filesystem::remove_all(folder);
}

TEST_F(RendererTest, SelectedPanelsAreTintedAndTheOthersAreNot) {
  Scene scene;
  scene.panels = two_squares();
  const PictureOptions options = from_above(scene);
  const Image plain = drawn(scene, options);
  scene.selected = {1};
  const Image tinted = drawn(scene, options);
  const Palette& palette = palette_of({});
  EXPECT_LT(distance(at(tinted, options, {0.5, 0.4, 0}), at(plain, options, {0.5, 0.4, 0})), 0.005f);
  const glm::vec3 before = at(plain, options, {1.5, 0.4, 0}), after = at(tinted, options, {1.5, 0.4, 0});
  EXPECT_GT(distance(after, before), 0.08f);
  EXPECT_LT(distance(after, palette.selected), distance(before, palette.selected));
}

TEST_F(RendererTest, RegionsHaveTheirColoursAndPanelsLieOverThemAsGlass) {
  const auto context = EglContext::create();
  ASSERT_TRUE(context);
  auto renderer = Renderer::create();
  ASSERT_TRUE(renderer);
  const PolygonLayer squares = two_squares();
  Scene scene;
  scene.panels = squares;
  PictureOptions options = from_above(scene);
  const auto regions = std::make_shared<RegionArrays>();
  regions->faces = make_panel_arrays(squares.points, squares.polygons);
  regions->colours = Vector{{2.0, 5.0}};
  renderer->set_regions(regions);
  const auto draw = [&](Renderer::What what) {
    options.what = what;
    auto image = draw_image(*renderer, {}, options);
    EXPECT_TRUE(image);
    return image ? std::move(*image) : Image{};
  };
  // Lit from above, each is nearer to its own entry of the palette than to any other.
  for (const bool dark : {false, true}) {
    options.theme.dark = dark;
    const Palette& palette = palette_of(options.theme);
    const Image image = draw(Renderer::What::Regions);
    for (const auto& [place, own] :
         {std::pair(Vector3d(0.5, 0.4, 0), 2), std::pair(Vector3d(1.5, 0.4, 0), 5)}) {
      const glm::vec3 seen = at(image, options, place);
      for (int other = 0; other < kRegionColours; ++other) {
        if (other == own) continue;
        EXPECT_LT(distance(glm::normalize(seen), glm::normalize(palette.regions[own])),
                  distance(glm::normalize(seen), glm::normalize(palette.regions[other])))
            << own << " and " << other;
      }
    }
  }
  options.theme.dark = false;
  const glm::vec3 bare = at(draw(Renderer::What::Over), options, {0.5, 0.4, 0});
  EXPECT_LT(distance(bare, at(draw(Renderer::What::Regions), options, {0.5, 0.4, 0})), 0.005f)
      << "no panels yet";

  // Panels beneath the regions, too: as glass they are over everything.
  PolygonLayer lower = squares;
  lower.points.col(2).array() -= 0.01;
  renderer->set_panels(make_panel_arrays(lower.points, lower.polygons), {}, {});
  const glm::vec3 over = at(draw(Renderer::What::Over), options, {0.5, 0.4, 0});
  const glm::vec3 card = at(draw(Renderer::What::Panels), options, {0.5, 0.4, 0});
  EXPECT_GT(distance(over, bare), 0.02f);
  EXPECT_GT(distance(over, card), 0.02f);
  EXPECT_NEAR(distance(over, bare) + distance(over, card), distance(bare, card), 0.02f) << "between the two";

  // What is selected is tinted, the rest is not.
  renderer->set_region_marks(triangles_of(regions->faces, {1}), {}, {});
  const Image marked = draw(Renderer::What::Regions);
  EXPECT_LT(distance(at(marked, options, {0.5, 0.4, 0}), bare), 0.005f);
  const Palette& palette = palette_of({});
  EXPECT_LT(distance(at(marked, options, {1.5, 0.4, 0}), palette.selected),
            distance(palette.regions[5], palette.selected));
}

TEST_F(RendererTest, FurtherLayersHaveTonesOfTheirOwnAndHideWhatIsBehind) {
  Scene scene;
  scene.panels = two_squares();
  scene.further = {{Tone::OtherLayer, unit_square(0.5)}, {Tone::Beam, unit_square(-0.5)}};
  const PictureOptions options = from_above(scene);
  const Image image = drawn(scene, options);
  const glm::vec3 other = at(image, options, {0.5, 0.4, 0.5}), own = at(image, options, {1.5, 0.4, 0});
  EXPECT_LT(grey(other), grey(own) - 0.03f) << "quieter than the layer that is worked on";
  EXPECT_GT(grey(other), 0.5f);
  scene.further = {{Tone::Beam, unit_square(0.5)}};
  const glm::vec3 beam = at(drawn(scene, options), options, {0.5, 0.4, 0.5});
  EXPECT_LT(grey(beam), grey(other) - 0.2f) << "beams are dark";
  scene.further.clear();
  EXPECT_LT(distance(at(drawn(scene, options), options, {0.5, 0.4, 0}), own), 0.02f);
}

}  // namespace
}  // namespace planewright::render
