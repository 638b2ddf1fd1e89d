// sample, check and render through the real binary.
#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/sample_shapes.h"
#include "ui/render/egl_context.h"

namespace planewright {
namespace {

using test::Ended;

class OtherCommands : public test::CommandLineTest {};

TEST_F(OtherCommands, EverySampleIsWrittenAndHealthy) {
  for (const SampleInfo& info : samples()) {
    const std::string name(info.name);
    const Ended made = run({"sample", name, "--panels", "150", "-o", path(name + ".ply")});
    ASSERT_EQ(made.status, 0) << name << made.err;
    const auto mesh = load_mesh(path(name + ".ply")).value();
    EXPECT_TRUE(mesh.health.healthy()) << name;
    const int panels = info.triangles ? mesh.mesh.vertex_count() : mesh.mesh.face_count();
    EXPECT_NEAR(panels, 150, 38) << name;
    EXPECT_NE(made.out.find(std::to_string(mesh.mesh.face_count()) + " faces"), std::string::npos);
  }
}

TEST_F(OtherCommands, SampleRefusesUnknownNamesAndCounts) {
  const Ended unknown = run({"sample", "castle", "-o", path("a.obj")});
  expect_refusal(unknown, 2, {"castle"});
  for (const SampleInfo& info : samples()) EXPECT_NE(unknown.err.find(info.name), std::string::npos);
  expect_refusal(run({"sample", "dome", "--panels", "3", "-o", path("a.obj")}), 2, {});
  EXPECT_EQ(run({"sample", "dome", "--panels", "some", "-o", path("a.obj")}).status, 2);
  expect_refusal(run({"sample", "dome", "-o", path("a.3dm")}), 2, {".obj"});
  expect_refusal(run({"sample", "dome", "-o", path("no/a.obj")}), 5, {"no/a.obj"});
  EXPECT_EQ(files(), 0);
}

TEST_F(OtherCommands, CheckTellsPlanarFromNot) {
  folder_.write("bent.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.4\nv 0 1 0\nf 1 2 3 4\n");
  const Ended bent = run({"check", path("bent.obj")});
  EXPECT_EQ(bent.status, 1);
  EXPECT_NE(bent.out.find("not planar: 1 of 1 faces"), std::string::npos) << bent.out;
  EXPECT_NE(bent.out.find("health: healthy"), std::string::npos) << bent.out;
  // The corners are 0.1 off the best plane, nearly.
  EXPECT_EQ(run({"check", path("bent.obj"), "--tolerance", "0.11"}).status, 0);
  EXPECT_EQ(run({"check", path("bent.obj"), "--tolerance", "0.08"}).status, 1);
  EXPECT_EQ(run({"check", path("bent.obj"), "--tolerance", "-1"}).status, 2);
}

TEST_F(OtherCommands, CheckListsDefects) {
  folder_.write("fan.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 7 7 7\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  const Ended check = run({"check", path("fan.obj")});
  EXPECT_EQ(check.status, 1);
  EXPECT_NE(check.out.find("non-manifold edge: 1"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("at 0-1"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("isolated vertex: 1"), std::string::npos) << check.out;
  EXPECT_NE(check.out.find("at 5"), std::string::npos) << check.out;
}

TEST_F(OtherCommands, CheckRefusesWhatItCannotRead) {
  expect_refusal(run({"check", path("none.off")}), 3, {"none.off"});
  expect_refusal(run({"check", folder_.path().string()}), 3, {"folder"});
}

TEST_F(OtherCommands, RenderWritesAPng) {
  if (const auto context = render::EglContext::create(); !context) GTEST_SKIP() << context.error().text();
  const std::string input = sample("dome", 100);
  for (const std::vector<std::string>& options :
       {std::vector<std::string>{}, {"--dark", "--planarity"}, {"--ghost", input}}) {
    std::vector<std::string> arguments{"render",  input, "-o",       path("p.png"),
                                       "--width", "320", "--height", "200"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ended drawn = run(arguments);
    ASSERT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_NE(drawn.out.find("320 x 200"), std::string::npos);
    const std::string png = test::text_of(path("p.png"));
    ASSERT_GT(png.size(), 2000u);
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    // Width and height stand in the first chunk.
    EXPECT_EQ(png.substr(16, 8), std::string("\0\0\1\x40\0\0\0\xc8", 8));
  }
}

// Width and height of a PNG, big endian in its first chunk.
std::pair<int, int> size_of(const std::string& png) {
  const auto number = [&](size_t at) {
    int value = 0;
    for (size_t k = 0; k < 4; ++k) value = 256 * value + static_cast<unsigned char>(png.at(at + k));
    return value;
  };
  return {number(16), number(20)};
}

TEST_F(OtherCommands, RenderComparesSeveralMeshesInOneSheet) {
  if (const auto context = render::EglContext::create(); !context) GTEST_SKIP() << context.error().text();
  const std::string dome = sample("dome", 50), vault = sample("vault", 50);
  const auto draw = [&](std::vector<std::string> options) {
    options.insert(options.begin(), "render");
    for (const char* word : {"-o", "", "--width", "604", "--height", "404"}) options.emplace_back(word);
    *(options.end() - 5) = path("sheet.png");
    const Ended drawn = run(options);
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    return test::text_of(path("sheet.png"));
  };
  // Two pictures of 301 beside each other with 2 pixels between them; the same in two rows of 201.
  const std::string one = draw({dome}), two = draw({dome, vault});
  EXPECT_EQ(size_of(two), std::pair(604, 404));
  EXPECT_EQ(size_of(draw({dome, vault, dome, "--columns", "2"})), std::pair(604, 404));
  EXPECT_NE(one, two);
  EXPECT_NE(two, draw({vault, dome}));
  EXPECT_NE(two, draw({dome, vault, "--caption", "left", "--caption", "right"}));
  // Another direction, closer, another centre: each shows.
  const std::string turned = draw({dome, "--view=-90:40"}), closer = draw({dome, "--view=-90:40:2"});
  EXPECT_NE(turned, one);
  EXPECT_NE(closer, turned);
  EXPECT_NE(draw({dome, "--view=-90:40:2:3:0:0"}), closer);
}

TEST_F(OtherCommands, RenderMarksPanelsThatCross) {
  if (const auto context = render::EglContext::create(); !context) GTEST_SKIP() << context.error().text();
  // Two squares side by side, and an upright triangle through the right one; then a square that crosses
  // itself.
  folder_.write("squares.obj",
                "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n");
  folder_.write("through.obj", "v 1.2 0.5 -1\nv 1.8 0.5 -1\nv 1.5 0.5 1\nf 1 2 3\n");
  folder_.write("above.obj", "v 1.2 0.5 0.1\nv 1.8 0.5 0.1\nv 1.5 0.5 1\nf 1 2 3\n");
  folder_.write("bow.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3 4\n");
  const auto draw = [&](const std::string& input, std::vector<std::string> options) {
    options.insert(options.begin(),
                   {"render", path(input), "-o", path("p.png"), "--width", "200", "--height", "160"});
    const Ended drawn = run(options);
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    return drawn.out;
  };
  const auto mark = [&](const std::string& input, const std::string& with) {
    return draw(input, {"--with", path(with), "--mark-crossings"});
  };
  EXPECT_NE(mark("squares.obj", "through.obj").find("through.obj: 1\n"), std::string::npos);
  const std::string marked = test::text_of(path("p.png"));
  draw("squares.obj", {"--with", path("through.obj")});
  EXPECT_NE(test::text_of(path("p.png")), marked);
  EXPECT_NE(mark("squares.obj", "above.obj").find("above.obj: 0\n"), std::string::npos);
  EXPECT_NE(draw("bow.obj", {"--mark-crossings"}).find("cross themselves: 1\n"), std::string::npos);
}

TEST_F(OtherCommands, RenderRefuses) {
  const std::string input = sample("dome", 50);
  expect_refusal(run({"render", path("none.obj"), "-o", path("p.png")}), 3, {"none.obj"});
  expect_refusal(run({"render", input, "--ghost", path("none.obj"), "-o", path("p.png")}), 3, {"none.obj"});
  expect_refusal(run({"render", input, "--with", path("none.obj"), "-o", path("p.png")}), 3, {"none.obj"});
  EXPECT_EQ(run({"render", input, "-o", path("p.png"), "--width", "5"}).status, 2);
  expect_refusal(
      run({"render", input, input, input, "--caption", "a", "--caption", "b", "-o", path("p.png")}), 2,
      {"--caption", "3 meshes"});
  for (const char* view : {"north", "1", "1:2:0", "1:2:3:4", "1:2:x"})
    expect_refusal(run({"render", input, "--view", view, "-o", path("p.png")}), 2, {view});
  expect_refusal(run({"render", input, input, input, "-o", path("p.png"), "--width", "40"}), 2, {"too few"});
  EXPECT_FALSE(exists("p.png"));
  if (!render::EglContext::create()) return;
  expect_refusal(run({"render", input, "-o", path("no/p.png")}), 5, {"no/p.png"});
}

}  // namespace
}  // namespace planewright
