#include "core/design/selection_file.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace planewright {
namespace {

using namespace test;

// 9 vertices, 4 faces, 12 edges.
PolygonMesh quads() {
  return grid(2, 2).mesh();
}

TEST(SelectionFile, ReadsNamesRangesAndEdgesByTheirEnds) {
  const PolygonMesh mesh = quads();
  const auto read = parse_selection_file(
      "# two parts\n"
      "roof: vertices 7 1, 3-5; faces 0\n"
      "rim: edges 3 0/1 1/0   # twice the same\n"
      "roof: faces 2-3 2\n",
      "s.txt", mesh);
  ASSERT_TRUE(read) << read.error().text();
  std::vector<int> rim{3, mesh.find_edge(0, 1)};
  std::sort(rim.begin(), rim.end());
  EXPECT_EQ(*read, (std::vector<Selection>{{"roof", {1, 3, 4, 5, 7}, {}, {0, 2, 3}}, {"rim", {}, rim, {}}}));
}

TEST(SelectionFile, RefusesWithTheLine) {
  const struct {
    const char* line;
    const char* says;
  } wrong[] = {
      {"roof vertices 1", "\"roof\""},         {": vertices 1", "\":\""},
      {"a@b: vertices 1", "\"a@b:\""},         {"roof:", "names nothing"},
      {"roof: vertices", "names nothing"},     {"roof: 1 2", "before one of"},
      {"roof: panels 1", "\"panels\""},        {"roof: vertices 9", "no vertex 9"},
      {"roof: faces 2-4", "no face 4"},        {"roof: edges 12", "no edge 12"},
      {"roof: vertices 5-3", "backwards"},     {"roof: vertices 1x", "\"1x\""},
      {"roof: vertices 1-", "\"1-\""},         {"roof: vertices 1-2-3", "\"1-2-3\""},
      {"roof: edges 0/8", "no edge joins"},    {"roof: edges 0/9", "no vertex 9"},
      {"roof: vertices 0/1", "neither a num"}, {"roof: vertices -1", "\"-1\""},
  };
  for (const auto& [line, says] : wrong) {
    const auto read = parse_selection_file(std::string("good: faces 1\n") + line + "\n", "s.txt", quads());
    ASSERT_FALSE(read) << line;
    EXPECT_EQ(read.error().code, ErrorCode::Unreadable) << line;
    EXPECT_EQ(read.error().where, "s.txt:2") << line;
    EXPECT_NE(read.error().what.find(says), std::string::npos) << line << ": " << read.error().text();
  }
}

}  // namespace
}  // namespace planewright
