// The list of failures: which are in it, in which order, and where one is found again.
#include "ui/failure_list.h"

#include <gtest/gtest.h>

#include "ui/failure_text.h"

namespace planewright::ui {
namespace {

using Kind = ToleranceKind;

std::shared_ptr<const PreparedWorkshop> with(std::vector<ToleranceFailure> failures) {
  auto made = std::make_shared<PreparedWorkshop>();
  made->verdicts.failures = std::move(failures);
  return made;
}

TEST(FailureList, IsByKindAndTheWorstFirst) {
  const auto from = with({{0, Kind::AreaMax, -1, 5.0, 4.0},
                          {1, Kind::EdgeMin, 0, 90.0, 100.0},
                          {1, Kind::EdgeMin, 2, 40.0, 100.0},
                          {2, Kind::AreaMax, -1, 9.0, 4.0}});
  const FailureList list = make_failure_list(from, {});
  ASSERT_EQ(list.size(), 4);
  EXPECT_EQ(list.failure(0).measured, 40.0);
  EXPECT_EQ(list.failure(1).measured, 90.0);
  EXPECT_EQ(list.failure(2).measured, 9.0);
  EXPECT_EQ(list.failure(3).measured, 5.0);
  EXPECT_EQ(list.count[static_cast<std::size_t>(Kind::EdgeMin)], 2);
}

TEST(FailureList, HiddenKindsAreCountedAndNotListed) {
  HiddenFailures hidden;
  hidden.set(static_cast<std::size_t>(Kind::EdgeMin));
  const FailureList list =
      make_failure_list(with({{0, Kind::AreaMax, -1, 5.0, 4.0}, {1, Kind::EdgeMin, 0, 90.0, 100.0}}), hidden);
  ASSERT_EQ(list.size(), 1);
  EXPECT_EQ(list.failure(0).kind, Kind::AreaMax);
  EXPECT_EQ(list.count[static_cast<std::size_t>(Kind::EdgeMin)], 1);
}

TEST(FailureList, FindsTheSamePlaceInANewerOne) {
  const ToleranceFailure before{1, Kind::EdgeMin, 2, 40.0, 100.0};
  const FailureList list =
      make_failure_list(with({{1, Kind::EdgeMin, 1, 20.0, 100.0}, {1, Kind::EdgeMin, 2, 41.0, 100.0}}), {});
  EXPECT_EQ(list.find(before), 1);
  EXPECT_EQ(list.find({1, Kind::EdgeMax, 2, 40.0, 30.0}), std::nullopt);
}

TEST(FailureText, SaysMeasureAndLimit) {
  EXPECT_EQ(failure_measure({0, Kind::EdgeMin, 0, 24.1, 50.0}), "24.1 < 50 mm");
  EXPECT_EQ(failure_measure({0, Kind::InteriorMax, 0, 170.0, 160.0}), "170 > 160°");
  EXPECT_EQ(failure_measure({0, Kind::EdgeMin, 0, 49.9999, 50.0}), "hardly < 50 mm");
  EXPECT_EQ(failure_measure({0, Kind::CrossesItself, -1, 1.0, 0.0}), "");
}

}  // namespace
}  // namespace planewright::ui
