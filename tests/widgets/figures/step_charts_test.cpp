// SPDX-License-Identifier: Apache-2.0
// Charts of the filter itself, step by step.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/widgets/figures/made_drive.h"
#include "widgets/figures/error_charts.h"

namespace nadir {
namespace step_charts_test {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsNan;
using ::testing::SizeIs;
using ::testing::UnorderedElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(TimingChart, ShowsTheMillisecondsOfEachUpdateAndTheTimeThereIs) {
  const FigureRun run = drive("a", 30, [](RunStep& step) { step.update_ms = 300.0 + step.step; });
  const ChartSpec chart = timing_chart(run, light());
  EXPECT_EQ(chart.x.title, "time [s]");
  EXPECT_EQ(chart.y.title, "update time [ms]");
  ASSERT_THAT(chart.lines, SizeIs(1));
  EXPECT_EQ(chart.lines[0].y[7], 307.0);
  EXPECT_NEAR(chart.lines[0].x[7], 3.5, 1e-9);
  ASSERT_THAT(chart.levels, SizeIs(1));
  EXPECT_NEAR(chart.levels[0].y, 500.0, 1e-6);
  EXPECT_THAT(names_of(chart), ElementsAre("update", "time between steps"));
}

TEST(TimingChart, LeavesOutABudgetThatWouldFlattenTheUpdates) {
  EXPECT_THAT(timing_chart(drive("fast"), light()).levels, IsEmpty());  // 8 ms of 500
  EXPECT_NEAR(step_period_ms(drive("fast")).value(), 500.0, 1e-6);
}

TEST(TimingChart, TakesASingleStepAndUnknownTimes) {
  const ChartSpec single = timing_chart(drive("single", 1), light());
  EXPECT_THAT(single.lines[0].y, ElementsAre(8.0));
  EXPECT_THAT(single.levels, IsEmpty());
  const ChartSpec unknown =
      timing_chart(drive("unknown", 9, [](RunStep& step) { step.update_ms = kNan; }), light());
  EXPECT_THAT(unknown.lines[0].y, Each(IsNan()));
  EXPECT_THAT(names_of(unknown), IsEmpty());
}

TEST(SampleSizeChart, ShowsBothCounts) {
  const ChartSpec chart = sample_size_chart(drive("a"), light());
  EXPECT_THAT(chart.lines[0].y, Each(60.0));
  EXPECT_THAT(chart.lines[1].y, Each(100.0));
  EXPECT_THAT(names_of(chart), ElementsAre("effective sample size", "particles"));
}

TEST(CalibrationChart, IsADistributionBesideTheDiagonal) {
  const ChartSpec chart = calibration_chart(drive("a"), light());
  ASSERT_THAT(chart.lines, SizeIs(2));
  EXPECT_TRUE(std::is_sorted(chart.lines[0].x.begin(), chart.lines[0].x.end()));
  EXPECT_TRUE(std::is_sorted(chart.lines[0].y.begin(), chart.lines[0].y.end()));
  EXPECT_EQ(chart.lines[0].y.back(), 1.0);
  EXPECT_THAT(names_of(chart), ElementsAre("expected of a consistent filter"));
}

TEST(CalibrationChart, LeavesOutStepsWithoutACovariance) {
  const auto forget = [](RunStep& step) {
    if (step.step < 20) step.estimate.moments.covariance.setConstant(kNan);
  };
  const ChartSpec some = calibration_chart(drive("some", 30, forget), light());
  EXPECT_THAT(some.lines[0].x, SizeIs(10 + 2));
  EXPECT_LT(*std::max_element(some.lines[0].x.begin(), some.lines[0].x.end() - 1), 1.0);
  const ChartSpec none = calibration_chart(
      drive("none", 30, [](RunStep& step) { step.estimate.moments.covariance.setConstant(kNan); }),
      light());
  EXPECT_THAT(none.lines[0].x, IsEmpty());
  EXPECT_THAT(none.lines[1].x, SizeIs(2));
}

TEST(ConsistencyCharts, DrawDifferentThingsInDifferentWays) {
  const FigureRun run = drive("a");
  const std::vector<CaptionedChart> charts = {{"a", nees_chart(run, light())},
                                              {"b", calibration_chart(run, light())},
                                              {"c", sample_size_chart(run, light())},
                                              {"d", agreement_chart({&run, 1}, light())}};
  const std::vector<LegendEntry> entries = legend_of_all(charts);
  EXPECT_THAT(entries, SizeIs(4));  // run, expected, bounds, particles
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(entries[i].name, entries[j].name);
      EXPECT_TRUE(entries[i].colour != entries[j].colour || entries[i].kind != entries[j].kind)
          << entries[i].name << " and " << entries[j].name;
    }
  }
}

TEST(NeesChart, HasTheBoundsAndTheMeanOfThreeDegreesOfFreedom) {
  const ChartSpec chart = nees_chart(drive("a"), light());
  std::vector<double> levels;
  for (const auto& level : chart.levels) levels.push_back(level.y);
  EXPECT_THAT(levels, UnorderedElementsAre(DoubleNear(0.216, 5e-4), DoubleNear(9.348, 5e-4), 3.0));
  // 0.2^2 / 0.3 + 0.2^2 / 0.1 + 0.01^2 / 0.002
  EXPECT_NEAR(chart.lines[0].y[0], 0.583333, 1e-6);
}

TEST(CalibrationChart, IsTheDiagonalForAFilterAsSureAsItMayBe) {
  constexpr int kSteps = 200;
  const FigureRun run = drive("gaussian", kSteps, [](RunStep& step) {
    // One error at the middle of each 200th of a Gaussian in the plane, stretched and turned by `root`.
    const double probability = (step.step + 0.5) / kSteps;
    const double radius = std::sqrt(-2.0 * std::log(1.0 - probability));
    const double angle = 2.4 * step.step;
    Eigen::Matrix2d root;
    root << 2.0, 0.0, 0.7, 0.5;
    const Eigen::Vector2d error = root * Eigen::Vector2d(std::cos(angle), std::sin(angle)) * radius;
    step.estimate.moments.mean.x_m = step.truth_in_enu->x_m + error.x();
    step.estimate.moments.mean.y_m = step.truth_in_enu->y_m + error.y();
    step.estimate.moments.mean.yaw_rad = 0.1;
    step.estimate.moments.covariance.setZero();
    step.estimate.moments.covariance.topLeftCorner<2, 2>() = root * root.transpose();
    step.estimate.moments.covariance(2, 2) = 0.002;
  });
  const LineSpec line = calibration_chart(run, light()).lines[0];
  ASSERT_THAT(line.x, SizeIs(kSteps + 2));
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    EXPECT_NEAR(line.x[i], line.y[i], 0.51 / kSteps) << i;
  }
}

TEST(TimingChart, TakesTheLowerOfTwoMiddlePeriods) {
  const FigureRun run = drive("uneven", 3, [](RunStep& step) {
    if (step.step == 2) step.time_s += 60.0;
  });
  EXPECT_NEAR(step_period_ms(run).value(), 500.0, 1e-6);
}

}  // namespace step_charts_test
}  // namespace nadir
