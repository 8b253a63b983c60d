// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_value.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/core/session/made_run.h"

namespace nadir {
namespace moment_value_test {

/// "8.0 m" of the first moment of a kind.
std::string value_of(const RunDocument& run, MomentKind kind) {
  for (const WorstMoment& moment : run.worst_moments) {
    if (moment.kind != kind) continue;
    const MomentValue value = moment_value(run, moment);
    return value.unit.empty() ? value.digits : value.digits + " " + value.unit;
  }
  return "no such moment";
}

TEST(MomentValue, OfTheLargestErrorIsItsMetres) {
  const auto run =
      made_document(300, [](RunStep& step) { set_error_m(step, step.step == 120 ? 0.75 : 0.1); });
  EXPECT_EQ(value_of(*run, MomentKind::kLargestError), "0.75 m");
}

TEST(MomentValue, OfOverConfidenceIsTheNees) {
  // Metres are as they were; the filter holds a hundredth of them possible.
  const auto run = made_document(300, [](RunStep& step) {
    if (step.step == 150) step.estimate.moments.covariance(1, 1) = 1e-4;
  });
  EXPECT_EQ(value_of(*run, MomentKind::kOverConfident), "100");
}

TEST(MomentValue, OfLowAgreementIsThePercent) {
  const auto run = made_document(300, [](RunStep& step) {
    if (step.step == 100) step.agreement = 0.314;
  });
  EXPECT_EQ(value_of(*run, MomentKind::kLowAgreement), "31 %");
}

TEST(MomentValue, OfBeingLostIsTheLargestErrorOfTheEpisodeAndOfBeingFoundThatOfTheStep) {
  const auto run = made_document(600, [](RunStep& step) {
    if (step.step >= 200 && step.step < 300) set_error_m(step, step.step == 270 ? 12.5 : 8.0);
  });
  EXPECT_EQ(value_of(*run, MomentKind::kLost), "12.5 m");
  EXPECT_EQ(value_of(*run, MomentKind::kFound), "0.10 m");
}

TEST(MomentValue, WithoutTruthOfBeingLostIsTheSpread) {
  const auto run = made_document(600, [](RunStep& step) {
    step.truth_in_enu.reset();
    const double sigma_m = step.step >= 200 && step.step < 300 ? 7.0 : 0.5;
    step.estimate.moments.covariance.topLeftCorner<2, 2>() =
        sigma_m * sigma_m * Eigen::Matrix2d::Identity();
  });
  EXPECT_EQ(value_of(*run, MomentKind::kLost), "7.0 m");
}

TEST(MomentValue, OfMissingDataIsItsDuration) {
  RunDocument late = made_run(300);
  for (std::size_t i = 150; i < late.steps.size(); ++i) late.steps[i].time_s += 2.9;
  EXPECT_EQ(value_of(*RunDocument::from_steps(late), MomentKind::kMissingData), "3.0 s");
  const auto unseen = made_document(400, [](RunStep& step) {
    if (step.step >= 200 && step.step < 225) step.topview_cells = 0;
  });
  EXPECT_EQ(value_of(*unseen, MomentKind::kMissingData), "2.5 s");
  const auto to_the_end = made_document(400, [](RunStep& step) {
    if (step.step >= 380) step.topview_cells = 0;
  });
  EXPECT_EQ(value_of(*to_the_end, MomentKind::kMissingData), "1.9 s");
}

TEST(MomentValue, OfWhatIsNotKnownIsADash) {
  const auto run = made_document(50, [](RunStep& step) { step.truth_in_enu.reset(); });
  WorstMoment moment;
  moment.step = 7;
  moment.kind = MomentKind::kLargestError;
  EXPECT_EQ(moment_value(*run, moment).digits, "–");
  EXPECT_EQ(moment_value(*run, moment).unit, "");
}

}  // namespace moment_value_test
}  // namespace nadir
