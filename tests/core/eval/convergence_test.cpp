// SPDX-License-Identifier: Apache-2.0
#include "core/eval/convergence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nadir {
namespace convergence_test {

/// A flight straight east, 1 m and 0.5 s a step, whose error is north of the truth.
std::vector<EvaluatedStep> flight_with_errors(const std::vector<double>& errors_m) {
  std::vector<EvaluatedStep> steps;
  for (std::size_t i = 0; i < errors_m.size(); ++i) {
    const auto m = static_cast<double>(i);
    EvaluatedStep step{.time_s = 100.0 + 0.5 * m,
                       .truth_in_enu = Rigid2{m, 0, 0},
                       .estimate_in_enu = {m, errors_m[i], 0}};
    step.covariance = Eigen::Matrix3d::Identity();
    steps.push_back(step);
  }
  return steps;
}

std::vector<double> errors(std::initializer_list<std::pair<int, double>> stretches) {
  std::vector<double> all;
  for (const auto& [count, error_m] : stretches)
    all.insert(all.end(), static_cast<std::size_t>(count), error_m);
  return all;
}

TEST(Convergence, IsAtTheFirstStepFromWhichTheErrorStaysSmall) {
  const auto result = find_convergence(flight_with_errors(errors({{10, 30.0}, {50, 1.0}})));
  EXPECT_EQ(result.after_s, 5.0);
  EXPECT_EQ(result.after_m, 10.0);
  EXPECT_EQ(result.lost_stretches, 0U);
}

TEST(Convergence, PassingTheTruthByChanceIsNone) {
  const auto result =
      find_convergence(flight_with_errors(errors({{10, 30.0}, {19, 1.0}, {10, 30.0}, {30, 1.0}})));
  EXPECT_EQ(result.after_m, 39.0) << "the 19 m stretch before is too short";
}

TEST(Convergence, NeedsAnEstimateThatIsSureOfItself) {
  auto steps = flight_with_errors(errors({{60, 1.0}}));
  for (std::size_t i = 0; i < 20; ++i)
    steps[i].covariance *= 2.0;  // sqrt(det) = 2 m^2: not below it.
  EXPECT_EQ(find_convergence(steps).after_m, 20.0);
}

TEST(Convergence, TakesAFilterThatCollapsedToALineAsSureAndOneWithoutCovarianceAsNot) {
  auto steps = flight_with_errors(errors({{60, 1.0}}));
  for (EvaluatedStep& step : steps) {  // rounding leaves its determinant below zero
    step.covariance(0, 1) = step.covariance(1, 0) = 1.0 + 1e-14;
  }
  EXPECT_EQ(find_convergence(steps).after_m, 0.0);
  for (EvaluatedStep& step : steps) step.covariance = -Eigen::Matrix3d::Identity();
  EXPECT_FALSE(find_convergence(steps).after_m) << "two negative variances, determinant 1";
}

TEST(Convergence, IsUnknownWhereItNeverComesOrTheFlightIsTooShort) {
  EXPECT_FALSE(find_convergence(flight_with_errors(errors({{60, 4.0}}))).after_s);
  EXPECT_FALSE(find_convergence(flight_with_errors(errors({{20, 0.0}}))).after_s) << "19 m of path";
  EXPECT_TRUE(find_convergence(flight_with_errors(errors({{21, 0.0}}))).after_s) << "20 m of path";
  EXPECT_FALSE(find_convergence({}).after_s);
}

TEST(Convergence, DoesNotLatch) {
  const auto result =
      find_convergence(flight_with_errors(errors({{30, 1.0}, {12, 6.0}, {30, 1.0}, {8, 9.0}})));
  EXPECT_EQ(result.after_m, 0.0);
  EXPECT_EQ(result.lost_stretches, 2U);
  EXPECT_EQ(result.lost_m, 12.0 + 7.0);
}

TEST(TrackingChanges, SayAtWhichStepsItWasFoundAndLost) {
  auto steps = flight_with_errors(errors({{5, 30.0}, {30, 1.0}, {12, 6.0}, {30, 1.0}, {8, 9.0}}));
  steps[2].truth_in_enu.reset();  // indices are of all steps
  std::vector<std::size_t> at;
  for (const TrackingChange& change : find_tracking_changes(steps)) {
    EXPECT_EQ(change.is_found, at.size() % 2 == 0);
    at.push_back(change.step);
  }
  EXPECT_EQ(at, (std::vector<std::size_t>{5, 35, 47, 77}));
  EXPECT_TRUE(find_tracking_changes({}).empty());
}

TEST(Convergence, SmallExcursionsAreNoLoss) {
  EXPECT_EQ(
      find_convergence(flight_with_errors(errors({{30, 1.0}, {5, 4.9}, {30, 1.0}}))).lost_stretches,
      0U);
}

TEST(Convergence, HoveringIsNoDistance) {
  auto steps = flight_with_errors(errors({{40, 1.0}}));
  for (auto& step : steps) {
    step.truth_in_enu = Rigid2{};
    step.estimate_in_enu = {};
  }
  EXPECT_FALSE(find_convergence(steps).after_s) << "standing still shows nothing";
}

TEST(Convergence, StepsWithoutTruthOrWithBrokenCovarianceDoNotConverge) {
  auto steps = flight_with_errors(errors({{60, 1.0}}));
  for (std::size_t i = 0; i < 8; ++i) steps[i].truth_in_enu.reset();
  for (std::size_t i = 8; i < 12; ++i) steps[i].covariance(0, 0) = std::nan("");
  const auto result = find_convergence(steps);
  EXPECT_EQ(result.after_s, 6.0) << "from the first step, with truth or without";
  EXPECT_EQ(result.after_m, 4.0) << "from the first truth";
}

}  // namespace convergence_test
}  // namespace nadir
