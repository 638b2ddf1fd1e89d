#include "ui/typed_path.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace planewright::ui {
namespace {

TEST(TypedPath, TheTildeIsHome) {
  ASSERT_EQ(setenv("HOME", "/home/ada", 1), 0);
  EXPECT_EQ(typed_path("~"), "/home/ada");
  EXPECT_EQ(typed_path("~/roof/out"), "/home/ada/roof/out");
  EXPECT_EQ(typed_path("~roof"), "~roof");
  EXPECT_EQ(typed_path("roof/~"), "roof/~");
  EXPECT_EQ(typed_path("/roof"), "/roof");
}

}  // namespace
}  // namespace planewright::ui
