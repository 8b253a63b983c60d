// SPDX-License-Identifier: Apache-2.0
#include "core/geo/trajectory.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/support/error_text.h"

namespace nadir {
namespace trajectory_test {

using testing::HasSubstr;

TimedPose pose_at(double time_s, double x_m, double y_m = 0.0, double yaw_rad = 0.0) {
  return {time_s, {rotation_of({0.0, 0.0, yaw_rad}), {x_m, y_m, 0.0}}};
}

Trajectory trajectory_of(std::vector<TimedPose> poses) {
  auto trajectory = Trajectory::create(std::move(poses), "drawn.tum");
  EXPECT_TRUE(trajectory) << error_text(trajectory);
  return trajectory.value_or(Trajectory());
}

TEST(Trajectory, RefusesATimeThatRepeats) {
  const auto refused = Trajectory::create({pose_at(0, 0), pose_at(1, 0), pose_at(1, 0)}, "a.tum");
  ASSERT_FALSE(refused);
  EXPECT_EQ(error_code(refused), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(refused), HasSubstr("a.tum: pose 3: time 1 does not come after 1"));
}

TEST(Trajectory, RefusesATimeThatGoesBack) {
  const auto refused = Trajectory::create({pose_at(5, 0), pose_at(4, 0)}, "a.tum");
  EXPECT_THAT(error_text(refused), HasSubstr("pose 2: time 4 does not come after 5"));
}

TEST(Trajectory, RefusesNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(error_text(Trajectory::create({pose_at(nan, 0)}, "a")),
              HasSubstr("pose 1: its time"));
  EXPECT_THAT(error_text(Trajectory::create({pose_at(0, 0), pose_at(1, infinity)}, "a")),
              HasSubstr("pose 2: is not finite"));
  TimedPose bad_rotation = pose_at(0, 0);
  bad_rotation.pose.rotation.x() = nan;
  EXPECT_FALSE(Trajectory::create({bad_rotation}, "a"));
}

TEST(Trajectory, InterpolatesPositionLinearly) {
  const Trajectory trajectory = trajectory_of({pose_at(10.0, 0.0, 4.0), pose_at(11.0, 8.0, 0.0)});
  const auto pose = trajectory.at(10.25);
  ASSERT_TRUE(pose.has_value());
  EXPECT_TRUE(pose->translation_m.isApprox(Eigen::Vector3d(2.0, 3.0, 0.0), 1e-15));
}

TEST(Trajectory, InterpolatesRotationTheShortWayRound) {
  const Trajectory trajectory = trajectory_of({pose_at(0, 0, 0, 3.0), pose_at(1, 0, 0, -3.0)});
  const auto pose = trajectory.at(0.5);
  ASSERT_TRUE(pose.has_value());
  EXPECT_NEAR(std::abs(planar(*pose).yaw_rad), std::numbers::pi, 1e-12);
}

TEST(Trajectory, InterpolationDoesNotCareForTheSignOfAQuaternion) {
  TimedPose flipped = pose_at(1, 0, 0, 0.2);
  flipped.pose.rotation.coeffs() *= -1.0;
  const auto pose = trajectory_of({pose_at(0, 0, 0, 0.0), flipped}).at(0.5);
  ASSERT_TRUE(pose.has_value());
  EXPECT_NEAR(planar(*pose).yaw_rad, 0.1, 1e-12);
}

TEST(Trajectory, GivesRecordedPosesExactly) {
  const Trajectory trajectory = trajectory_of({pose_at(0.1, 1), pose_at(0.7, 2), pose_at(9.0, 3)});
  for (const TimedPose& recorded : trajectory.poses()) {
    const auto pose = trajectory.at(recorded.time_s);
    ASSERT_TRUE(pose.has_value());
    EXPECT_EQ(pose->translation_m, recorded.pose.translation_m);
    EXPECT_EQ(pose->rotation.coeffs(), recorded.pose.rotation.coeffs());
  }
}

TEST(Trajectory, GivesNothingInsideALongGapUnlessAskedTo) {
  const Trajectory trajectory = trajectory_of({pose_at(0, 0), pose_at(1, 1), pose_at(4, 4)});
  EXPECT_TRUE(trajectory.at(0.5).has_value());
  EXPECT_FALSE(trajectory.at(2.0).has_value());
  EXPECT_TRUE(trajectory.at(2.0, 3.0).has_value());
  EXPECT_TRUE(trajectory.at(4.0).has_value());  // the far side of the gap was recorded
}

TEST(Trajectory, ForgivesAMillisecondAtItsEndsAndNoMore) {
  const Trajectory trajectory = trajectory_of({pose_at(1.0, 1.0), pose_at(1.5, 2.0)});
  EXPECT_EQ(trajectory.at(0.9995)->translation_m.x(), 1.0);
  EXPECT_EQ(trajectory.at(1.5005)->translation_m.x(), 2.0);
  EXPECT_FALSE(trajectory.at(0.998).has_value());
  EXPECT_FALSE(trajectory.at(1.502).has_value());
  EXPECT_FALSE(trajectory.at(std::numeric_limits<double>::quiet_NaN()).has_value());
}

TEST(Trajectory, ASinglePoseIsATrajectoryOfAnInstant) {
  const Trajectory trajectory = trajectory_of({pose_at(3.0, 7.0)});
  EXPECT_EQ(trajectory.start_s(), trajectory.end_s());
  EXPECT_EQ(trajectory.at(3.0)->translation_m.x(), 7.0);
  EXPECT_FALSE(trajectory.at(3.1).has_value());
  EXPECT_EQ(trajectory.planar_length_m(), 0.0);
}

TEST(Trajectory, WithoutPosesAnswersNothing) {
  const Trajectory trajectory;
  EXPECT_TRUE(trajectory.empty());
  EXPECT_FALSE(trajectory.at(0.0).has_value());
  EXPECT_EQ(trajectory.planar_length_m(), 0.0);
}

TEST(Trajectory, LengthIsMeasuredInThePlane) {
  std::vector<TimedPose> poses = {pose_at(0, 0, 0), pose_at(1, 3, 4), pose_at(2, 3, 0)};
  poses[1].pose.translation_m.z() = 100.0;  // climbing does not count
  EXPECT_EQ(trajectory_of(poses).planar_length_m(), 9.0);
}

TEST(Trajectory, StaysFiniteBetweenPosesThatAreImmenselyFarApart) {
  const double far_m = std::numeric_limits<double>::max();
  const auto pose = trajectory_of({pose_at(0, -far_m), pose_at(1, far_m)}).at(0.5);
  ASSERT_TRUE(pose.has_value());
  EXPECT_TRUE(pose->translation_m.allFinite());
}

}  // namespace trajectory_test
}  // namespace nadir
