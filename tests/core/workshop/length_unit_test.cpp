#include "core/workshop/length_unit.h"

#include <gtest/gtest.h>

namespace planewright {
namespace {

TEST(LengthUnit, MillimetresAreExactByDefinition) {
  EXPECT_EQ(millimetres_per(LengthUnit::Millimetre), 1.0);
  EXPECT_EQ(millimetres_per(LengthUnit::Centimetre), 10.0);
  EXPECT_EQ(millimetres_per(LengthUnit::Metre), 1000.0);
  EXPECT_EQ(millimetres_per(LengthUnit::Inch), 25.4);
  EXPECT_EQ(millimetres_per(LengthUnit::Foot), 304.8);
}

TEST(LengthUnit, EverySymbolReadsBack) {
  ASSERT_EQ(length_units().size(), 5u);
  for (const LengthUnit unit : length_units()) {
    const auto read = parse_length_unit(symbol(unit), "--unit");
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, unit);
  }
  EXPECT_EQ(parse_length_unit("Metres", "--unit").value(), LengthUnit::Metre);
  EXPECT_EQ(parse_length_unit("INCH", "--unit").value(), LengthUnit::Inch);
}

TEST(LengthUnit, UnknownUnitsAreNamed) {
  const auto read = parse_length_unit("parsec", "--unit");
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::Usage);
  EXPECT_NE(read.error().text().find("--unit: there is no unit of length 'parsec'"), std::string::npos)
      << read.error().text();
}

}  // namespace
}  // namespace planewright
