#include "ui/user_settings.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "ui/finding_limits.h"

namespace planewright::ui {
namespace {

TEST(UserSettings, SurviveTheRoundTrip) {
  UserSettings settings{.window_width = 1234, .unit = "mm"};
  settings.left_width = 345.5f;
  settings.dark = true;
  settings.schedule_height = 320.5f;
  settings.schedule_tab = true;
  settings.show_hint = false;
  settings.auto_solve = false;
  settings.polish_automatically = true;
  settings.finding_limits = {{"close-points", 0.25}, {"twisted-beam", 2.0}};
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

TEST(FindingLimits, KeepWhatDiffersAndLeaveTheRestOut) {
  const FindingLimits limits = {{"close-points", 0.25}, {"far-point", 0.5}};
  FindingLimits damaged = limits;
  damaged["of the future"] = 1.0;
  damaged["not-convex"] = -3.0;
  EXPECT_EQ(limits_of(with_limits(damaged)), limits);
  EXPECT_EQ(with_limits({}), FindingSettings());
  for (const FindingKind kind : all_finding_kinds()) {
    const LimitLook look = limit_look(kind, info(kind).threshold);
    EXPECT_FALSE(look.unit.empty() || look.tooltip.empty()) << info(kind).name;
    EXPECT_GT(look.per_pixel, 0.0);
  }
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
