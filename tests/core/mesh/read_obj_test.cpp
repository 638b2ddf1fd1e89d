#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"

namespace planewright {
namespace {

Result<PolygonSoup> parse(std::string_view text) {
  return parse_mesh(text, MeshFormat::Obj, "a.obj");
}

PolygonSoup parsed(std::string_view text) {
  auto soup = parse(text);
  EXPECT_TRUE(soup) << soup.error().text();
  return soup ? std::move(*soup) : PolygonSoup{};
}

void expect_error(std::string_view text, const std::string& where, const std::string& what) {
  const auto soup = parse(text);
  ASSERT_FALSE(soup);
  EXPECT_EQ(soup.error().code, ErrorCode::Unreadable);
  EXPECT_EQ(soup.error().where, where);
  EXPECT_NE(soup.error().what.find(what), std::string::npos) << soup.error().text();
  EXPECT_FALSE(soup.error().remedy.empty());
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ReadObj, ReadsPlainFile) {
  const PolygonSoup soup = parsed("# comment\n  # another\no roof\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(soup.positions, test::make_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup.faces, (Polygons{{0, 1, 2}}));
}

TEST(ReadObj, ReadsAttributesAndPassesOverTheRest) {
  const PolygonSoup soup = parsed(
      "mtllib a.mtl\nvt 0 0\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ns off\nusemtl white\n"
      "f 1/1 2/1 4/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 3/1/1\nl 1 2\np 1\n");
  EXPECT_EQ(soup.faces, (Polygons{{0, 1, 3, 2}, {0, 1, 2}, {0, 1, 2}}));
}

TEST(ReadObj, ReadsNegativeIndices) {
  const PolygonSoup soup = parsed(std::string(kTriangle) + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
  EXPECT_EQ(soup.faces, (Polygons{{0, 1, 2}, {0, 1, 3}}));
}

TEST(ReadObj, ReadsFacesBeforeTheirVertices) {
  EXPECT_EQ(parsed(std::string("f 1 2 3\n") + kTriangle).faces, (Polygons{{0, 1, 2}}));
}

TEST(ReadObj, ReadsContinuedLines) {
  const PolygonSoup soup = parsed("v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n2\\\n 3\n");
  EXPECT_EQ(soup.positions.rows(), 3);
  EXPECT_EQ(soup.faces, (Polygons{{0, 1, 2}}));
  expect_error("v 0 0 \\\n0\nv 1 0 x\n", "a.obj:3", "\"x\" is not a number");
}

TEST(ReadObj, ReadsColoursAndWeightsAfterCoordinates) {
  EXPECT_EQ(parsed("v 0 0 0 0.5 0.5 0.5\nv 1 0 0 1.0\nv 0 1 0 # here\nf 1 2 3").positions.rows(), 3);
}

TEST(ReadObj, ReadsEveryLineEndAndByteOrderMark) {
  for (const char* text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "\xEF\xBB\xBFv 0 0 0\n\n\tv 1 0 0  \nv 0 1 0\nf 1 2 3"}) {
    const PolygonSoup soup = parsed(text);
    EXPECT_EQ(soup.positions.rows(), 3);
    EXPECT_EQ(soup.faces, (Polygons{{0, 1, 2}}));
  }
  expect_error("v 0 0 0\rv 1 x 0\r", "a.obj:2", "\"x\"");
  expect_error("v 0 0 0\r\n\r\nv 1 x 0\r\n", "a.obj:3", "\"x\"");
}

TEST(ReadObj, ReadsNumbersInEverySpelling) {
  const PolygonSoup soup = parsed("v +1.5 -.5 1e2\nv 1E-3 5. 007\nv 1e-400 0 0\nf 1 2 3\n");
  EXPECT_EQ(soup.positions, test::make_points({{1.5, -0.5, 100}, {0.001, 5, 7}, {0, 0, 0}}));
}

TEST(ReadObj, NamesTheLineOfABadVertex) {
  expect_error("v 0 0 0\nv 1 0\n", "a.obj:2", "2 coordinates");
  expect_error("v 1 2 abc\n", "a.obj:1", "\"abc\" is not a number");
  expect_error("v 1 2 1,5\n", "a.obj:1", "\"1,5\" is not a number");
  expect_error("v 1 2 0x10\n", "a.obj:1", "not a number");
  expect_error("v 1 2 1e400\n", "a.obj:1", "not a finite number");
  expect_error("\nv nan 0 0\n", "a.obj:2", "not a finite number");
  expect_error("v 0 -inf 0\n", "a.obj:1", "not a finite number");
  expect_error("v 1.#IND 0 0\n", "a.obj:1", "not a number");
}

TEST(ReadObj, NamesTheLineOfABadFace) {
  const std::string v = kTriangle;
  expect_error(v + "f 1 2 0\n", "a.obj:4", "vertex 0");
  expect_error(v + "f 1 2 3\nf 1 2 4\nf 1 2 3\n", "a.obj:5", "vertex 4, but the file has 3");
  expect_error(v + "f 1 2 -4\n", "a.obj:4", "vertex -4");
  expect_error(v + "f 1 2 99999999999999999999\n", "a.obj:4", "more than the file can hold");
  expect_error(v + "f 1 2 2147483648\n", "a.obj:4", "more than the file can hold");
  expect_error(v + "f 1 2 -99999999999999999999\n", "a.obj:4", "more than the file can hold");
  expect_error(v + "f 1 2 3.5\n", "a.obj:4", "\"3.5\"");
  expect_error(v + "f 1 2 3/x\n", "a.obj:4", "\"3/x\"");
  expect_error(v + "f 1 2 /3\n", "a.obj:4", "\"/3\"");
  expect_error(v + "f 1 2 3/1/1/1\n", "a.obj:4", "\"3/1/1/1\"");
  expect_error(v + "f\n", "a.obj:4", "no corners");
}

TEST(ReadObj, RefusesWhatIsNoObj) {
  expect_error("", "a.obj", "empty");
  expect_error("hello\nworld\n", "a.obj", "no vertex");
  expect_error(std::string_view("v 0 0 0\0\n", 9), "a.obj", "binary data");
}

}  // namespace
}  // namespace planewright
