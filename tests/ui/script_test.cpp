#include "ui/script.h"

#include <gtest/gtest.h>

namespace planewright::ui {
namespace {

TEST(Script, SplitsLinesIntoWords) {
  const auto script = parse_script(
      "# a comment\n"
      "\n"
      "sample dome 200   # and another\n"
      "drag \"Design/weight fairing\" 0.5\r\n"
      "type \"\"\n",
      "test.txt");
  ASSERT_TRUE(script.has_value());
  ASSERT_EQ(script->commands.size(), 3u);
  EXPECT_EQ(script->commands[0].line, 3);
  EXPECT_EQ(script->commands[0].words, (std::vector<std::string>{"sample", "dome", "200"}));
  EXPECT_EQ(script->commands[1].words, (std::vector<std::string>{"drag", "Design/weight fairing", "0.5"}));
  EXPECT_EQ(script->commands[2].words, (std::vector<std::string>{"type", ""}));
}

TEST(Script, NamesTheLineOfAMistake) {
  for (const char* text : {"fit\ndance\n", "fit\n", "open\n", "open a b\n", "click \"half\n"}) {
    const auto script = parse_script(text, "test.txt");
    ASSERT_FALSE(script.has_value()) << text;
    EXPECT_EQ(script.error().code, ErrorCode::Usage);
    EXPECT_EQ(script.error().where.substr(0, 9), "test.txt:");
  }
}

TEST(Script, AMissingFileIsUnreadable) {
  const auto script = load_script("/nowhere/at all.txt");
  ASSERT_FALSE(script.has_value());
  EXPECT_EQ(script.error().code, ErrorCode::Unreadable);
}

}  // namespace
}  // namespace planewright::ui
