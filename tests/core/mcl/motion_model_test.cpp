// SPDX-License-Identifier: Apache-2.0
#include "core/mcl/motion_model.h"

#include <gmock/gmock.h>

#include <numbers>

#include "core/mcl/pose_estimate.h"

namespace nadir {
namespace motion_model_test {

ParticleSet copies(std::size_t count, const Rigid2& pose) {
  ParticleSet particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    particles.set_pose(i, pose);
    particles.weight[i] = 1.0 / static_cast<double>(count);
  }
  return particles;
}

LocaliserOptions without_noise(MotionKind kind) {
  LocaliserOptions options;
  options.motion = kind;
  options.rotation_noise_rad = options.translation_noise_m = 0.0;
  options.position_noise_m_per_sqrt_s = options.along_noise_m_per_sqrt_m = 0.0;
  options.across_noise_m_per_sqrt_m = options.yaw_noise_rad_per_sqrt_s = 0.0;
  options.turn_noise_rad_per_sqrt_rad = 0.0;
  return options;
}

void expect_pose(const Rigid2& actual, const Rigid2& expected) {
  EXPECT_NEAR(actual.x_m, expected.x_m, 1e-12);
  EXPECT_NEAR(actual.y_m, expected.y_m, 1e-12);
  EXPECT_NEAR(wrap_rad(actual.yaw_rad - expected.yaw_rad), 0.0, 1e-12);
}

TEST(MotionModel, ComposesTheStepExactlyWhenThereIsNoNoise) {
  const Rigid2 start{3.0, -2.0, 2.9};
  for (const MotionKind kind : {MotionKind::kThesis, MotionKind::kScaled}) {
    for (const Rigid2& step :
         {Rigid2{1.0, 0.2, 0.5}, Rigid2{-0.5, 0.1, -3.0}, Rigid2{0.0, 0.0, 0.3}}) {
      ParticleSet particles = copies(1, start);
      predict(particles, {step, 0.25}, without_noise(kind), 1);
      expect_pose(particles.pose(0), start * step);
    }
  }
}

TEST(MotionModel, HasTheThesisSpreadOfTurnGoTurn) {
  LocaliserOptions options = localiser_preset("thesis").value();
  ParticleSet particles = copies(20'000, {});
  predict(particles, {{4.0, 0.0, 0.0}, 1.0}, options, 1);
  const PoseMoments moments = pose_moments(particles);
  EXPECT_NEAR(std::sqrt(moments.covariance(0, 0)), 0.3, 0.02);  // along: sigma_trans
  EXPECT_NEAR(std::sqrt(moments.covariance(1, 1)), 4.0 * 0.1,
              0.02);  // across: way times sigma_rot1
  EXPECT_NEAR(std::sqrt(moments.covariance(2, 2)), 0.1 * std::numbers::sqrt2,
              0.01);  // both rotations
}

TEST(MotionModel, SpreadsTheSameInOneStepAndInTenTenths) {
  LocaliserOptions options;  // every noise is on
  options.position_noise_m_per_sqrt_s = 0.5;
  options.along_noise_m_per_sqrt_m = 0.2;
  options.across_noise_m_per_sqrt_m = 0.4;
  options.yaw_noise_rad_per_sqrt_s =
      0.001;  // so small that where ten steps lead does not blur where one leads
  options.turn_noise_rad_per_sqrt_rad = 0.01;
  ParticleSet once = copies(20'000, {});
  predict(once, {{4.0, 0.0, 0.02}, 1.0}, options, 1);
  ParticleSet often = copies(20'000, {});
  for (std::uint32_t i = 0; i < 10; ++i) predict(often, {{0.4, 0.0, 0.002}, 0.1}, options, i + 1);
  const PoseMoments one = pose_moments(once);
  const PoseMoments ten = pose_moments(often);
  for (const int i : {0, 1, 2}) {
    EXPECT_NEAR(std::sqrt(ten.covariance(i, i) / one.covariance(i, i)), 1.0, 0.03) << i;
  }
  EXPECT_NEAR(std::sqrt(one.covariance(0, 0)), std::sqrt(0.25 + 0.04 * 4.0), 0.02);
  EXPECT_NEAR(std::sqrt(one.covariance(1, 1)), std::sqrt(0.25 + 0.16 * 4.0), 0.02);
}

TEST(MotionModel, InventsNoHeadingForAHoveringVehicle) {
  LocaliserOptions options = without_noise(MotionKind::kScaled);
  options.across_noise_m_per_sqrt_m = 0.5;
  ParticleSet particles = copies(100, {1.0, 2.0, 0.3});
  predict(particles, {{0.001, -0.002, 0.0}, 0.0}, options, 1);
  const PoseMoments moments = pose_moments(particles);
  EXPECT_NEAR(moments.mean.yaw_rad, 0.3, 1e-12);
  EXPECT_NEAR(moments.covariance.norm(), 0.0, 1e-12);
}

TEST(MotionModel, HasNoiseOfMeanZero) {
  LocaliserOptions options;
  ParticleSet particles = copies(40'000, {0.0, 0.0, 1.0});
  const Rigid2 step{1.0, 0.0, 0.1};
  predict(particles, {step, 0.25}, options, 7);
  const PoseMoments moments = pose_moments(particles);
  const Rigid2 expected = Rigid2{0.0, 0.0, 1.0} * step;
  const double tolerance_m = 4.0 * std::sqrt(moments.covariance(0, 0) / 40'000.0);
  EXPECT_NEAR(moments.mean.x_m, expected.x_m, tolerance_m);
  EXPECT_NEAR(moments.mean.y_m, expected.y_m, tolerance_m);
  EXPECT_NEAR(moments.mean.yaw_rad, expected.yaw_rad,
              4.0 * std::sqrt(moments.covariance(2, 2) / 40'000.0));
}

TEST(Blur, HasTheThesisCovarianceAndScalesWithTimeWhereAsked) {
  LocaliserOptions options = localiser_preset("thesis").value();
  ParticleSet particles = copies(20'000, {});
  blur(particles, 123.0, options, 1);  // one blur a step, whatever the time
  EXPECT_NEAR(pose_moments(particles).covariance(0, 0), 1.0, 0.04);
  EXPECT_NEAR(pose_moments(particles).covariance(2, 2), 0.1, 0.005);
  options.blur_interval_s = 2.0;
  particles = copies(20'000, {});
  blur(particles, 0.5, options, 1);
  EXPECT_NEAR(pose_moments(particles).covariance(1, 1), 0.25, 0.01);
}

TEST(Blur, ChangesNothingWhenItIsOff) {
  ParticleSet particles = copies(10, {1.0, 2.0, 3.0});
  const ParticleSet before = particles;
  blur(particles, 1.0, LocaliserOptions{}, 1);
  EXPECT_EQ(particles, before);
}

}  // namespace motion_model_test
}  // namespace nadir
