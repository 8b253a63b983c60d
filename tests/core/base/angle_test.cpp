// SPDX-License-Identifier: Apache-2.0
#include "core/base/angle.h"

#include <gtest/gtest.h>

#include <limits>

namespace nadir {
namespace angle_test {

constexpr double kPi = std::numbers::pi;

TEST(WrapRad, StaysWithinHalfATurnAndKeepsTheDirection) {
  for (int i = -100'000; i <= 100'000; ++i) {
    const double angle_rad = 0.001 * i;
    const double wrapped = wrap_rad(angle_rad);
    ASSERT_GT(wrapped, -kPi);
    ASSERT_LE(wrapped, kPi);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle_rad), 1e-12);
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle_rad), 1e-12);
  }
}

TEST(WrapRad, HalfATurnIsPositiveFromBothSides) {
  EXPECT_EQ(wrap_rad(kPi), kPi);
  EXPECT_EQ(wrap_rad(-kPi), kPi);
  EXPECT_EQ(wrap_rad(0.0), 0.0);
}

TEST(WrapRad, NanStaysNan) {
  EXPECT_TRUE(std::isnan(wrap_rad(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(wrap_rad(std::numeric_limits<double>::infinity())));
}

TEST(Angle, KnowsBothUnits) {
  EXPECT_DOUBLE_EQ(Angle::degrees(180.0).radians(), kPi);
  EXPECT_DOUBLE_EQ(Angle::radians(kPi / 2.0).degrees(), 90.0);
  EXPECT_EQ(Angle().radians(), 0.0);
}

TEST(CompassDegFromYaw, IsClockwiseFromNorth) {
  EXPECT_DOUBLE_EQ(compass_deg_from_yaw(Angle::degrees(90.0)), 0.0);     // north
  EXPECT_DOUBLE_EQ(compass_deg_from_yaw(Angle::degrees(0.0)), 90.0);     // east
  EXPECT_DOUBLE_EQ(compass_deg_from_yaw(Angle::degrees(-90.0)), 180.0);  // south
  EXPECT_DOUBLE_EQ(compass_deg_from_yaw(Angle::degrees(180.0)), 270.0);  // west
}

TEST(CompassDegFromYaw, StaysWithinOneTurn) {
  for (double yaw_deg = -720.0; yaw_deg <= 720.0; yaw_deg += 0.5) {
    const double compass_deg = compass_deg_from_yaw(Angle::degrees(yaw_deg));
    ASSERT_GE(compass_deg, 0.0) << yaw_deg;
    ASSERT_LT(compass_deg, 360.0) << yaw_deg;
  }
}

TEST(CompassDegFromYaw, AHairWestOfNorthIsStillBelowAWholeTurn) {
  EXPECT_LT(compass_deg_from_yaw(Angle::degrees(90.00000000000003)), 360.0);
  EXPECT_LT(compass_deg_from_yaw(Angle::radians(std::nextafter(kPi / 2.0, 2.0))), 360.0);
}

}  // namespace angle_test
}  // namespace nadir
