#include "ui/format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace planewright::ui {
namespace {

TEST(Format, NumbersHaveThreeDigits) {
  EXPECT_EQ(format_number(0), "0");
  EXPECT_EQ(format_number(1), "1");
  EXPECT_EQ(format_number(-1), "-1");
  EXPECT_EQ(format_number(0.125), "0.125");
  EXPECT_EQ(format_number(0.5), "0.5");
  EXPECT_EQ(format_number(0.0123), "0.0123");
  EXPECT_EQ(format_number(12.34), "12.3");
  EXPECT_EQ(format_number(123.4), "123");
  EXPECT_EQ(format_number(1753), "1,753");
  EXPECT_EQ(format_number(2.1e-10), "2.1e-10");
  EXPECT_EQ(format_number(2e-10), "2e-10");
  EXPECT_EQ(format_number(1.5e7), "1.5e+07");
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN()), "–");
  EXPECT_EQ(format_number(std::numeric_limits<double>::infinity()), "∞");
}

TEST(Format, UnitsAndCounts) {
  EXPECT_EQ(format_with_unit(0.25, "m"), "0.25 m");
  EXPECT_EQ(format_with_unit(0.25, ""), "0.25");
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1000), "1,000");
  EXPECT_EQ(format_count(-1234567), "-1,234,567");
  EXPECT_EQ(format_count(1, "panel", "panels"), "1 panel");
  EXPECT_EQ(format_count(2, "panel", "panels"), "2 panels");
}

TEST(Format, DurationsAndBytes) {
  EXPECT_EQ(format_duration(0.0012), "1.2 ms");
  EXPECT_EQ(format_duration(0.34), "340 ms");
  EXPECT_EQ(format_duration(1.24), "1.2 s");
  EXPECT_EQ(format_duration(125), "2 min 05 s");
  EXPECT_EQ(format_duration(-1), "–");
  EXPECT_EQ(format_bytes(12), "12 B");
  EXPECT_EQ(format_bytes(12345), "12.3 KB");
  EXPECT_EQ(format_bytes(3'000'000), "3 MB");
}

}  // namespace
}  // namespace planewright::ui
