// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/geo/rigid2.h"
#include "core/geo/rigid3.h"

namespace nadir {
namespace rigid_test {

constexpr double kPi = std::numbers::pi;

Attitude drawn_attitude(std::uint32_t i) {
  const auto [a, b] = uniforms({7, kAttitude, i, 0, 0});
  const auto [c, d] = uniforms({7, kAttitude, i, 0, 1});
  (void)d;
  return {(2.0 * a - 1.0) * kPi, (b - 0.5) * 0.99 * kPi, (2.0 * c - 1.0) * kPi};
}

TEST(Rigid2, TurnsCounterClockwiseFromEast) {
  const Rigid2 enu_from_body{10.0, 20.0, kPi / 2.0};
  const Eigen::Vector2d ahead_in_enu = enu_from_body * Eigen::Vector2d(3.0, 0.0);
  EXPECT_NEAR(ahead_in_enu.x(), 10.0, 1e-15);
  EXPECT_NEAR(ahead_in_enu.y(), 23.0, 1e-15);
}

TEST(Rigid2, AProductAppliesTheRightFactorFirst) {
  const Rigid2 c_from_b{1.0, 2.0, 0.3};
  const Rigid2 b_from_a{-4.0, 0.5, 3.0};
  const Eigen::Vector2d point_in_a(7.0, -2.0);
  EXPECT_TRUE(
      ((c_from_b * b_from_a) * point_in_a).isApprox(c_from_b * (b_from_a * point_in_a), 1e-14));
}

TEST(Rigid2, TheInverseUndoesTheMotion) {
  const Rigid2 motion{5.0, -3.0, 2.5};
  const Rigid2 nothing = motion * motion.inverse();
  EXPECT_NEAR(nothing.x_m, 0.0, 1e-14);
  EXPECT_NEAR(nothing.y_m, 0.0, 1e-14);
  EXPECT_NEAR(nothing.yaw_rad, 0.0, 1e-15);
}

TEST(Rigid2, YawStaysInOneTurnHoweverOftenItIsMultiplied) {
  Rigid2 pose;
  for (int i = 0; i < 1000; ++i) {
    pose = pose * Rigid2{0.1, 0.0, 1.0};
    ASSERT_GT(pose.yaw_rad, -kPi);
    ASSERT_LE(pose.yaw_rad, kPi);
  }
  EXPECT_NEAR(pose.yaw_rad, std::remainder(1000.0, 2.0 * kPi), 1e-11);
}

TEST(Rigid3, AgreesWithTheMatrixOfFourByFour) {
  const Rigid3 c_from_b{rotation_of({0.1, -0.2, 2.0}), {1.0, 2.0, 3.0}};
  const Rigid3 b_from_a{rotation_of({-1.0, 0.4, -3.0}), {-5.0, 0.0, 0.5}};
  const auto matrix = [](const Rigid3& rigid) {
    Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
    result.linear() = rigid.rotation.toRotationMatrix();
    result.translation() = rigid.translation_m;
    return result.matrix();
  };
  EXPECT_TRUE(matrix(c_from_b * b_from_a).isApprox(matrix(c_from_b) * matrix(b_from_a), 1e-14));
  EXPECT_TRUE(matrix(c_from_b.inverse()).isApprox(matrix(c_from_b).inverse(), 1e-14));
}

TEST(Attitude, PositiveRollLowersTheRightSide) {
  const Eigen::Vector3d right_in_body(0.0, -1.0, 0.0);
  EXPECT_LT((rotation_of({0.1, 0.0, 0.0}) * right_in_body).z(), 0.0);
}

TEST(Attitude, PositivePitchLowersTheNose) {
  EXPECT_LT((rotation_of({0.0, 0.1, 0.0}) * Eigen::Vector3d::UnitX()).z(), 0.0);
}

TEST(Attitude, PositiveYawTurnsTheNoseToTheLeft) {
  EXPECT_GT((rotation_of({0.0, 0.0, 0.1}) * Eigen::Vector3d::UnitX()).y(), 0.0);
}

TEST(Attitude, AnglesComeBackFromTheirRotation) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Attitude wanted = drawn_attitude(i);
    const Attitude found = attitude_of(rotation_of(wanted));
    ASSERT_NEAR(found.roll_rad, wanted.roll_rad, 1e-10);
    ASSERT_NEAR(found.pitch_rad, wanted.pitch_rad, 1e-10);
    ASSERT_NEAR(found.yaw_rad, wanted.yaw_rad, 1e-10);
  }
}

TEST(Attitude, LookingStraightDownIsStillOneRotation) {
  for (const double pitch_rad : {kPi / 2.0, -kPi / 2.0}) {
    const Eigen::Quaterniond rotation = rotation_of({0.4, pitch_rad, 1.1});
    const Attitude found = attitude_of(rotation);
    EXPECT_NEAR(found.pitch_rad, pitch_rad, 1e-7);
    EXPECT_LT(rotation_of(found).angularDistance(rotation), 1e-7);
  }
}

TEST(Attitude, AnglesDoNotDependOnTheSignOfTheQuaternion) {
  const Eigen::Quaterniond q = rotation_of({0.3, -0.2, 3.0});
  const Attitude positive = attitude_of(q);
  const Attitude negative = attitude_of(Eigen::Quaterniond(-q.coeffs()));
  EXPECT_EQ(positive.yaw_rad, negative.yaw_rad);
  EXPECT_EQ(positive.roll_rad, negative.roll_rad);
}

TEST(Planar, KeepsPositionAndHeadingOnly) {
  const Rigid2 pose = planar({rotation_of({0.2, -0.1, 2.2}), {4.0, 5.0, 60.0}});
  EXPECT_EQ(pose.x_m, 4.0);
  EXPECT_EQ(pose.y_m, 5.0);
  EXPECT_NEAR(pose.yaw_rad, 2.2, 1e-14);
}

TEST(LevelFromBody, KeepsTheHeadingAheadAndUpUp) {
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Attitude attitude = drawn_attitude(i);
    const Eigen::Quaterniond level_from_body_rotation = level_from_body(rotation_of(attitude));
    const Attitude left = attitude_of(level_from_body_rotation);
    ASSERT_NEAR(left.yaw_rad, 0.0, 1e-9);
    ASSERT_NEAR(left.roll_rad, attitude.roll_rad, 1e-9);
    ASSERT_NEAR(left.pitch_rad, attitude.pitch_rad, 1e-9);
    const Eigen::Vector3d up_in_body = rotation_of(attitude).inverse() * Eigen::Vector3d::UnitZ();
    ASSERT_TRUE((level_from_body_rotation * up_in_body).isApprox(Eigen::Vector3d::UnitZ(), 1e-9));
  }
}

TEST(ForwardBodyFromCamera, PutsTheCamerasAxesWhereTheyPoint) {
  const Eigen::Quaterniond body_from_camera = forward_body_from_camera();
  EXPECT_EQ(body_from_camera.norm(), 1.0);
  EXPECT_EQ(body_from_camera * Eigen::Vector3d::UnitZ(), Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_EQ(body_from_camera * Eigen::Vector3d::UnitX(), Eigen::Vector3d(0.0, -1.0, 0.0));
  EXPECT_EQ(body_from_camera * Eigen::Vector3d::UnitY(), Eigen::Vector3d(0.0, 0.0, -1.0));
}

}  // namespace rigid_test
}  // namespace nadir
