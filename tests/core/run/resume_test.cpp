// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>

#include "core/base/parallel.h"
#include "core/run/run_start.h"
#include "tests/core/run/rendered_flight.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace resume_test {

using testing::HasSubstr;

/// The drive with an odometry that drifts and lies elsewhere, so that dead reckoning is not the truth.
FlightDescription drifting_drive() {
  FlightDescription description = description_of_drive();
  std::vector<TimedPose> poses = description.odometry->poses();
  const Rigid3 odom_from_enu{rotation_of({0.0, 0.0, 1.0}), {500.0, -20.0, 3.0}};
  for (TimedPose& timed : poses) {
    const Rigid3 drift{rotation_of({0.0, 0.0, 0.01 * timed.time_s}),
                       {0.1 * timed.time_s, -0.05 * timed.time_s, 0.0}};
    timed.pose = odom_from_enu * timed.pose * drift;
  }
  description.odometry = Trajectory::create(poses, "drifting").value();
  return description;
}

/// The whole drive in a file, as another program would find it; made once.
class RecordedDrive : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder();
    whole_ = new Outcome(localise(drifting_drive()));
    ASSERT_TRUE(whole_->summary.has_value()) << fault(*whole_);
    const RenderedFlight flight(drifting_drive());
    auto writer =
        RunWriter::create(path(), run_header(flight, street_map(0.2), "m", "default", {})).value();
    for (const RunStep& step : whole_->steps) ASSERT_TRUE(writer.write(step).has_value());
    ASSERT_TRUE(writer.finish().has_value());
  }
  static void TearDownTestSuite() {
    delete whole_;
    delete folder_;
  }
  static std::filesystem::path path() { return folder_->path() / "whole.nadir"; }
  static const std::vector<RunStep>& whole() { return whole_->steps; }
  static ResumePoint point_at(double elapsed_s) {
    const auto run = RunReader::open(path()).value();
    return resume_point(run, "whole.nadir", elapsed_s).value();
  }
  static LocaliseRequest request_from(double elapsed_s) {
    LocaliseRequest request;
    request.resume_after = point_at(elapsed_s);
    return request;
  }

 private:
  inline static ScratchFolder* folder_ = nullptr;
  inline static Outcome* whole_ = nullptr;
};

TEST_F(RecordedDrive, GoesOnWithTheNextFrameAndTheNextNumber) {
  const Outcome outcome = localise(drifting_drive(), request_from(2.6));
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  ASSERT_EQ(outcome.steps.size(), static_cast<std::size_t>(kFrames - 11));
  EXPECT_EQ(outcome.summary->steps, kFrames - 11);
  for (std::size_t i = 0; i < outcome.steps.size(); ++i) {
    EXPECT_EQ(outcome.steps[i].step, 11 + static_cast<int>(i));
    EXPECT_DOUBLE_EQ(outcome.steps[i].time_s, 0.25 * (11.0 + static_cast<double>(i)));
  }
}

TEST_F(RecordedDrive, BeginsWithExactlyTheRecordedParticles) {
  const RunStep recorded = RunReader::open(path()).value().step(10).value();
  const ResumePoint point = point_at(2.5);
  ASSERT_TRUE(point.after.particles.has_value());
  EXPECT_EQ(*point.after.particles, *recorded.particles);
  const auto start = detail::start_after(point, index_of(street_map(0.2)), {}).value();
  EXPECT_EQ(start.localiser.particles(), *recorded.particles);
  EXPECT_EQ(start.first_step, 11);
  EXPECT_EQ(start.time_s, recorded.time_s);
  EXPECT_EQ(start.odom_from_body, recorded.odom_from_body);
}

TEST_F(RecordedDrive, GivesARunThatIsLikeTheRecordedOne) {
  for (const double elapsed_s : {0.0, 1.0, 3.5}) {
    const Outcome outcome = localise(drifting_drive(), request_from(elapsed_s));
    ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
    for (const RunStep& step : outcome.steps) {
      const RunStep& before = whole().at(static_cast<std::size_t>(step.step));
      const PoseMoments& now = step.estimate.moments;
      const PoseMoments& then = before.estimate.moments;
      // Along the street the filter is unsure by metres, so chance may move its mean by a part of that.
      const double sigma_m = std::sqrt(then.covariance(0, 0) + then.covariance(1, 1));
      const double sigma_now_m = std::sqrt(now.covariance(0, 0) + now.covariance(1, 1));
      EXPECT_LT((now.mean.translation_m() - then.mean.translation_m()).norm(), 0.1 + 0.5 * sigma_m)
          << step.step;
      EXPECT_LT(std::abs(wrap_rad(now.mean.yaw_rad - then.mean.yaw_rad)), 0.02) << step.step;
      EXPECT_GT(sigma_now_m, 0.5 * sigma_m - 0.1) << step.step;
      EXPECT_LT(sigma_now_m, 2.0 * sigma_m + 0.1) << step.step;
      EXPECT_EQ(step.truth_in_enu, before.truth_in_enu);
      EXPECT_EQ(step.topview->cells, before.topview->cells);
    }
    // The first draws are those of the recorded run, for they belong to the same step of the same seed.
    const RunStep& first = outcome.steps.front();
    const RunStep& before = whole().at(static_cast<std::size_t>(first.step));
    EXPECT_LT(
        (first.estimate.moments.mean.translation_m() - before.estimate.moments.mean.translation_m())
            .norm(),
        1e-3);
  }
}

TEST_F(RecordedDrive, GoesOnWithDeadReckoningWhereItWas) {
  const Outcome outcome = localise(drifting_drive(), request_from(3.0));
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  for (const RunStep& step : outcome.steps) {
    const RunStep& before = whole().at(static_cast<std::size_t>(step.step));
    EXPECT_NEAR(step.odometry_in_enu->x_m, before.odometry_in_enu->x_m, 1e-9);
    EXPECT_NEAR(step.odometry_in_enu->y_m, before.odometry_in_enu->y_m, 1e-9);
    EXPECT_NEAR(wrap_rad(step.odometry_in_enu->yaw_rad - before.odometry_in_enu->yaw_rad), 0.0,
                1e-12);
    EXPECT_EQ(step.odom_from_body, before.odom_from_body);
  }
  const RunStep& last = outcome.steps.back();
  EXPECT_GT((last.odometry_in_enu->translation_m() - last.truth_in_enu->translation_m()).norm(),
            0.3);
}

TEST_F(RecordedDrive, LaysDeadReckoningNowhereWhereTheRecordedRunDidNot) {
  LocaliseRequest request = request_from(3.0);
  request.resume_after->after.odometry_in_enu.reset();
  for (const RunStep& step : localise(drifting_drive(), request).steps) {
    EXPECT_FALSE(step.odometry_in_enu.has_value());
  }
}

TEST_F(RecordedDrive, GivesTheSameBitsOnAnyNumberOfThreads) {
  const auto run_on = [](int threads) {
    const ThreadLimit limit(threads);
    return localise(drifting_drive(), request_from(3.0)).steps.back();
  };
  const RunStep one = run_on(1);
  const RunStep three = run_on(3);
  EXPECT_EQ(one.particles, three.particles);
  EXPECT_EQ(one.estimate.moments.mean, three.estimate.moments.mean);
}

TEST_F(RecordedDrive, TakesOtherOptionsFromThere) {
  LocaliseRequest request = request_from(3.0);
  request.options.localiser.min_update_interval_s = 0.5;
  request.options.localiser.particle_count = 3'000;
  request.options.localiser.adapt_particle_count = false;
  request.most_frames = 7;
  const Outcome outcome = localise(drifting_drive(), request);
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  ASSERT_EQ(outcome.steps.size(), 3U);  // of the 7 frames after the moment every second one
  EXPECT_DOUBLE_EQ(outcome.steps.front().time_s, 3.5);
  EXPECT_EQ(outcome.summary->frames_passed_over, 4);
}

TEST_F(RecordedDrive, GoesOnAfterTopviewsThatSayNothing) {
  LocaliseRequest request = request_from(5.25);
  request.options.topview.min_votes = 1000;
  const Outcome outcome = localise(drifting_drive(), request);
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  EXPECT_EQ(outcome.summary->steps_without_evidence, outcome.summary->steps);
}

TEST_F(RecordedDrive, HasNothingToDoAfterTheLastFrame) {
  EXPECT_EQ(fault(localise(drifting_drive(), request_from(5.75))),
            "drive-folder: has no frame to use after the 5.750 s of whole.nadir from which to go "
            "on");
  LocaliseRequest soon = request_from(3.0);  // all of its frames come before the next update
  soon.options.localiser.min_update_interval_s = 10.0;
  EXPECT_THAT(fault(localise(drifting_drive(), soon)), HasSubstr("has no frame to use after"));
}

TEST_F(RecordedDrive, IsOfThatFlightOnly) {
  const std::string other = "drive-folder: is not the flight that whole.nadir was made on";
  FlightDescription later_frame = drifting_drive();
  later_frame.frames.back().time_s += 0.01;
  EXPECT_EQ(fault(localise(later_frame, request_from(3.0))), other);
  LocaliseRequest unchecked = request_from(3.0);
  unchecked.resume_after->flight_hash.clear();
  EXPECT_EQ(fault(localise(later_frame, unchecked)), "none");
  EXPECT_EQ(fault(localise(description_of_drive(), unchecked)), other);  // of another odometry
  FlightDescription short_odometry = drifting_drive();
  std::vector<TimedPose> poses = short_odometry.odometry->poses();
  poses.resize(5);
  short_odometry.odometry = Trajectory::create(poses, "short").value();
  EXPECT_EQ(fault(localise(short_odometry, unchecked)), other);
}

TEST_F(RecordedDrive, RefusesAPriorAnotherPlaneAndNoParticles) {
  LocaliseRequest with_prior = request_from(3.0);
  with_prior.prior = GlobalPrior{};
  EXPECT_EQ(fault(localise(drifting_drive(), with_prior)),
            "prior: there is none for a run that goes on from whole.nadir");
  LocaliseRequest moved = request_from(3.0);
  moved.resume_after->plane_origin->latitude_deg += 0.01;
  EXPECT_THAT(fault(localise(drifting_drive(), moved)), HasSubstr("of another plane"));
  LocaliseRequest empty = request_from(3.0);
  empty.resume_after->after.particles.reset();
  EXPECT_EQ(fault(localise(drifting_drive(), empty)),
            "whole.nadir: holds no particles of step 12, so nothing can go on from there");
}

TEST_F(RecordedDrive, TellsInItsHeaderWhereItWentOn) {
  const RenderedFlight flight(drifting_drive());
  const RunHeader header = run_header(flight, street_map(0.2), "m", "default", request_from(3.1));
  EXPECT_EQ(header.parent_run, "whole.nadir");
  EXPECT_EQ(header.started_at_s, 3.0);
  EXPECT_EQ(header.options.at("prior"), "particles of step 12 of whole.nadir");
  const RunHeader whole_header = run_header(flight, street_map(0.2), "m", "default", {});
  EXPECT_EQ(whole_header.parent_run, "");
  EXPECT_FALSE(whole_header.started_at_s.has_value());
}

}  // namespace resume_test
}  // namespace nadir
