// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/geo/similarity2.h"
#include "core/geo/trajectory_file.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace recorded_trajectory_data_test {

std::filesystem::path data_folder() {
  // Read before any thread is started.
  const char* const folder = std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe)
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

class RecordedTrajectory : public testing::Test {
 protected:
  void SetUp() override {
    if (data_folder().empty())
      GTEST_SKIP() << "NADIR_TEST_DATA is not set: recorded trajectories are left out";
  }

  static Trajectory kitti00(const std::string& name) {
    const auto trajectory = read_trajectory(data_folder() / "kitti_odometry_00" / name);
    EXPECT_TRUE(trajectory) << error_text(trajectory);
    return trajectory.value_or(Trajectory());
  }

  static std::vector<Eigen::Vector2d> positions(const Trajectory& trajectory) {
    std::vector<Eigen::Vector2d> result;
    for (const TimedPose& timed : trajectory.poses()) {
      result.push_back(planar(timed.pose).translation_m());
    }
    return result;
  }
};

TEST_F(RecordedTrajectory, TruthOfKitti00IsTheKnownDrive) {
  const Trajectory truth = kitti00("poses_gt.txt");
  ASSERT_EQ(truth.size(), 4541U);
  EXPECT_NEAR(truth.planar_length_m(), 3'720.0, 10.0);
  EXPECT_NEAR(truth.end_s(), 470.58, 0.01);
  // It starts along x, and comes back to its start at the end.
  const Rigid2 after_a_second = planar(*truth.at(1.0));
  EXPECT_GT(after_a_second.x_m, 5.0);
  EXPECT_LT(std::abs(after_a_second.y_m), 1.0);
}

TEST_F(RecordedTrajectory, RotationsOfKitti00AreMadeOrthonormalAndStayAlmostLevel) {
  const Trajectory truth = kitti00("poses_gt.txt");
  for (const TimedPose& timed : truth.poses()) {
    ASSERT_NEAR(timed.pose.rotation.norm(), 1.0, 1e-14);
    const Attitude attitude = attitude_of(timed.pose.rotation);
    ASSERT_LT(std::abs(attitude.roll_rad), 0.2);
    ASSERT_LT(std::abs(attitude.pitch_rad), 0.2);
  }
}

TEST_F(RecordedTrajectory, TheHeadingOfKitti00IsTheDirectionOfTravel) {
  const Trajectory truth = kitti00("poses_gt.txt");
  int moving = 0;
  int agreeing = 0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const Rigid2 step = planar(truth.poses()[i - 1].pose).inverse() * planar(truth.poses()[i].pose);
    if (step.x_m < 0.3)
      continue;  // the camera is ahead of the rear axle: it moves sideways in turns
    ++moving;
    if (std::abs(std::atan2(step.y_m, step.x_m)) < 0.3) ++agreeing;
  }
  EXPECT_GT(moving, 4000);
  EXPECT_GT(agreeing, moving * 99 / 100);
}

TEST_F(RecordedTrajectory, MonocularOdometryFitsTheTruthOnlyWithAScale) {
  const std::vector<Eigen::Vector2d> truth = positions(kitti00("poses_gt.txt"));
  const std::vector<Eigen::Vector2d> odometry = positions(kitti00("poses_orbslam.txt"));
  const auto rigid = align_rigid2(odometry, truth);
  const auto similarity = align_similarity2(odometry, truth);
  ASSERT_TRUE(rigid && similarity);
  double rigid_m2 = 0.0;
  double similarity_m2 = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    rigid_m2 += (*rigid * odometry[i] - truth[i]).squaredNorm();
    similarity_m2 += (*similarity * odometry[i] - truth[i]).squaredNorm();
  }
  EXPECT_LT(similarity_m2, rigid_m2);
  EXPECT_NEAR(similarity->scale, 1.0, 0.2);
}

TEST_F(RecordedTrajectory, FilesOfEvoParse) {
  const std::filesystem::path folder = data_folder() / "trajectories" / "evo";
  const std::filesystem::path times = folder / "KITTI_00_gt_times.txt";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path() == times || entry.path().filename() == "V102.txt") continue;
    const auto trajectory = read_trajectory(entry.path(), times);
    EXPECT_TRUE(trajectory) << error_text(trajectory);
    ++files;
  }
  EXPECT_GE(files, 7);
}

TEST_F(RecordedTrajectory, ATimeThatRealRecordersRepeatedIsFound) {
  const auto trajectory = read_trajectory(data_folder() / "trajectories" / "evo" / "V102.txt");
  EXPECT_EQ(error_code(trajectory), ErrorCode::kMalformed);
  EXPECT_THAT(error_text(trajectory), testing::HasSubstr("V102.txt: line 433: time 1403715572"));
}

TEST_F(RecordedTrajectory, AGeoreferencedTrajectoryKeepsItsMillimetres) {
  const auto trajectory =
      read_trajectory(data_folder() / "trajectories" / "evo" / "georeferenced.tum");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  EXPECT_EQ(trajectory->size(), 1000U);
  EXPECT_EQ(trajectory->poses()[0].pose.translation_m.y(), 5429380.172093272209);
  EXPECT_GT(trajectory->planar_length_m(), 10.0);
}

TEST_F(RecordedTrajectory, AFileWithoutTimesIsRefusedWithItsReason) {
  // Seven columns: position and quaternion, but no time.
  const auto trajectory = read_trajectory(data_folder() / "rgbd_slambook" / "pose.txt");
  EXPECT_EQ(error_code(trajectory), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(trajectory), testing::HasSubstr("pose.txt: line 1: has 7 numbers"));
}

}  // namespace recorded_trajectory_data_test
}  // namespace nadir
