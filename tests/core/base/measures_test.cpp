// SPDX-License-Identifier: Apache-2.0
#include "core/base/measures.h"

#include <gmock/gmock.h>

#include <numbers>

#include "tests/support/error_text.h"

namespace nadir {
namespace measures_test {

using testing::HasSubstr;
using testing::StartsWith;

TEST(ParseLength, IsInMetresWhateverTheUnit) {
  EXPECT_DOUBLE_EQ(*parse_length_m("12.5"), 12.5);
  EXPECT_DOUBLE_EQ(*parse_length_m("3 m"), 3.0);
  EXPECT_DOUBLE_EQ(*parse_length_m(" 450 mm "), 0.45);
  EXPECT_DOUBLE_EQ(*parse_length_m("15cm"), 0.15);
  EXPECT_DOUBLE_EQ(*parse_length_m("1.2 km"), 1200.0);
  EXPECT_DOUBLE_EQ(*parse_length_m("12 ft"), 3.6576);
  EXPECT_DOUBLE_EQ(*parse_length_m("10 in"), 0.254);
  EXPECT_DOUBLE_EQ(*parse_length_m("100yd"), 91.44);
  EXPECT_DOUBLE_EQ(*parse_length_m("-2.5"), -2.5);
  EXPECT_DOUBLE_EQ(*parse_length_m("+2.5 m"), 2.5);
  EXPECT_DOUBLE_EQ(*parse_length_m("1e3"), 1000.0);
}

TEST(ParseLength, SaysWhatIsWrong) {
  EXPECT_EQ(error_text(parse_length_m("3 furlongs")),
            "3 furlongs: is no length (furlongs is none of m, km, cm, mm, ft, in, yd)");
  EXPECT_EQ(error_text(parse_length_m(" \t")), "nothing was typed for the length");
  EXPECT_THAT(error_text(parse_length_m("wide")), HasSubstr("begins with no number"));
  EXPECT_THAT(error_text(parse_length_m("12,5")), HasSubstr("decimals come after a point"));
  EXPECT_THAT(error_text(parse_length_m("1e999")), HasSubstr("too large"));
  EXPECT_THAT(error_text(parse_length_m("1e308 km")), HasSubstr("too large"));
  for (const char* const text : {"nan", "inf", "-inf m", "++1", "+-1", "0x10", "1 m 2", "30 deg"}) {
    const auto length = parse_length_m(text);
    ASSERT_FALSE(length) << text;
    EXPECT_EQ(length.error().code, ErrorCode::kInvalidOptions);
    EXPECT_THAT(error_text(length), StartsWith(text));
  }
}

TEST(ParseAngle, IsInDegreesUnlessAUnitSaysOtherwise) {
  EXPECT_DOUBLE_EQ(parse_angle("30")->degrees(), 30.0);
  EXPECT_DOUBLE_EQ(parse_angle("30 deg")->degrees(), 30.0);
  EXPECT_DOUBLE_EQ(parse_angle("30\u00B0")->degrees(), 30.0);
  EXPECT_DOUBLE_EQ(parse_angle("1.5 rad")->radians(), 1.5);
  EXPECT_DOUBLE_EQ(parse_angle("100 gon")->radians(), std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(parse_angle("-45")->radians(), -std::numbers::pi / 4.0);
}

TEST(ParseAngle, SaysWhatIsWrong) {
  EXPECT_EQ(error_text(parse_angle("30 m")),
            "30 m: is no angle (m is none of deg, \u00B0, rad, gon)");
  EXPECT_THAT(error_text(parse_angle("")), HasSubstr("nothing was typed for the angle"));
}

}  // namespace measures_test
}  // namespace nadir
