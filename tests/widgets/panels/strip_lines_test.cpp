// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/strip_lines.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/eval/consistency.h"
#include "tests/widgets/panels/timeline_run.h"

namespace nadir {
namespace strip_lines_test {

using ::testing::ElementsAre;

std::size_t pieces_of(const PointLine& line) {
  std::size_t pieces = 0;
  for (std::size_t i = 0; i < line.y.size(); ++i) {
    if (std::isfinite(line.y[i]) && (i == 0 || !std::isfinite(line.y[i - 1]))) ++pieces;
  }
  return pieces;
}

double highest(const PointLine& line) {
  double found = -1e300;
  for (const double y : line.y) {
    if (std::isfinite(y)) found = std::max(found, y);
  }
  return found;
}

TEST(StripPlot, ThinsALongRunToItsPixelsAndKeepsItsPeak) {
  const auto run =
      made_document(4541, [](RunStep& step) { set_error_m(step, step.step == 3000 ? 7.5 : 0.1); });
  const std::vector<TimelineRun> runs = {timeline_run(run)};
  const double px_per_s = 500.0 / run->duration_s();
  const StripPlot plot = strip_plot(Strip::kPositionError, runs, px_per_s);
  ASSERT_EQ(plot.curves.size(), 1U);
  EXPECT_LE(plot.curves[0].line.x.size(), 1003U);
  EXPECT_DOUBLE_EQ(highest(plot.curves[0].line), 7.5);
}

TEST(StripPlot, ShowsNearlyAllWhereFewAreFarLarger) {
  const auto run =
      made_document(500, [](RunStep& step) { set_error_m(step, step.step < 5 ? 90.0 : 0.5); });
  const StripPlot plot = strip_plot(Strip::kPositionError, std::vector{timeline_run(run)}, 10.0);
  EXPECT_DOUBLE_EQ(plot.high, 1.0);
  EXPECT_EQ(plot.cut_off, 90.0);
  const auto calm = made_document(500);
  EXPECT_FALSE(strip_plot(Strip::kPositionError, std::vector{timeline_run(calm)}, 10.0).cut_off);
}

TEST(StripPlot, BreaksLinesAtGapsOfTimeAndOfTruth) {
  RunDocument made = made_run(100, [](RunStep& step) {
    if (step.step >= 60 && step.step < 70) step.truth_in_enu.reset();
  });
  for (std::size_t i = 30; i < made.steps.size(); ++i) made.steps[i].time_s += 5.0;
  const auto run = RunDocument::from_steps(made);
  const std::vector<TimelineRun> runs = {timeline_run(run)};
  EXPECT_EQ(pieces_of(strip_plot(Strip::kAgreement, runs, 100.0).curves[0].line), 2U);
  EXPECT_EQ(pieces_of(strip_plot(Strip::kPositionError, runs, 100.0).curves[0].line), 3U);
  // Thinned hard they stay apart.
  EXPECT_EQ(pieces_of(strip_plot(Strip::kPositionError, runs, 1.0).curves[0].line), 3U);
}

TEST(StripPlot, OfARunWithoutTruthHasNoErrorsButAllElse) {
  const auto run = made_document(50, [](RunStep& step) { step.truth_in_enu.reset(); });
  const std::vector<TimelineRun> runs = {timeline_run(run)};
  for (const Strip strip : {Strip::kPositionError, Strip::kOrientationError, Strip::kNees}) {
    EXPECT_TRUE(strip_plot(strip, runs, 100.0).curves[0].line.x.empty()) << strip_info(strip).name;
    EXPECT_EQ(strip_value(strip, runs[0], 1.0), "–");
  }
  for (const Strip strip :
       {Strip::kSigma, Strip::kSampleSize, Strip::kAgreement, Strip::kUpdateTime}) {
    EXPECT_FALSE(strip_plot(strip, runs, 100.0).curves[0].line.x.empty()) << strip_info(strip).name;
    EXPECT_NE(strip_value(strip, runs[0], 1.0), "–");
  }
}

TEST(StripPlot, OfNeesIsRedJustWhereTheFilterIsOverConfident) {
  // Sigmas of half a metre: 3 m north is a NEES of 36, far above the bound of 9.35.
  const auto run = made_document(
      100, [](RunStep& step) { set_error_m(step, step.step >= 40 && step.step < 60 ? 3.0 : 0.1); });
  const StripPlot plot = strip_plot(Strip::kNees, std::vector{timeline_run(run)}, 1000.0);
  ASSERT_EQ(plot.curves.size(), 2U);
  const StripCurve& red = plot.curves.back();
  EXPECT_EQ(red.tone, StripCurve::Tone::kBad);
  ASSERT_FALSE(red.line.x.empty());
  EXPECT_GT(red.line.x.front(), 3.9);
  EXPECT_LT(red.line.x.back(), 6.1);
  EXPECT_DOUBLE_EQ(red.line.y.front(), step_nees_bounds().upper);
  EXPECT_TRUE(plot.is_logarithmic);
  ASSERT_EQ(plot.levels.size(), 2U);
  EXPECT_NEAR(plot.levels[0].value, 9.348, 1e-3);
  EXPECT_NEAR(plot.levels[1].value, 0.216, 1e-3);
  EXPECT_TRUE(plot.levels[0].is_bound) << "only above the upper one something is wrong";
  EXPECT_FALSE(plot.levels[1].is_bound);
}

TEST(StripPlot, OfUpdateTimeHasTheTimeBetweenStepsWhereItIsNear) {
  const auto slow = made_document(20, [](RunStep& step) { step.update_ms = 80.0; });
  const StripPlot plot = strip_plot(Strip::kUpdateTime, std::vector{timeline_run(slow)}, 100.0);
  ASSERT_EQ(plot.levels.size(), 1U);
  EXPECT_NEAR(plot.levels[0].value, 100.0, 1e-6);
  EXPECT_GE(plot.high, 100.0 - 1e-6);
  const auto quick = made_document(20);
  EXPECT_TRUE(
      strip_plot(Strip::kUpdateTime, std::vector{timeline_run(quick)}, 100.0).levels.empty());
}

TEST(StripPlot, LaysARunThatBeganLaterAtTheSameMomentOfTheFlight) {
  TimelineRun later = timeline_run(made_document(20), false, 2);
  later.offset_s = 1.5;
  const StripPlot plot =
      strip_plot(Strip::kAgreement, std::vector{later, timeline_run(made_document(50))}, 100.0);
  ASSERT_EQ(plot.curves.size(), 2U);
  EXPECT_DOUBLE_EQ(plot.curves[0].line.x.front(), 1.5);
  EXPECT_DOUBLE_EQ(plot.curves[1].line.x.front(), 0.0);
  EXPECT_EQ(strip_value(Strip::kAgreement, later, 1.0), "–") << "before its first step";
  EXPECT_NE(strip_value(Strip::kAgreement, later, 1.5), "–");
}

TEST(StripValue, IsThatOfTheLastStepNotAfterTheMoment) {
  const auto run = made_document(10, [](RunStep& step) {
    set_error_m(step, 0.5 + step.step);
    step.estimate.moments.mean.yaw_rad = -0.1;
    step.effective_sample_size = 100.0 * step.step;
  });
  const TimelineRun shown = timeline_run(run);
  EXPECT_EQ(strip_value(Strip::kPositionError, shown, 0.3), "3.50");
  EXPECT_EQ(strip_value(Strip::kPositionError, shown, 0.39), "3.50");
  EXPECT_EQ(strip_value(Strip::kOrientationError, shown, 0.3), "5.7");
  EXPECT_EQ(strip_value(Strip::kSigma, shown, 0.3), "0.50 0.50");
  EXPECT_EQ(strip_value(Strip::kSampleSize, shown, 0.3), "300/1000");
  EXPECT_EQ(strip_value(Strip::kUpdateTime, shown, 0.3), "10.0");
  EXPECT_EQ(strip_value(Strip::kPositionError, shown, 0.95), "9.50")
      << "within a step after the end";
  EXPECT_EQ(strip_value(Strip::kPositionError, shown, 1.5), "–") << "after the end";
}

TEST(StripValue, OfNumbersThatAreNotKnownIsADash) {
  const auto run = made_document(5, [](RunStep& step) {
    step.agreement.reset();
    step.estimate.moments.covariance.setConstant(std::nan(""));
  });
  EXPECT_EQ(strip_value(Strip::kAgreement, timeline_run(run), 0.2), "–");
  EXPECT_EQ(strip_value(Strip::kSigma, timeline_run(run), 0.2), "–");
  EXPECT_EQ(strip_value(Strip::kNees, timeline_run(run), 0.2), "–");
}

TEST(StripPlot, OfNoStepsOrOneIsDrawnWithoutALine) {
  for (const int steps : {0, 1}) {
    const std::vector<TimelineRun> runs = {timeline_run(made_document(steps))};
    for (std::size_t i = 0; i < kStripCount; ++i) {
      const StripPlot plot = strip_plot(static_cast<Strip>(i), runs, 1000.0);
      EXPECT_LT(plot.low, plot.high);
      for (const StripCurve& curve : plot.curves)
        EXPECT_LE(curve.line.x.size(), static_cast<std::size_t>(steps));
    }
  }
}

TEST(Above, CutsALineWhereItCrossesTheLimit) {
  const PointLine up_and_down = {{0.0, 1.0, 2.0, 3.0}, {0.0, 4.0, 4.0, 0.0}};
  const PointLine part = above(up_and_down, 2.0);
  EXPECT_THAT(part.x, ElementsAre(0.5, 1.0, 2.0, 2.5));
  EXPECT_THAT(part.y, ElementsAre(2.0, 4.0, 4.0, 2.0));
}

TEST(Above, KeepsPiecesApart) {
  const double nan = std::nan("");
  const PointLine line = {{0.0, 1.0, 1.0, 2.0, 3.0, 4.0}, {5.0, 5.0, nan, 5.0, 0.0, 0.0}};
  const PointLine part = above(line, 2.5);
  EXPECT_EQ(pieces_of(part), 2U);
  EXPECT_THAT(part.x, ElementsAre(0.0, 1.0, 2.0, 2.0, 2.5));
  EXPECT_TRUE(above({{0.0, 1.0}, {1.0, 2.0}}, 3.0).x.empty());
  EXPECT_TRUE(above({}, 3.0).x.empty());
}

TEST(RoundUp, GivesRoundNumbersThatAreNotBelow) {
  for (const auto& [value, round] : std::vector<std::pair<double, double>>{{0.0, 1.0},
                                                                           {-3.0, 1.0},
                                                                           {1.0, 1.0},
                                                                           {1.01, 2.0},
                                                                           {2.2, 2.5},
                                                                           {2.6, 5.0},
                                                                           {7.0, 10.0},
                                                                           {0.03, 0.05},
                                                                           {430.0, 500.0}}) {
    EXPECT_NEAR(round_up(value), round, 1e-12 * round) << value;
  }
  EXPECT_DOUBLE_EQ(round_up(std::nan("")), 1.0);
}

TEST(StripPlot, HeightsGoFromTheLowerEdgeToTheUpper) {
  StripPlot plot;
  plot.high = 4.0;
  EXPECT_DOUBLE_EQ(plot.height_of(1.0), 0.25);
  plot.low = 0.1;
  plot.high = 1000.0;
  plot.is_logarithmic = true;
  EXPECT_DOUBLE_EQ(plot.height_of(0.1), 0.0);
  EXPECT_NEAR(plot.height_of(10.0), 0.5, 1e-12);
  EXPECT_LT(plot.height_of(0.0), 0.0);
  EXPECT_TRUE(std::isfinite(plot.height_of(1e300)));
  EXPECT_TRUE(std::isnan(plot.height_of(std::nan(""))));
}

}  // namespace strip_lines_test
}  // namespace nadir
