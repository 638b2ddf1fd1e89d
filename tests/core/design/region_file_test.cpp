#include "core/design/region_file.h"

#include <gtest/gtest.h>

namespace planewright {
namespace {

TEST(RegionFile, IsReadAsItIsWritten) {
  const std::vector<int> regions{2, 0, 0, 1};
  const std::string text = region_csv(regions);
  EXPECT_EQ(text, "face,region\n0,2\n1,0\n2,0\n3,1\n");
  EXPECT_EQ(parse_region_csv(text, "r.csv", 4).value(), regions);
  EXPECT_EQ(parse_region_csv("face,region\r\n1,5\r\n0,3\r\n\r\n", "r.csv", 6).has_value(), false)
      << "2 is missing";
  EXPECT_EQ(parse_region_csv("face,region\r\n1,1\r\n\r\n0,0", "r.csv", 2).value(), (std::vector<int>{0, 1}))
      << "in any order";
}

TEST(RegionFile, IsRefusedWithTheLine) {
  for (const auto& [text, line, says] : {std::tuple{"", "r.csv:1", "face,region"},
                                         {"0,1\n1,1\n2,1\n", "r.csv:1", "face,region"},
                                         {"face,region\n0,0\n1\n2,0\n", "r.csv:3", "\"1\""},
                                         {"face,region\n0,0\n1,x\n", "r.csv:3", "\"1,x\""},
                                         {"face,region\n0,0\n1,0,2\n", "r.csv:3", "\"1,0,2\""},
                                         {"face,region\n0, 0\n", "r.csv:2", "\"0,\""},
                                         {"face,region\n0,0\n3,0\n", "r.csv:3", "no face 3"},
                                         {"face,region\n-1,0\n", "r.csv:2", "no face -1"},
                                         {"face,region\n0,-1\n", "r.csv:2", "no region -1"},
                                         {"face,region\n0,3\n", "r.csv:2", "no region 3"},
                                         {"face,region\n0,99999999999999999999\n", "r.csv:2", "no region"},
                                         {"face,region\n0,0\n0,1\n", "r.csv:3", "listed twice"},
                                         {"face,region\n0,0\n2,1\n", "r.csv:3", "face 1 has no region"}}) {
    const auto parsed = parse_region_csv(text, "r.csv", 3);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().code, ErrorCode::Unreadable);
    EXPECT_EQ(parsed.error().where, line) << text;
    EXPECT_NE((parsed.error().what + parsed.error().remedy).find(says), std::string::npos)
        << parsed.error().text();
  }
}

}  // namespace
}  // namespace planewright
