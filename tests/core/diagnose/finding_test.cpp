#include "core/diagnose/finding.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace planewright {
namespace {

TEST(FindingKind, AllHaveNamesOfTheirOwnAndCanBeFound) {
  std::set<std::string> names;
  for (const FindingKind kind : all_finding_kinds()) {
    names.insert(info(kind).name);
    EXPECT_EQ(find_finding_kind(info(kind).name).value(), kind);
    EXPECT_LT(info(kind).least_severity, info(kind).most_severity);
    EXPECT_GE(info(kind).least_severity, 0.0);
    EXPECT_LE(info(kind).most_severity, 1.0);
  }
  EXPECT_EQ(names.size(), static_cast<size_t>(kFindingKinds));
  const auto unknown = find_finding_kind("ugly");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::Usage);
  EXPECT_NE(unknown.error().text().find("reversed-edge"), std::string::npos);
}

TEST(FindingSettings, BeginWithEveryKindOnAtItsThreshold) {
  const FindingSettings settings;
  for (const FindingKind kind : all_finding_kinds()) {
    EXPECT_TRUE(settings[kind].on);
    EXPECT_EQ(settings[kind].threshold, info(kind).threshold);
  }
}

TEST(Finding, SeverityGoesFromTheLeastOfItsKindToTheMost) {
  const auto severity = [](double share) {
    return make_finding(FindingKind::FarPoint, {ElementKind::Point, 1}, 2.0, 1.0, share).severity;
  };
  const FindingKindInfo& of = info(FindingKind::FarPoint);
  EXPECT_EQ(severity(0.0), of.least_severity);
  EXPECT_EQ(severity(-1.0), of.least_severity);
  EXPECT_DOUBLE_EQ(severity(0.5), 0.5 * (of.least_severity + of.most_severity));
  EXPECT_DOUBLE_EQ(severity(1.0), of.most_severity);
  EXPECT_DOUBLE_EQ(severity(7.0), of.most_severity);
  EXPECT_DOUBLE_EQ(severity(std::numeric_limits<double>::quiet_NaN()), of.most_severity);
}

}  // namespace
}  // namespace planewright
