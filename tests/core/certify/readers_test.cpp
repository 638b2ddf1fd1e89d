// Each reader by itself: what it makes of good text, and that it refuses what is broken.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/certify/csv_reader.h"
#include "core/certify/dxf_groups.h"
#include "core/certify/dxf_reader.h"
#include "core/certify/pdf_reader.h"
#include "core/certify/ply_reader.h"
#include "core/certify/svg_numbers.h"
#include "core/certify/svg_reader.h"
#include "support/certify_sample.h"

namespace planewright {
namespace {

using sample::replaced;

TEST(DxfReader, KeepsEveryDigitThatDimeLoses) {
  const sample::Strip strip;
  for (const bool r12 : {false, true}) {
    strip.write("a.dxf", strip.dxf(r12));
    const auto read = read_dxf(strip.folder / "a.dxf");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->disagreements.empty()) << read->disagreements.front();
    const Drawing& wanted = strip.content.drawings[0];
    ASSERT_EQ(read->drawing.lines.size(), wanted.lines.size());
    for (size_t i = 0; i < wanted.lines.size(); ++i)
      EXPECT_EQ(read->drawing.lines[i].points, wanted.lines[i].points);
    EXPECT_EQ(read->drawing.texts.size(), wanted.texts.size());
    EXPECT_EQ(read->drawing.mm_per_unit, 1.0);
  }
}

TEST(DxfReader, InchesBecomeMillimetres) {
  const sample::Strip strip;
  const auto read = read_dxf_groups(replaced(strip.dxf(), "$INSUNITS\n70\n4", "$INSUNITS\n70\n1"), "a.dxf");
  ASSERT_TRUE(read);
  EXPECT_NEAR((*read->size)[0], 150.0 * 25.4, 1e-9);
}

TEST(DxfReader, RefusesWhatIsBroken) {
  const sample::Strip strip;
  const std::string good = strip.dxf();
  EXPECT_FALSE(read_dxf_groups(good.substr(0, good.size() / 2), "a.dxf"));
  EXPECT_FALSE(read_dxf_groups("garbage", "a.dxf"));
  EXPECT_FALSE(read_dxf_groups(replaced(good, "90\n4", "90\n5"), "a.dxf"));
  EXPECT_FALSE(read_dxf_groups(replaced(good, "LWPOLYLINE", "SPLINE"), "a.dxf"));
  EXPECT_FALSE(read_dxf_groups(replaced(good, "10\n150", "10\n1x50"), "a.dxf"));
  EXPECT_FALSE(read_dxf(strip.folder / "none.dxf"));
}

TEST(SvgReader, NumbersTransformsAndPaths) {
  EXPECT_DOUBLE_EQ(svg_length("2in").value(), 50.8);
  EXPECT_FALSE(svg_length("50%"));
  EXPECT_EQ(svg_numbers("1-2, 3e1").value(), (std::vector<double>{1.0, -2.0, 30.0}));
  EXPECT_FALSE(svg_numbers("1 x"));
  const auto t = svg_transform("translate(10,20) scale(2)");
  ASSERT_TRUE(t);
  EXPECT_TRUE(((*t * Eigen::Vector2d(1.0, 1.0)) - Eigen::Vector2d(12.0, 22.0)).isZero());
  EXPECT_FALSE(svg_transform("skewX(3)"));
  const auto path = svg_path("M1 2 L3 2 v4 h-2 z m10 0 l1 1");
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 2u);
  EXPECT_TRUE(path->front().closed);
  EXPECT_EQ(path->front().points[3], Eigen::Vector2d(1.0, 6.0));
  EXPECT_EQ(path->back().points[1], Eigen::Vector2d(12.0, 3.0));
  EXPECT_FALSE(svg_path("M0 0 C1 1 2 2 3 3"));
}

TEST(SvgReader, TransformsOfGroupsAdd) {
  const sample::Strip strip;
  strip.write("a.svg",
              "<svg xmlns='http://www.w3.org/2000/svg' width='10cm' height='50mm' viewBox='0 0 200 100'>"
              "<g transform='translate(10 0)'><path transform='scale(2)' d='M0 0 h10 v10 z'/></g></svg>");
  const auto read = read_svg(strip.folder / "a.svg");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->lines.size(), 1u);
  EXPECT_NEAR(read->lines[0].points(0, 0), 5.0, 1e-12);
  EXPECT_NEAR(read->lines[0].points(2, 0), 15.0, 1e-12);
  EXPECT_NEAR(read->lines[0].points(2, 1), 40.0, 1e-12);
}

TEST(CsvReader, QuotesAndLineEnds) {
  const auto read = read_csv("a,b\r\n\"1,\"\"x\"\"\r\n2\",\r\n", "a.csv");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->rows, (std::vector<std::vector<std::string>>{{"1,\"x\"\r\n2", ""}}));
  for (const char* broken :
       {"a,b\n1,2\n", "a,b\r\n1\r\n", "a,b\r\n1,2", "a,b\r\n\"1,2\r\n", "a\r\n1\"2\r\n", "", "a,b\r\n1,"})
    EXPECT_FALSE(read_csv(broken, "a.csv")) << broken;
}

TEST(PlyReader, BinaryOfBothEnds) {
  const sample::Strip strip;
  const std::string head =
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const bool little : {true, false}) {
    std::string body;
    const auto append = [&](auto value) {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      if (!little) std::reverse(bytes, bytes + sizeof value);
      body.append(bytes, sizeof value);
    };
    for (const double v : {0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, -0.7}) append(v);
    append(std::uint8_t{3});
    for (const int v : {0, 1, 2}) append(v);
    const std::string format = little ? "binary_little_endian" : "binary_big_endian";
    strip.write("a.ply", "ply\nformat " + format + " 1.0\n" + head + body);
    const auto read = read_ply_file(strip.folder / "a.ply");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->points(0, 0), 0.1);
    EXPECT_EQ(read->points(2, 2), -0.7);
    strip.write("b.ply", "ply\nformat " + format + " 1.0\n" + head + body.substr(1));
    EXPECT_FALSE(read_ply_file(strip.folder / "b.ply"));
  }
}

TEST(PdfReader, PathsAndTextsInMillimetres) {
  const sample::Strip strip;
  strip.write("a.pdf", strip.pdf());
  const auto read = read_pdf(strip.folder / "a.pdf");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->size(), 2u);
  EXPECT_NEAR(read->front().width, 420.0, 1e-9);
  EXPECT_EQ(read->back().lines.size(), strip.content.drawings[0].lines.size());
  EXPECT_EQ(read->back().texts.size(), strip.content.drawings[0].texts.size() + 2);
  EXPECT_EQ(read->back().texts.back().text, "Scale 1:2");
}

}  // namespace
}  // namespace planewright
