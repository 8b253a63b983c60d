// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/flight/flight_recording.h"
#include "core/geo/trajectory_file.h"
#include "core/map/map_import.h"
#include "core/sim/simulated_flight.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// The hand-drawn town of KITTI 00; its README gives georeference and classes.
OverheadMap drawn_town(const fs::path& data) {
  ImportOptions options;
  options.name = "kitti00";
  options.anchor = Geodetic{48.987721, 8.387722};
  options.metres_per_pixel = 1.0 / 3.058;
  options.flip_vertically = true;
  options.inside_value = 0;
  options.remap =
      ClassRemap::parse(
          "[ids]\n0 = \"terrain\"\n1 = \"road\"\n3 = \"building\"\n4 = \"vegetation\"\n", "kitti00")
          .value();
  return import_map(data / "maps" / "kitti00_drawn", options).value().map;
}

/// Where the drive begins: the README's similarity puts the first camera at pixel (592.6, 746.5) of
/// the stored raster, whose rows run north, looking along (-sin a, cos a) with a = 5.7515.
Rigid2 start_of_drive(const OverheadMap& town) {
  constexpr double kTurnRad = 5.7515;
  const Eigen::Vector2d start = town.enu_from_overhead({592.6, town.labels.height() - 746.5});
  return {start.x(), start.y(), std::atan2(std::cos(kTurnRad), -std::sin(kTurnRad))};
}

TEST(RecordedPath, IsObservedAlongTheRoadsOfTheDrawnTown) {
  const char* folder =
      std::getenv("NADIR_TEST_DATA");  // NOLINT(concurrency-mt-unsafe): tests set no variables
  if (folder == nullptr) GTEST_SKIP() << "NADIR_TEST_DATA is not set: no recorded drive";
  const fs::path data = folder;
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
  const fs::path output = fs::path(testing::TempDir()) / "nadir_recorded_path";
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
  fs::remove_all(output);
}

}  // namespace
}  // namespace nadir
