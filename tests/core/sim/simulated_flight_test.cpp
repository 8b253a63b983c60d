// SPDX-License-Identifier: Apache-2.0
#include "core/sim/simulated_flight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include "core/base/parallel.h"
#include "core/base/staged_output.h"
#include "core/flight/colour_image.h"
#include "core/flight/flight_recording.h"
#include "core/sim/route.h"
#include "tests/core/sim/street_map.h"

namespace nadir {
namespace simulated_flight_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A folder of its own for every test, gone afterwards.
class SimulatedFlightTest : public testing::Test {
 protected:
  void SetUp() override {
    output =
        fs::path(testing::TempDir()) /
        (std::string("nadir_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(output);
    fs::create_directories(output);
  }
  void TearDown() override { fs::remove_all(output); }

  fs::path output;
};

SimulationOptions small_images() {
  SimulationOptions options;
  options.image_width_px = 96;
  options.image_height_px = 72;
  return options;
}

/// A short flight along the eastbound lane and round the corner.
FlownPath short_flight() {
  const Route route{.name = "short",
                    .waypoints_in_enu_m = {{20.0, 28.0}, {42.0, 28.0}, {42.0, 40.0}}};
  return {"short", plan_flight(route, 1).value(), std::nullopt, 4.0};
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files[fs::relative(entry.path(), folder).string()] = read_text_file(entry.path()).value();
  }
  return files;
}

TEST_F(SimulatedFlightTest, IsAFlightThatCanBeOpenedAndHoldsWhatWasFlown) {
  const FlownPath path = short_flight();
  const auto flown = simulate_flight(street_map(), path, small_images(), output / "f", {});
  ASSERT_TRUE(flown.has_value()) << flown.error().message;
  EXPECT_EQ(flown->frames, static_cast<std::size_t>(path.truth.end_s() * 4.0) + 1);
  EXPECT_EQ(flown->frames_off_map, 0U);
  EXPECT_NEAR(flown->length_m, path.truth.planar_length_m(), 1e-9);

  const auto recording = open_flight(output / "f");
  ASSERT_TRUE(recording.has_value()) << recording.error().message;
  const FlightDescription& description = (*recording)->description();
  ASSERT_EQ(description.frames.size(), flown->frames);
  EXPECT_NEAR(description.frames[6].time_s, 1.5, 1e-6);
  EXPECT_EQ(description.camera->width, 96);
  EXPECT_NEAR(description.altitude_m, 2.0, 1e-9);
  EXPECT_NEAR(description.truth_origin->latitude_deg, 33.45, 1e-9);
  ASSERT_TRUE(description.truth && description.odometry);
  EXPECT_EQ(description.truth->size(), path.truth.size());
  EXPECT_TRUE(description.truth->poses()[40].pose.translation_m.isApprox(
      path.truth.poses()[40].pose.translation_m, 1e-9));
}

TEST_F(SimulatedFlightTest, ShowsTheMapWhereTheTruthSays) {
  // From the files alone: depth, camera, body and truth put every label on its cell of the map.
  const OverheadMap map = street_map();
  SimulationOptions options = small_images();
  options.has_label_noise = false;
  ASSERT_TRUE(simulate_flight(map, short_flight(), options, output / "f", {}).has_value());
  const auto recording = open_flight(output / "f");
  ASSERT_TRUE(recording.has_value());
  const FlightDescription& description = (*recording)->description();
  int points = 0;
  int right = 0;
  for (std::size_t i = 0; i < description.frames.size(); i += 5) {
    const auto frame = (*recording)->load(i);
    ASSERT_TRUE(frame.has_value());
    const Rigid3 enu_from_camera =
        *description.truth->at(frame->time_s) * description.body_from_camera;
    for (int row = 0; row < 72; ++row) {
      for (int column = 0; column < 96; ++column) {
        const double depth_m = static_cast<double>(frame->depth_m.at(column, row));
        const Eigen::Vector3d point =
            enu_from_camera * (depth_m * description.camera->ray({column + 0.5, row + 0.5}));
        // Cars, trees and people are not in the map; on the ground everything is.
        if (depth_m <= 0.0 || point.z() > 0.13 || is_movable(frame->labels.at(column, row)))
          continue;
        ++points;
        right += map.class_at(point.head<2>()) == frame->labels.at(column, row) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(points, 10'000);
  EXPECT_GT(right, 0.98 * points);
}

/// A picture of one colour.
ColourRaster plain_picture(const OverheadMap& map, const Colour& colour) {
  return {map.labels.width(), map.labels.height(), colour};
}

TEST_F(SimulatedFlightTest, HoldsWhatTheCameraSawInColour) {
  const OverheadMap map = street_map();
  const auto flown = simulate_flight(map, short_flight(), small_images(), output / "f", {},
                                     plain_picture(map, {30, 160, 90}));
  ASSERT_TRUE(flown.has_value()) << flown.error().message;
  const auto recording = open_flight(output / "f");
  ASSERT_TRUE(recording.has_value()) << recording.error().message;
  for (const FlightFrame& frame : (*recording)->description().frames) {
    ASSERT_TRUE(frame.image.has_value());
    const auto image = read_colour_image(*frame.image);
    ASSERT_TRUE(image.has_value()) << image.error().message;
    EXPECT_EQ(image->width(), 96);
    EXPECT_EQ(image->height(), 72);
    EXPECT_GT(image->at(48, 0).blue, 150) << "sky is above";
  }
  // The first frame looks along the empty lane: road right in front of the camera.
  const auto first = read_colour_image(*(*recording)->description().frames[0].image);
  EXPECT_NEAR(first->at(48, 70).red, 30, 12);
  EXPECT_NEAR(first->at(48, 70).green, 160, 12);
  EXPECT_NEAR(first->at(48, 70).blue, 90, 12);
}

TEST_F(SimulatedFlightTest, IsTheSameFlightWithoutColour) {
  SimulationOptions options = small_images();
  ASSERT_TRUE(simulate_flight(street_map(), short_flight(), options, output / "c", {}).has_value());
  ASSERT_TRUE(set_option(options, "colour", "false").has_value());
  ASSERT_TRUE(simulate_flight(street_map(), short_flight(), options, output / "n", {}).has_value());
  auto with_colour = files_of(output / "c");
  const auto without = files_of(output / "n");
  EXPECT_EQ(without.count("rgb.txt"), 0U);
  EXPECT_EQ(
      std::erase_if(with_colour, [](const auto& file) { return file.first.starts_with("rgb"); }),
      std::count_if(without.begin(), without.end(), [](const auto& file) {
        return file.first.starts_with("labels/");
      }) + 1);
  EXPECT_EQ(with_colour, without) << "labels, depth and poses do not depend on colour";
}

TEST_F(SimulatedFlightTest, RefusesAPictureOfAnotherSize) {
  const auto flown = simulate_flight(street_map(), short_flight(), small_images(), output / "f", {},
                                     ColourRaster(10, 20));
  ASSERT_FALSE(flown.has_value());
  EXPECT_EQ(flown.error().code, ErrorCode::kInvalidOptions);
  EXPECT_EQ(flown.error().message,
            "map 'drawn': its picture is 10 x 20 pixels, but its labels are 400 x 300");
  EXPECT_TRUE(fs::is_empty(output));
}

TEST_F(SimulatedFlightTest, IsTheSameToTheLastByteOnAnyNumberOfThreads) {
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    SimulationOptions options = small_images();
    options.level = SimulationLevel::kHard;
    ASSERT_TRUE(
        simulate_flight(street_map(), short_flight(), options, output / std::to_string(threads), {})
            .has_value());
  }
  const auto one = files_of(output / "1");
  EXPECT_GT(one.size(), 50U);
  EXPECT_EQ(one, files_of(output / "2"));
}

TEST_F(SimulatedFlightTest, DiffersWithTheSeed) {
  SimulationOptions options = small_images();
  ASSERT_TRUE(simulate_flight(street_map(), short_flight(), options, output / "1", {}).has_value());
  options.seed = 2;
  ASSERT_TRUE(simulate_flight(street_map(), short_flight(), options, output / "2", {}).has_value());
  EXPECT_NE(files_of(output / "1").at("odometry.txt"), files_of(output / "2").at("odometry.txt"));
  EXPECT_EQ(files_of(output / "1").at("truth.txt"), files_of(output / "2").at("truth.txt"));
}

TEST_F(SimulatedFlightTest, LeavesNothingBehindWhenItIsStopped) {
  std::stop_source stop;
  double last_fraction = 0.0;
  const WorkContext work{stop.get_token(), [&](double fraction, const std::string&) {
                           EXPECT_GE(fraction, last_fraction);
                           last_fraction = fraction;
                           if (fraction > 0.3) stop.request_stop();
                         }};
  const auto flown =
      simulate_flight(street_map(), short_flight(), small_images(), output / "f", work);
  ASSERT_FALSE(flown.has_value());
  EXPECT_EQ(flown.error().code, ErrorCode::kCancelled);
  EXPECT_TRUE(fs::is_empty(output));
}

TEST_F(SimulatedFlightTest, ReplacesAFlightThatItHasMadeAndNoRecording) {
  const auto fly = [&] {
    return simulate_flight(street_map(), short_flight(), small_images(), output / "f", {});
  };
  ASSERT_TRUE(fly());
  const auto again = fly();
  ASSERT_TRUE(again.has_value()) << again.error().message;
  const fs::path toml = output / "f" / "flight.toml";
  const std::string generator = "generator = \"nadir simulate\"\n";
  std::string text = read_text_file(toml).value();
  ASSERT_NE(text.find(generator), std::string::npos);
  // What remains could have been recorded by a camera.
  ASSERT_TRUE(write_text_file(toml, text.erase(text.find(generator), generator.size())));
  const auto files = files_of(output / "f");
  const auto over_recording = fly();
  ASSERT_FALSE(over_recording.has_value());
  EXPECT_THAT(over_recording.error().message, HasSubstr("may be a recording"));
  EXPECT_EQ(files_of(output / "f"), files);
}

TEST_F(SimulatedFlightTest, RefusesAPathThatStartsOffTheMap) {
  const Route route{.name = "lost", .waypoints_in_enu_m = {{-5.0, 28.0}, {42.0, 28.0}}};
  const FlownPath path{"lost", plan_flight(route, 1).value(), std::nullopt, 4.0};
  const auto flown = simulate_flight(street_map(), path, small_images(), output / "f", {});
  ASSERT_FALSE(flown.has_value());
  EXPECT_THAT(flown.error().message,
              HasSubstr("lost: the path starts off the map drawn at (-5.0, 28.0) m"));
  EXPECT_TRUE(fs::is_empty(output));
}

TEST_F(SimulatedFlightTest, CountsFramesThatLeaveTheMap) {
  const Route route{.name = "out", .waypoints_in_enu_m = {{70.0, 28.0}, {90.0, 28.0}}};
  const FlownPath path{"out", plan_flight(route, 1).value(), std::nullopt, 4.0};
  const auto flown = simulate_flight(street_map(), path, small_images(), output / "f", {});
  ASSERT_TRUE(flown.has_value());
  EXPECT_GT(flown->frames_off_map, 5U);
  EXPECT_LT(flown->frames_off_map, flown->frames);
}

TEST_F(SimulatedFlightTest, RefusesOptionsAndMapsThatCannotWork) {
  SimulationOptions options = small_images();
  options.frame_rate_hz = std::nan("");
  const auto rate = simulate_flight(street_map(), short_flight(), options, output / "f", {});
  ASSERT_FALSE(rate.has_value());
  EXPECT_THAT(rate.error().message, HasSubstr("frame-rate"));
  const auto blank = drawn_map(10.0, {"......", "......", "......", "......", "......"});
  const auto flown = simulate_flight(blank, short_flight(), small_images(), output / "f", {});
  ASSERT_FALSE(flown.has_value());
  EXPECT_EQ(flown.error().code, ErrorCode::kMalformed);
  EXPECT_TRUE(fs::is_empty(output));
}

/// A recorded drive in a frame of its own: first pose tilted and turned, then ahead and to the
/// left.
Trajectory recorded_drive() {
  const double yaw_rad = 0.5;
  std::vector<TimedPose> poses;
  poses.reserve(6);
  for (int i = 0; i < 6; ++i) {
    poses.push_back({10.0 + 0.1 * i,
                     {rotation_of({0.0, 0.02 + 0.01 * i, yaw_rad + 0.1 * i}),
                      {3.0 + i * std::cos(yaw_rad), -2.0 + i * std::sin(yaw_rad), 7.0 + 0.3 * i}}});
  }
  return Trajectory::create(std::move(poses), "drive").value();
}

TEST(PlaceRecordedPath, LaysTheFirstPoseOnTheStartAndTurnsTheRestWithIt) {
  const Trajectory placed = place_recorded_path(recorded_drive(), Rigid2{100.0, 50.0, 1.5}, 2.0);
  ASSERT_EQ(placed.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto ahead_m = static_cast<double>(i);
    const Rigid3& pose = placed.poses()[i].pose;
    const Attitude attitude = attitude_of(pose.rotation);
    EXPECT_NEAR(pose.translation_m.x(), 100.0 + ahead_m * std::cos(1.5), 1e-9);
    EXPECT_NEAR(pose.translation_m.y(), 50.0 + ahead_m * std::sin(1.5), 1e-9);
    EXPECT_EQ(pose.translation_m.z(), 2.0);
    EXPECT_NEAR(attitude.yaw_rad, 1.5 + 0.1 * ahead_m, 1e-9);
    EXPECT_NEAR(attitude.pitch_rad, 0.01 * ahead_m, 4e-3) << "relative to the first pose";
    EXPECT_EQ(placed.poses()[i].time_s, recorded_drive().poses()[i].time_s);
  }
}

TEST(PlaceRecordedPath, KeepsPosesThatAreInEnuAlreadyButTheirHeight) {
  const Trajectory recorded = recorded_drive();
  const Trajectory placed = place_recorded_path(recorded, std::nullopt, 1.7);
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    const Rigid3& before = recorded.poses()[i].pose;
    const Rigid3& after = placed.poses()[i].pose;
    EXPECT_EQ(after.translation_m.head<2>(), before.translation_m.head<2>());
    EXPECT_EQ(after.translation_m.z(), 1.7);
    EXPECT_TRUE(after.rotation.isApprox(before.rotation));
  }
}

TEST_F(SimulatedFlightTest, TakesRecordedOdometryAsItIsAndMakesAFrameOfEveryTruePose) {
  const Trajectory truth = place_recorded_path(recorded_drive(), Rigid2{20.0, 28.0, 0.0}, 2.0);
  const FlownPath path{"drive", truth, recorded_drive(), std::nullopt};
  const auto flown = simulate_flight(street_map(), path, small_images(), output / "f", {});
  ASSERT_TRUE(flown.has_value()) << flown.error().message;
  EXPECT_EQ(flown->frames, 6U);
  const auto recording = open_flight(output / "f");
  ASSERT_TRUE(recording.has_value());
  const auto& odometry = (*recording)->description().odometry;
  ASSERT_TRUE(odometry.has_value());
  ASSERT_EQ(odometry->size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_TRUE(odometry->poses()[i].pose.translation_m.isApprox(
        recorded_drive().poses()[i].pose.translation_m, 1e-9));
  }
}

TEST_F(SimulatedFlightTest, RefusesOdometryOfAnotherTime) {
  std::vector<TimedPose> later = recorded_drive().poses();
  for (TimedPose& timed : later) timed.time_s += 1000.0;
  const Trajectory truth = place_recorded_path(recorded_drive(), Rigid2{20.0, 28.0, 0.0}, 2.0);
  const FlownPath path{"drive", truth, Trajectory::create(later, "later").value(), std::nullopt};
  const auto flown = simulate_flight(street_map(), path, small_images(), output / "f", {});
  ASSERT_FALSE(flown.has_value());
  EXPECT_THAT(flown.error().message, HasSubstr("share no time"));
}

TEST(LevelNoise, IsTheTableOfTheThesis) {
  EXPECT_EQ(level_noise(SimulationLevel::kEasy).odometry_position_mse_m2, 7.78);
  EXPECT_EQ(level_noise(SimulationLevel::kMedium).inverse_depth_sigma, 0.0);
  EXPECT_EQ(level_noise(SimulationLevel::kMedium).depth_range_m, 20.0);
  EXPECT_EQ(level_noise(SimulationLevel::kHard).inverse_depth_sigma, 0.05);
  EXPECT_EQ(level_noise(SimulationLevel::kHard).depth_range_m, 12.0);
}

TEST(SimulationOptions, AreAllReachableByNameWorldIncluded) {
  SimulationOptions options;
  EXPECT_TRUE(set_option(options, "level", "hard").has_value());
  EXPECT_TRUE(set_option(options, "tree-share", "0.1").has_value());
  EXPECT_TRUE(set_option(options, "label-noise", "false").has_value());
  EXPECT_EQ(options.level, SimulationLevel::kHard);
  EXPECT_EQ(options.world.tree_share, 0.1);
  EXPECT_FALSE(options.has_label_noise);
  EXPECT_TRUE(options.has_colour);
  EXPECT_TRUE(set_option(options, "colour", "false").has_value());
  EXPECT_FALSE(options.has_colour);
  EXPECT_FALSE(set_option(options, "tree-share", "1.5").has_value());
}

}  // namespace simulated_flight_test
}  // namespace nadir
