// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/chart_values.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/widgets/views/drawn_chart.h"
#include "tests/widgets/views/sample_charts.h"

namespace nadir {
namespace chart_values_test {

using testing::IsEmpty;
using testing::SizeIs;

constexpr PageRect kRoom{0.0, 0.0, 640.0, 400.0};

ChartSpec logarithmic_bars(std::size_t groups) {
  ChartSpec spec;
  spec.bars = BarsSpec{{}, {{"a", {}, {230, 160, 0}}, {"b", {}, {0, 114, 178}}}, true, true};
  for (std::size_t i = 0; i < groups; ++i) {
    spec.bars->groups.push_back("g" + std::to_string(i));
    spec.bars->series[0].heights.push_back(7.4 * static_cast<double>(i + 1));
    spec.bars->series[1].heights.push_back(0.012 * static_cast<double>(i + 1));
  }
  return spec;
}

std::vector<BarValue> values_of(const ChartSpec& spec) {
  const ChartType type(theme(ThemeName::kLight), 1.5, true);
  TextStyle style = type.x_label;
  style.size_px = 10.0;
  return bar_values(*spec.bars, lay_out(spec, type, kRoom), style);
}

TEST(BarValues, StandOverTheBarsThatAreDrawn) {
  const ChartSpec spec = logarithmic_bars(3);
  const std::vector<BarValue> values = values_of(spec);
  ASSERT_THAT(values, SizeIs(6));
  EXPECT_EQ(values[0].text, "7.40");
  EXPECT_EQ(values[1].text, "0.012");
  RecordingCanvas canvas;
  XyChart(spec, theme(ThemeName::kLight), 1.5).draw(canvas, kRoom, 640, 400);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto drawn = canvas.fills_in(spec.bars->series[i % 2].colour);
    ASSERT_THAT(drawn, SizeIs(3));
    Eigen::AlignedBox2d bar;
    for (const Eigen::Vector2d& point : drawn[i / 2].outline) bar.extend(point);
    EXPECT_NEAR(values[i].bar.left, bar.min().x(), 1.0);
    EXPECT_NEAR(values[i].bar.right(), bar.max().x(), 1.0);
    EXPECT_NEAR(values[i].bar.top(), bar.max().y(), 1.0);
    EXPECT_GT(values[i].baseline.y(), bar.max().y());
  }
}

TEST(BarValues, LeaveOutWhatHasNoBar) {
  ChartSpec spec = logarithmic_bars(2);
  spec.bars->series[0].heights = {std::numeric_limits<double>::quiet_NaN(), 0.0};
  spec.bars->series[1].heights = {3.0};
  EXPECT_THAT(values_of(spec), SizeIs(1));
}

/// The dashes of a chart, from the left.
std::vector<double> dashes_of(const ChartSpec& spec) {
  RecordingCanvas canvas;
  XyChart(spec, theme(ThemeName::kLight), 1.5).draw(canvas, kRoom, 640, 400);
  std::vector<double> at;
  for (const auto& text : canvas.texts) {
    if (text.line == kNoBar) at.push_back(text.point.x());
  }
  return at;
}

TEST(BarValues, AreADashWhereNoneIsKnownAndNotWhereItIsZero) {
  ChartSpec spec = logarithmic_bars(3);
  spec.bars->is_logarithmic = spec.bars->shows_values = false;
  EXPECT_THAT(dashes_of(spec), IsEmpty());
  spec.bars->series[0].heights = {0.0, std::numeric_limits<double>::quiet_NaN(), 5.0};
  spec.bars->series[1].heights = {1.0, 2.0};  // and none for the third
  const std::vector<double> dashes = dashes_of(spec);
  ASSERT_THAT(dashes, SizeIs(2));
  const XyChart chart(spec, theme(ThemeName::kLight), 1.5);
  RecordingCanvas canvas;
  chart.draw(canvas, kRoom, 640, 400);
  // In the middle of the left and of the right half of a group that is 0.7 wide.
  EXPECT_NEAR(dashes[0], chart.page_from_data({1.0 - 0.175, 0.0}, kRoom).x(), 0.5);
  EXPECT_NEAR(dashes[1], chart.page_from_data({2.0 + 0.175, 0.0}, kRoom).x(), 0.5);
}

TEST(BarValues, HaveNoDashesInBarsThatAreNarrowerThanOne) {
  ChartSpec spec = logarithmic_bars(200);
  for (double& height : spec.bars->series[0].heights) {
    height = std::numeric_limits<double>::quiet_NaN();
  }
  EXPECT_THAT(dashes_of(spec), IsEmpty());
}

TEST(BarValues, AreNoneWhereTheyWouldTouchEachOther) {
  EXPECT_THAT(values_of(logarithmic_bars(60)), IsEmpty());
}

TEST(XyChart, WritesValuesOnlyWhereTheyAreAskedFor) {
  ChartSpec spec = logarithmic_bars(2);
  spec.bars->shows_values = false;
  RecordingCanvas canvas;
  XyChart(spec, theme(ThemeName::kLight), 1.5).draw(canvas, kRoom, 640, 400);
  for (const auto& text : canvas.texts) EXPECT_NE(text.line, "7.40");
}

}  // namespace chart_values_test
}  // namespace nadir
