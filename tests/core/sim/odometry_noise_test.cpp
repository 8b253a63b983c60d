// SPDX-License-Identifier: Apache-2.0
#include "core/sim/odometry_noise.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/sim/simulated_flight.h"

namespace nadir {
namespace odometry_noise_test {

/// A banked flight in a circle, with time stamps that are not evenly spaced.
Trajectory circle(double duration_s) {
  std::vector<TimedPose> poses;
  for (double time_s = 100.0; time_s <= 100.0 + duration_s;
       time_s += poses.size() % 3 == 0 ? 0.2 : 0.05) {
    const double angle_rad = 0.2 * time_s;
    poses.push_back({time_s,
                     {rotation_of({-0.1, 0.07, wrap_rad(angle_rad)}),
                      {20.0 * std::sin(angle_rad), -20.0 * std::cos(angle_rad), 2.0}}});
  }
  return Trajectory::create(std::move(poses), "circle").value();
}

struct MeanSquares {
  double position_m2 = 0.0, yaw_rad2 = 0.0;
};

MeanSquares errors_of(const Trajectory& odometry, const Trajectory& truth) {
  MeanSquares sum;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Rigid2 a = planar(odometry.poses()[i].pose);
    const Rigid2 b = planar(truth.poses()[i].pose);
    sum.position_m2 += (a.translation_m() - b.translation_m()).squaredNorm();
    sum.yaw_rad2 += std::pow(wrap_rad(a.yaw_rad - b.yaw_rad), 2);
  }
  const auto count = static_cast<double>(truth.size());
  return {sum.position_m2 / count, sum.yaw_rad2 / count};
}

class EveryLevel : public testing::TestWithParam<SimulationLevel> {};

TEST_P(EveryLevel, DriftsAsMuchAsTheThesisMeasuredInTheMeanOverFlights) {
  const LevelNoise level = level_noise(GetParam());
  const Trajectory truth = circle(100.0);
  const OdometryDiffusion diffusion =
      calibrated_diffusion(truth, level.odometry_position_mse_m2, level.odometry_yaw_mse_rad2);
  MeanSquares mean;
  constexpr int kFlights = 1000;
  for (std::uint64_t seed = 1; seed <= kFlights; ++seed) {
    const MeanSquares one = errors_of(drifting_odometry(truth, diffusion, seed), truth);
    mean.position_m2 += one.position_m2 / kFlights;
    mean.yaw_rad2 += one.yaw_rad2 / kFlights;
  }
  EXPECT_NEAR(mean.position_m2 / level.odometry_position_mse_m2, 1.0, 0.1);
  EXPECT_NEAR(mean.yaw_rad2 / level.odometry_yaw_mse_rad2, 1.0, 0.1);
}

INSTANTIATE_TEST_SUITE_P(OdometryNoise,
                         EveryLevel,
                         testing::Values(SimulationLevel::kEasy,
                                         SimulationLevel::kMedium,
                                         SimulationLevel::kHard));

TEST(OdometryNoise, IsCalibratedForAnyDuration) {
  // The mean time of evenly spaced samples is half the duration: q = sqrt(mse / duration).
  for (const double duration_s : {10.0, 400.0}) {
    std::vector<TimedPose> poses;
    for (int i = 0; i <= 1000; ++i) poses.push_back({0.001 * i * duration_s, {}});
    const auto truth = Trajectory::create(std::move(poses), "hover").value();
    const OdometryDiffusion diffusion = calibrated_diffusion(truth, 50.0, 0.1);
    EXPECT_NEAR(diffusion.position_m_per_sqrt_s, std::sqrt(50.0 / duration_s), 1e-9);
    EXPECT_NEAR(diffusion.yaw_rad_per_sqrt_s, std::sqrt(0.2 / duration_s), 1e-9);
  }
}

TEST(OdometryNoise, StartsAtTheTruthAndKeepsHeightRollAndPitch) {
  const Trajectory truth = circle(60.0);
  const Trajectory odometry = drifting_odometry(truth, {1.0, 0.05}, 4);
  ASSERT_EQ(odometry.size(), truth.size());
  EXPECT_TRUE(odometry.poses()[0].pose.translation_m.isApprox(truth.poses()[0].pose.translation_m));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Rigid3& pose = odometry.poses()[i].pose;
    const Attitude attitude = attitude_of(pose.rotation);
    EXPECT_EQ(odometry.poses()[i].time_s, truth.poses()[i].time_s);
    EXPECT_NEAR(attitude.roll_rad, -0.1, 1e-9);
    EXPECT_NEAR(attitude.pitch_rad, 0.07, 1e-9);
    EXPECT_EQ(pose.translation_m.z(), 2.0);
  }
}

TEST(OdometryNoise, DoesNotTurnThePositionWalkByTheYawWalk) {
  // "Added in an integral fashion to the true pose": the position error is the same with and
  // without a yaw error.
  const Trajectory truth = circle(60.0);
  const Trajectory straight = drifting_odometry(truth, {1.0, 0.0}, 4);
  const Trajectory turned = drifting_odometry(truth, {1.0, 0.3}, 4);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(straight.poses()[i].pose.translation_m, turned.poses()[i].pose.translation_m);
  }
}

TEST(OdometryNoise, IsTheTruthWithoutDiffusionAndAFunctionOfTheSeed) {
  const Trajectory truth = circle(20.0);
  const auto end = [&](const OdometryDiffusion& diffusion, std::uint64_t seed) {
    return drifting_odometry(truth, diffusion, seed).poses().back().pose.translation_m.eval();
  };
  EXPECT_EQ(end({0.0, 0.0}, 1), truth.poses().back().pose.translation_m);
  EXPECT_EQ(end({1.0, 0.1}, 1), end({1.0, 0.1}, 1));
  EXPECT_NE(end({1.0, 0.1}, 1), end({1.0, 0.1}, 2));
}

TEST(OdometryNoise, HasNoDriftToCalibrateWithoutDuration) {
  const auto truth = Trajectory::create({{5.0, {}}}, "one pose").value();
  EXPECT_EQ(calibrated_diffusion(truth, 50.0, 0.1).position_m_per_sqrt_s, 0.0);
}

TEST(DriftingOdometry, ReportsTheMotionOfTheBodyTurnedByTheYawError) {
  const Trajectory truth = circle(60.0);
  const Trajectory odometry = drifting_odometry(truth, {.yaw_rad_per_sqrt_s = 0.1}, 3);
  double largest_rad = 0.0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Rigid2 start = planar(truth.poses()[i - 1].pose);
    const Rigid2 reported_start = planar(odometry.poses()[i - 1].pose);
    const double error_rad = wrap_rad(reported_start.yaw_rad - start.yaw_rad);
    const Eigen::Vector2d motion =
        (start.inverse() * planar(truth.poses()[i].pose)).translation_m();
    const Eigen::Vector2d reported =
        (reported_start.inverse() * planar(odometry.poses()[i].pose)).translation_m();
    EXPECT_NEAR((reported - Eigen::Rotation2Dd(-error_rad) * motion).norm(), 0.0, 1e-9);
    largest_rad = std::max(largest_rad, std::abs(error_rad));
  }
  EXPECT_GT(largest_rad, 0.3) << "or nothing was shown";
}

}  // namespace odometry_noise_test
}  // namespace nadir
