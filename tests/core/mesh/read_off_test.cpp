#include <gtest/gtest.h>

#include "core/mesh/mesh_io.h"
#include "support/shapes.h"

namespace planewright {
namespace {

Result<PolygonSoup> parse(std::string_view text) {
  return parse_mesh(text, MeshFormat::Off, "a.off");
}

const Polygons kFaces{{0, 1, 2}, {0, 2, 3}};

void expect_square(std::string_view text) {
  const auto soup = parse(text);
  ASSERT_TRUE(soup) << soup.error().text();
  EXPECT_EQ(soup->positions, test::make_points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})) << text;
  EXPECT_EQ(soup->faces, kFaces) << text;
}

void expect_error(std::string_view text, const std::string& where, const std::string& what) {
  const auto soup = parse(text);
  ASSERT_FALSE(soup) << text;
  EXPECT_EQ(soup.error().code, ErrorCode::Unreadable);
  EXPECT_EQ(soup.error().where, where);
  EXPECT_NE(soup.error().what.find(what), std::string::npos) << soup.error().text();
  EXPECT_FALSE(soup.error().remedy.empty());
}

TEST(ReadOff, ReadsPlainFile) {
  expect_square("OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  expect_square("OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3");
  expect_square("OFF\r\n4 2 5\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2\r\n3 0 2 3\r\n");
}

TEST(ReadOff, ReadsHeadersInEverySpelling) {
  const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
  for (const char* head : {"OFF 4 2 5\n", "off\n4 2 5\n", "OFF\n4 2\n", "4 2 0\n",
                           "OFF # a comment\n# more\n\n4 2 0\n", "\xEF\xBB\xBFOFF\n4\n2 0\n"})
    expect_square(head + body);
}

TEST(ReadOff, ReadsFacesOverSeveralLinesAndComments) {
  expect_square("OFF\n4 2 5\n\n0 0 0\n1 0 0 # corner\n1 1 0\n\n0 1\n0\n# faces\n3\n0\n1\n2\n\n3\n0 2\n3\n\n");
}

TEST(ReadOff, PassesOverColours) {
  expect_square(
      "OFF\n4 2 5\n0 0 0 255 0 0\n1 0 0 9 9 9\n1 1 0 1 1 1\n0 1 0 2 2 2\n3 0 1 2 0.5 0.5 0.5\n3 0 2 3 7\n");
  expect_square(
      "COFF\n4 2 5\n0 0 0 1 0 0 1\n1 0 0 9 9 9 1\n1 1 0 1 1 1 1\n0 1 0 2 2 2 1\n3 0 1 2\n3 0 2 3\n");
  expect_square("NOFF\n4 2 5\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n3 0 2 3\n");
  expect_square(
      "STCNOFF\n4 2 5\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0 0 0 1 0 0\n1 1 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n3 0 2 "
      "3\n");
}

TEST(ReadOff, DividesHomogeneousCoordinates) {
  expect_square("4OFF\n4 2 5\n0 0 0 1\n2 0 0 2\n1 1 0 1\n0 4 0 4\n3 0 1 2\n3 0 2 3\n");
  expect_error("4OFF\n1 0 0\n1 0 0 0\n", "a.off:3", "infinity");
}

TEST(ReadOff, ReadsSeveralElementsOnALine) {
  expect_square("OFF\n4 2 5\n0 0 0 1 0 0\n1 1 0 0 1 0\n3 0 1 2 3 0 2 3\n");
  expect_square("OFF 4 2 5 0 0 0 1 0 0 1 1 0 0 1 0 3 0 1 2 3 0 2 3");
}

TEST(ReadOff, ReadsFilesThatCountFromOne) {
  const auto soup = parse("OFF\n4 2 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n3 1 3 4\n");
  ASSERT_TRUE(soup);
  EXPECT_TRUE(soup->one_based_indices);
  EXPECT_EQ(soup->faces, kFaces);
  // Not when vertex 0 is used too, and not when the highest number fits counting from 0.
  expect_error("OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n3 1 2 3\n", "a.off:7, face 1",
               "vertex 3, but the file has 3");
  EXPECT_FALSE(parse("OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 1 2 3\n")->one_based_indices);
}

TEST(ReadOff, RefusesImpossibleCountsAtOnce) {
  expect_error("OFF\n353535235358 6 0\n0 0 0\n", "a.off:2", "353535235358 vertices");
  expect_error("OFF\n1 99999999999999999999999 0\n0 0 0\n", "a.off:2", "more than its");
  expect_error("OFF\n-4 2 0\n0 0 0\n", "a.off:2", "\"-4\"");
  expect_error("OFF\n4 2.5 0\n0 0 0\n", "a.off:2", "\"2.5\"");
  expect_error("OFF\n", "a.off:1", "ends before");
  expect_error("OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n1000000000 0 1 2\n", "a.off:6", "ends inside face 0");
  expect_error("OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n-3 0 1 2\n", "a.off:6", "\"-3\" is not a number of corners");
}

TEST(ReadOff, NamesWhereAFileBreaksOff) {
  expect_error("OFF\n4 1 0\n0.00 0.00 0.00\n0.00 0.00 0.00\n0.00 0.00 0.00\n", "a.off:5",
               "ends inside vertex 3");
  expect_error("OFF\n3 2 0\n0 0 0\n0 1 0\n0 0 0\n3 0 1 2\n3 0 1", "a.off:7", "ends inside face 1");
  expect_error("OFF\n3 1 0\n0 0 0\n0 1 0\n0 0 0\n3 0 1 2\n3 0 1 2\n", "a.off:7", "goes on after the 1 faces");
}

TEST(ReadOff, NamesTheLineOfABadValue) {
  expect_error("OFF\n3 1 0\n0 0 0\n0 x 0\n0 0 0\n3 0 1 2\n", "a.off:4", "\"x\" is not a number");
  expect_error("OFF\n3 1 0\n0 0 0\n0 nan 0\n0 0 0\n3 0 1 2\n", "a.off:4", "not a finite number");
  expect_error("OFF\n3 1 0\n0 0 0\n0 1 0\n0 0 0\n3 0 1 a\n", "a.off:6", "\"a\" is not a corner");
  expect_error("OFF\n3 1 0\n0 0 0\n0 1 0\n0 0 0\n3 0 1 7\n", "a.off:6", "vertex 7, but the file has 3");
  expect_error("OFF\n3 1 0\n0 0 0\n0 1 0\n0 0 0\n3 0 1 -1\n", "a.off:6", "vertex -1");
}

TEST(ReadOff, RefusesWhatItCannotRead) {
  expect_error("OFF BINARY\n\1\1\1", "a.off:1", "binary OFF");
  expect_error("nOFF\n5\n1 1 0\n", "a.off:1", "nOFF");
  expect_error("solid x\n", "a.off:1", "begins with \"OFF\"");
  expect_error("", "a.off", "empty");
}

}  // namespace
}  // namespace planewright
