// The scale of sliders for a number of things.
#include "ui/count_scale.h"

#include <gtest/gtest.h>

namespace planewright::ui {
namespace {

TEST(CountScale, EndsAreTheLeastAndTheMostAndEveryNumberComesBack) {
  EXPECT_EQ(count_at(-0.1, 2, 2500), 2);
  EXPECT_EQ(count_at(0.0, 2, 2500), 2);
  EXPECT_EQ(count_at(1.0, 2, 2500), 2500);
  EXPECT_EQ(count_at(1.7, 2, 2500), 2500);
  for (int count = 2; count <= 2500; ++count)
    EXPECT_EQ(count_at(fraction_of_count(count, 2, 2500), 2, 2500), count);
}

TEST(CountScale, IsLogarithmic) {
  EXPECT_EQ(count_at(0.5, 1, 10000), 100);
  EXPECT_NEAR(fraction_of_count(1000, 1, 10000), 0.75, 1e-12);
}

TEST(CountScale, NumbersOffTheScaleStandAtItsEnds) {
  EXPECT_EQ(fraction_of_count(1, 2, 2500), 0.0);
  EXPECT_EQ(fraction_of_count(9000, 2, 2500), 1.0);
  EXPECT_EQ(fraction_of_count(5, 3, 3), 0.0);
}

TEST(CountScale, ANotchIsATwentiethAndAtLeastOne) {
  EXPECT_EQ(count_step(100, 1, 1, 1000), 105);
  EXPECT_EQ(count_step(4, -1, 1, 1000), 3);
  EXPECT_EQ(count_step(1, -1, 1, 1000), 1);
  EXPECT_EQ(count_step(990, 1, 1, 1000), 1000);
  EXPECT_EQ(count_step(5000, 1, 1, 1000), 5000)
      << "what was typed beyond the end is not taken back by a notch up";
}

}  // namespace
}  // namespace planewright::ui
