// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/widgets/views/sample_charts.h"

namespace nadir {
namespace chart_bars_test {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(XyChart, PutsBarsBesideEachOtherOnTheAxis) {
  const XyChart chart(sample_bars(), light_theme(), kPxPerPt);
  const RecordingCanvas canvas = drawn(chart);
  const auto left = canvas.fills_in(kOrange);
  const auto right = canvas.fills_in(kLineBlue);
  ASSERT_THAT(left, SizeIs(3));
  ASSERT_THAT(right, SizeIs(3));
  const std::vector<double> heights = {4.0, 9.0, 14.0};
  for (std::size_t group = 0; group < 3; ++group) {
    const auto x = static_cast<double>(group);
    const Eigen::AlignedBox2d odometry = box_of(left[group].outline);
    const Eigen::AlignedBox2d estimate = box_of(right[group].outline);
    EXPECT_NEAR((odometry.min() - chart.page_from_data({x - 0.35, 0.0}, kChartRoom)).norm(), 0.0,
                0.01);
    EXPECT_NEAR((odometry.max() - chart.page_from_data({x, heights[group]}, kChartRoom)).norm(),
                0.0, 0.01);
    EXPECT_NEAR(estimate.min().x(), odometry.max().x(), 0.01);
    EXPECT_NEAR(estimate.max().x(), chart.page_from_data({x + 0.35, 0.0}, kChartRoom).x(), 0.01);
  }
}

TEST(XyChart, MakesTheBarsOfASingleGroupAsWideAsOthers) {
  ChartSpec spec = sample_bars();
  spec.bars->groups = {"only"};
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const Eigen::AlignedBox2d bar = box_of(drawn(chart).fills_in(kOrange).at(0).outline);
  EXPECT_NEAR(bar.sizes().x(), 0.35 * chart.plot_area(kChartRoom).width, 0.1);
}

TEST(XyChart, LeavesOutBarsWithoutHeight) {
  ChartSpec spec = sample_bars();
  spec.bars->series[0].heights = {kNan, 9.0};  // and none for the third
  const XyChart chart(spec, light_theme(), kPxPerPt);
  for (const auto& bar : drawn(chart).fills_in(kOrange)) {
    const Eigen::Vector2d size = box_of(bar.outline).sizes();
    EXPECT_TRUE(size.y() == 0.0 ||
                std::abs(size.y() - chart.page_from_data({0.0, 9.0}, kChartRoom).y() +
                         chart.page_from_data({0.0, 0.0}, kChartRoom).y()) < 0.01);
  }
}

TEST(XyChart, StandsLogarithmicBarsOnTheLowEnd) {
  ChartSpec spec = sample_bars();
  spec.bars->is_logarithmic = true;
  spec.bars->series[1].heights = {0.003, 0.05, 2.0};
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const auto bars = drawn(chart).fills_in(kLineBlue);
  ASSERT_THAT(bars, SizeIs(3));
  const PageRect plot = chart.plot_area(kChartRoom);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::AlignedBox2d bar = box_of(bars[i].outline);
    EXPECT_NEAR(bar.min().y(), plot.bottom, 0.01);
    EXPECT_NEAR(bar.max().y(),
                chart.page_from_data({0.0, spec.bars->series[1].heights[i]}, kChartRoom).y(), 0.01);
    EXPECT_GT(bar.sizes().y(), 5.0);
  }
  // From 0.003 to 0.03 is as far as from 0.3 to 3.
  const auto height = [&chart](double y) { return chart.page_from_data({0.0, y}, kChartRoom).y(); };
  EXPECT_NEAR(height(0.03) - height(0.003), height(3.0) - height(0.3), 1e-9);
}

TEST(XyChart, DrawsLevelsOverTheWholeWidth) {
  ChartSpec spec = sample_chart();
  spec.levels = {{"bound", 0.75, kOrange}, {"far away", 900.0, {9, 9, 9}}};
  spec.y.high = 2.0;
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const RecordingCanvas canvas = drawn(chart);
  const auto levels = canvas.strokes_in(kOrange);
  ASSERT_THAT(levels, SizeIs(1));
  const PageRect plot = chart.plot_area(kChartRoom);
  EXPECT_NEAR(levels[0].points.front().x(), plot.left, 0.01);
  EXPECT_NEAR(levels[0].points.back().x(), plot.right(), 0.01);
  EXPECT_NEAR(levels[0].points.front().y(), chart.page_from_data({0.0, 0.75}, kChartRoom).y(),
              0.01);
  EXPECT_FALSE(levels[0].style.dashes_px.empty());
  EXPECT_THAT(canvas.strokes_in({9, 9, 9}), IsEmpty());
}

}  // namespace chart_bars_test
}  // namespace nadir
