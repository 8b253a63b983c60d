// SPDX-License-Identifier: Apache-2.0
#include "core/run/localise_flight.h"

#include <gmock/gmock.h>

#include "tests/core/run/rendered_flight.h"

namespace nadir {
namespace localise_flight_test {

using testing::HasSubstr;

TEST(LocaliseFlight, RecordsEveryStepWithTruthOdometryAndEstimate) {
  const Outcome outcome = localise(description_of_drive());
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  ASSERT_EQ(outcome.steps.size(), static_cast<std::size_t>(kFrames));
  for (const RunStep& step : outcome.steps) {
    ASSERT_TRUE(step.truth_in_enu.has_value());
    EXPECT_NEAR(step.truth_in_enu->x_m, 10.0 + 2.0 * step.time_s, 1e-9);
    EXPECT_NEAR(step.odometry_in_enu->x_m, step.truth_in_enu->x_m,
                1e-9);  // this odometry does not drift
    EXPECT_TRUE(step.particles.has_value());
    EXPECT_EQ(static_cast<int>(step.particles->size()), step.particle_count);
    EXPECT_EQ(static_cast<int>(step.topview->cells.size()), step.topview_cells);
    EXPECT_GT(step.update_ms, 0.0);
  }
  const RunStep& last = outcome.steps.back();
  EXPECT_LT(
      (last.estimate.moments.mean.translation_m() - last.truth_in_enu->translation_m()).norm(),
      1.0);
  EXPECT_GT(last.agreement.value(), 0.5);
}

TEST(LocaliseFlight, PassesOverFramesThatComeTooSoon) {
  LocaliseRequest request;
  request.options.localiser.min_update_interval_s = 1.0;
  const Outcome outcome = localise(description_of_drive(), request);
  EXPECT_EQ(outcome.steps.size(), 6U);
  EXPECT_EQ(outcome.summary->frames_passed_over, 18);
  EXPECT_DOUBLE_EQ(outcome.steps[1].time_s, 1.0);
}

TEST(LocaliseFlight, LeavesOutFramesWithoutOdometryAndCountsThem) {
  FlightDescription description = description_of_drive();
  description.odometry = straight_line(3.0);
  const Outcome outcome = localise(description);
  EXPECT_EQ(outcome.steps.size(), 13U);
  EXPECT_EQ(outcome.summary->frames_without_odometry, kFrames - 13);
}

TEST(LocaliseFlight, LaysDeadReckoningAtTheStart) {
  FlightDescription description = description_of_drive();
  std::vector<TimedPose> poses = description.odometry->poses();
  const Rigid3 odom_from_enu{rotation_of({0.0, 0.0, 1.0}), {500.0, -20.0, 3.0}};
  for (TimedPose& timed : poses) timed.pose = odom_from_enu * timed.pose;
  description.odometry = Trajectory::create(poses, "moved").value();
  const Outcome outcome = localise(description);
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  const RunStep& last = outcome.steps.back();
  EXPECT_NEAR(last.odometry_in_enu->x_m, last.truth_in_enu->x_m, 1e-6);
  EXPECT_NEAR(last.odometry_in_enu->y_m, last.truth_in_enu->y_m, 1e-6);
}

TEST(LocaliseFlight, LaysDeadReckoningNowhereWhereNobodyKnowsTheStart) {
  FlightDescription description = description_of_drive();
  description.truth.reset();
  LocaliseRequest request;
  request.prior = GlobalPrior{};
  request.options.localiser.global_particle_count = 2'000;
  const Outcome outcome = localise(description, request);
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  for (const RunStep& step : outcome.steps) EXPECT_FALSE(step.odometry_in_enu.has_value());
}

TEST(LocaliseFlight, StopsWhenItIsToldTo) {
  std::stop_source source;
  const WorkContext context{source.get_token(), [&](double fraction, const std::string&) {
                              if (fraction > 0.3) source.request_stop();
                            }};
  const Outcome outcome = localise(description_of_drive(), {}, context);
  EXPECT_EQ(outcome.summary.error().code, ErrorCode::kCancelled);
  EXPECT_GT(outcome.steps.size(), 5U);
  EXPECT_LT(outcome.steps.size(), 12U);
}

TEST(LocaliseFlight, NeedsAStartWhereTheFlightKnowsNoTruth) {
  FlightDescription description = description_of_drive();
  description.truth.reset();
  EXPECT_THAT(fault(localise(description)), HasSubstr("holds no truth at its first frame"));
  LocaliseRequest request;
  request.prior = GaussianPrior{.mean_in_enu = {10.0, 28.0, 0.0}};
  const Outcome outcome = localise(description, request);
  ASSERT_TRUE(outcome.summary.has_value()) << fault(outcome);
  EXPECT_FALSE(outcome.steps.back().truth_in_enu.has_value());
}

TEST(LocaliseFlight, RefusesWhatItCannotRunOnNamingTheFlight) {
  FlightDescription no_odometry = description_of_drive();
  no_odometry.odometry.reset();
  EXPECT_EQ(fault(localise(no_odometry)), "drive-folder: holds no odometry");
  FlightDescription no_camera = description_of_drive();
  no_camera.camera.reset();
  EXPECT_EQ(fault(localise(no_camera)), "drive-folder: no camera is described");
  FlightDescription no_frames = description_of_drive();
  no_frames.frames.clear();
  EXPECT_EQ(fault(localise(no_frames)), "drive-folder: no frame has labels, depth and odometry");
  LocaliseRequest request;
  request.prior = GaussianPrior{.mean_in_enu = {-900.0, 0.0, 0.0}};
  EXPECT_THAT(fault(localise(description_of_drive(), request)), HasSubstr("is off map"));
}

TEST(LocaliseFlight, SaysSoWhenNoTopviewTellsAnything) {
  LocaliseRequest request;
  request.options.topview.min_votes = 1000;
  EXPECT_THAT(fault(localise(description_of_drive(), request)), HasSubstr("nothing was localised"));
}

TEST(LocaliseFlight, PassesOnWhatTheRecorderSays) {
  const auto summary = localise_flight(
      RenderedFlight(description_of_drive()), index_of(street_map(0.2)), {},
      [](const RunStep&) -> Result<void> { return fail(ErrorCode::kIo, "disk full"); });
  EXPECT_EQ(summary.error().message, "disk full");
}

TEST(TruthInPlane, MovesAPoseToThePlaneOfAnotherOrigin) {
  FlightDescription description = description_of_drive();
  description.truth_origin = Geodetic{48.98, 8.39};
  const auto plane = ProjectPlane::create({48.99, 8.40}).value();
  const auto source = ProjectPlane::create(*description.truth_origin).value();
  const Rigid2 before = planar(description.truth->poses().front().pose);
  const Rigid2 after = planar(truth_in_plane(description, plane).value()->poses().front().pose);
  const Geodetic place = source.geodetic_from_enu(before.translation_m());
  EXPECT_NEAR((plane.enu_from_geodetic(place) - after.translation_m()).norm(), 0.0, 1e-6);
  // The direction of travel must be the same on the ground: compare with a point a metre ahead,
  // moved the same way.
  const Eigen::Vector2d ahead = before * Eigen::Vector2d(1.0, 0.0);
  const Eigen::Vector2d ahead_after = plane.enu_from_geodetic(source.geodetic_from_enu(ahead));
  const Eigen::Vector2d step = ahead_after - after.translation_m();
  EXPECT_NEAR(wrap_rad(std::atan2(step.y(), step.x()) - after.yaw_rad), 0.0, 1e-6);
}

TEST(RunHeader, TellsInputsApartByTheirHashes) {
  const OverheadMap map = street_map(0.2);
  OverheadMap changed = map;
  changed.labels.at(3, 3) = kFence;
  const RenderedFlight flight(description_of_drive());
  const RunHeader header = run_header(flight, map, "m", "default", {});
  EXPECT_NE(header.map_hash, run_header(flight, changed, "m", "default", {}).map_hash);
  EXPECT_EQ(header.map_hash, run_header(flight, map, "m", "default", {}).map_hash);
  FlightDescription later = description_of_drive();
  later.frames.back().time_s += 0.1;
  EXPECT_NE(header.flight_hash,
            run_header(RenderedFlight(later), map, "m", "default", {}).flight_hash);
  EXPECT_EQ(header.options.at("gamma0"), "0.01");
  EXPECT_EQ(header.options.at("max-range"), "20");
}

}  // namespace localise_flight_test
}  // namespace nadir
