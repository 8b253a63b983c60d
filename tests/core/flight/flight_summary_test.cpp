// SPDX-License-Identifier: Apache-2.0
#include "core/flight/flight_summary.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/flight/flight_fixtures.h"

namespace nadir {
namespace flight_summary_test {

using test::small_camera;
using test::straight_path;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Labels, depth and images ten times a second from `start_s`; odometry and truth around them.
FlightDescription whole_flight(double start_s = 10.0, int frames = 101) {
  FlightDescription flight;
  flight.camera = small_camera();
  for (int i = 0; i < frames; ++i) {
    flight.frames.push_back({start_s + 0.1 * i, "i.png", "d.png", "l.png"});
  }
  const double end_s = start_s + 0.1 * (frames - 1);
  const int poses = static_cast<int>(std::lround((end_s - start_s + 2.0) / 0.05));
  flight.odometry = straight_path(start_s - 1.0, 0.05, poses + 1);
  flight.truth = straight_path(start_s - 1.0, 0.05, poses + 1);
  return flight;
}

TEST(StreamSummary, HasRateAndJitterOfTheOrdinaryIntervals) {
  // Intervals 0.1, 0.1, 0.08, 0.12, 0.1: median 0.1, mean square deviation 0.0008 / 5.
  const auto stream = summarise_stream("odometry", {0.0, 0.1, 0.2, 0.28, 0.4, 0.5});
  EXPECT_EQ(stream.count, 6U);
  EXPECT_EQ(stream.span, (TimeSpan{0.0, 0.5}));
  EXPECT_NEAR(*stream.rate_hz, 10.0, 1e-9);
  EXPECT_NEAR(*stream.jitter_s, std::sqrt(0.0008 / 5.0), 1e-9);
  EXPECT_THAT(stream.gaps, IsEmpty());
}

TEST(StreamSummary, ListsGapsAndKeepsThemOutOfRateAndJitter) {
  const auto stream = summarise_stream("labels", {0.0, 1.0, 2.0, 3.75, 4.75, 6.75, 7.75});
  EXPECT_THAT(stream.gaps, ElementsAre(TimeSpan{4.75, 6.75}));  // 1.75 is below 1.8 medians.
  EXPECT_EQ(*stream.rate_hz, 1.0);
  EXPECT_NEAR(*stream.jitter_s, std::sqrt(0.75 * 0.75 / 5.0), 1e-12);
}

TEST(StreamSummary, SamplesInOneInstantAreNoGapsAndChangeNoRate) {
  // Every sample twice, a millisecond apart: a rate of 10 Hz all the same, and no gap.
  std::vector<double> times_s;
  for (int i = 0; i < 50; ++i) {
    times_s.push_back(0.1 * i);
    times_s.push_back(0.1 * i + 0.001);
  }
  const auto stream = summarise_stream("odometry", times_s);
  EXPECT_EQ(stream.count, 100U);
  EXPECT_EQ(stream.duplicates, 50U);
  EXPECT_NEAR(*stream.rate_hz, 10.0, 1e-9);
  EXPECT_NEAR(*stream.jitter_s, 0.0, 1e-9);
  EXPECT_THAT(stream.gaps, IsEmpty());
  EXPECT_NEAR(stream.span.end_s, 4.901, 1e-12) << "the span is that of all samples";
}

TEST(StreamSummary, TimesThatRepeatExactlyAreDuplicatesToo) {
  const auto stream = summarise_stream("images", {0.0, 1.0, 1.0, 2.0, 3.0, 3.0, 3.0, 6.0, 7.0});
  EXPECT_EQ(stream.duplicates, 3U);
  EXPECT_EQ(*stream.rate_hz, 1.0);
  EXPECT_THAT(stream.gaps, ElementsAre(TimeSpan{3.0, 6.0}));
  const auto stuck = summarise_stream("images", {5.0, 5.0, 5.0});
  EXPECT_EQ(stuck.duplicates, 2U);
  EXPECT_FALSE(stuck.rate_hz);
}

TEST(StreamSummary, OneShortIntervalAmongMissingSamplesIsFoundAndNothingElse) {
  // A third of the samples is lost; what is left is no duplicate.
  const auto stream = summarise_stream("labels", {0.0, 0.1, 0.3, 0.4, 0.41, 0.6, 0.7, 0.705, 0.9});
  EXPECT_EQ(stream.duplicates, 2U);
}

TEST(StreamSummary, OfASingleSampleHasNoRate) {
  const auto stream = summarise_stream("images", {3.0});
  EXPECT_EQ(stream.count, 1U);
  EXPECT_FALSE(stream.rate_hz);
  EXPECT_FALSE(stream.jitter_s);
  EXPECT_EQ(stream.span.length_s(), 0.0);
  EXPECT_THROW((void)summarise_stream("images", {}), std::logic_error);
}

TEST(FlightSummary, OfAFlightWithoutFaultHasNoNotice) {
  const FlightSummary summary = summarise_flight(whole_flight());
  EXPECT_THAT(summary.notices, IsEmpty());
  EXPECT_TRUE(summary.are_times_sane);
  ASSERT_EQ(summary.streams.size(), 5U);
  EXPECT_EQ(summary.streams[0].name, "images");
  EXPECT_EQ(summary.streams[2].name, "labels");
  EXPECT_EQ(summary.streams[2].count, 101U);
  ASSERT_TRUE(summary.overlap);
  EXPECT_NEAR(summary.overlap->start_s, 10.0, 1e-9);
  EXPECT_NEAR(summary.overlap->end_s, 20.0, 1e-9);
  EXPECT_NEAR(*summary.truth_length_m, 24.0, 1e-9);  // 12 s at 2 m/s.
  EXPECT_NEAR(*summary.odometry_length_m, 24.0, 1e-9);
}

TEST(FlightSummary, TellsThatOdometryEndsBeforeTheLabels) {
  FlightDescription flight = whole_flight();
  flight.odometry = straight_path(9.0, 0.05, 41);  // Until 11 s; labels until 20 s.
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_THAT(summary.notices, ElementsAre("odometry ends 9.0 s before the labels"));
  EXPECT_NEAR(summary.overlap->end_s, 11.0, 1e-9);
  EXPECT_TRUE(summary.are_times_sane);
}

TEST(FlightSummary, TellsThatTruthStartsLate) {
  FlightDescription flight = whole_flight();
  flight.truth = straight_path(12.5, 0.05, 400);
  EXPECT_THAT(summarise_flight(flight).notices, ElementsAre("truth starts 2.5 s after the labels"));
}

TEST(FlightSummary, AFramesPeriodAtTheEndIsNoFault) {
  FlightDescription flight = whole_flight();
  flight.odometry = straight_path(10.05, 0.05, 198);  // 10.05 s to 19.9 s.
  EXPECT_THAT(summarise_flight(flight).notices, IsEmpty());
}

TEST(FlightSummary, StreamsThatDoNotMeetAreNotSane) {
  FlightDescription flight = whole_flight();
  flight.odometry =
      straight_path(1.4e9, 0.05, 100);  // Since 1970, while labels count from a start.
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_FALSE(summary.overlap);
  EXPECT_FALSE(summary.are_times_sane);
  EXPECT_THAT(
      summary.notices,
      ElementsAre("odometry (1400000000.0 s to 1400000005.0 s) and labels (10.0 s to 20.0 s) "
                  "do not overlap in time"));
}

TEST(FlightSummary, BothClocksAreSaneWhereAllStreamsShareOne) {
  EXPECT_TRUE(summarise_flight(whole_flight(1.0)).are_times_sane);
  EXPECT_TRUE(summarise_flight(whole_flight(1317042272.0)).are_times_sane);
}

TEST(FlightSummary, SeesOtherUnitsInTheTimes) {
  const auto notices = [](double start_s) {
    FlightDescription flight = whole_flight();
    flight.odometry = straight_path(start_s, 1024.0, 3);
    const FlightSummary summary = summarise_flight(flight);
    EXPECT_FALSE(summary.are_times_sane);
    return summary.notices;
  };
  EXPECT_THAT(notices(1.4e12),
              Contains("times of the odometry look like milliseconds, not seconds"));
  EXPECT_THAT(notices(1.4e15),
              Contains("times of the odometry look like microseconds, not seconds"));
  EXPECT_THAT(notices(1.4e18),
              Contains("times of the odometry look like nanoseconds, not seconds"));
  EXPECT_THAT(notices(-5e6), Contains(HasSubstr("neither seconds since a start nor since 1970")));
  EXPECT_THAT(notices(5e7), Contains(HasSubstr("neither seconds since a start nor since 1970")));
}

TEST(FlightSummary, NamesTheLongestGapOfEachStream) {
  FlightDescription flight = whole_flight();
  flight.frames.erase(flight.frames.begin() + 10, flight.frames.begin() + 12);
  flight.frames.erase(flight.frames.begin() + 50, flight.frames.begin() + 60);
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_THAT(summary.notices, Contains("labels: 2 gaps, the longest of 1.10 s at 15.10 s"));
  EXPECT_EQ(summary.streams[2].gaps.size(), 2U);
}

TEST(FlightSummary, CountsFramesWithoutDepth) {
  FlightDescription flight = whole_flight();
  for (std::size_t i = 0; i < flight.frames.size(); i += 2) flight.frames[i].depth.reset();
  EXPECT_THAT(summarise_flight(flight).notices,
              Contains("51 of 101 label images have no depth image of the same time"));
}

TEST(FlightSummary, NamesWhatIsMissing) {
  FlightDescription flight = whole_flight();
  for (FlightFrame& frame : flight.frames) frame.labels.reset();
  EXPECT_THAT(summarise_flight(flight).notices,
              ElementsAre("there are no label images, so there is nothing to localise with"));
  flight = whole_flight();
  for (FlightFrame& frame : flight.frames) frame.depth.reset();
  EXPECT_THAT(summarise_flight(flight).notices,
              ElementsAre("there is no depth, so nobody knows where the labels lie"));
  flight = whole_flight();
  flight.camera.reset();
  flight.odometry.reset();
  flight.truth.reset();
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_THAT(summary.notices, ElementsAre("the camera is not known", "there is no odometry",
                                           "there is no truth, so errors cannot be told"));
  EXPECT_FALSE(summary.truth_length_m);
  EXPECT_NEAR(summary.overlap->length_s(), 10.0, 1e-9);
}

TEST(FlightSummary, OfPosesAloneComparesThemWithEachOther) {
  FlightDescription flight;
  flight.odometry = straight_path(0.0, 0.1, 101);
  flight.truth = straight_path(0.0, 0.1, 51);
  EXPECT_THAT(summarise_flight(flight).notices,
              ElementsAre("there are no images, labels or depth, only poses",
                          "truth ends 5.0 s before the odometry"));
}

/// 100 m straight ahead at 2 m/s, twenty poses a second, each with noise of 5 cm either way.
Trajectory noisy_path() {
  std::vector<TimedPose> poses;
  for (std::uint32_t i = 0; i <= 1000; ++i) {
    const auto [along, across] = standard_normals({.seed = 5, .particle = i});
    poses.push_back(
        {0.05 * i, {Eigen::Quaterniond::Identity(), {0.1 * i + 0.05 * along, 0.05 * across, 2.0}}});
  }
  return Trajectory::create(std::move(poses), "noisy path").value();
}

TEST(WayInPieces, HardlyGrowsWithTheNoiseOfSinglePoses) {
  const Trajectory path = noisy_path();
  EXPECT_GT(path.planar_length_m(), 120.0);
  EXPECT_NEAR(way_in_pieces_m(path, 1.0), 100.0, 2.0);
}

TEST(WayInPieces, OfAStraightPathIsItsLengthWhateverThePieces) {
  const Trajectory path = straight_path(0.0, 0.1, 100);  // 19.8 m
  for (const double piece_m : {0.1, 1.0, 7.0, 50.0}) {
    EXPECT_NEAR(way_in_pieces_m(path, piece_m), 19.8, 1e-9) << piece_m;
  }
  EXPECT_EQ(way_in_pieces_m(Trajectory(), 1.0), 0.0);
}

TEST(WayInPieces, OfAHoveringVehicleIsNotTheSumOfItsJitter) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < 1000; ++i) {
    poses.push_back(
        {0.1 * i, {Eigen::Quaterniond::Identity(), {i % 2 == 0 ? 0.0 : 0.2, 0.0, 2.0}}});
  }
  const Trajectory hover = Trajectory::create(std::move(poses), "hover").value();
  EXPECT_GT(hover.planar_length_m(), 199.0);
  EXPECT_LT(way_in_pieces_m(hover, 1.0), 0.3);
}

TEST(FlightSummary, TellsTheWayOfOdometryApartFromTheSumOfItsSteps) {
  FlightDescription flight = whole_flight();
  flight.odometry = noisy_path();
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_NEAR(*summary.odometry_length_m, 100.0, 2.0);
  EXPECT_GT(*summary.odometry_summed_m, 120.0);
  EXPECT_NEAR(*summary.truth_length_m, 24.0, 1e-9);
}

TEST(FlightSummary, SaysWhichFileBecameWhat) {
  FlightDescription flight = whole_flight();
  flight.path = "drives/7";
  flight.odometry_source = "drives/7/poses_a.txt";
  flight.truth_source = "drives/7/oxts";
  flight.other_odometry = {"drives/7/poses_b.txt", "drives/7/poses_c.txt"};
  const FlightSummary summary = summarise_flight(flight);
  EXPECT_EQ(summary.streams[0].source, "");
  EXPECT_EQ(summary.streams[3].source, "poses_a.txt");
  EXPECT_EQ(summary.streams[4].source, "oxts");
  EXPECT_THAT(
      summary.notices,
      ElementsAre("the odometry is poses_a.txt, the first by name; left aside: poses_b.txt, "
                  "poses_c.txt"));
  flight.path = "drives/7/poses_a.txt";  // A trajectory by itself is the flight.
  EXPECT_EQ(summarise_flight(flight).streams[3].source, "poses_a.txt");
}

TEST(FlightSummary, NotesDuplicatesInsteadOfGaps) {
  FlightDescription flight = whole_flight();
  std::vector<TimedPose> poses = flight.odometry->poses();
  for (int i = 4; i >= 0; --i) {
    TimedPose twin = poses[static_cast<std::size_t>(10 * i)];
    twin.time_s += 1e-4;
    poses.insert(poses.begin() + 10 * i + 1, twin);
  }
  flight.odometry = Trajectory::create(std::move(poses), "odometry").value();
  EXPECT_THAT(summarise_flight(flight).notices,
              ElementsAre("odometry: 5 of 246 samples have practically the time of the one before; "
                          "rate, jitter and gaps leave them out"));
}

TEST(CentreText, GivesThePrincipalPointInBothConventions) {
  EXPECT_EQ(
      centre_text(CameraModel::from_horizontal_view(640, 480, 1.0)),
      "(320.00, 240.00) px where pixel centres are at +0.5, (319.50, 239.50) px where they are "
      "whole numbers, as in flight.toml, OpenCV and ROS");
}

TEST(FlightSummary, OfNothingAtAllIsEmpty) {
  const FlightSummary summary = summarise_flight({});
  EXPECT_THAT(summary.streams, IsEmpty());
  EXPECT_FALSE(summary.overlap);
  EXPECT_THAT(summary.notices, Not(IsEmpty()));
}

}  // namespace flight_summary_test
}  // namespace nadir
