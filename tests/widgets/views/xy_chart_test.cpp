// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/xy_chart.h"

#include <gmock/gmock.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkPlot.h>
#include <vtkStringArray.h>

#include <cmath>
#include <limits>

#include "tests/widgets/views/drawn_chart.h"
#include "widgets/canvas/cairo_canvas.h"
#include "widgets/canvas/png_file.h"
#include "widgets/canvas/svg_canvas.h"

namespace nadir {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPxPerPt = 96.0 / 72.0;
constexpr int kWidth = 500;
constexpr int kHeight = 300;
constexpr PageRect kWhere{10.0, 10.0, 480.0, 280.0};

const Theme& light() { return theme(ThemeName::kLight); }

ChartSpec error_spec() {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y.title = "east error [m]";
  spec.lines.push_back(line_through(101, 1.0, [](double x) { return std::sin(x / 8.0); }));
  spec.bands.push_back({.name = "band", .colour = kPaleBlue});
  for (const double x : spec.lines[0].x) {
    spec.bands[0].x.push_back(x);
    spec.bands[0].low.push_back(std::sin(x / 8.0) - 0.5);
    spec.bands[0].high.push_back(std::sin(x / 8.0) + 0.5);
  }
  return spec;
}

ChartSpec bars_spec() {
  ChartSpec spec;
  spec.y.title = "MSE [m²]";
  spec.bars =
      BarsSpec{{"easy", "medium", "hard"},
               {{"odometry", {4.0, 9.0, 14.0}, kOrange}, {"estimate", {0.5, 1.0, 2.0}, kLineBlue}},
               false};
  return spec;
}

RecordingCanvas drawn(const XyChart& chart, const PageRect& where = kWhere) {
  RecordingCanvas canvas;
  chart.draw(canvas, where, kWidth, kHeight);
  return canvas;
}

RecordingCanvas drawn(const ChartSpec& spec, const PageRect& where = kWhere) {
  return drawn(XyChart(spec, light(), kPxPerPt), where);
}

Raster<Rgba> pixels_of(const ChartSpec& spec, const Theme& colours = light()) {
  const auto canvas = CairoCanvas::for_pixels(kWidth, kHeight, colours.page);
  XyChart(spec, colours, kPxPerPt).draw(*canvas, kWhere, kWidth, kHeight);
  return canvas->pixels();
}

/// The lowest and the highest corner of an outline.
Eigen::AlignedBox2d box_of(const std::vector<Eigen::Vector2d>& outline) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : outline) box.extend(point);
  return box;
}

TEST(XyChart, HasAxesThatFitTheData) {
  XyChart chart(error_spec(), light(), kPxPerPt);
  vtkAxis& x = *chart.chart().GetAxis(vtkAxis::BOTTOM);
  vtkAxis& y = *chart.chart().GetAxis(vtkAxis::LEFT);
  EXPECT_EQ(x.GetMinimum(), 0.0);
  EXPECT_EQ(x.GetMaximum(), 100.0);
  EXPECT_NEAR(y.GetMinimum(), -1.65, 0.02);
  EXPECT_NEAR(y.GetMaximum(), 1.65, 0.02);
  EXPECT_EQ(x.GetTitle(), "time [s]");
  EXPECT_EQ(y.GetTitle(), "east error [m]");
}

TEST(XyChart, KeepsItsAxesAndTicksWhenDrawn) {
  XyChart chart(error_spec(), light(), kPxPerPt);
  drawn(chart);
  vtkAxis& x = *chart.chart().GetAxis(vtkAxis::BOTTOM);
  EXPECT_EQ(x.GetMaximum(), 100.0);
  ASSERT_EQ(x.GetTickLabels()->GetNumberOfValues(), 6);
  EXPECT_EQ(x.GetTickLabels()->GetValue(0), "0");
  EXPECT_EQ(x.GetTickLabels()->GetValue(1), "20");
  EXPECT_EQ(x.GetTickLabels()->GetValue(5), "100");
}

TEST(XyChart, HasAPlotForEachThingAndTheMomentLine) {
  ChartSpec spec = error_spec();
  spec.lines.push_back({.name = "empty"});
  spec.levels.push_back({.y = 0.5});
  XyChart chart(spec, light(), kPxPerPt);
  ASSERT_EQ(chart.chart().GetNumberOfPlots(), 5);
  EXPECT_EQ(chart.chart().GetPlot(0)->GetLabel(), "band");
  EXPECT_EQ(chart.chart().GetPlot(2)->GetLabel(), "line");
  EXPECT_FALSE(chart.chart().GetPlot(3)->GetVisible());
  EXPECT_FALSE(chart.chart().GetPlot(4)->GetVisible());
  drawn(chart);
  EXPECT_EQ(chart.chart().GetNumberOfPlots(), 5);
}

TEST(XyChart, DrawsTheLineThroughItsData) {
  const ChartSpec spec = error_spec();
  const XyChart chart(spec, light(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  ASSERT_THAT(lines[0].points, SizeIs(101));
  for (std::size_t i = 0; i < 101; ++i) {
    const Eigen::Vector2d expected =
        chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kWhere);
    EXPECT_NEAR((lines[0].points[i] - expected).norm(), 0.0, 0.01) << i;
  }
  EXPECT_NEAR(lines[0].style.width_px, 1.5 * kPxPerPt, 1e-6);
}

TEST(XyChart, MapsTheEndsOfTheAxesToTheCornersOfThePlotArea) {
  ChartSpec spec = error_spec();
  spec.y = {.low = -2.0, .high = 2.0};
  const XyChart chart(spec, light(), kPxPerPt);
  const PageRect plot = chart.plot_area(kWhere);
  EXPECT_EQ(chart.page_from_data({0.0, -2.0}, kWhere), Eigen::Vector2d(plot.left, plot.bottom));
  EXPECT_EQ(chart.page_from_data({100.0, 2.0}, kWhere), Eigen::Vector2d(plot.right(), plot.top()));
  EXPECT_EQ(chart.page_from_data({50.0, 0.0}, kWhere), plot.centre());
}

TEST(XyChart, ColoursThePixelsThatTheDataSay) {
  ChartSpec spec = error_spec();
  spec.lines[0].width_pt = 3.0;
  const Raster<Rgba> pixels = pixels_of(spec);
  const XyChart chart(spec, light(), kPxPerPt);
  for (std::size_t i = 1; i < 100; ++i) {
    const Eigen::Vector2d at =
        chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kWhere);
    EXPECT_EQ(pixels.at(static_cast<int>(at.x()), kHeight - 1 - static_cast<int>(at.y())),
              kLineBlue)
        << i;
  }
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
    const XyChart chart(spec, light(), kPxPerPt);
    const RecordingCanvas canvas = drawn(chart);
    const auto lines = canvas.strokes_in(kLineBlue);
    ASSERT_THAT(lines, SizeIs(1));
    ASSERT_THAT(lines[0].points, SizeIs(50));
    for (std::size_t i = 0; i < 50; ++i) {
      const Eigen::Vector2d expected =
          chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kWhere);
      EXPECT_NEAR((lines[0].points[i] - expected).norm(), 0.0, 0.1) << numbers.step << " " << i;
    }
    const auto bands = canvas.fills_in(kPaleBlue);
    ASSERT_THAT(bands, SizeIs(1));
    EXPECT_NEAR(bands[0].outline[20].y(),
                chart.page_from_data({0.0, spec.bands[0].low[20]}, kWhere).y(), 0.1);
  }
}

TEST(XyChart, DrawsTheSameEachTimeAlsoAfterAnotherPlace) {
  const XyChart chart(error_spec(), light(), kPxPerPt);
  const RecordingCanvas first = drawn(chart);
  const RecordingCanvas elsewhere = drawn(chart, {50.0, 60.0, 300.0, 150.0});
  const RecordingCanvas again = drawn(chart);
  ASSERT_EQ(first.strokes.size(), again.strokes.size());
  for (std::size_t i = 0; i < first.strokes.size(); ++i) {
    EXPECT_EQ(first.strokes[i].points, again.strokes[i].points);
  }
  const Eigen::AlignedBox2d line = box_of(elsewhere.strokes_in(kLineBlue)[0].points);
  EXPECT_GT(line.min().x(), 50.0);
  EXPECT_LT(line.max().x(), 350.0);
}

TEST(XyChart, BreaksALineWhereItsDataDo) {
  ChartSpec spec = error_spec();
  for (std::size_t i = 40; i < 60; ++i) spec.lines[0].y[i] = kNan;
  const auto lines = drawn(spec).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines[0].points, SizeIs(40));
  EXPECT_THAT(lines[1].points, SizeIs(41));
}

TEST(XyChart, DrawsASinglePoint) {
  ChartSpec spec;
  spec.lines.push_back({.x = {3.0}, .y = {2.0}, .colour = kLineBlue});
  const XyChart chart(spec, light(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_NEAR((box_of(lines[0].points).center() - chart.page_from_data({3.0, 2.0}, kWhere)).norm(),
              0.0, 0.01);
}

TEST(XyChart, FillsABandBetweenItsLines) {
  const ChartSpec spec = error_spec();
  const XyChart chart(spec, light(), kPxPerPt);
  const auto bands = drawn(chart).fills_in(kPaleBlue);
  ASSERT_THAT(bands, SizeIs(1));
  ASSERT_THAT(bands[0].outline, SizeIs(202));
  for (std::size_t i = 0; i < 101; ++i) {
    const double x = spec.bands[0].x[i];
    const Eigen::Vector2d low = chart.page_from_data({x, spec.bands[0].low[i]}, kWhere);
    const Eigen::Vector2d high = chart.page_from_data({x, spec.bands[0].high[i]}, kWhere);
    EXPECT_NEAR((bands[0].outline[i] - low).norm(), 0.0, 0.01);
    EXPECT_NEAR((bands[0].outline[201 - i] - high).norm(), 0.0, 0.01);
  }
}

TEST(XyChart, BreaksABandWhereItsDataDo) {
  ChartSpec spec = error_spec();
  spec.bands[0].high[50] = kNan;
  EXPECT_THAT(drawn(spec).fills_in(kPaleBlue), SizeIs(2));
}

TEST(XyChart, DrawsBandsBelowLines) {
  const Raster<Rgba> pixels = pixels_of(error_spec());
  const XyChart chart(error_spec(), light(), kPxPerPt);
  const Eigen::Vector2d on_line = chart.page_from_data({4.0 * std::numbers::pi, 1.0}, kWhere);
  const Rgba found =
      pixels.at(static_cast<int>(on_line.x()), kHeight - 1 - static_cast<int>(on_line.y()));
  EXPECT_LT(found.red, 60);
}

TEST(XyChart, ClipsWhatLeavesThePlotArea) {
  ChartSpec spec = error_spec();
  spec.y = {.low = -0.4, .high = 0.4};
  const PageRect plot = XyChart(spec, light(), kPxPerPt).plot_area(kWhere);
  const Raster<Rgba> pixels = pixels_of(spec);
  int blue = 0;
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const Rgba pixel = pixels.at(column, row);
      if (pixel.blue < pixel.red + 30) continue;
      ++blue;
      const double y = kHeight - 1 - row;
      EXPECT_TRUE(column >= plot.left - 1.0 && column <= plot.right() + 1.0 &&
                  y >= plot.bottom - 1.0 && y <= plot.top() + 1.0)
          << column << ", " << row;
    }
  }
  EXPECT_GT(blue, 1000);
}

TEST(XyChart, PutsBarsBesideEachOtherOnTheAxis) {
  const XyChart chart(bars_spec(), light(), kPxPerPt);
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
    EXPECT_NEAR((odometry.min() - chart.page_from_data({x - 0.35, 0.0}, kWhere)).norm(), 0.0, 0.01);
    EXPECT_NEAR((odometry.max() - chart.page_from_data({x, heights[group]}, kWhere)).norm(), 0.0,
                0.01);
    EXPECT_NEAR(estimate.min().x(), odometry.max().x(), 0.01);
    EXPECT_NEAR(estimate.max().x(), chart.page_from_data({x + 0.35, 0.0}, kWhere).x(), 0.01);
  }
}

TEST(XyChart, MakesTheBarsOfASingleGroupAsWideAsOthers) {
  ChartSpec spec = bars_spec();
  spec.bars->groups = {"only"};
  const XyChart chart(spec, light(), kPxPerPt);
  const Eigen::AlignedBox2d bar = box_of(drawn(chart).fills_in(kOrange).at(0).outline);
  EXPECT_NEAR(bar.sizes().x(), 0.35 * chart.plot_area(kWhere).width, 0.1);
}

TEST(XyChart, LeavesOutBarsWithoutHeight) {
  ChartSpec spec = bars_spec();
  spec.bars->series[0].heights = {kNan, 9.0};  // and none for the third
  const XyChart chart(spec, light(), kPxPerPt);
  for (const auto& bar : drawn(chart).fills_in(kOrange)) {
    const Eigen::Vector2d size = box_of(bar.outline).sizes();
    EXPECT_TRUE(size.y() == 0.0 ||
                std::abs(size.y() - chart.page_from_data({0.0, 9.0}, kWhere).y() +
                         chart.page_from_data({0.0, 0.0}, kWhere).y()) < 0.01);
  }
}

TEST(XyChart, StandsLogarithmicBarsOnTheLowEnd) {
  ChartSpec spec = bars_spec();
  spec.bars->is_logarithmic = true;
  spec.bars->series[1].heights = {0.003, 0.05, 2.0};
  const XyChart chart(spec, light(), kPxPerPt);
  const auto bars = drawn(chart).fills_in(kLineBlue);
  ASSERT_THAT(bars, SizeIs(3));
  const PageRect plot = chart.plot_area(kWhere);
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::AlignedBox2d bar = box_of(bars[i].outline);
    EXPECT_NEAR(bar.min().y(), plot.bottom, 0.01);
    EXPECT_NEAR(bar.max().y(),
                chart.page_from_data({0.0, spec.bars->series[1].heights[i]}, kWhere).y(), 0.01);
    EXPECT_GT(bar.sizes().y(), 5.0);
  }
  // From 0.003 to 0.03 is as far as from 0.3 to 3.
  const auto height = [&chart](double y) { return chart.page_from_data({0.0, y}, kWhere).y(); };
  EXPECT_NEAR(height(0.03) - height(0.003), height(3.0) - height(0.3), 1e-9);
}

TEST(XyChart, DrawsLevelsOverTheWholeWidth) {
  ChartSpec spec = error_spec();
  spec.levels = {{"bound", 0.75, kOrange}, {"far away", 900.0, {9, 9, 9}}};
  spec.y.high = 2.0;
  const XyChart chart(spec, light(), kPxPerPt);
  const RecordingCanvas canvas = drawn(chart);
  const auto levels = canvas.strokes_in(kOrange);
  ASSERT_THAT(levels, SizeIs(1));
  const PageRect plot = chart.plot_area(kWhere);
  EXPECT_NEAR(levels[0].points.front().x(), plot.left, 0.01);
  EXPECT_NEAR(levels[0].points.back().x(), plot.right(), 0.01);
  EXPECT_NEAR(levels[0].points.front().y(), chart.page_from_data({0.0, 0.75}, kWhere).y(), 0.01);
  EXPECT_FALSE(levels[0].style.dashes_px.empty());
  EXPECT_THAT(canvas.strokes_in({9, 9, 9}), IsEmpty());
}

TEST(XyChart, MovesTheMomentLine) {
  ChartSpec spec = error_spec();
  spec.marked_x = 30.0;
  XyChart chart(spec, light(), kPxPerPt);
  const auto moment = [&chart] { return drawn(chart).strokes_in(light().text); };
  const PageRect plot = chart.plot_area(kWhere);
  ASSERT_THAT(moment(), SizeIs(1));
  EXPECT_NEAR(moment()[0].points[0].x(), chart.page_from_data({30.0, 0.0}, kWhere).x(), 0.01);
  EXPECT_NEAR(box_of(moment()[0].points).sizes().y(), plot.height, 0.01);
  chart.mark_x(70.5);
  ASSERT_THAT(moment(), SizeIs(1));
  EXPECT_NEAR(moment()[0].points[0].x(), chart.page_from_data({70.5, 0.0}, kWhere).x(), 0.01);
  for (const std::optional<double> nowhere : {std::optional<double>{}, {-1.0}, {100.1}, {kNan}}) {
    chart.mark_x(nowhere);
    EXPECT_THAT(moment(), IsEmpty());
  }
}

TEST(XyChart, DrawsTwoAxisLinesAndAHorizontalGridOnly) {
  const XyChart chart(error_spec(), light(), kPxPerPt);
  const RecordingCanvas canvas = drawn(chart);
  const PageRect plot = chart.plot_area(kWhere);
  int long_lines = 0;
  for (const auto& line : canvas.strokes_in(light().muted)) {
    const Eigen::AlignedBox2d box = box_of(line.points);
    EXPECT_TRUE(box.min().x() == plot.left || box.max().y() == plot.bottom);
    if (box.sizes().norm() > 20.0) ++long_lines;
  }
  EXPECT_EQ(long_lines, 2);
  const auto grid = canvas.strokes_in(light().line);
  EXPECT_GE(grid.size(), 4U);
  for (const auto& line : grid) {
    EXPECT_EQ(line.points[0].y(), line.points[1].y());
    EXPECT_EQ(std::abs(line.points[0].x() - line.points[1].x()), plot.width);
    // One pixel wide and in the middle of a row of pixels: sharp.
    EXPECT_EQ(line.style.width_px, 1.0);
    EXPECT_EQ(line.points[0].y() - std::floor(line.points[0].y()), 0.5);
  }
}

TEST(XyChart, WritesNumbersAndTitlesInTheirFaces) {
  int titles = 0;
  for (const auto& text : drawn(error_spec()).texts) {
    const bool is_title = text.line.find('[') != std::string::npos;
    EXPECT_EQ(text.style.face, is_title ? FontFace::kText : FontFace::kNumbers) << text.line;
    EXPECT_EQ(text.style.size_px, is_title ? 12.0 : 11.0) << text.line;
    EXPECT_FALSE(text.style.is_bold);
    titles += is_title ? 1 : 0;
  }
  EXPECT_EQ(titles, 2);
}

TEST(XyChart, KeepsItsTextsInItsRoomAndApart) {
  ChartSpec wide = error_spec();
  for (double& y : wide.lines[0].y) y *= 3e7;
  ChartSpec logarithmic = bars_spec();
  logarithmic.bars->is_logarithmic = true;
  logarithmic.bars->groups[1] = "a long name of a trial";
  for (const ChartSpec& spec : {error_spec(), wide, bars_spec(), logarithmic}) {
    for (const PageRect& where : {PageRect{5, 5, 250, 160}, PageRect{5, 5, 490, 90}, kWhere}) {
      const auto texts = drawn(spec, where).texts;
      EXPECT_GE(texts.size(), 5U);
      for (std::size_t i = 0; i < texts.size(); ++i) {
        const Eigen::AlignedBox2d box = texts[i].box();
        EXPECT_GE(box.min().x(), where.left - 0.5) << texts[i].line;
        EXPECT_GE(box.min().y(), where.bottom - 0.5) << texts[i].line;
        EXPECT_LE(box.max().x(), where.right() + 0.5) << texts[i].line;
        EXPECT_LE(box.max().y(), where.top() + 0.5) << texts[i].line;
        for (std::size_t j = 0; j < i; ++j) {
          EXPECT_TRUE(box.intersection(texts[j].box()).isEmpty())
              << texts[i].line << " over " << texts[j].line;
        }
      }
    }
  }
}

TEST(XyChart, AlignsStackedChartsByACommonMargin) {
  ChartSpec upper = error_spec();
  ChartSpec lower = error_spec();
  for (double& y : lower.lines[0].y) y *= 1000.0;
  const auto margin = [](const ChartSpec& spec) {
    return XyChart(spec, light(), kPxPerPt).needed_left_margin_px(kWhere);
  };
  EXPECT_LT(margin(upper), margin(lower));
  const double common = margin(lower);
  upper.left_margin_px = common;
  lower.left_margin_px = common;
  EXPECT_EQ(margin(upper), margin(error_spec()));  // what it would need itself
  const auto plot = [](const ChartSpec& spec) {
    return XyChart(spec, light(), kPxPerPt).plot_area(kWhere);
  };
  EXPECT_EQ(plot(upper).left, plot(lower).left);
  EXPECT_EQ(plot(upper).left, kWhere.left + common + 0.5);
  EXPECT_EQ(plot(upper).width, plot(lower).width);
}

TEST(XyChart, DrawsNoMorePointsThanPixelsCanShow) {
  ChartSpec spec;
  spec.lines.push_back(line_through(500'000, 1e-3, [](double x) { return std::sin(977.0 * x); }));
  spec.lines[0].y[123'456] = 5.0;
  const XyChart chart(spec, light(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_LE(lines[0].points.size(), 2.0 * chart.plot_area(kWhere).width + 2.0);
  EXPECT_NEAR(box_of(lines[0].points).max().y(), chart.page_from_data({0.0, 5.0}, kWhere).y(),
              0.01);
}

TEST(XyChart, GivesTheSameBytesTwice) {
  ChartSpec spec = error_spec();
  spec.marked_x = 12.0;
  const auto svg = [&spec] {
    SvgCanvas canvas(kWidth, kHeight, 96.0, "chart", "");
    XyChart(spec, light(), kPxPerPt).draw(canvas, kWhere, kWidth, kHeight);
    return canvas.finish();
  };
  const auto pdf = [&spec] {
    const auto canvas = CairoCanvas::for_pdf(kWidth, kHeight, 96.0, "chart", "");
    XyChart(spec, light(), kPxPerPt).draw(*canvas, kWhere, kWidth, kHeight);
    return canvas->finish_pdf();
  };
  EXPECT_EQ(encode_png(pixels_of(spec)), encode_png(pixels_of(spec)));
  EXPECT_EQ(svg(), svg());
  EXPECT_EQ(pdf(), pdf());
  EXPECT_THAT(svg(), HasSubstr("east error [m]"));
}

TEST(XyChart, HasTheColoursOfTheDarkTheme) {
  const Theme& dark = theme(ThemeName::kDark);
  RecordingCanvas canvas;
  XyChart(error_spec(), dark, kPxPerPt).draw(canvas, kWhere, kWidth, kHeight);
  for (const auto& text : canvas.texts) {
    EXPECT_TRUE(text.style.colour == dark.text || text.style.colour == dark.muted) << text.line;
  }
  EXPECT_THAT(canvas.strokes_in(dark.line), Each(testing::_));
  EXPECT_FALSE(canvas.strokes_in(dark.line).empty());
  EXPECT_THAT(canvas.fills, SizeIs(1));  // the band, no background
}

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
    XyChart chart(spec, light(), kPxPerPt);
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
  EXPECT_GE(canvas.strokes_in(light().muted).size(), 2U);
  EXPECT_GE(canvas.texts.size(), 4U);
}

TEST(XyChart, MayBeMoved) {
  XyChart chart(error_spec(), light(), kPxPerPt);
  const std::size_t before = drawn(chart).strokes.size();
  const XyChart moved = std::move(chart);
  EXPECT_EQ(drawn(moved).strokes.size(), before);
}

TEST(XyChart, RefusesAScaleOfNothing) {
  EXPECT_THROW(XyChart(error_spec(), light(), 0.0), std::logic_error);
}

TEST(ChartLegend, ListsWhatHasAName) {
  ChartSpec spec = error_spec();
  spec.lines.push_back({.name = "odometry", .colour = kOrange, .is_dashed = true});
  spec.lines.push_back({.colour = kOrange});
  spec.levels = {{"95 % bounds", 7.8, light().muted}, {"95 % bounds", 0.2, light().muted}};
  spec.bars = bars_spec().bars;
  EXPECT_THAT(legend_of(spec),
              ElementsAre(LegendEntry{"line", kLineBlue, LegendEntry::Kind::kLine},
                          LegendEntry{"odometry", kOrange, LegendEntry::Kind::kDashed},
                          LegendEntry{"band", kPaleBlue, LegendEntry::Kind::kBand},
                          LegendEntry{"odometry", kOrange, LegendEntry::Kind::kBar},
                          LegendEntry{"estimate", kLineBlue, LegendEntry::Kind::kBar},
                          LegendEntry{"95 % bounds", light().muted, LegendEntry::Kind::kDashed}));
}

}  // namespace
}  // namespace nadir
