// SPDX-License-Identifier: Apache-2.0
// From where runs part, and how far they are from each other.
#include <gmock/gmock.h>

#include <cmath>

#include "core/session/run_comparison.h"
#include "tests/core/session/made_run.h"

namespace nadir {
namespace run_divergence_test {

using Document = std::shared_ptr<const RunDocument>;

TEST(Divergence, IsTheFirstMomentFromWhichRunsStayApart) {
  const auto first = made_document(300);
  const auto second = made_document(300, [](RunStep& step) {
    if (step.step >= 100 && step.step < 108) step.estimate.moments.mean.y_m += 9.0;  // too short
    if (step.step >= 200) step.estimate.moments.mean.y_m += 2.5;
  });
  const auto divergence = first_divergence(*first, *second);
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->first_index, 200U);
  EXPECT_EQ(divergence->second_index, 200U);
  EXPECT_DOUBLE_EQ(divergence->time_s, first->time_s[200]);
  EXPECT_NEAR(divergence->distance_m, 2.5, 1e-9);
  EXPECT_NEAR(divergence->sigmas, 2.5 / std::sqrt(0.5), 1e-9);
  EXPECT_EQ(divergence->words, "2.5 m apart (3.5 sigma)");
  const std::vector<Document> runs = {first, second};
  EXPECT_EQ(compare_runs(runs).divergence[1]->first_index, 200U);
}

TEST(Divergence, SaysItsRuleInWords) {
  EXPECT_EQ(divergence_words(),
            "more than 2 m apart, or more than 0.5 m and 3 sigma, for at least 1 s");
  EXPECT_EQ(divergence_words({.apart_m = 1.25, .apart_sigmas = 2.0}),
            "more than 1.25 m apart, or more than 0.5 m and 2 sigma, for at least 1 s");
}

TEST(Divergence, NeedsMoreThanACollapsedFiltersMillimetres) {
  const auto collapsed = [](double offset_m) {
    return made_document(100, [=](RunStep& step) {
      step.estimate.moments.covariance.diagonal() << 1e-6, 1e-6, 1e-8;
      step.estimate.moments.mean.y_m += offset_m;
    });
  };
  EXPECT_EQ(first_divergence(*collapsed(0.0), *collapsed(0.4)), std::nullopt);
  const auto divergence = first_divergence(*collapsed(0.0), *collapsed(0.6));
  ASSERT_TRUE(divergence);
  EXPECT_EQ(divergence->first_index, 0U);
}

TEST(Divergence, OfLessThanTheSigmasAndMetresIsNone) {
  const auto far = made_document(100, [](RunStep& step) { set_error_m(step, 1.9); });
  EXPECT_EQ(first_divergence(*made_document(100), *far), std::nullopt) << "2.5 sigma, 1.8 m";
  EXPECT_TRUE(first_divergence(*made_document(100), *far, {.apart_m = 1.5}));
  EXPECT_TRUE(first_divergence(*made_document(100), *far, {.apart_sigmas = 2.0}));
}

TEST(Divergence, OfDifferentFlightsIsNone) {
  RunDocument other = made_run(100, [](RunStep& step) { set_error_m(step, 50.0); });
  other.header.flight_hash = "f2";
  EXPECT_EQ(first_divergence(*made_document(100), *RunDocument::from_steps(other)), std::nullopt);
}

TEST(DistanceBetween, RunsOfDifferentRatesIsThatOfTheirPaths) {
  // The second run takes every third frame, and begins 5 s later.
  RunDocument sparse = made_run(300);
  std::vector<RunStep> kept;
  for (const RunStep& step : sparse.steps) {
    if (step.step >= 50 && step.step % 3 == 0) kept.push_back(step);
  }
  sparse.steps = kept;
  const auto second = RunDocument::from_steps(sparse);
  const auto first = made_document(300);
  const auto distance = distance_between_m(*first, *second);
  ASSERT_EQ(distance.size(), 300U);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    if (i < 51 || i > 297) {
      EXPECT_TRUE(std::isnan(distance[i])) << i;
    } else {
      EXPECT_NEAR(distance[i], 0.0, 1e-9) << i;  // 0.5 m a step if it were not interpolated
    }
  }
  EXPECT_THAT(distance_between_m(*second, *first), ::testing::Each(::testing::Lt(1e-9)));
  EXPECT_EQ(first_divergence(*first, *second), std::nullopt);
}

TEST(DistanceBetween, IsNotKnownInsideAGap) {
  RunDocument gappy = made_run(300);
  gappy.steps.erase(gappy.steps.begin() + 100, gappy.steps.begin() + 200);
  const auto distance = distance_between_m(*made_document(300), *RunDocument::from_steps(gappy));
  EXPECT_EQ(distance[99], 0.0);
  for (std::size_t i = 100; i < 200; ++i) EXPECT_TRUE(std::isnan(distance[i])) << i;
  EXPECT_EQ(distance[200], 0.0);
}

}  // namespace run_divergence_test
}  // namespace nadir
