// What pictures are made of besides OpenGL: PNG, text, legend, the ground's shadow.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "test_layers.h"
#include "ui/render/colour_map.h"
#include "ui/render/ground_shadow.h"
#include "ui/render/legend.h"
#include "ui/render/palette.h"
#include "ui/render/panel_geometry.h"
#include "ui/render/png.h"
#include "ui/render/text.h"

namespace planewright::render {
namespace {

Image blank(int width, int height, std::uint8_t shade = 255) {
  return {width, height, std::vector<std::uint8_t>(static_cast<size_t>(width) * height * 4, shade)};
}

std::optional<GroundShadow> shadow_of(const PolygonLayer& layer) {
  return make_ground_shadow(layer.points, make_panel_geometry(layer.points, layer.polygons).corners);
}

int changed_pixels(const Image& image, std::uint8_t shade = 255) {
  return static_cast<int>(
      std::count_if(image.rgba.begin(), image.rgba.end(), [&](auto v) { return v != shade; }));
}

std::filesystem::path scratch_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      std::filesystem::path(testing::TempDir()) / (std::string("planewright_") + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

TEST(Png, WritesAWholeFileOrNone) {
  const auto folder = scratch_folder();
  ASSERT_TRUE(write_png(blank(17, 9), folder / "a.png"));
  std::ifstream file(folder / "a.png", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(bytes, encode_png(blank(17, 9)));
  ASSERT_GT(bytes.size(), 24u);
  EXPECT_EQ(bytes.substr(1, 3), "PNG");
  EXPECT_EQ(bytes[19], 17);
  EXPECT_EQ(bytes[23], 9);

  const auto refused = write_png(blank(4, 4), folder / "missing" / "a.png");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::Unwritable);
}

TEST(FontFile, TakesTheFirstThatIsAFile) {
  const auto folder = scratch_folder();
  std::ofstream(folder / "b.ttf") << "b";
  std::ofstream(folder / "c.ttf") << "c";
  EXPECT_EQ(first_readable({folder / "a.ttf", folder, folder / "b.ttf", folder / "c.ttf"}), folder / "b.ttf");
  EXPECT_FALSE(first_readable({folder / "a.ttf"}));
  EXPECT_FALSE(font_candidates(FontWeight::Regular).empty());
}

TEST(Text, DrawsLettersWhereAFontIsFound) {
  const TextPen pen;
  if (!pen.has_font()) GTEST_SKIP() << "no font on this machine";
  Image image = blank(200, 40);
  pen.draw(image, "Panel 17 × 10⁻³", 10.0f, 30.0f, 16.0f, {0, 0, 0});
  EXPECT_GT(changed_pixels(image), 200);
  EXPECT_GT(pen.width("Planarity", 16.0f), 40.0f);
  EXPECT_NEAR(pen.width("Planarity", 32.0f), 2.0f * pen.width("Planarity", 16.0f), 0.5f);
  EXPECT_GT(pen.width("\xff\xe2\x82", 16.0f), 0.0f);  // no UTF-8: replacement signs, no crash
}

TEST(Text, WithoutAFontNothingIsDrawn) {
  const TextPen pen(std::filesystem::path("/no/such/font.ttf"));
  EXPECT_FALSE(pen.has_font());
  Image image = blank(50, 20);
  pen.draw(image, "Panel", 2.0f, 15.0f, 12.0f, {0, 0, 0});
  EXPECT_EQ(changed_pixels(image), 0);
  EXPECT_EQ(pen.width("Panel", 12.0f), 0.0f);
}

TEST(Legend, NumbersHaveThreeDigitsAndReadableExponents) {
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(2.0), "2");
  EXPECT_EQ(short_number(1.849), "1.85");
  EXPECT_EQ(short_number(0.0256), "0.0256");
  EXPECT_EQ(short_number(12.34), "12.3");
  EXPECT_EQ(short_number(1234.5), "1234");
  EXPECT_EQ(short_number(-0.5), "−0.5");
  EXPECT_EQ(short_number(2.1e-10), "2.1 × 10⁻¹⁰");
  EXPECT_EQ(short_number(1e-9), "10⁻⁹");
  EXPECT_EQ(short_number(3e7), "3 × 10⁷");
  EXPECT_EQ(short_number(std::nan("")), "–");
}

TEST(Legend, BarRunsThroughTheMapWithItsBreak) {
  const ColourScale colours{0.0, 2.0, "Planarity", "mm", 1.0};
  Image image = blank(600, 300);
  draw_legend(image, colours, {}, 1.0f);
  const auto shows = [&](double value) {
    const glm::vec3 wanted = 255.0f * colour_of(colours, value);
    for (size_t i = 0; i < image.rgba.size(); i += 4) {
      if (std::abs(image.rgba[i] - wanted.x) < 3 && std::abs(image.rgba[i + 1] - wanted.y) < 3 &&
          std::abs(image.rgba[i + 2] - wanted.z) < 3) {
        return true;
      }
    }
    return false;
  };
  for (double value : {0.02, 0.5, 0.95, 1.1, 1.5, 1.98}) EXPECT_TRUE(shows(value)) << value;
  // The gap that the break cuts out of the map is nowhere.
  const glm::vec3 left_out = 255.0f * viridis(0.66f);
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    EXPECT_FALSE(std::abs(image.rgba[i] - left_out.x) < 3 && std::abs(image.rgba[i + 1] - left_out.y) < 3 &&
                 std::abs(image.rgba[i + 2] - left_out.z) < 3);
  }
}

TEST(Legend, FitsIntoAnyPicture) {
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{40, 30}, std::pair{3000, 200}}) {
    Image image = blank(width, height);
    draw_legend(image, {1.0, 1.0, "x", "", 1.0}, {true}, 2.0f);
    draw_title(image, "A title longer than the picture", {}, 2.0f);
  }
}

TEST(GroundShadow, LiesUnderTheModelAndFadesOut) {
  const auto shadow = shadow_of(cube());
  ASSERT_TRUE(shadow);
  EXPECT_EQ(shadow->low.z(), -1.0);
  EXPECT_LT(shadow->low.x(), -1.0);
  EXPECT_GT(shadow->high.y(), 1.0);
  const int n = GroundShadow::kCells;
  EXPECT_GT(shadow->darkness[n / 2 * n + n / 2], 150);
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(shadow->darkness[i], 0);
    EXPECT_EQ(shadow->darkness[i * n + n - 1], 0);
  }
}

TEST(GroundShadow, OddLayersHaveNone) {
  EXPECT_FALSE(shadow_of({}));
  PolygonLayer layer = unit_square();
  layer.points(1, 1) = std::nan("");
  const auto shadow = shadow_of(layer);
  EXPECT_TRUE(!shadow || shadow->low.allFinite());
  PolygonLayer wall{rows({{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}), {{0, 1, 2, 3}}, {}, {}};
  EXPECT_TRUE(shadow_of(wall));  // seen from above a line: a rectangle without darkness
}

}  // namespace
}  // namespace planewright::render
