// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <numbers>

#include "core/flight/flight_recording.h"
#include "core/flight/kitti_raw_text.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace kitti_raw_test {

using test::message_of;
using testing::EndsWith;
using testing::HasSubstr;

TEST(KittiTimestamps, AreSecondsSince1970) {
  const auto times_s = parse_kitti_timestamps(
      "1970-01-01 00:00:00.000000000\n1970-01-02 01:02:03.5\n2011-09-26 13:04:32.345808896\n",
      "timestamps.txt");
  ASSERT_TRUE(times_s) << message_of(times_s);
  ASSERT_EQ(times_s->size(), 3U);
  EXPECT_EQ((*times_s)[0], 0.0);
  EXPECT_EQ((*times_s)[1], 86400.0 + 3723.5);
  EXPECT_NEAR((*times_s)[2], 1317042272.345808896, 1e-6);
}

TEST(KittiTimestamps, CrossLeapDaysAndMidnight) {
  const auto times_s = parse_kitti_timestamps(
      "2012-02-28 23:59:59.9\n2012-02-29 00:00:00.1\n2012-03-01 00:00:00.1\n", "t");
  ASSERT_TRUE(times_s);
  EXPECT_NEAR((*times_s)[1] - (*times_s)[0], 0.2, 1e-6);
  EXPECT_NEAR((*times_s)[2] - (*times_s)[1], 86400.0, 1e-6);
}

TEST(KittiTimestamps, NameTheLineThatIsNone) {
  for (const char* wrong :
       {"yesterday", "2011-09-26", "2011-13-26 13:04:32", "2011-02-30 13:04:32",
        "2011-09-26 24:04:32", "2011-09-26 13:60:32", "2011-09-26 13:04:nan", "2011-09-26 13-04-32",
        "2011-09-26 13:04:61", "20110-9-26 13:04:32", ""}) {
    const auto times_s = parse_kitti_timestamps(
        fmt::format("2011-09-26 13:04:32.3\n{}\n2011-09-26 13:04:33.3\n", wrong), "t.txt");
    ASSERT_FALSE(times_s) << wrong;
    EXPECT_THAT(times_s.error().message, HasSubstr("t.txt: line 2: "));
  }
}

std::string packet_text(const OxtsPacket& packet) {
  std::string text =
      fmt::format("{} {} {} {} {} {} 0 0 {} {} {}", packet.position.latitude_deg,
                  packet.position.longitude_deg, packet.altitude_m, packet.attitude.roll_rad,
                  packet.attitude.pitch_rad, packet.attitude.yaw_rad, packet.speed_in_level_mps.x(),
                  packet.speed_in_level_mps.y(), packet.speed_in_level_mps.z());
  for (int column = 11; column < 22; ++column) text += " 77";
  return text + fmt::format(" {} 0.1 0.1 4 10 4 4 0\n", packet.turn_rate_radps);
}

/// A circle of 50 m radius, left-hand, at 10 m/s, heading east at first, driven on the ground at 49
/// N 8.4 E.
std::vector<OxtsPacket> circle(int count, double period_s) {
  const auto plane = ProjectPlane::create({49.0, 8.4});
  std::vector<OxtsPacket> packets;
  for (int i = 0; i < count; ++i) {
    const double time_s = period_s * i;
    const double yaw_rad = 0.2 * time_s;
    OxtsPacket packet;
    packet.time_s = time_s;
    packet.position =
        plane->geodetic_from_enu({50.0 * std::sin(yaw_rad), 50.0 * (1.0 - std::cos(yaw_rad))});
    packet.altitude_m = 110.0 + 0.1 * time_s;
    packet.attitude = {0.02, -0.03, wrap_rad(yaw_rad)};
    packet.speed_in_level_mps = {10.0, 0.0, 0.1};
    packet.turn_rate_radps = 0.2;
    packets.push_back(packet);
  }
  return packets;
}

TEST(OxtsPacket, HasItsColumnsWhereTheFormatSays) {
  OxtsPacket packet = circle(3, 1.0)[2];
  packet.speed_in_level_mps = {1.0, 2.0, 3.0};
  const auto again = parse_oxts_packet(packet_text(packet), "0.txt");
  ASSERT_TRUE(again) << message_of(again);
  EXPECT_EQ(again->position.latitude_deg, packet.position.latitude_deg);
  EXPECT_EQ(again->position.longitude_deg, packet.position.longitude_deg);
  EXPECT_EQ(again->altitude_m, packet.altitude_m);
  EXPECT_EQ(again->attitude.roll_rad, 0.02);
  EXPECT_EQ(again->attitude.pitch_rad, -0.03);
  EXPECT_EQ(again->attitude.yaw_rad, packet.attitude.yaw_rad);
  EXPECT_EQ(again->speed_in_level_mps, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(again->turn_rate_radps, 0.2);
}

TEST(OxtsPacket, RefusesTooFewNumbersAndNan) {
  EXPECT_EQ(message_of(parse_oxts_packet("1 2 3", "0.txt")), "0.txt: has 3 numbers, fewer than 23");
  std::string text = packet_text(circle(1, 1.0)[0]);
  EXPECT_EQ(message_of(parse_oxts_packet("nan" + text.substr(text.find(' ')), "0.txt")),
            "0.txt: number 1 is 'nan', not a finite number");
}

TEST(OxtsTruth, IsThePathInThePlaneAtTheFirstPacket) {
  const auto truth = truth_from_oxts(circle(60, 0.5), "oxts");
  ASSERT_TRUE(truth) << message_of(truth);
  for (const TimedPose& timed : truth->poses()) {
    const double yaw_rad = 0.2 * timed.time_s;
    EXPECT_NEAR(timed.pose.translation_m.x(), 50.0 * std::sin(yaw_rad), 1e-6);
    EXPECT_NEAR(timed.pose.translation_m.y(), 50.0 * (1.0 - std::cos(yaw_rad)), 1e-6);
    EXPECT_NEAR(timed.pose.translation_m.z(), 0.1 * timed.time_s, 1e-9);
    const Attitude attitude = attitude_of(timed.pose.rotation);
    EXPECT_NEAR(wrap_rad(attitude.yaw_rad - yaw_rad), 0.0, 2e-5);
    EXPECT_NEAR(attitude.roll_rad, 0.02, 1e-12);
    EXPECT_NEAR(attitude.pitch_rad, -0.03, 1e-12);
  }
}

TEST(OxtsTruth, YawIsOfTheGridWhereTrueNorthLeansAway) {
  // 30 km east of the plane's centre at 60 N the meridians lean by 0.47 degrees. A vehicle that
  // heads true east there moves along the parallel, which a small step of longitude shows.
  std::vector<OxtsPacket> packets(2);
  packets[0].position = {60.0, 8.0};
  packets[1].position = {60.0, 8.54};
  packets[1].time_s = 1.0;
  const auto truth = truth_from_oxts(packets, "oxts");
  ASSERT_TRUE(truth) << message_of(truth);
  const auto plane = ProjectPlane::create(packets[0].position);
  const Eigen::Vector2d along =
      plane->enu_from_geodetic({60.0, 8.5401}) - plane->enu_from_geodetic({60.0, 8.5399});
  const double expected_rad = std::atan2(along.y(), along.x());
  EXPECT_GT(std::abs(expected_rad), 0.005);
  EXPECT_NEAR(attitude_of(truth->poses()[1].pose.rotation).yaw_rad, expected_rad, 1e-6);
}

TEST(OxtsOdometry, IntegratesSpeedsAndTurnRateFromTheOrigin) {
  const double period_s = 0.1;
  const auto odometry = odometry_from_oxts(circle(400, period_s), "oxts");
  ASSERT_TRUE(odometry) << message_of(odometry);
  const TimedPose& first = odometry->poses().front();
  EXPECT_EQ(first.pose.translation_m, Eigen::Vector3d::Zero());
  for (const TimedPose& timed : odometry->poses()) {
    const double yaw_rad = 0.2 * timed.time_s;
    // A chord is shorter than its arc by (turn per step)^2 / 24 of its length.
    EXPECT_NEAR(timed.pose.translation_m.x(), 50.0 * std::sin(yaw_rad), 2e-3);
    EXPECT_NEAR(timed.pose.translation_m.y(), 50.0 * (1.0 - std::cos(yaw_rad)), 2e-3);
    EXPECT_NEAR(timed.pose.translation_m.z(), 0.1 * timed.time_s, 1e-9);
    EXPECT_NEAR(wrap_rad(attitude_of(timed.pose.rotation).yaw_rad - yaw_rad), 0.0, 1e-9);
    EXPECT_NEAR(attitude_of(timed.pose.rotation).roll_rad, 0.02, 1e-9);
  }
}

TEST(OxtsOdometry, NeverLooksAtPositionsOrAtTheMeasuredYaw) {
  std::vector<OxtsPacket> packets = circle(50, 0.1);
  const auto before = odometry_from_oxts(packets, "oxts");
  for (OxtsPacket& packet : packets) {
    packet.position = {-20.0, 100.0};
    packet.altitude_m = 3.0;
    packet.attitude.yaw_rad = 2.5;
  }
  const auto after = odometry_from_oxts(packets, "oxts");
  for (std::size_t i = 0; i < before->size(); ++i) {
    EXPECT_EQ(before->poses()[i].pose.translation_m, after->poses()[i].pose.translation_m);
    EXPECT_EQ(before->poses()[i].pose.rotation.coeffs(), after->poses()[i].pose.rotation.coeffs());
  }
}

TEST(OxtsOdometry, SidewaysSpeedGoesToTheLeft) {
  std::vector<OxtsPacket> packets(2);
  packets[1].time_s = 2.0;
  for (OxtsPacket& packet : packets) packet.speed_in_level_mps = {0.0, 1.5, 0.0};
  const auto odometry = odometry_from_oxts(packets, "oxts");
  EXPECT_EQ(odometry->poses()[1].pose.translation_m, Eigen::Vector3d(0.0, 3.0, 0.0));
}

constexpr const char* kCamToCam =
    "calib_time: 09-Jan-2012 13:57:47\nS_rect_02: 100 50\nR_rect_00: 1 0 0 0 1 0 0 0 1\n"
    "P_rect_02: 80 0 49.5 8 0 81 24.5 0 0 0 1 0\n";
// Velodyne axes are x forward, y left, z up, like the body's.
constexpr const char* kVeloToCam = "R: 0 -1 0 0 0 -1 1 0 0\nT: 0 -0.1 -0.3\n";
constexpr const char* kImuToVelo = "R: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.8\n";

TEST(KittiCamera, HasItsHalfPixelAndStandsWhereTheCalibrationSays) {
  const auto mount =
      camera_from_kitti(parse_kitti_calibration(kCamToCam), parse_kitti_calibration(kVeloToCam),
                        parse_kitti_calibration(kImuToVelo), "day");
  ASSERT_TRUE(mount) << message_of(mount);
  EXPECT_EQ(mount->camera.width, 100);
  EXPECT_EQ(mount->camera.height, 50);
  EXPECT_EQ(mount->camera.centre_x_px, 50.0);
  EXPECT_EQ(mount->camera.centre_y_px, 25.0);
  EXPECT_EQ(mount->camera.focal_x_px, 80.0);
  EXPECT_EQ(mount->camera.focal_y_px, 81.0);
  const Eigen::Vector3d ahead = mount->body_from_camera.rotation * Eigen::Vector3d::UnitZ();
  EXPECT_LT((ahead - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  // Any point of the body must fall on the pixel that P R (Tr (Tr p)) gives, written out here with
  // plain matrices.
  const Eigen::Vector3d point_in_body(12.0, 1.0, 0.5);
  const Eigen::Vector3d in_velodyne = point_in_body + Eigen::Vector3d(-0.8, 0.3, -0.8);
  const Eigen::Vector3d in_camera0(-in_velodyne.y(), -in_velodyne.z() - 0.1, in_velodyne.x() - 0.3);
  const double u = (80.0 * in_camera0.x() + 49.5 * in_camera0.z() + 8.0) / in_camera0.z();
  const double v = (81.0 * in_camera0.y() + 24.5 * in_camera0.z()) / in_camera0.z();
  const Eigen::Vector2d pixel =
      mount->camera.project(mount->body_from_camera.inverse() * point_in_body);
  EXPECT_NEAR(pixel.x(), u + 0.5, 1e-9);
  EXPECT_NEAR(pixel.y(), v + 0.5, 1e-9);
}

TEST(KittiCamera, NamesTheFileAndTheKeyThatIsWrong) {
  const auto fault = [](const char* cam, const char* velo, const char* imu) {
    return message_of(camera_from_kitti(parse_kitti_calibration(cam), parse_kitti_calibration(velo),
                                        parse_kitti_calibration(imu), "day"));
  };
  EXPECT_EQ(fault("", kVeloToCam, kImuToVelo), "day/calib_cam_to_cam.txt: S_rect_02 is missing");
  EXPECT_EQ(fault(kCamToCam, "R: 1 2\n", kImuToVelo),
            "day/calib_velo_to_cam.txt: R has 2 numbers, not 9");
  EXPECT_EQ(fault(kCamToCam, kVeloToCam, "R: 2 0 0 0 1 0 0 0 1\nT: 0 0 0\n"),
            "day/calib_imu_to_velo.txt: R is not a rotation");
  EXPECT_EQ(fault(kCamToCam, kVeloToCam, "R: 1 0 0 0 1 0 0 0 -1\nT: 0 0 0\n"),
            "day/calib_imu_to_velo.txt: R is not a rotation");
  EXPECT_EQ(fault(kCamToCam, kVeloToCam, "R: 1 0 0 0 1 0 0 0 1\nT: 0 nan 0\n"),
            "day/calib_imu_to_velo.txt: T is missing");
}

class KittiRawDrive : public testing::Test {
 protected:
  void SetUp() override {
    day_.write("calib_cam_to_cam.txt", kCamToCam);
    day_.write("calib_velo_to_cam.txt", kVeloToCam);
    day_.write("calib_imu_to_velo.txt", kImuToVelo);
    std::string image_times;
    std::string oxts_times;
    const auto packets = circle(6, 0.1);
    for (int i = 0; i < 6; ++i) {
      image_times += fmt::format("2011-09-26 13:00:0{}.050000000\n", i);
      oxts_times += fmt::format("2011-09-26 13:00:0{}.000000000\n", i);
      day_.write(fmt::format("drive/oxts/data/{:010}.txt", i),
                 packet_text(packets[static_cast<std::size_t>(i)]));
    }
    day_.write("drive/image_02/timestamps.txt", image_times);
    day_.write("drive/oxts/timestamps.txt", oxts_times);
    for (const int number : {0, 2, 5}) {
      day_.write(fmt::format("drive/image_02/data/{:010}.png", number), "not read");
    }
  }
  [[nodiscard]] Result<std::unique_ptr<FlightRecording>> open() const {
    return open_flight(day_.path() / "drive");
  }

  test::TemporaryFolder day_;
};

TEST_F(KittiRawDrive, FramesWithGapsHaveTheTimeOfTheirNumber) {
  const auto flight = open();
  ASSERT_TRUE(flight) << message_of(flight);
  const FlightDescription& d = (*flight)->description();
  EXPECT_EQ(d.format, "KITTI raw drive");
  EXPECT_EQ(d.name, "drive");
  ASSERT_EQ(d.frames.size(), 3U);
  EXPECT_NEAR(d.frames[1].time_s - d.frames[0].time_s, 2.0, 1e-6);
  EXPECT_NEAR(d.frames[2].time_s - d.frames[0].time_s, 5.0, 1e-6);
  EXPECT_THAT(d.frames[2].image->string(), EndsWith("drive/image_02/data/0000000005.png"));
  EXPECT_EQ(d.truth->size(), 6U);
  EXPECT_EQ(d.odometry->size(), 6U);
  EXPECT_EQ(d.truth_origin->latitude_deg, circle(1, 1.0)[0].position.latitude_deg);
  EXPECT_TRUE(d.camera);
  EXPECT_NEAR(d.altitude_m, 0.93, 1e-12);
}

TEST_F(KittiRawDrive, HasNothingToLocaliseWith) {
  const auto frame = (*open())->load(0);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::kUnsupported);
  EXPECT_THAT(frame.error().message,
              EndsWith("has images but no label images, so there is nothing to localise with"));
}

TEST_F(KittiRawDrive, OpensWithoutCalibrationImagesOrPackets) {
  std::filesystem::remove(day_.path() / "calib_cam_to_cam.txt");
  EXPECT_FALSE((*open())->description().camera);
  std::filesystem::remove_all(day_.path() / "drive/oxts");
  EXPECT_FALSE((*open())->description().odometry);
  std::filesystem::remove_all(day_.path() / "drive/image_02/data");
  EXPECT_THAT(message_of(open()), HasSubstr("without a picture in image_02/data"));
}

TEST_F(KittiRawDrive, NamesWhatIsMissingOrWrong) {
  std::filesystem::remove(day_.path() / "calib_imu_to_velo.txt");
  EXPECT_THAT(message_of(open()), EndsWith("calib_imu_to_velo.txt: does not exist"));
  SetUp();
  day_.write("drive/image_02/data/0000000009.png", "late");
  EXPECT_THAT(message_of(open()),
              EndsWith("0000000009.png: is frame 9, but timestamps.txt has only 6 lines"));
  SetUp();
  std::filesystem::remove(day_.path() / "drive/image_02/data/0000000009.png");
  std::filesystem::remove(day_.path() / "drive/oxts/timestamps.txt");
  EXPECT_THAT(message_of(open()), EndsWith("oxts/timestamps.txt: does not exist"));
  SetUp();
  std::string times = "2011-09-26 13:00:09.0\n";
  for (int i = 1; i < 6; ++i) times += fmt::format("2011-09-26 13:00:0{}.0\n", i);
  day_.write("drive/image_02/timestamps.txt", times);
  EXPECT_THAT(message_of(open()), HasSubstr("image_02/timestamps.txt: line 3: "));
  day_.write("drive/oxts/timestamps.txt", times);
  day_.write("drive/image_02/timestamps.txt", std::string());
  EXPECT_FALSE(open());
}

}  // namespace kitti_raw_test
}  // namespace nadir
