// SPDX-License-Identifier: Apache-2.0
#include "core/geo/trajectory_file.h"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace trajectory_file_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kIdentity = "1 0 0 0 0 1 0 0 0 0 1 0\n";
/// Two metres forward (camera z), one to the right (camera x), half a metre down (camera y).
constexpr const char* kForward = "1 0 0 1 0 1 0 0.5 0 0 1 2\n";

std::string tum_error(std::string_view text) {
  return error_text(parse_tum_trajectory(text, "flight.tum"));
}

std::string kitti_error(std::string_view text, const std::vector<double>& times_s) {
  return error_text(parse_kitti_trajectory(text, times_s, "00.txt"));
}

TEST(TumTrajectory, ReadsTimePositionAndQuaternionWithWLast) {
  const auto trajectory =
      parse_tum_trajectory("# time x y z qx qy qz qw\n10.5 1 2 3 0 0 0.6 0.8\n", "flight.tum");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  const TimedPose& pose = trajectory->poses().at(0);
  EXPECT_EQ(pose.time_s, 10.5);
  EXPECT_EQ(pose.pose.translation_m, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_NEAR(planar(pose.pose).yaw_rad, 2.0 * std::atan2(0.6, 0.8), 1e-15);
}

TEST(TumTrajectory, ReadsWindowsFilesWithBlankLinesAndComments) {
  const auto trajectory = parse_tum_trajectory(
      "\xEF\xBB\xBF# head\r\n\r\n0 0 0 0 0 0 0 1\r\n# between\r\n1\t1 0 0 0 0 0 1\r\n\r\n",
      "w.tum");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  EXPECT_EQ(trajectory->size(), 2U);
}

TEST(TumTrajectory, NamesTheLineOfEachFault) {
  EXPECT_EQ(tum_error("# c\n0 0 0 0 0 0 1\n"),
            "flight.tum: line 2: has 7 numbers, but a TUM pose has 8");
  EXPECT_THAT(tum_error("0 0 0 0 0 0 0 1 9\n"), HasSubstr("line 1: has 9 numbers"));
  EXPECT_THAT(tum_error("0 0 0 0 0 0 0 1\n1 nan 0 0 0 0 0 1\n"), HasSubstr("line 2: 'nan'"));
  EXPECT_THAT(tum_error("0 0 inf 0 0 0 0 1\n"), HasSubstr("line 1: 'inf'"));
  EXPECT_THAT(tum_error("time x y z qx qy qz qw\n"), HasSubstr("line 1: 'time' is not a number"));
}

TEST(TumTrajectory, RefusesTimesThatRepeatOrGoBack) {
  EXPECT_EQ(tum_error("1 0 0 0 0 0 0 1\n\n1 0 0 0 0 0 0 1\n"),
            "flight.tum: line 3: time 1 does not come after 1");
  EXPECT_THAT(tum_error("1 0 0 0 0 0 0 1\n0.5 0 0 0 0 0 0 1\n"),
              HasSubstr("line 2: time 0.5 does not come after 1"));
}

TEST(TumTrajectory, NormalisesARoundedQuaternionAndRefusesAWrongOne) {
  const auto rounded = parse_tum_trajectory("0 0 0 0 0 0 0.603 0.8\n", "flight.tum");
  ASSERT_TRUE(rounded) << error_text(rounded);
  EXPECT_NEAR(rounded->poses()[0].pose.rotation.norm(), 1.0, 1e-15);
  EXPECT_THAT(tum_error("0 0 0 0 0 0 0 0\n"), HasSubstr("line 1: the quaternion (0, 0, 0, 0)"));
  EXPECT_THAT(tum_error("0 0 0 0 0 0 0 1.02\n"), HasSubstr("is not of unit length"));
  EXPECT_THAT(tum_error("0 0 0 0 1e308 1e308 1e308 1e308\n"), HasSubstr("unit length"));
}

TEST(TumTrajectory, AFileWithoutPosesIsAFault) {
  EXPECT_EQ(tum_error(""), "flight.tum: holds no poses");
  EXPECT_EQ(tum_error("# only words\n\n"), "flight.tum: holds no poses");
}

TEST(TumText, ReadsBackAsTheSameNumbersToTheLastBit) {
  std::vector<TimedPose> poses;
  for (std::uint32_t i = 0; i < 500; ++i) {
    const auto [a, b] = standard_normals({5, 99, i, 0, 0});
    const auto [c, d] = standard_normals({5, 99, i, 0, 1});
    poses.push_back(
        {1'706'282'470.0983865 + 0.1 * i,
         {rotation_of({0.2 * a, 0.2 * b, c}), {458'074.6 + a, 5'429'380.2 + b, 1e-9 * d}}});
  }
  const auto written = Trajectory::create(poses, "made");
  ASSERT_TRUE(written);
  const auto read = parse_tum_trajectory(tum_text(*written, "two lines\nof comment"), "read");
  ASSERT_TRUE(read) << error_text(read);
  ASSERT_EQ(read->size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(read->poses()[i].time_s, poses[i].time_s);
    ASSERT_EQ(read->poses()[i].pose.translation_m, poses[i].pose.translation_m);
    ASSERT_EQ(read->poses()[i].pose.rotation.coeffs(), poses[i].pose.rotation.coeffs());
  }
}

TEST(KittiTrajectory, TheFirstPoseStaysTheIdentityExactly) {
  const auto trajectory = parse_kitti_trajectory(kIdentity, {0.0}, "00.txt");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  EXPECT_EQ(trajectory->poses()[0].pose.rotation.coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_EQ(trajectory->poses()[0].pose.translation_m, Eigen::Vector3d(0.0, 0.0, 0.0));
}

TEST(KittiTrajectory, CameraAxesBecomeForwardLeftAndUp) {
  const auto trajectory =
      parse_kitti_trajectory(std::string(kIdentity) + kForward, {0, 1}, "00.txt");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  EXPECT_EQ(trajectory->poses()[1].pose.translation_m, Eigen::Vector3d(2.0, -1.0, -0.5));
}

TEST(KittiTrajectory, ARightTurnOfTheCameraIsANegativeYaw) {
  // About the camera's y axis (down) by +30 degrees: z turns towards x, that is to the right.
  const double c = std::cos(std::numbers::pi / 6.0);
  const std::string line = fmt::format("{0} 0 0.5 0 0 1 0 0 -0.5 0 {0} 0\n", c);
  const auto trajectory = parse_kitti_trajectory(line, {0.0}, "00.txt");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  const Attitude attitude = attitude_of(trajectory->poses()[0].pose.rotation);
  EXPECT_NEAR(attitude.yaw_rad, -std::numbers::pi / 6.0, 1e-12);
  EXPECT_NEAR(attitude.roll_rad, 0.0, 1e-12);
  EXPECT_NEAR(attitude.pitch_rad, 0.0, 1e-12);
}

TEST(KittiTrajectory, RoundedRotationsAreMadeOrthonormal) {
  const auto trajectory =
      parse_kitti_trajectory("0.866 0 0.5 0 0 1 0 0 -0.5 0 0.866 0\n", {0.0}, "00.txt");
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  const Eigen::Matrix3d r = trajectory->poses()[0].pose.rotation.toRotationMatrix();
  EXPECT_LT((r.transpose() * r - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_NEAR(planar(trajectory->poses()[0].pose).yaw_rad, -std::atan2(0.5, 0.866), 1e-12);
}

TEST(KittiTrajectory, RefusesMatricesThatAreNotRotations) {
  const std::vector<std::string> lines = {"1 0 0 0 0 1 0 0 0 0 -1 0",       // a mirror
                                          "0 0 0 0 0 0 0 0 0 0 0 0",        // nothing
                                          "1.1 0 0 0 0 1.1 0 0 0 0 1.1 0",  // a scale
                                          "1 0.1 0 0 0 1 0 0 0 0 1 0",      // a shear
                                          "1e200 0 0 0 0 1e200 0 0 0 0 1e200 0"};
  for (const std::string& line : lines) {
    EXPECT_EQ(kitti_error(line, {0.0}),
              "00.txt: line 1: the first three columns of the pose are not a rotation")
        << line;
  }
}

TEST(KittiTrajectory, NeedsOneTimeAPose) {
  const std::string two = std::string(kIdentity) + kForward;
  EXPECT_EQ(kitti_error(two, {0.0}), "00.txt: holds 2 poses, but there are 1 times");
  EXPECT_EQ(kitti_error(two, {0.0, 1.0, 2.0}), "00.txt: holds 2 poses, but there are 3 times");
  EXPECT_THAT(kitti_error(two, {1.0, 0.5}), HasSubstr("pose 2: time 0.5 does not come after 1"));
  EXPECT_THAT(kitti_error(two, {0.0, std::nan("")}), HasSubstr("is not finite"));
}

TEST(KittiTrajectory, NamesTheLineOfAWrongColumnCount) {
  EXPECT_EQ(kitti_error(std::string(kIdentity) + "1 0 0\n", {0, 1}),
            "00.txt: line 2: has 3 numbers, but a KITTI pose has 12");
}

TEST(KittiTrajectory, PositionsThatOverflowAreRefused) {
  // The axes' change doubles numbers on its way: the largest doubles do not survive it, and that is
  // said.
  const std::string line = "1 0 0 1.7e308 0 1 0 1.7e308 0 0 1 1.7e308\n";
  const auto trajectory = parse_kitti_trajectory(line, {0.0}, "00.txt");
  if (trajectory) {
    EXPECT_TRUE(trajectory->poses()[0].pose.translation_m.allFinite());
  } else {
    EXPECT_THAT(error_text(trajectory), HasSubstr("is not finite"));
  }
}

TEST(Times, AreReadOneALine) {
  const auto times_s = parse_times("0.000000e+00\r\n1.037359e-01\n", "times.txt");
  ASSERT_TRUE(times_s) << error_text(times_s);
  EXPECT_THAT(*times_s, ElementsAre(0.0, 0.1037359));
}

TEST(Times, NamesTheLineOfEachFault) {
  EXPECT_EQ(error_text(parse_times("0\n1 2\n", "times.txt")),
            "times.txt: line 2: has 2 numbers, but a line of times has 1");
  EXPECT_EQ(error_text(parse_times("0\n2\n1\n", "times.txt")),
            "times.txt: line 3: time 1 does not come after 2");
  EXPECT_EQ(error_text(parse_times("\n", "times.txt")), "times.txt: holds no times");
}

TEST(ReadTrajectory, TellsTheFormatsApartByTheirColumns) {
  const ScratchFolder folder;
  const auto tum = read_trajectory(folder.file("a.txt", "0 0 0 0 0 0 0 1\n"));
  EXPECT_TRUE(tum) << error_text(tum);
  const auto poses = folder.file("b.txt", std::string(kIdentity) + kForward);
  const auto without_times = read_trajectory(poses);
  EXPECT_EQ(error_code(without_times), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(without_times), HasSubstr("there is no"));
  const auto given = read_trajectory(poses, folder.file("elsewhere.txt", "5\n6\n"));
  ASSERT_TRUE(given) << error_text(given);
  EXPECT_EQ(given->start_s(), 5.0);
  (void)folder.file("times.txt", "7\n8\n");
  const auto beside = read_trajectory(poses);
  ASSERT_TRUE(beside) << error_text(beside);
  EXPECT_EQ(beside->start_s(), 7.0);
}

TEST(ReadTrajectory, EachFaultNamesItsFile) {
  const ScratchFolder folder;
  const auto missing = read_trajectory(folder.path() / "none.tum");
  EXPECT_EQ(error_code(missing), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(missing), HasSubstr("none.tum"));
  const auto odd = read_trajectory(folder.file("odd.txt", "\n1 2 3 4 5 6 7\n"));
  EXPECT_EQ(error_code(odd), ErrorCode::kUnsupported);
  EXPECT_THAT(error_text(odd), HasSubstr("odd.txt: line 2: has 7 numbers"));
  EXPECT_THAT(error_text(read_trajectory(folder.file("empty.txt", ""))),
              HasSubstr("holds no poses"));
  EXPECT_FALSE(read_trajectory(folder.path()));
  const auto poses = folder.file("p.txt", kIdentity);
  EXPECT_EQ(error_code(read_trajectory(poses, folder.path() / "gone.txt")), ErrorCode::kNotFound);
  EXPECT_THAT(error_text(read_trajectory(poses, folder.file("t.txt", "0\n1\n"))),
              HasSubstr("p.txt: holds 1 poses, but there are 2 times"));
}

TEST(ReadTrajectory, ReadsAnHourAtAHundredHertzInSeconds) {
  std::string text;
  for (int i = 0; i < 360'000; ++i) {
    text += fmt::format("{}.{:02} 1.234567890123 -2.345678901234 3.456789012345 0 0 0.6 0.8\n",
                        i / 100, i % 100);
  }
  const auto start = std::chrono::steady_clock::now();
  const auto trajectory = parse_tum_trajectory(text, "long.tum");
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  ASSERT_TRUE(trajectory) << error_text(trajectory);
  EXPECT_EQ(trajectory->size(), 360'000U);
  EXPECT_LT(elapsed.count(), 5.0);  // generous: sanitizers and busy machines take longer
}

}  // namespace trajectory_file_test
}  // namespace nadir
