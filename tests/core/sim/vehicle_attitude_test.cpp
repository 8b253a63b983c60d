// SPDX-License-Identifier: Apache-2.0
#include "core/sim/vehicle_attitude.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/angle.h"
#include "core/sim/route.h"

namespace nadir {
namespace vehicle_attitude_test {

/// Mean tilt over ten seconds of a steady load, after it has settled; the jitter averages out.
Tilt settled(double forward_mps2, double left_mps2, double speed_mps) {
  std::vector<VehicleLoad> loads;
  loads.reserve(2000);
  for (int i = 0; i < 2000; ++i) loads.push_back({0.05 * i, forward_mps2, left_mps2, speed_mps});
  const std::vector<Tilt> tilts = vehicle_tilt(loads, 3);
  Tilt mean;
  for (std::size_t i = 100; i < tilts.size(); ++i) {
    mean.roll_rad += tilts[i].roll_rad / 1900.0;
    mean.pitch_rad += tilts[i].pitch_rad / 1900.0;
  }
  return mean;
}

double degrees(double angle_rad) { return Angle::radians(angle_rad).degrees(); }

TEST(VehicleTilt, IsLevelAtRest) {
  const Tilt tilt = settled(0.0, 0.0, 0.0);
  EXPECT_NEAR(degrees(tilt.roll_rad), 0.0, 0.15);
  EXPECT_NEAR(degrees(tilt.pitch_rad), 0.0, 0.15);
}

TEST(VehicleTilt, LowersTheNoseByFourDegreesToKeepFourMetresASecond) {
  EXPECT_NEAR(degrees(settled(0.0, 0.0, 4.0).pitch_rad), 4.0, 0.2);
}

TEST(VehicleTilt, LowersTheNoseToSpeedUpAndRaisesItToBrake) {
  EXPECT_NEAR(degrees(settled(1.0, 0.0, 0.0).pitch_rad), 5.8, 0.2);
  EXPECT_NEAR(degrees(settled(-1.0, 0.0, 0.0).pitch_rad), -5.8, 0.2);
}

TEST(VehicleTilt, LowersTheLeftSideInALeftTurnAsACoordinatedTurnDoes) {
  // tan(bank) = v^2 / (r g); positive roll lowers the right side.
  EXPECT_NEAR(settled(0.0, 1.5, 2.0).roll_rad, -std::atan(1.5 / 9.81), 0.003);
  EXPECT_NEAR(settled(0.0, -1.5, 2.0).roll_rad, std::atan(1.5 / 9.81), 0.003);
}

TEST(VehicleTilt, FollowsAJumpOfTheLoadWithoutJumping) {
  std::vector<VehicleLoad> loads;
  loads.reserve(200);
  for (int i = 0; i < 200; ++i) loads.push_back({0.02 * i, 0.0, i < 100 ? 0.0 : 1.5, 2.0});
  const std::vector<Tilt> tilts = vehicle_tilt(loads, 3);
  for (std::size_t i = 1; i < tilts.size(); ++i) {
    EXPECT_LT(std::abs(degrees(tilts[i].roll_rad - tilts[i - 1].roll_rad)), 1.2);
  }
  EXPECT_NEAR(degrees(tilts.back().roll_rad), -8.7, 1.5);
}

TEST(VehicleTilt, JittersByHalfADegreeWhateverTheSampling) {
  for (const double step_s : {0.01, 0.25}) {
    std::vector<VehicleLoad> loads;
    loads.reserve(20000);
    for (int i = 0; i < 20000; ++i) loads.push_back({step_s * i, 0.0, 0.0, 0.0});
    double squares = 0.0;
    for (const Tilt& tilt : vehicle_tilt(loads, 8)) squares += std::pow(degrees(tilt.pitch_rad), 2);
    EXPECT_NEAR(std::sqrt(squares / 20000.0), 0.5, 0.06) << step_s;
  }
}

TEST(PlannedFlight, BanksIntoItsTurns) {
  const Route left{.name = "left",
                   .waypoints_in_enu_m = {{0.0, 0.0}, {40.0, 0.0}, {40.0, 40.0}},
                   .corner_radius_m = 8.0};
  Route right = left;
  right.waypoints_in_enu_m[2].y() = -40.0;
  const auto strongest_roll = [](const Route& route) {
    double strongest_rad = 0.0;
    const auto flight = plan_flight(route, 1);
    for (const TimedPose& timed : flight->poses()) {
      const double roll_rad = attitude_of(timed.pose.rotation).roll_rad;
      if (std::abs(roll_rad) > std::abs(strongest_rad)) strongest_rad = roll_rad;
    }
    return degrees(strongest_rad);
  };
  EXPECT_LT(strongest_roll(left), -6.0) << "left side down";
  EXPECT_GT(strongest_roll(right), 6.0);
}

}  // namespace vehicle_attitude_test
}  // namespace nadir
