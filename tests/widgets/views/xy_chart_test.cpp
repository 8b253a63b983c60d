// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/xy_chart.h"

#include <gmock/gmock.h>
#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkPlot.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>

#include "tests/widgets/views/sample_charts.h"
#include "widgets/canvas/png_file.h"
#include "widgets/canvas/svg_canvas.h"

namespace nadir {
namespace xy_chart_test {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(XyChart, HasAxesThatFitTheData) {
  XyChart chart(sample_chart(), light_theme(), kPxPerPt);
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
  XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  drawn(chart);
  vtkAxis& x = *chart.chart().GetAxis(vtkAxis::BOTTOM);
  EXPECT_EQ(x.GetMaximum(), 100.0);
  ASSERT_EQ(x.GetTickLabels()->GetNumberOfValues(), 6);
  EXPECT_EQ(x.GetTickLabels()->GetValue(0), "0");
  EXPECT_EQ(x.GetTickLabels()->GetValue(1), "20");
  EXPECT_EQ(x.GetTickLabels()->GetValue(5), "100");
}

TEST(XyChart, HasAPlotForEachThingAndTheMomentLine) {
  ChartSpec spec = sample_chart();
  spec.lines.push_back({.name = "empty"});
  spec.levels.push_back({.y = 0.5});
  XyChart chart(spec, light_theme(), kPxPerPt);
  ASSERT_EQ(chart.chart().GetNumberOfPlots(), 5);
  EXPECT_EQ(chart.chart().GetPlot(0)->GetLabel(), "band");
  EXPECT_EQ(chart.chart().GetPlot(2)->GetLabel(), "line");
  EXPECT_FALSE(chart.chart().GetPlot(3)->GetVisible());
  EXPECT_FALSE(chart.chart().GetPlot(4)->GetVisible());
  drawn(chart);
  EXPECT_EQ(chart.chart().GetNumberOfPlots(), 5);
}

TEST(XyChart, DrawsTheLineThroughItsData) {
  const ChartSpec spec = sample_chart();
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  ASSERT_THAT(lines[0].points, SizeIs(101));
  for (std::size_t i = 0; i < 101; ++i) {
    const Eigen::Vector2d expected =
        chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kChartRoom);
    EXPECT_NEAR((lines[0].points[i] - expected).norm(), 0.0, 0.01) << i;
  }
  EXPECT_NEAR(lines[0].style.width_px, 1.5 * kPxPerPt, 1e-6);
}

TEST(XyChart, MapsTheEndsOfTheAxesToTheCornersOfThePlotArea) {
  ChartSpec spec = sample_chart();
  spec.y = {.low = -2.0, .high = 2.0};
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const PageRect plot = chart.plot_area(kChartRoom);
  EXPECT_EQ(chart.page_from_data({0.0, -2.0}, kChartRoom), Eigen::Vector2d(plot.left, plot.bottom));
  EXPECT_EQ(chart.page_from_data({100.0, 2.0}, kChartRoom),
            Eigen::Vector2d(plot.right(), plot.top()));
  EXPECT_EQ(chart.page_from_data({50.0, 0.0}, kChartRoom), plot.centre());
}

TEST(XyChart, ColoursThePixelsThatTheDataSay) {
  ChartSpec spec = sample_chart();
  spec.lines[0].width_pt = 3.0;
  const Raster<Rgba> pixels = pixels_of(spec);
  const XyChart chart(spec, light_theme(), kPxPerPt);
  for (std::size_t i = 1; i < 100; ++i) {
    const Eigen::Vector2d at =
        chart.page_from_data({spec.lines[0].x[i], spec.lines[0].y[i]}, kChartRoom);
    EXPECT_EQ(pixels.at(static_cast<int>(at.x()), kPageHeight - 1 - static_cast<int>(at.y())),
              kLineBlue)
        << i;
  }
}

TEST(XyChart, DrawsTheSameEachTimeAlsoAfterAnotherPlace) {
  const XyChart chart(sample_chart(), light_theme(), kPxPerPt);
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
  ChartSpec spec = sample_chart();
  for (std::size_t i = 40; i < 60; ++i) spec.lines[0].y[i] = kNan;
  const auto lines = drawn(spec).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(2));
  EXPECT_THAT(lines[0].points, SizeIs(40));
  EXPECT_THAT(lines[1].points, SizeIs(41));
}

TEST(XyChart, DrawsASinglePoint) {
  ChartSpec spec;
  spec.lines.push_back({.x = {3.0}, .y = {2.0}, .colour = kLineBlue});
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const auto lines = drawn(chart).strokes_in(kLineBlue);
  ASSERT_THAT(lines, SizeIs(1));
  EXPECT_NEAR(
      (box_of(lines[0].points).center() - chart.page_from_data({3.0, 2.0}, kChartRoom)).norm(), 0.0,
      0.01);
}

TEST(XyChart, FillsABandBetweenItsLines) {
  const ChartSpec spec = sample_chart();
  const XyChart chart(spec, light_theme(), kPxPerPt);
  const auto bands = drawn(chart).fills_in(kPaleBlue);
  ASSERT_THAT(bands, SizeIs(1));
  ASSERT_THAT(bands[0].outline, SizeIs(202));
  for (std::size_t i = 0; i < 101; ++i) {
    const double x = spec.bands[0].x[i];
    const Eigen::Vector2d low = chart.page_from_data({x, spec.bands[0].low[i]}, kChartRoom);
    const Eigen::Vector2d high = chart.page_from_data({x, spec.bands[0].high[i]}, kChartRoom);
    EXPECT_NEAR((bands[0].outline[i] - low).norm(), 0.0, 0.01);
    EXPECT_NEAR((bands[0].outline[201 - i] - high).norm(), 0.0, 0.01);
  }
}

TEST(XyChart, BreaksABandWhereItsDataDo) {
  ChartSpec spec = sample_chart();
  spec.bands[0].high[50] = kNan;
  EXPECT_THAT(drawn(spec).fills_in(kPaleBlue), SizeIs(2));
}

TEST(XyChart, DrawsBandsBelowLines) {
  const Raster<Rgba> pixels = pixels_of(sample_chart());
  const XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  const Eigen::Vector2d on_line = chart.page_from_data({4.0 * std::numbers::pi, 1.0}, kChartRoom);
  const Rgba found =
      pixels.at(static_cast<int>(on_line.x()), kPageHeight - 1 - static_cast<int>(on_line.y()));
  EXPECT_LT(found.red, 60);
}

TEST(XyChart, ClipsWhatLeavesThePlotArea) {
  ChartSpec spec = sample_chart();
  spec.y = {.low = -0.4, .high = 0.4};
  const PageRect plot = XyChart(spec, light_theme(), kPxPerPt).plot_area(kChartRoom);
  const Raster<Rgba> pixels = pixels_of(spec);
  int blue = 0;
  for (int row = 0; row < kPageHeight; ++row) {
    for (int column = 0; column < kPageWidth; ++column) {
      const Rgba pixel = pixels.at(column, row);
      if (pixel.blue < pixel.red + 30) continue;
      ++blue;
      const double y = kPageHeight - 1 - row;
      EXPECT_TRUE(column >= plot.left - 1.0 && column <= plot.right() + 1.0 &&
                  y >= plot.bottom - 1.0 && y <= plot.top() + 1.0)
          << column << ", " << row;
    }
  }
  EXPECT_GT(blue, 1000);
}

TEST(XyChart, MovesTheMomentLine) {
  ChartSpec spec = sample_chart();
  spec.marked_x = 30.0;
  XyChart chart(spec, light_theme(), kPxPerPt);
  const auto moment = [&chart] { return drawn(chart).strokes_in(light_theme().text); };
  const PageRect plot = chart.plot_area(kChartRoom);
  ASSERT_THAT(moment(), SizeIs(1));
  EXPECT_NEAR(moment()[0].points[0].x(), chart.page_from_data({30.0, 0.0}, kChartRoom).x(), 0.01);
  EXPECT_NEAR(box_of(moment()[0].points).sizes().y(), plot.height, 0.01);
  chart.mark_x(70.5);
  ASSERT_THAT(moment(), SizeIs(1));
  EXPECT_NEAR(moment()[0].points[0].x(), chart.page_from_data({70.5, 0.0}, kChartRoom).x(), 0.01);
  for (const std::optional<double> nowhere : {std::optional<double>{}, {-1.0}, {100.1}, {kNan}}) {
    chart.mark_x(nowhere);
    EXPECT_THAT(moment(), IsEmpty());
  }
}

TEST(XyChart, DrawsTwoAxisLinesAndAHorizontalGridOnly) {
  const XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  const RecordingCanvas canvas = drawn(chart);
  const PageRect plot = chart.plot_area(kChartRoom);
  int long_lines = 0;
  for (const auto& line : canvas.strokes_in(light_theme().muted)) {
    const Eigen::AlignedBox2d box = box_of(line.points);
    EXPECT_TRUE(box.min().x() == plot.left || box.max().y() == plot.bottom);
    if (box.sizes().norm() > 20.0) ++long_lines;
  }
  EXPECT_EQ(long_lines, 2);
  const auto grid = canvas.strokes_in(light_theme().line);
  EXPECT_GE(grid.size(), 4U);
  for (const auto& line : grid) {
    EXPECT_EQ(line.points[0].y(), line.points[1].y());
    EXPECT_EQ(std::abs(line.points[0].x() - line.points[1].x()), plot.width);
    // One pixel wide and in the middle of a row of pixels: sharp.
    EXPECT_EQ(line.style.width_px, 1.0);
    EXPECT_EQ(line.points[0].y() - std::floor(line.points[0].y()), 0.5);
  }
}

TEST(XyChart, GivesTheSameBytesTwice) {
  ChartSpec spec = sample_chart();
  spec.marked_x = 12.0;
  const auto svg = [&spec] {
    SvgCanvas canvas(kPageWidth, kPageHeight, 96.0, "chart", "");
    XyChart(spec, light_theme(), kPxPerPt).draw(canvas, kChartRoom, kPageWidth, kPageHeight);
    return canvas.finish();
  };
  const auto pdf = [&spec] {
    const auto canvas = CairoCanvas::for_pdf(kPageWidth, kPageHeight, 96.0, "chart", "");
    XyChart(spec, light_theme(), kPxPerPt).draw(*canvas, kChartRoom, kPageWidth, kPageHeight);
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
  XyChart(sample_chart(), dark, kPxPerPt).draw(canvas, kChartRoom, kPageWidth, kPageHeight);
  for (const auto& text : canvas.texts) {
    EXPECT_TRUE(text.style.colour == dark.text || text.style.colour == dark.muted) << text.line;
  }
  EXPECT_THAT(canvas.strokes_in(dark.line), Each(testing::_));
  EXPECT_FALSE(canvas.strokes_in(dark.line).empty());
  EXPECT_THAT(canvas.fills, SizeIs(1));  // the band, no background
}

TEST(XyChart, MayBeMoved) {
  XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  const std::size_t before = drawn(chart).strokes.size();
  const XyChart moved = std::move(chart);
  EXPECT_EQ(drawn(moved).strokes.size(), before);
}

TEST(XyChart, RefusesAScaleOfNothing) {
  EXPECT_THROW(XyChart(sample_chart(), light_theme(), 0.0), std::logic_error);
}

/// When anything of a plot was last changed, its data included.
std::vector<vtkMTimeType> times_of_change(XyChart& chart, int plots) {
  std::vector<vtkMTimeType> times;
  for (int i = 0; i < plots; ++i) {
    vtkPlot& plot = *chart.chart().GetPlot(i);
    times.push_back(plot.GetMTime());
    times.push_back(plot.GetInput()->GetMTime());
  }
  return times;
}

// What a film needs: it moves the line of the moment in every frame.
TEST(XyChart, MarksMomentsWithoutTouchingItsDataOrItsAxes) {
  XyChart chart(sample_chart(), light_theme(), kPxPerPt);
  const RecordingCanvas before = drawn(chart);
  const int data_plots = static_cast<int>(chart.chart().GetNumberOfPlots()) - 1;
  vtkPlot* const first_plot = chart.chart().GetPlot(0);
  const auto changed = times_of_change(chart, data_plots);
  const auto* const ticks = chart.chart().GetAxis(vtkAxis::BOTTOM)->GetTickLabels();
  for (const double moment : {0.0, 12.5, 99.0}) {
    chart.mark_x(moment);
    const RecordingCanvas marked = drawn(chart);
    EXPECT_EQ(chart.chart().GetPlot(0), first_plot);
    EXPECT_EQ(times_of_change(chart, data_plots), changed);
    EXPECT_EQ(chart.chart().GetAxis(vtkAxis::BOTTOM)->GetTickLabels(), ticks);
    EXPECT_EQ(marked.strokes_in(kLineBlue)[0].points, before.strokes_in(kLineBlue)[0].points);
    EXPECT_EQ(marked.fills_in(kPaleBlue)[0].outline, before.fills_in(kPaleBlue)[0].outline);
    EXPECT_EQ(marked.strokes.size(), before.strokes.size() + 1);
  }
}

TEST(XyChart, KeptAndMarkedLooksLikeOneMadeWithTheMark) {
  ChartSpec spec = sample_chart();
  XyChart kept(spec, light_theme(), kPxPerPt);
  drawn(kept);
  kept.mark_x(42.0);
  spec.marked_x = 42.0;
  EXPECT_EQ(encode_png(pixels_of(kept)), encode_png(pixels_of(spec)));
}

}  // namespace xy_chart_test
}  // namespace nadir
