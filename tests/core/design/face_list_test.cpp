#include "core/design/face_list.h"

#include <gtest/gtest.h>

namespace planewright {
namespace {

TEST(FaceList, HasNumbersAndRangesInTheirOrder) {
  EXPECT_EQ(parse_face_list("9,3, 5-7 0", "f", 10).value(), (std::vector<int>{9, 3, 5, 6, 7, 0}));
  EXPECT_EQ(parse_face_list("# seeds\r\n4-4\r\n\r\n2 # the ridge\n", "f", 5).value(),
            (std::vector<int>{4, 2}));
}

TEST(FaceList, IsRefusedWithTheLine) {
  for (const auto& [text, line, says] : {std::tuple{"", "f.txt:1", "no face is listed"},
                                         {"# nothing\n", "f.txt:1", "no face is listed"},
                                         {"1\n2;3", "f.txt:2", "\"2;3\""},
                                         {"1 x", "f.txt:1", "\"x\""},
                                         {"1\n\n3-", "f.txt:3", "\"3-\""},
                                         {"1-2-3", "f.txt:1", "\"1-2-3\""},
                                         {"3-2", "f.txt:1", "runs backwards"},
                                         {"-1", "f.txt:1", "no face -1"},
                                         {"0\n5", "f.txt:2", "no face 5"},
                                         {"0\n3-99999999999999999999", "f.txt:2", "no face 9"},
                                         {"0-3\n2", "f.txt:2", "face 2 is listed twice"}}) {
    const auto parsed = parse_face_list(text, "f.txt", 5);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.error().code, ErrorCode::Unreadable);
    if (std::string(says) != "no face is listed") EXPECT_EQ(parsed.error().where, line) << text;
    EXPECT_NE(parsed.error().what.find(says), std::string::npos) << parsed.error().text();
  }
}

}  // namespace
}  // namespace planewright
