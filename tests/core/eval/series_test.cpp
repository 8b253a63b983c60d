// SPDX-License-Identifier: Apache-2.0
#include "core/eval/series.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/base/random.h"
#include "core/eval/consistency.h"
#include "core/eval/trajectory_error.h"

namespace nadir {
namespace series_test {

using testing::DoubleEq;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsNan;

constexpr double kPi = std::numbers::pi;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

EvaluatedStep step_at(double time_s, const Rigid2& truth, const Rigid2& estimate) {
  EvaluatedStep step{.time_s = time_s, .truth_in_enu = truth, .estimate_in_enu = estimate};
  step.covariance = Eigen::Vector3d(4.0, 0.25, 0.01).asDiagonal();
  return step;
}

/// Errors of about one standard deviation; every tenth step has no truth, every eleventh a singular
/// covariance.
std::vector<EvaluatedStep> noisy_steps(std::uint32_t count) {
  std::vector<EvaluatedStep> steps;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto [a, b] = standard_normals({.seed = 41, .step = i, .draw = 0});
    const auto [c, unused] = standard_normals({.seed = 41, .step = i, .draw = 1});
    static_cast<void>(unused);
    const Rigid2 truth{0.5 * i, 3.0, wrap_rad(0.2 * i)};
    steps.push_back(
        step_at(5.0 + 0.1 * i, truth,
                {truth.x_m + 2.0 * a, truth.y_m + 0.5 * b, wrap_rad(truth.yaw_rad + 0.1 * c)}));
    if (i % 10 == 9) steps.back().truth_in_enu.reset();
    if (i % 11 == 10) steps.back().covariance.setZero();
  }
  return steps;
}

TEST(PoseError, IsEstimateMinusTruthWithTheYawWrapped) {
  const Eigen::Vector3d error = pose_error({4.0, -1.0, -3.0}, {1.0, 1.0, 3.0});
  EXPECT_EQ(error.x(), 3.0);
  EXPECT_EQ(error.y(), -2.0);
  EXPECT_NEAR(error.z(), 2.0 * kPi - 6.0, 1e-12);
}

TEST(ErrorSeries, HasTheErrorsAndSpreadsOfEachStepByHand) {
  const std::vector<EvaluatedStep> steps = {
      step_at(10.0, {0.0, 0.0, 0.0}, {3.0, -4.0, 0.1}),
      step_at(10.5, {1.0, 0.0, 3.1}, {1.0, 0.0, -3.1}),
  };
  const ErrorSeries series = error_series(steps);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_THAT(series.step, ElementsAre(0U, 1U));
  EXPECT_THAT(series.time_s, ElementsAre(0.0, 0.5));
  EXPECT_THAT(series.x_error_m, ElementsAre(3.0, 0.0));
  EXPECT_THAT(series.y_error_m, ElementsAre(-4.0, 0.0));
  EXPECT_THAT(series.yaw_error_rad, ElementsAre(DoubleEq(0.1), DoubleNear(2.0 * kPi - 6.2, 1e-12)));
  EXPECT_THAT(series.position_error_m, ElementsAre(DoubleEq(5.0), 0.0));
  EXPECT_THAT(series.x_sigma_m, ElementsAre(2.0, 2.0));
  EXPECT_THAT(series.y_sigma_m, ElementsAre(0.5, 0.5));
  EXPECT_THAT(series.yaw_sigma_rad, ElementsAre(DoubleEq(0.1), DoubleEq(0.1)));
  EXPECT_NEAR(series.nees[0], 9.0 / 4.0 + 16.0 / 0.25 + 1.0, 1e-9);
  EXPECT_THAT(series.is_inside_95, ElementsAre(false, true));
}

TEST(ErrorSeries, LeavesOutStepsWithoutTruthButCountsTimeFromTheFirstStepOfAll) {
  std::vector<EvaluatedStep> steps;
  for (int i = 0; i < 6; ++i) steps.push_back(step_at(7.0 + i, {}, {}));
  steps[0].truth_in_enu.reset();
  steps[3].truth_in_enu.reset();
  const ErrorSeries series = error_series(steps);
  EXPECT_THAT(series.time_s, ElementsAre(1.0, 2.0, 4.0, 5.0));
  EXPECT_THAT(series.step, ElementsAre(1U, 2U, 4U, 5U)) << "a gap that a chart can leave open";
  for (EvaluatedStep& step : steps) step.truth_in_enu.reset();
  EXPECT_EQ(error_series(steps).size(), 0U);
  EXPECT_EQ(error_series({}).size(), 0U);
}

TEST(ErrorSeries, BreaksWhereAnEstimateOrItsCovarianceIsNone) {
  std::vector<EvaluatedStep> steps(4, step_at(0.0, {}, {}));
  steps[1].estimate_in_enu = {kNaN, 0.0, 0.0};
  steps[2].covariance(1, 1) = -1.0;
  steps[3].covariance(2, 2) = 0.0;
  const ErrorSeries series = error_series(steps);
  EXPECT_THAT(series.x_error_m, ElementsAre(0.0, IsNan(), 0.0, 0.0));
  EXPECT_THAT(series.y_error_m, ElementsAre(0.0, 0.0, 0.0, 0.0));
  EXPECT_THAT(series.position_error_m, ElementsAre(0.0, IsNan(), 0.0, 0.0));
  EXPECT_THAT(series.y_sigma_m, ElementsAre(0.5, 0.5, IsNan(), 0.5));
  EXPECT_EQ(series.yaw_sigma_rad[3], 0.0) << "a filter that is sure, not one that is silent";
  EXPECT_THAT(series.nees, ElementsAre(0.0, IsNan(), IsNan(), IsNan()));
  EXPECT_THAT(series.is_inside_95, ElementsAre(true, false, false, true));
  EXPECT_THAT(series.is_ellipse_known, ElementsAre(true, true, true, true));
  steps[0].covariance(0, 1) = kNaN;
  EXPECT_THAT(error_series(steps).is_ellipse_known, ElementsAre(false, true, true, true));
}

TEST(ErrorSeries, HasTheMeansOfTheTables) {
  const auto steps = noisy_steps(500);
  const ErrorSeries series = error_series(steps);
  const Consistency consistency = assess_consistency(steps);
  double nees_sum = 0.0;
  std::size_t nees_steps = 0;
  for (const double nees : series.nees) {
    if (std::isnan(nees)) continue;
    nees_sum += nees;
    ++nees_steps;
  }
  EXPECT_EQ(nees_steps, consistency.nees_steps);
  EXPECT_EQ(series.size() - nees_steps, consistency.excluded_steps);
  EXPECT_EQ(nees_sum / static_cast<double>(nees_steps), consistency.nees_mean);
  const auto inside = std::count(series.is_inside_95.begin(), series.is_inside_95.end(), true);
  EXPECT_EQ(static_cast<double>(inside) / static_cast<double>(series.size()),
            consistency.coverage_95);

  std::vector<PosePair> pairs;
  for (const EvaluatedStep& step : steps) {
    if (step.truth_in_enu) pairs.push_back({step.time_s, step.estimate_in_enu, *step.truth_in_enu});
  }
  const PoseErrorSummary summary = summarise_pose_errors(pairs).value();
  EXPECT_EQ(summarise_errors(series.position_error_m).mean_square, summary.position_m.mean_square);
  EXPECT_EQ(summarise_errors(series.yaw_error_rad).p90, summary.orientation_rad.p90);
}

TEST(StepConsistency, ComparesSquaredDistancesWithTheEllipse) {
  const Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity() * 0.01;
  EXPECT_TRUE(assess_step({0.244, 0.0, 0.0}, covariance).is_inside_95);   // d^2 = 5.954
  EXPECT_FALSE(assess_step({0.246, 0.0, 0.0}, covariance).is_inside_95);  // d^2 = 6.052
  EXPECT_NEAR(assess_step({0.1, 0.2, 0.3}, covariance).nees.value(), 14.0, 1e-9);
  EXPECT_FALSE(assess_step({}, Eigen::Matrix3d::Zero()).is_inside_95);
}

TEST(CumulativeDistribution, HasTheShareOfValuesUpToEach) {
  const auto result = cumulative_distribution({3.0, 1.0, 2.0, 1.0});
  EXPECT_THAT(result.value, ElementsAre(1.0, 1.0, 2.0, 3.0));
  EXPECT_THAT(result.share, ElementsAre(0.25, 0.5, 0.75, 1.0));
}

TEST(CumulativeDistribution, CrossesTheMedianAndThePercentilesOfTheTables) {
  std::vector<double> errors_m;
  for (std::uint32_t i = 0; i < 1001; ++i) {
    errors_m.push_back(std::abs(standard_normals({.seed = 42, .step = i})[0]));
  }
  const ErrorStatistics statistics = summarise_errors(errors_m);
  const auto result = cumulative_distribution(errors_m);
  for (std::size_t i = 0; i < result.value.size(); ++i) {  // counted one by one
    const auto at_most = std::count_if(errors_m.begin(), errors_m.end(),
                                       [&](double error_m) { return error_m <= result.value[i]; });
    ASSERT_DOUBLE_EQ(result.share[i], static_cast<double>(at_most) / 1001.0);
  }
  EXPECT_EQ(result.value[500], statistics.median);
  EXPECT_EQ(result.value[900], statistics.p90);
  EXPECT_EQ(result.value.back(), statistics.maximum);
}

TEST(CumulativeDistribution, LeavesOutWhatIsNoNumber) {
  const auto result = cumulative_distribution({kNaN, 2.0, kNaN, -1.0});
  EXPECT_THAT(result.value, ElementsAre(-1.0, 2.0));
  EXPECT_THAT(result.share, ElementsAre(0.5, 1.0));
  EXPECT_THAT(cumulative_distribution({kNaN}).value, IsEmpty());
  EXPECT_THAT(cumulative_distribution({}).share, IsEmpty());
}

/// Steps every tenth of a second, truth where the pattern has a T.
std::vector<EvaluatedStep> steps_with_truth(const std::string& pattern) {
  std::vector<EvaluatedStep> steps;
  for (const char letter : pattern) {
    steps.push_back(step_at(0.1 * static_cast<double>(steps.size()), {}, {1.0, 0.0, 0.0}));
    if (letter != 'T') steps.back().truth_in_enu.reset();
  }
  return steps;
}

TEST(TimeGaps, AreWhereMoreThanFiveMedianPeriodsPass) {
  EXPECT_THAT(time_gaps(std::vector<double>{0.0, 1.0, 2.0, 7.0, 8.0, 14.0, 15.0}),
              ElementsAre(5U));  // 5 periods are none yet
  EXPECT_THAT(time_gaps(std::vector<double>{0.0, 1.0, 2.0, 5.0, 6.0}, 2.0), ElementsAre(3U));
}

TEST(TimeGaps, AreNoneInEvenTimesAndFewPoints) {
  EXPECT_THAT(time_gaps(std::vector<double>{}), IsEmpty());
  EXPECT_THAT(time_gaps(std::vector<double>{3.0}), IsEmpty());
  EXPECT_THAT(time_gaps(std::vector<double>{3.0, 900.0}), IsEmpty());
  std::vector<double> even(1000);
  for (std::size_t i = 0; i < even.size(); ++i) even[i] = 1.7e9 + 0.1 * static_cast<double>(i);
  EXPECT_THAT(time_gaps(even), IsEmpty());
}

TEST(TimeGaps, AreSeenWhereHalfOfAllDistancesAreGaps) {
  EXPECT_THAT(time_gaps(std::vector<double>{0.0, 1.0, 100.0, 101.0, 200.0}), ElementsAre(2U, 4U));
}

TEST(GapsOf, AreWhereTruthIsMissing) {
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("TTT..TT.TTTT"))), ElementsAre(3U, 5U));
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("..TTTT.."))), IsEmpty());
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("...."))), IsEmpty());
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("..T."))), IsEmpty());
}

TEST(GapsOf, DoNotTearTruthOfALowerRateToPoints) {
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("T..T..T..T.....T..T"))), ElementsAre(4U));
}

TEST(GapsOf, CountAPauseOfTheRunOnce) {
  std::vector<EvaluatedStep> steps = steps_with_truth("TTTTT.TTTT");
  for (std::size_t i = 3; i < steps.size(); ++i) steps[i].time_s += 60.0;
  for (std::size_t i = 6; i < steps.size(); ++i) steps[i].time_s += 60.0;
  EXPECT_THAT(gaps_of(error_series(steps)), ElementsAre(3U, 5U));
}

TEST(BrokenAt, PutsANanBeforeEachGapAndKeepsTheRest) {
  const std::vector<double> values = {1.0, 2.0, 3.0, 4.0};
  EXPECT_THAT(broken_at(std::vector<std::size_t>{1, 3}, values),
              ElementsAre(1.0, IsNan(), 2.0, 3.0, IsNan(), 4.0));
  EXPECT_EQ(broken_at(std::vector<std::size_t>{}, values), values);
  EXPECT_THROW((void)broken_at(std::vector<std::size_t>{4}, values), std::logic_error);
  EXPECT_THROW((void)broken_at(std::vector<std::size_t>{2, 1}, values), std::logic_error);
}

TEST(GapsOf, AreNotMadeByTwoTruthsInARowAmongFewer) {
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("T..T..TT..T..T..T"))), IsEmpty());
}

TEST(GapsOf, AreNoneInTruthThatComesAlmostEvenly) {
  // Truth every third and every fourth step by turns.
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("T..T...T..T...T..T...T"))), IsEmpty());
  EXPECT_THAT(gaps_of(error_series(steps_with_truth("T..T...T..T......T..T...T"))),
              ElementsAre(4U));
}

TEST(LowerMedian, IsTheMiddleOneOrTheLowerOfTwo) {
  EXPECT_EQ(lower_median({7.0}), 7.0);
  EXPECT_EQ(lower_median({9.0, 1.0, 5.0}), 5.0);
  EXPECT_EQ(lower_median({9.0, 1.0, 5.0, 4.0}), 4.0);
  EXPECT_THROW((void)lower_median({}), std::logic_error);
}

}  // namespace series_test
}  // namespace nadir
