// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/widgets/views/sample_charts.h"

namespace nadir {
namespace chart_unusual_test {

using testing::HasSubstr;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(VtkWords, AreHeard) {
  const VtkWords words;
  vtkGenericWarningMacro("a warning");
  EXPECT_THAT(words.said(), HasSubstr("a warning"));
}

TEST(XyChart, DrawsUnusualDataWithoutAWordOfVtk) {
  const VtkWords words;
  const std::vector<std::vector<double>> values = {{},
                                                   {1.0},
                                                   {kNan},
                                                   {kNan, kNan, kNan},
                                                   {3, 3, 3},
                                                   {0, 0, 0},
                                                   {1, kInfinity, -kInfinity, 2},
                                                   {1e300, 1.0, 2.0},
                                                   {1e99, -1e99},
                                                   {1e-300, 2e-300},
                                                   {1e-99, 2e-99},
                                                   {1e20, 1e20 + 1e15},
                                                   {-5.0, kNan, -5.0}};
  for (const auto& y : values) {
    ChartSpec spec;
    spec.lines.push_back({.y = y, .colour = kLineBlue, .is_stepped = y.size() == 3});
    for (std::size_t i = 0; i < y.size(); ++i) spec.lines[0].x.push_back(static_cast<double>(i));
    spec.bands.push_back({.x = spec.lines[0].x, .low = y, .high = y, .colour = kPaleBlue});
    spec.levels.push_back({.y = y.empty() ? kNan : y[0]});
    spec.marked_x = 0.5;
    XyChart chart(spec, light_theme(), kPxPerPt);
    const RecordingCanvas canvas = drawn(chart);
    for (const auto& stroke : canvas.strokes) {
      for (const Eigen::Vector2d& point : stroke.points) EXPECT_TRUE(point.allFinite());
    }
    for (const auto& fill : canvas.fills) {
      for (const Eigen::Vector2d& point : fill.outline) EXPECT_TRUE(point.allFinite());
    }
    spec.bars = BarsSpec{{"a", "b", "c", "d"}, {{"bars", y, kOrange}}, y.size() == 2};
    drawn(spec);
  }
  drawn(ChartSpec{});
  ChartSpec bare;
  bare.bars = BarsSpec{};
  drawn(bare);
  EXPECT_EQ(words.said(), "");
}

TEST(XyChart, DrawsItsAxesWithoutAnyData) {
  const RecordingCanvas canvas = drawn(ChartSpec{});
  EXPECT_GE(canvas.strokes_in(light_theme().muted).size(), 2U);
  EXPECT_GE(canvas.texts.size(), 4U);
}

// VTK shifts and scales data far from 0 or of unusual size, and only from its second paint on.
TEST(XyChart, IsRightInTheFirstDrawAlsoFarFromZero) {
  struct Numbers {
    double from, step, level, height;
  };
  for (const Numbers& numbers :
       {Numbers{1.7e9, 0.1, 0.0, 1.0}, Numbers{0.0, 1.0, 5e6, 0.01},
        Numbers{0.0, 1e-13, 0.0, 1e-15}, Numbers{-1e15, 1e13, 3e20, 1e19}}) {
    ChartSpec spec;
    spec.lines.push_back({.colour = kLineBlue});
    spec.bands.push_back({.colour = kPaleBlue});
    for (int i = 0; i < 50; ++i) {
      const double x = numbers.from + numbers.step * i;
      const double y = numbers.level + numbers.height * std::sin(i / 5.0);
      spec.lines[0].x.push_back(x);
      spec.lines[0].y.push_back(y);
      spec.bands[0].x.push_back(x);
      spec.bands[0].low.push_back(y - numbers.height);
      spec.bands[0].high.push_back(y + numbers.height);
    }
    const XyChart chart(spec, light_theme(), kPxPerPt);
    const RecordingCanvas canvas = drawn(chart);
    const auto lines = canvas.strokes_in(kLineBlue);
    ASSERT_THAT(lines, SizeIs(1));
    ASSERT_THAT(lines[0].points, SizeIs(50));
    for (std::size_t i = 0; i < 50; ++i) {
      const Eigen::Vector2d expected =
          chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kChartRoom);
      EXPECT_NEAR((lines[0].points[i] - expected).norm(), 0.0, 0.1) << numbers.step << " " << i;
    }
    const auto bands = canvas.fills_in(kPaleBlue);
    ASSERT_THAT(bands, SizeIs(1));
    EXPECT_NEAR(bands[0].outline[20].y(),
                chart.page_from_data({0.0, spec.bands[0].low[20]}, kChartRoom).y(), 0.1);
  }
}

TEST(XyChart, DrawsNoMorePointsThanPixelsCanShow) {
  ChartSpec spec;
  spec.lines.push_back(line_through(500'000, 1e-3, [](double x) { return std::sin(977.0 * x); }));
  spec.lines[0].y[123'456] = 5.0;
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LE(lines[0].points.size(), 2.0 * chart.plot_area(kChartRoom).width + 2.0);
  EXPECT_NEAR(box_of(lines[0].points).max().y(), chart.page_from_data({0.0, 5.0}, kChartRoom).y(),
              0.01);
}

}  // namespace chart_unusual_test
}  // namespace nadir
