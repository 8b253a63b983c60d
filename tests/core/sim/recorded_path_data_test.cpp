// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/flight/flight_recording.h"
#include "core/geo/trajectory_file.h"
#include "core/sim/simulated_flight.h"
#include "tests/support/recorded_drive.h"

namespace nadir {
namespace recorded_path_data_test {

TEST(RecordedPath, IsObservedAlongTheRoadsOfTheDrawnTown) {
  const std::filesystem::path data = test_data_folder();
  if (data.empty()) GTEST_SKIP() << "NADIR_TEST_DATA is not set: no recorded drive";
  const OverheadMap town = drawn_town(data);
  const auto recorded = read_trajectory(data / "kitti_odometry_00" / "poses_gt.txt");
  const auto odometry = read_trajectory(data / "kitti_odometry_00" / "poses_sptam.txt");
  ASSERT_TRUE(recorded && odometry);
  const Trajectory truth = place_recorded_path(*recorded, start_of_drive(town), 2.0);
  int on_road = 0;
  for (const TimedPose& timed : truth.poses()) {
    on_road += town.class_at(timed.pose.translation_m.head<2>()) == kRoad ? 1 : 0;
    const Attitude attitude = attitude_of(timed.pose.rotation);
    EXPECT_LT(std::hypot(attitude.roll_rad, attitude.pitch_rad), 0.2) << "a car stays upright";
  }
  EXPECT_GT(on_road, 0.99 * static_cast<double>(truth.size()));

  const std::vector<TimedPose> first(truth.poses().begin(), truth.poses().begin() + 20);
  const FlownPath path{"drive", Trajectory::create(first, "drive").value(), *odometry,
                       std::nullopt};
  const std::filesystem::path output =
      std::filesystem::path(testing::TempDir()) / "nadir_recorded_path";
  SimulationOptions options;
  options.image_width_px = 160;
  options.image_height_px = 120;
  const auto flown = simulate_flight(town, path, options, output, {});
  ASSERT_TRUE(flown.has_value()) << flown.error().message;
  EXPECT_EQ(flown->frames, 20U);
  EXPECT_EQ(flown->frames_off_map, 0U);
  const auto recording = open_flight(output);
  ASSERT_TRUE(recording.has_value());
  const auto frame = (*recording)->load(10);
  ASSERT_TRUE(frame.has_value());
  // The street ahead of the car's bonnet.
  int road = 0;
  for (int column = 60; column < 100; ++column)
    road += frame->labels.at(column, 110) == kRoad ? 1 : 0;
  EXPECT_GT(road, 20);
  std::filesystem::remove_all(output);
}

}  // namespace recorded_path_data_test
}  // namespace nadir
