// SPDX-License-Identifier: Apache-2.0
// Where a run is lost, and where it is found again.
#include "core/session/moment_tracking.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/core/session/moments_of_run.h"

namespace nadir {
namespace moment_tracking_test {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(WorstMoments, LostAndFoundAgainFollowTheRuleOfTheEvaluation) {
  const auto run = made_document(400, [](RunStep& step) {
    if (is_within(step, 100, 149)) set_error_m(step, step.step == 120 ? 12.0 : 8.0);
  });
  ASSERT_EQ(run->evaluation.convergence.lost_stretches, 1U);
  const auto lost = of_kind(*run, MomentKind::kLost);
  ASSERT_THAT(lost, SizeIs(1));
  EXPECT_EQ(lost[0].step, 100U);
  EXPECT_EQ(lost[0].words, "lost: 8.0 m off, up to 12.0 m, found again 5.0 s later");
  EXPECT_NEAR(lost[0].severity, 12.0 / 5.0, 1e-9);
  EXPECT_NEAR(lost[0].to_s, 15.0, 1e-9);
  const auto found = of_kind(*run, MomentKind::kFound);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].step, 150U);
  EXPECT_EQ(found[0].words, "found again after 5.0 s");
}

TEST(WorstMoments, ARunThatBeganLostIsFoundOnceAndMayStayLost) {
  const auto run = made_document(400, [](RunStep& step) {
    if (step.step < 100) set_error_m(step, 30.0);
    if (step.step >= 300) set_error_m(step, 6.0);
  });
  const auto found = of_kind(*run, MomentKind::kFound);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found[0].words, "found 10.0 s after the start");
  EXPECT_DOUBLE_EQ(found[0].time_s, *run->evaluation.convergence.after_s);
  const auto lost = of_kind(*run, MomentKind::kLost);
  ASSERT_THAT(lost, SizeIs(1));
  EXPECT_EQ(lost[0].words, "lost: 6.0 m off, up to 6.0 m, not found again");
  EXPECT_EQ(lost[0].to_s, run->time_s.back());
}

TEST(WorstMoments, ARunIsNotFoundWhereItBeganAsRunsDo) {
  const auto began_wide = [](int steps) {
    return of_kind(*made_document(400,
                                  [=](RunStep& step) {
                                    if (step.step >= steps) return;
                                    step.estimate.moments.covariance.diagonal() << 9, 9, 0.01;
                                  }),
                   MomentKind::kFound);
  };
  EXPECT_THAT(began_wide(19), IsEmpty());
  EXPECT_THAT(began_wide(21), SizeIs(1));
}

TEST(WorstMoments, StepsWithoutACovarianceAreNeitherLostNorFound) {
  const auto run = made_document(100, [](RunStep& step) {
    step.truth_in_enu.reset();
    if (step.step % 2 == 0) step.estimate.moments.covariance.setConstant(std::nan(""));
  });
  EXPECT_THAT(run->worst_moments, IsEmpty());
}

}  // namespace moment_tracking_test
}  // namespace nadir
