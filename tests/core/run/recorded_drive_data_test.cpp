// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/flight/flight_recording.h"
#include "core/geo/trajectory_file.h"
#include "core/run/evaluate_run.h"
#include "core/run/localise_flight.h"
#include "core/sim/simulated_flight.h"
#include "tests/support/recorded_drive.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace recorded_drive_data_test {

constexpr std::size_t kFrames = 400;

Trajectory first_poses(const Trajectory& whole) {
  const auto& poses = whole.poses();
  return Trajectory::create({poses.begin(), poses.begin() + kFrames}, "piece").value();
}

/// Name of the file with the recorded visual odometry.
class RecordedDrive : public testing::TestWithParam<const char*> {};

TEST_P(RecordedDrive, IsLocalisedWithinThreeMetresFromItsStart) {
  const std::filesystem::path data = test_data_folder();
  if (data.empty()) GTEST_SKIP() << "NADIR_TEST_DATA is not set: no recorded drive";
  const std::filesystem::path drive = data / "kitti_odometry_00";
  const auto index = index_of(drawn_town(data));
  const auto truth = read_trajectory(drive / "poses_gt.txt");
  const auto odometry = read_trajectory(drive / GetParam());
  ASSERT_TRUE(truth && odometry);
  const ScratchFolder scratch;
  const FlownPath path{"drive",
                       place_recorded_path(first_poses(*truth), start_of_drive(index->map()), 2.0),
                       first_poses(*odometry), std::nullopt};
  const auto made = simulate_flight(index->map(), path, {}, scratch.path() / "flight", {});
  ASSERT_TRUE(made.has_value()) << made.error().message;
  ASSERT_EQ(made->frames, kFrames);

  const auto flight = open_flight(scratch.path() / "flight");
  ASSERT_TRUE(flight.has_value()) << flight.error().message;
  std::vector<EvaluatedStep> steps;
  const auto summary = localise_flight(**flight, index, {}, [&](const RunStep& step) {
    steps.push_back(evaluated_step(step));
    return Result<void>();
  });
  ASSERT_TRUE(summary.has_value()) << summary.error().message;
  const auto evaluation = evaluate_steps(steps).value();
  EXPECT_EQ(evaluation.matched_pairs, kFrames);
  EXPECT_LT(evaluation.estimate->position_m.mean, 3.0);
  EXPECT_LT(evaluation.estimate->position_m.mean, evaluation.odometry->position_m.mean);
  RecordProperty("estimate_mean_m", std::to_string(evaluation.estimate->position_m.mean));
}

INSTANTIATE_TEST_SUITE_P(WithRecordedOdometry,
                         RecordedDrive,
                         testing::Values("poses_sptam.txt", "poses_orbslam.txt"),
                         [](const auto& instance) {
                           return std::string(instance.param).substr(6, 5);
                         });

}  // namespace recorded_drive_data_test
}  // namespace nadir
