// SPDX-License-Identifier: Apache-2.0
#include "core/session/worst_moments.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/base/angle.h"
#include "tests/core/session/moments_of_run.h"

namespace nadir {
namespace worst_moments_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(WorstMoments, OfAQuietRunAreItsLargestErrorAlone) {
  const auto run = made_document(400, [](RunStep& step) {
    if (step.step == 250) set_error_m(step, 0.3);
  });
  ASSERT_THAT(run->worst_moments, SizeIs(1));
  const WorstMoment& moment = run->worst_moments.front();
  EXPECT_EQ(moment.kind, MomentKind::kLargestError);
  EXPECT_EQ(moment.step, 250U);
  EXPECT_DOUBLE_EQ(moment.time_s, run->time_s[250]);
  EXPECT_NEAR(moment.severity, 0.3, 1e-12) << "limit is 1 m";
  EXPECT_EQ(moment.words, "0.30 m off, 95 % ellipse 1.2 m");  // 0.5 m * sqrt(5.991)
}

TEST(WorstMoments, OfAnEmptyRunAreNone) { EXPECT_THAT(made_document(0)->worst_moments, IsEmpty()); }

TEST(WorstMoments, OneEpisodeOfErrorsIsOneMomentAtItsPeak) {
  const auto run = made_document(400, [](RunStep& step) {
    if (is_within(step, 100, 110)) set_error_m(step, 1.5);
    if (is_within(step, 130, 140)) set_error_m(step, 2.0 + 0.1 * (5 - std::abs(step.step - 135)));
    if (is_within(step, 300, 301)) set_error_m(step, 1.2);
  });
  const auto errors = of_kind(*run, MomentKind::kLargestError);
  ASSERT_THAT(errors, SizeIs(2));
  EXPECT_EQ(errors[0].step, 135U);
  EXPECT_NEAR(errors[0].severity, 2.5, 1e-9);
  EXPECT_NEAR(errors[0].from_s, 10.0, 1e-9);
  EXPECT_NEAR(errors[0].to_s, 14.0, 1e-9);
  EXPECT_EQ(errors[1].step, 300U) << "the first of two that are as bad";
}

TEST(WorstMoments, KnowWhereTheEstimateIsStillNearTheTruth) {
  const auto run = made_document(400, [](RunStep& step) {
    if (step.step == 100) set_error_m(step, 1.9);
    if (step.step == 200) set_error_m(step, 2.1);
    if (step.step == 300) {
      set_error_m(step, 1.5);
      step.estimate.moments.mean.yaw_rad += Angle::degrees(12.0).radians();
    }
  });
  const std::vector<WorstMoment>& moments = run->worst_moments;
  ASSERT_THAT(moments, SizeIs(3));
  EXPECT_TRUE(moments[0].is_near_truth);
  EXPECT_FALSE(moments[1].is_near_truth) << "farther than 2 m";
  EXPECT_FALSE(moments[2].is_near_truth) << "turned by more than 10 degrees";
}

TEST(WorstMoments, AnErrorCountsAgainstWhatIsUsualInItsRun) {
  const auto run = made_document(400, [](RunStep& step) {
    set_error_m(step, step.step == 200 ? 4.6 : is_within(step, 50, 60) ? 2.2 : 1.0);
    step.estimate.moments.covariance.diagonal() << 4.0, 4.0, 0.01;
  });
  const auto errors = of_kind(*run, MomentKind::kLargestError);
  ASSERT_THAT(errors, SizeIs(1)) << "2.2 m is less than 2.5 times the median";
  EXPECT_EQ(errors[0].step, 200U);
  EXPECT_NEAR(errors[0].severity, 4.6 / 2.5, 1e-9);
}

TEST(WorstMoments, TruthFartherOffThanTheFilterHeldPossibleIsOverConfidence) {
  const auto run = made_document(400, [](RunStep& step) {
    if (step.step == 50) set_error_m(step, 0.95);
    if (is_within(step, 200, 203)) {
      set_error_m(step, step.step == 202 ? 0.9 : 0.6);
      step.estimate.moments.covariance.diagonal() << 0.01, 0.01, 0.0009;
    }
  });
  const auto moments = of_kind(*run, MomentKind::kOverConfident);
  ASSERT_THAT(moments, SizeIs(1));
  EXPECT_EQ(moments[0].step, 202U);
  EXPECT_EQ(moments[0].words, "0.90 m off, 95 % ellipse 0.24 m");
  EXPECT_NEAR(moments[0].severity, std::sqrt(81.0 / 16.266), 1e-4);
}

TEST(WorstMoments, OverConfidenceInTheHeadingIsSaidInDegrees) {
  const auto run = made_document(400, [](RunStep& step) {
    if (step.step == 50) set_error_m(step, 0.95);
    if (step.step == 200) step.estimate.moments.mean.yaw_rad = -0.2;
  });
  const auto moments = of_kind(*run, MomentKind::kOverConfident);
  ASSERT_THAT(moments, SizeIs(1));
  EXPECT_EQ(moments[0].words, "heading 11.5 deg off, 95 % within 3.4 deg");  // 1.96 * 0.03 rad
}

TEST(WorstMoments, ErrorOverConfidenceAndLowAgreementOfOneMomentAreOne) {
  const auto run = made_document(400, [](RunStep& step) {
    if (!is_within(step, 200, 204)) return;
    set_error_m(step, step.step == 202 ? 4.0 : 3.0);
    step.agreement = step.step == 203 ? 0.5 : 0.6;
  });
  ASSERT_THAT(run->worst_moments, SizeIs(1));
  EXPECT_EQ(run->worst_moments[0].kind, MomentKind::kLargestError);
  EXPECT_EQ(run->worst_moments[0].words,
            "4.0 m off, 95 % ellipse 1.2 m, agreement 0.60, usually 0.90");
}

TEST(WorstMoments, LowAgreementCountsAgainstTheRunsOwnSpread) {
  const auto drop_at_200 = [](double usual_spread) {
    return made_document(400, [=](RunStep& step) {
      step.agreement = 0.8 + usual_spread * std::sin(2.3 * step.step);
      if (is_within(step, 200, 202)) step.agreement = 0.6;
    });
  };
  const auto steady = of_kind(*drop_at_200(0.01), MomentKind::kLowAgreement);
  ASSERT_THAT(steady, SizeIs(1));
  EXPECT_EQ(steady[0].step, 200U);
  EXPECT_EQ(steady[0].words.substr(0, 14), "agreement 0.60");
  EXPECT_THAT(of_kind(*drop_at_200(0.15), MomentKind::kLowAgreement), IsEmpty());
}

TEST(WorstMoments, WithoutTruthSpreadAgreementAndGapsRemain) {
  const auto run = made_document(400, [](RunStep& step) {
    step.truth_in_enu.reset();
    if (step.step >= 300) step.time_s += 2.9;
    if (is_within(step, 100, 139)) {
      const double variance_m2 = step.step == 120 ? 64.0 : 36.0;
      step.estimate.moments.covariance.diagonal() << variance_m2, variance_m2, 0.01;
    }
    if (is_within(step, 200, 205)) step.agreement = 0.5;
  });
  std::vector<std::string> words;
  for (const WorstMoment& moment : run->worst_moments) words.push_back(moment.words);
  EXPECT_THAT(words, ElementsAre("lost: 6.0 m of spread, up to 8.0 m, found again 4.0 s later",
                                 "found again after 4.0 s", "agreement 0.50, usually 0.90",
                                 "no step for 3.0 s"));
  EXPECT_NEAR(run->worst_moments[3].severity, std::sqrt(3.0 / 0.5), 1e-6);
  EXPECT_EQ(run->worst_moments[3].step, 300U);
  EXPECT_EQ(run->worst_moments[3].from_s, run->time_s[299]);
}

TEST(WorstMoments, TopviewsWithoutCellsAreMissingDataUnlessTheRunHasNone) {
  const auto unseen = [](int first, int last) {
    return of_kind(*made_document(400,
                                  [=](RunStep& step) {
                                    if (is_within(step, first, last)) step.topview_cells = 0;
                                  }),
                   MomentKind::kMissingData);
  };
  const auto moments = unseen(200, 219);
  ASSERT_THAT(moments, SizeIs(1));
  EXPECT_EQ(moments[0].words, "nothing seen for 2.0 s");
  EXPECT_EQ(moments[0].step, 200U);
  EXPECT_THAT(unseen(200, 205), IsEmpty()) << "0.6 s";
  EXPECT_THAT(unseen(380, 399), SizeIs(1)) << "until the end";
  EXPECT_THAT(unseen(0, 399), IsEmpty());
}

TEST(WorstMoments, OnlyTheMostSevereOfAKindStay) {
  const auto run = made_document(4000, [](RunStep& step) {
    if (step.step % 100 == 50) set_error_m(step, 2.0 + 0.01 * step.step / 100);
    step.estimate.moments.covariance.diagonal() << 25.0, 25.0, 0.01;
  });
  const auto errors = of_kind(*run, MomentKind::kLargestError);
  ASSERT_THAT(errors, SizeIs(12));
  EXPECT_EQ(errors.front().step, 2850U);
  EXPECT_EQ(errors.back().step, 3950U);
}

TEST(WorstMoments, AreInOrderInsideTheirEpisodesAndApartInEachKind) {
  const WorstMomentRule rule;
  const auto run = made_document(3000, [](RunStep& step) {
    const double wave = std::sin(0.05 * step.step) * std::sin(0.0113 * step.step);
    set_error_m(step, 6.0 * std::abs(wave));
    step.agreement = 0.85 - 0.4 * std::max(0.0, wave);
    if (step.step % 700 == 0) step.topview_cells = 0;
  });
  ASSERT_THAT(run->worst_moments, ::testing::Not(IsEmpty()));
  std::map<MomentKind, double> last_end;
  double last_s = 0.0;
  for (const WorstMoment& moment : run->worst_moments) {
    EXPECT_GE(moment.time_s, last_s);
    last_s = moment.time_s;
    EXPECT_EQ(moment.time_s, run->time_s[moment.step]);
    EXPECT_LE(moment.from_s, moment.time_s);
    EXPECT_LE(moment.time_s, moment.to_s);
    EXPECT_GE(moment.severity, 1.0) << moment.words;
    EXPECT_FALSE(moment.words.empty());
    const auto before = last_end.find(moment.kind);
    if (before != last_end.end() && moment.kind <= MomentKind::kLowAgreement) {
      EXPECT_GE(moment.from_s - before->second, rule.merged_within_s);
    }
    last_end[moment.kind] = moment.to_s;
  }
}

TEST(WorstMoments, AreSteppedThroughWithoutStandingStill) {
  std::vector<WorstMoment> moments(3);
  moments[0].time_s = 1.0;
  moments[1].time_s = 2.0;
  moments[1].severity = 4.0;
  moments[2].time_s = 5.0;
  EXPECT_EQ(next_moment(moments, 0.0), &moments[0]);
  EXPECT_EQ(next_moment(moments, 1.0), &moments[1]);
  EXPECT_EQ(next_moment(moments, 1.0 - 1e-9), &moments[1]) << "a rounded time is the same";
  EXPECT_EQ(next_moment(moments, 5.0), nullptr);
  EXPECT_EQ(previous_moment(moments, 9.0), &moments[2]);
  EXPECT_EQ(previous_moment(moments, 5.0), &moments[1]);
  EXPECT_EQ(previous_moment(moments, 1.0), nullptr);
  EXPECT_EQ(most_severe(moments), &moments[1]);
  EXPECT_EQ(most_severe({}), nullptr);
}

}  // namespace worst_moments_test
}  // namespace nadir
