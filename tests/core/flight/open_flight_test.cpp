// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/flight/flight_formats.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace open_flight_test {

using test::message_of;
using testing::EndsWith;
using testing::HasSubstr;

/// Two KITTI camera poses `ahead_m` apart along the optical axis.
std::string kitti_poses(double ahead_m) {
  return fmt::format("1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 {}\n", ahead_m);
}

TEST(OpenFlight, SaysWhatItLookedForInAFolderThatIsNoFlight) {
  const test::TemporaryFolder folder;
  const auto flight = open_flight(folder.path());
  ASSERT_FALSE(flight);
  EXPECT_EQ(flight.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(
      flight.error().message,
      folder.path().string() +
          ": is not a flight: no flight.toml (native), no image_02 or oxts (KITTI raw drive), "
          "no times.txt with poses*.txt (KITTI odometry)");
}

TEST(OpenFlight, SaysWhatIsNotThere) {
  const auto flight = open_flight("/no/such/flight");
  ASSERT_FALSE(flight);
  EXPECT_EQ(flight.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(flight.error().message, "/no/such/flight: does not exist");
}

TEST(OpenFlight, RefusesFilesThatAreNoTrajectories) {
  const test::TemporaryFolder folder;
  for (const auto& content :
       {std::string(), std::string("1 2 3\n"), std::string("a b c d e f g h"),
        std::string(5000, '\0'), std::string("#ROSBAG V2.0\n\x45\x00\x01", 16)}) {
    const auto flight = open_flight(folder.write("file", content));
    ASSERT_FALSE(flight);
    EXPECT_EQ(flight.error().code, ErrorCode::kUnsupported);
    EXPECT_THAT(flight.error().message, HasSubstr("file: is not a flight: "));
  }
}

TEST(OpenFlight, ATumFileIsOdometryWithoutTruth) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("spin.txt", "# comment\n\n1 0 0 0 0 0 0 1\n2 3 4 0 0 0 0.6 0.8\n");
  const auto flight = open_flight(path);
  ASSERT_TRUE(flight) << message_of(flight);
  const FlightDescription& d = (*flight)->description();
  EXPECT_EQ(d.format, "TUM trajectory");
  EXPECT_EQ(d.name, "spin");
  EXPECT_TRUE(d.frames.empty());
  EXPECT_FALSE(d.truth);
  ASSERT_TRUE(d.odometry);
  EXPECT_NEAR(d.odometry->planar_length_m(), 5.0, 1e-12);
  EXPECT_EQ(d.odometry_source, path);
  EXPECT_THROW((void)(*flight)->load(0), std::logic_error);
}

TEST(OpenFlight, ATumFileWithAFaultNamesTheLine) {
  const test::TemporaryFolder folder;
  const auto nan = folder.write("nan.txt", "nan 0 0 0 0 0 0 1\n");
  EXPECT_THAT(message_of(open_flight(nan)), HasSubstr("nan.txt: line 1"));
  const auto back = folder.write("back.txt", "2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  EXPECT_THAT(message_of(open_flight(back)), HasSubstr("back.txt: line 2"));
}

TEST(OpenFlight, KittiOdometryHasTheGroundTruthAndTheFirstOtherPoses) {
  const test::TemporaryFolder folder;
  folder.write("times.txt", "0\n0.1\n");
  folder.write("poses_gt.txt", kitti_poses(1.0));
  folder.write("poses_orbslam.txt", kitti_poses(2.0));
  folder.write("poses_zed.txt", kitti_poses(3.0));
  const auto flight = open_flight(folder.path());
  ASSERT_TRUE(flight) << message_of(flight);
  const FlightDescription& d = (*flight)->description();
  EXPECT_EQ(d.format, "KITTI odometry");
  // The camera's z is the body's x.
  EXPECT_LT((d.truth->poses()[1].pose.translation_m - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((d.odometry->poses()[1].pose.translation_m - Eigen::Vector3d(2, 0, 0)).norm(), 1e-12);
  EXPECT_FALSE(d.camera);
  EXPECT_EQ(d.truth_source.filename(), "poses_gt.txt");
  EXPECT_EQ(d.odometry_source.filename(), "poses_orbslam.txt");
  ASSERT_EQ(d.other_odometry.size(), 1U);
  EXPECT_EQ(d.other_odometry[0].filename(), "poses_zed.txt");
}

TEST(OpenFlight, KittiOdometryWithASinglePoseFileHasOnlyTruth) {
  const test::TemporaryFolder folder;
  folder.write("times.txt", "0\n0.1\n");
  folder.write("poses.txt", kitti_poses(1.0));
  const auto flight = open_flight(folder.path());
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_TRUE((*flight)->description().truth);
  EXPECT_FALSE((*flight)->description().odometry);
}

TEST(OpenFlight, KittiOdometryWithoutGroundTruthHasOnlyOdometry) {
  const test::TemporaryFolder folder;
  folder.write("times.txt", "0\n0.1\n");
  folder.write("poses_a.txt", kitti_poses(1.0));
  folder.write("poses_b.txt", kitti_poses(2.0));
  const auto flight = open_flight(folder.path());
  ASSERT_TRUE(flight) << message_of(flight);
  EXPECT_FALSE((*flight)->description().truth);
  EXPECT_EQ((*flight)->description().odometry->poses()[1].pose.translation_m.x(), 1.0);
}

TEST(OpenFlight, KittiOdometryWithTooFewTimesIsMalformed) {
  const test::TemporaryFolder folder;
  folder.write("times.txt", "0\n");
  folder.write("poses.txt", kitti_poses(1.0));
  const auto flight = open_flight(folder.path());
  ASSERT_FALSE(flight);
  EXPECT_EQ(flight.error().code, ErrorCode::kMalformed);
  EXPECT_THAT(flight.error().message, HasSubstr("poses.txt"));
}

TEST(OpenFlight, TheNativeFormatComesFirst) {
  const test::TemporaryFolder folder;
  folder.write("flight.toml", "[flight]\nformat_version = 1\n");
  folder.write("times.txt", "0\n0.1\n");
  folder.write("poses.txt", kitti_poses(1.0));
  std::filesystem::create_directory(folder.path() / "image_02");
  EXPECT_EQ((*open_flight(folder.path()))->description().format, "nadir flight");
}

}  // namespace open_flight_test
}  // namespace nadir
