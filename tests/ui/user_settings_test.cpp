#include "ui/user_settings.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace planewright::ui {
namespace {

TEST(UserSettings, SurviveTheRoundTrip) {
  UserSettings settings{.window_width = 1234, .unit = "mm"};
  settings.left_width = 345.5f;
  settings.dark = true;
  settings.show_hint = false;
  settings.auto_solve = false;
  settings.polish_automatically = true;
  settings.last_folder = "/a folder/with \"quotes\" and ü";
  const auto read = parse_user_settings(format_user_settings(settings));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(*read, settings);
}

TEST(UserSettings, UnknownMissingAndWrongKeysAreHarmless) {
  const auto read =
      parse_user_settings(R"({"dark": "yes", "window_width": -5, "new": [1], "unit": "a very long unit"})");
  ASSERT_TRUE(read.has_value());
  EXPECT_FALSE(read->dark);
  EXPECT_FALSE(read->polish_automatically);
  EXPECT_EQ(read->window_width, 640);
  EXPECT_EQ(read->unit, "m");
}

TEST(UserSettings, DamagedTextIsAnError) {
  for (const char* text : {"", "{", "[]", "null", "\xff\xfe"}) {
    const auto read = parse_user_settings(text);
    ASSERT_FALSE(read.has_value()) << text;
    EXPECT_EQ(read.error().code, ErrorCode::Unreadable);
  }
}

TEST(UserSettings, FollowTheXdgFolder) {
  const char* before = std::getenv("XDG_CONFIG_HOME");
  const std::string kept = before != nullptr ? before : "";
  setenv("XDG_CONFIG_HOME", "/somewhere", 1);
  EXPECT_EQ(user_settings_path(), std::filesystem::path("/somewhere/planewright/window.json"));
  if (before != nullptr) {
    setenv("XDG_CONFIG_HOME", kept.c_str(), 1);
  } else {
    unsetenv("XDG_CONFIG_HOME");
  }
}

}  // namespace
}  // namespace planewright::ui
