// SPDX-License-Identifier: Apache-2.0
#include "core/session/map_upward.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "tests/support/error_text.h"

namespace nadir {
namespace map_upward_test {

constexpr double kPi = std::numbers::pi;

TEST(MapUpward, IsNorthUntilTheMapIsTurned) {
  EXPECT_EQ(MapUpward{}.text(), "north");
  EXPECT_EQ(MapUpward::of(default_map_look()), MapUpward{});
  EXPECT_DOUBLE_EQ(MapUpward{}.up_rad(0.3), kPi / 2.0);
}

TEST(MapUpward, OfAFreeMapIsACompassCourse) {
  MapLook look = default_map_look();
  look.up = MapUp::kFree;
  look.up_rad = 0.0;  // east is up
  EXPECT_EQ(MapUpward::of(look).text(), "90");
  look.up_rad = kPi;
  EXPECT_EQ(MapUpward::of(look).text(), "270");
  for (const double up_rad : {0.0, 1.0, -2.5, kPi, 3.1}) {
    look.up_rad = up_rad;
    const auto again = MapUpward::from_text(MapUpward::of(look).text());
    ASSERT_TRUE(again) << error_text(again);
    EXPECT_EQ(*again, MapUpward::of(look));
    EXPECT_NEAR(std::remainder(again->up_rad(0.0) - up_rad, 2.0 * kPi), 0.0, 1e-12);
  }
}

TEST(MapUpward, OfAMapThatFollowsTheHeadingIsThatOfTheMoment) {
  MapLook look = default_map_look();
  look.up = MapUp::kHeading;
  look.up_rad = 0.7;
  EXPECT_EQ(MapUpward::of(look).text(), "heading");
  EXPECT_EQ(MapUpward::from_text("heading")->up_rad(1.25), 1.25);
}

TEST(MapUpward, TakesAnyCourseRoundTheCircle) {
  EXPECT_EQ(MapUpward::from_text("450")->compass_deg, 90.0);
  EXPECT_EQ(MapUpward::from_text("-90")->compass_deg, 270.0);
  EXPECT_EQ(MapUpward::from_text("-1e-30")->compass_deg, 0.0) << "never 360";
}

TEST(MapUpward, IsNeverMoreThanHalfATurnFromEast) {
  for (const char* course : {"0", "90", "269.5", "270", "300", "359.9999999999"}) {
    const double up_rad = MapUpward::from_text(course)->up_rad(0.0);
    EXPECT_LE(std::abs(up_rad), kPi) << course;
  }
  EXPECT_NEAR(MapUpward::from_text("359.9999999999")->up_rad(0.0), kPi / 2.0, 1e-9) << "north";
}

TEST(MapUpward, RefusesWhatIsNoDirection) {
  for (const char* text : {"", "up", "90 deg", "nan", "inf", "north-east"}) {
    const auto refused = MapUpward::from_text(text);
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(refused.error().message,
              "'" + std::string(text) + "' is neither north, heading nor a course in degrees");
  }
}

}  // namespace map_upward_test
}  // namespace nadir
