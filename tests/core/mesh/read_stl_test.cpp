#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"

namespace planewright {
namespace {

Result<PolygonSoup> parse(std::string_view text) {
  return parse_mesh(text, MeshFormat::Stl, "a.stl");
}

void expect_error(std::string_view text, const std::string& where, const std::string& what) {
  const auto soup = parse(text);
  ASSERT_FALSE(soup);
  EXPECT_EQ(soup.error().code, ErrorCode::Unreadable);
  EXPECT_EQ(soup.error().where, where);
  EXPECT_NE(soup.error().what.find(what), std::string::npos) << soup.error().text();
  EXPECT_FALSE(soup.error().remedy.empty());
}

void append_uint32(std::string& out, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

std::string binary_stl(const Points& positions, const Polygons& triangles, std::string_view begin = {}) {
  std::string out(begin);
  out.resize(80, ' ');
  append_uint32(out, static_cast<std::uint32_t>(triangles.size()));
  for (int t = 0; t < triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) append_uint32(out, 0);
    for (int v : triangles[t])
      for (int axis = 0; axis < 3; ++axis)
        append_uint32(out, std::bit_cast<std::uint32_t>(static_cast<float>(positions(v, axis))));
    out += std::string(2, '\0');
  }
  return out;
}

constexpr const char* kAscii =
    "solid a roof\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1 0 0\n      vertex 1 1 0\n"
    "    endloop\n  endfacet\n"
    "  facet normal nan nan nan\n    outer loop\n      vertex -0 0 0\n      vertex 1 1 0\n      vertex 0 1 "
    "0\n"
    "    endloop\n  endfacet\n"
    "endsolid a roof\n";

TEST(ReadStl, ReadsAsciiAndJoinsCorners) {
  const auto soup = parse(kAscii);
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->positions, test::make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(soup->faces, (Polygons{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadStl, ReadsAnyCaseAndSeveralSolids) {
  std::string text = kAscii;
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  const auto soup = parse(text + "\n" + kAscii);
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->faces.size(), 4);
}

TEST(ReadStl, ReadsBinary) {
  const test::Shape shape = test::tetrahedron();
  // A binary file may begin with "solid" as well.
  for (const char* begin : {"", "solid of binary data"}) {
    const auto soup = parse(binary_stl(shape.positions, shape.faces, begin));
    ASSERT_TRUE(soup) << soup.error().text();
    EXPECT_EQ(soup->positions.rows(), 4);
    EXPECT_EQ(soup->faces.size(), 4);
  }
}

TEST(ReadStl, NamesTheTriangleOfABadBinaryValue) {
  test::Shape shape = test::tetrahedron();
  shape.positions(3, 0) = std::numeric_limits<double>::infinity();
  expect_error(binary_stl(shape.positions, shape.faces), "a.stl, triangle 1", "not a finite number");
}

TEST(ReadStl, NamesTheLineOfABadValue) {
  expect_error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", "a.stl:4", "\"x\" is not a number");
  expect_error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n", "a.stl:4", "not a finite number");
  expect_error("solid\nfacet normal 0 0 1\ninner loop\n", "a.stl:3", "\"inner\" stands where \"outer\"");
  expect_error("solid\ntriangle\n", "a.stl:2", "\"triangle\" stands where \"facet\"");
}

TEST(ReadStl, NamesWhereAFileBreaksOff) {
  const std::string text = kAscii;
  expect_error(text.substr(0, text.find("endsolid")), "a.stl:15", "ends inside triangle 2");
  expect_error(text.substr(0, text.find("endloop")), "a.stl:6", "ends inside triangle 0");
  const test::Shape shape = test::tetrahedron();
  const std::string binary = binary_stl(shape.positions, shape.faces);
  for (size_t size = 1; size < binary.size(); ++size) EXPECT_FALSE(parse(binary.substr(0, size)));
  expect_error(binary.substr(0, 200), "a.stl", "promises 4 triangles");
  expect_error(binary.substr(0, 70), "a.stl", "too short");
  expect_error("", "a.stl", "empty");
}

}  // namespace
}  // namespace planewright
