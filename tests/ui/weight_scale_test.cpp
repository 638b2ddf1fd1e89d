#include "ui/weight_scale.h"

#include <gtest/gtest.h>

namespace planewright::ui {
namespace {

TEST(WeightScale, ZeroIsWithinReach) {
  EXPECT_EQ(weight_at(0.0), 0.0);
  EXPECT_EQ(weight_at(-3.0), 0.0);
  EXPECT_EQ(weight_at(0.03), 0.0);
  EXPECT_EQ(fraction_of_weight(0.0), 0.0);
  EXPECT_EQ(fraction_of_weight(-1.0), 0.0);
}

TEST(WeightScale, SpansSixDecades) {
  EXPECT_DOUBLE_EQ(weight_at(1.0), kMostWeight);
  EXPECT_DOUBLE_EQ(weight_at(7.0), kMostWeight);
  EXPECT_GT(weight_at(0.05), 0.0);
  EXPECT_DOUBLE_EQ(weight_at(fraction_of_weight(1.0)), 1.0);
  EXPECT_EQ(fraction_of_weight(1e9), 1.0);
}

TEST(WeightScale, IsMonotonousWithRoundNumbers) {
  double last = -1;
  for (int i = 0; i <= 1000; ++i) {
    const double weight = weight_at(i / 1000.0);
    EXPECT_GE(weight, last);
    last = weight;
  }
  for (const double weight : {0.001, 0.012, 0.1, 1.0, 2.5, 10.0, 47.0, 1000.0}) {
    EXPECT_DOUBLE_EQ(weight_at(fraction_of_weight(weight)), weight);
  }
}

TEST(WeightScale, WheelSteps) {
  EXPECT_EQ(weight_step(0.0, 1), kLeastWeight);
  EXPECT_EQ(weight_step(0.0, -1), 0.0);
  EXPECT_EQ(weight_step(kLeastWeight, -1), 0.0);
  EXPECT_DOUBLE_EQ(weight_step(1.0, 10), 10.0);
  EXPECT_DOUBLE_EQ(weight_step(1.0, -10), 0.1);
  EXPECT_DOUBLE_EQ(weight_step(kMostWeight, 1), kMostWeight);
  EXPECT_DOUBLE_EQ(weight_step(5000.0, 1), 5000.0) << "a typed weight beyond the scale is not pulled back";
}

}  // namespace
}  // namespace planewright::ui
