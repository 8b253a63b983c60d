// SPDX-License-Identifier: Apache-2.0
#include "core/run/evaluate_run.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/eval/report.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace evaluate_run_test {

using testing::HasSubstr;

TEST(EvaluateRun, ComesToTheNumbersComputedByHand) {
  const ScratchFolder folder;
  const auto path = folder.path() / "R.nadir";
  record_run(path, 31);
  const auto evaluation = evaluate_run_file(path);
  ASSERT_TRUE(evaluation) << error_text(evaluation);
  EXPECT_EQ(evaluation->run, path.string());
  EXPECT_EQ(evaluation->flight, "loop");
  EXPECT_EQ(evaluation->map, "proving-ground");
  EXPECT_EQ(evaluation->preset, "default");
  EXPECT_EQ(evaluation->seed, 18446744073709551615ULL);
  EXPECT_TRUE(evaluation->is_complete);
  EXPECT_EQ(evaluation->matched_pairs, 31U);
  EXPECT_NEAR(evaluation->distance_m, 30.0, 1e-9);
  EXPECT_NEAR(*evaluation->update_rate_hz, 10.0, 1e-9);
  // The estimate is 0.1 m ahead, 1/3 m to the right and turned by 0.01 rad throughout.
  EXPECT_NEAR(evaluation->estimate->position_m.mean_square, 0.01 + 1.0 / 9.0, 1e-9);
  EXPECT_NEAR(evaluation->estimate->longitudinal_m.median, 0.1, 1e-9);
  EXPECT_NEAR(evaluation->estimate->lateral_m.median, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(evaluation->estimate->orientation_rad.mean_square, 1e-4, 1e-12);
  // The odometry is sqrt(0.02^2 + 0.01^2) m off for each metre: mean over 0 .. 30 m is 15 times
  // that.
  EXPECT_NEAR(evaluation->odometry->position_m.mean, 15.0 * std::sqrt(5e-4), 1e-9);
  EXPECT_NEAR(evaluation->odometry->position_m.maximum, 30.0 * std::sqrt(5e-4), 1e-9);
  EXPECT_EQ(evaluation->convergence.after_s, 0.0);
  EXPECT_NEAR(*evaluation->computing_ms_mean, 12.5, 1e-12);
}

TEST(EvaluateRun, SaysThatARunWasStopped) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 5, 0, false);
  const auto evaluation = evaluate_run_file(folder.path() / "R.nadir");
  ASSERT_TRUE(evaluation);
  EXPECT_FALSE(evaluation->is_complete);
  EXPECT_EQ(evaluation->steps, 5U);
}

TEST(EvaluateRun, ARunWithoutStepsKnowsNothing) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 0);
  const auto evaluation = evaluate_run_file(folder.path() / "R.nadir");
  ASSERT_TRUE(evaluation) << error_text(evaluation);
  EXPECT_FALSE(evaluation->estimate);
  EXPECT_THAT(report_as_json(std::vector{*evaluation}), HasSubstr("\"position_mse_m2\": null"));
}

TEST(EvaluateRun, AlignsWhenAskedAndNamesTheFileWhenItCannot) {
  const ScratchFolder folder;
  record_run(folder.path() / "R.nadir", 31);
  const auto aligned = evaluate_run_file(folder.path() / "R.nadir", Alignment::kSim2);
  ASSERT_TRUE(aligned) << error_text(aligned);
  EXPECT_LT(aligned->odometry->position_m.maximum, 1e-6) << "its drift is a scale and a turn";
  record_run(folder.path() / "one.nadir", 1);
  EXPECT_THAT(error_text(evaluate_run_file(folder.path() / "one.nadir", Alignment::kSe2)),
              HasSubstr("one.nadir: estimate cannot be aligned"));
  EXPECT_FALSE(evaluate_run_file(folder.path() / "none.nadir"));
}

}  // namespace evaluate_run_test
}  // namespace nadir
