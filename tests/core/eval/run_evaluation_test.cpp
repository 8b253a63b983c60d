// SPDX-License-Identifier: Apache-2.0
#include "core/eval/run_evaluation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace nadir {
namespace run_evaluation_test {

using testing::HasSubstr;

/// A circle of 20 m radius in 100 steps of 0.2 s; the estimate is 1 m east of the truth, the
/// odometry moved by `drift`.
std::vector<EvaluatedStep> circle(const Similarity2& drift = {}) {
  std::vector<EvaluatedStep> steps;
  for (int i = 0; i < 100; ++i) {
    const double angle_rad = 0.06 * i;
    const Rigid2 truth{20 * std::cos(angle_rad), 20 * std::sin(angle_rad),
                       wrap_rad(angle_rad + 1.5707963)};
    EvaluatedStep step{.time_s = 10 + 0.2 * i,
                       .truth_in_enu = truth,
                       .estimate_in_enu = {truth.x_m + 1.0, truth.y_m, truth.yaw_rad},
                       .odometry_in_enu = drift * truth,
                       .update_ms = 4.0 + i % 2};
    step.covariance = Eigen::Matrix3d::Identity();
    steps.push_back(step);
  }
  return steps;
}

TEST(RunEvaluation, JudgesEstimateAndOdometryWithoutAlignment) {
  const auto evaluation = evaluate_steps(circle({.scale = 1.0, .rigid = {3, 4, 0}}));
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->steps, 100U);
  EXPECT_EQ(evaluation->matched_pairs, 100U);
  EXPECT_EQ(evaluation->alignment, Alignment::kNone);
  EXPECT_NEAR(evaluation->estimate->position_m.mean, 1.0, 1e-12);
  EXPECT_NEAR(evaluation->odometry->position_m.mean, 5.0, 1e-12);
  EXPECT_NEAR(*evaluation->consistency.nees_mean, 1.0, 1e-12);
  EXPECT_EQ(evaluation->consistency.coverage_95, 1.0);
  EXPECT_EQ(evaluation->convergence.after_s, 0.0);
  EXPECT_NEAR(evaluation->duration_s, 19.8, 1e-9);
  EXPECT_NEAR(evaluation->distance_m, 99 * 40 * std::sin(0.03), 1e-9);
  EXPECT_NEAR(*evaluation->update_rate_hz, 5.0, 1e-9);
  EXPECT_NEAR(*evaluation->computing_ms_mean, 4.5, 1e-12);
}

TEST(RunEvaluation, RigidAlignmentTakesAwayAMoveAndATurnButNoScale) {
  const Similarity2 drift{.scale = 1.0, .rigid = {30, -8, 0.7}};
  const auto evaluation = evaluate_steps(circle(drift), Alignment::kSe2);
  ASSERT_TRUE(evaluation);
  EXPECT_LT(evaluation->odometry->position_m.maximum, 1e-9);
  EXPECT_LT(evaluation->odometry->orientation_rad.maximum, 1e-9);
  EXPECT_LT(evaluation->estimate->position_m.maximum, 1e-9) << "each is aligned on its own";
  EXPECT_NEAR(evaluation->odometry_alignment.rigid.yaw_rad, -0.7, 1e-9);
  const auto stretched = evaluate_steps(circle({.scale = 1.1, .rigid = {}}), Alignment::kSe2);
  EXPECT_GT(stretched->odometry->position_m.mean, 1.0);
}

TEST(RunEvaluation, SimilarityAlignmentTakesAwayTheScaleToo) {
  const auto evaluation =
      evaluate_steps(circle({.scale = 2.5, .rigid = {30, -8, 0.7}}), Alignment::kSim2);
  ASSERT_TRUE(evaluation);
  EXPECT_LT(evaluation->odometry->position_m.maximum, 1e-9);
  EXPECT_NEAR(evaluation->odometry_alignment.scale, 0.4, 1e-9);
}

TEST(RunEvaluation, AlignmentTurnsTheCovarianceWithTheEstimate) {
  // The filter's frame is turned by a right angle: what it calls x is the truth's y.
  auto steps = circle();
  const Rigid2 turned{0, 0, 1.5707963267948966};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i].estimate_in_enu = turned * *steps[i].truth_in_enu;
    steps[i].estimate_in_enu.x_m += i % 2 == 0 ? 0.5 : -0.5;
    steps[i].covariance = Eigen::Vector3d(0.25, 1e-4, 1e-4).asDiagonal();
  }
  const auto evaluation = evaluate_steps(steps, Alignment::kSe2);
  ASSERT_TRUE(evaluation);
  EXPECT_NEAR(*evaluation->consistency.nees_mean, 1.0, 0.1);
}

TEST(RunEvaluation, JudgesTheEstimateAloneWhereTheOdometryHasNoPlaceInThePlane) {
  auto steps = circle();
  for (EvaluatedStep& step : steps) step.odometry_in_enu.reset();
  for (const Alignment alignment : {Alignment::kNone, Alignment::kSe2}) {
    const auto evaluation = evaluate_steps(steps, alignment);
    ASSERT_TRUE(evaluation);
    EXPECT_EQ(evaluation->matched_pairs, 100U);
    EXPECT_TRUE(evaluation->estimate.has_value());
    EXPECT_FALSE(evaluation->odometry.has_value());
  }
}

TEST(RunEvaluation, DropsStepsWithoutTruthOrWithNaNAndSaysHowMany) {
  auto steps = circle();
  steps[0].truth_in_enu.reset();
  steps[1].estimate_in_enu.x_m = std::nan("");
  steps[2].odometry_in_enu->yaw_rad = std::nan("");
  const auto evaluation = evaluate_steps(steps);
  ASSERT_TRUE(evaluation);
  EXPECT_EQ(evaluation->matched_pairs, 97U);
  EXPECT_EQ(evaluation->dropped_steps, 3U);
  EXPECT_NEAR(evaluation->estimate->position_m.mean, 1.0, 1e-12);
  EXPECT_NEAR(*evaluation->convergence.after_s, 0.6, 1e-9)
      << "counted from the first step of the run";
}

TEST(RunEvaluation, WithoutTruthKnowsNoErrorsAndDoesNotFail) {
  auto steps = circle();
  for (auto& step : steps) step.truth_in_enu.reset();
  const auto evaluation = evaluate_steps(steps);
  ASSERT_TRUE(evaluation);
  EXPECT_FALSE(evaluation->estimate || evaluation->odometry || evaluation->consistency.nees_mean);
  EXPECT_TRUE(evaluation->update_rate_hz);
  EXPECT_TRUE(evaluate_steps({}).has_value());
}

TEST(RunEvaluation, CannotAlignWhatDoesNotMove) {
  const auto standing = std::vector<EvaluatedStep>(5, EvaluatedStep{.truth_in_enu = Rigid2{}});
  const auto evaluation = evaluate_steps(standing, Alignment::kSe2);
  ASSERT_FALSE(evaluation);
  EXPECT_THAT(evaluation.error().message, HasSubstr("cannot be aligned"));
  EXPECT_FALSE(evaluate_steps({}, Alignment::kSim2));
}

TEST(Alignment, NamesAreThoseOfTheCommandLine) {
  for (const auto alignment : {Alignment::kNone, Alignment::kSe2, Alignment::kSim2}) {
    EXPECT_EQ(alignment_from_name(enum_name(alignment)), alignment);
  }
  EXPECT_EQ(enum_name(Alignment::kSim2), "sim2");
  EXPECT_FALSE(alignment_from_name("SE3"));
}

}  // namespace run_evaluation_test
}  // namespace nadir
