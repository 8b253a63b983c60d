// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/error_charts.h"

#include <gmock/gmock.h>

#include <cmath>

#include "tests/widgets/figures/made_drive.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/views/chart_axis.h"

namespace nadir {
namespace error_charts_test {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsNan;
using ::testing::SizeIs;

FigureRun without_odometry() {
  return drive("blind", 30, [](RunStep& step) { step.odometry_in_enu.reset(); });
}

/// How many pieces a canvas would draw a line in.
std::size_t pieces_of(const LineSpec& line) {
  std::size_t pieces = 0;
  bool was_known = false;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const bool is_known = std::isfinite(line.x[i]) && std::isfinite(line.y[i]);
    if (is_known && !was_known) ++pieces;
    was_known = is_known;
  }
  return pieces;
}

/// Every chart over time of a run.
std::vector<ChartSpec> charts_over_time(const FigureRun& run) {
  const std::span<const FigureRun> runs(&run, 1);
  return {axis_error_chart(run, PoseAxis::kEast, light()),
          axis_error_chart(run, PoseAxis::kNorth, light()),
          axis_error_chart(run, PoseAxis::kYaw, light()),
          position_error_chart(runs, true, light()),
          orientation_error_chart(runs, true, light()),
          nees_chart(run, light())};
}

TEST(ErrorCharts, HaveOnePieceWhereNothingIsMissing) {
  for (const ChartSpec& chart : charts_over_time(drive("whole"))) {
    for (const LineSpec& line : chart.lines) {
      EXPECT_EQ(pieces_of(line), 1U) << chart.y.title << ", " << line.name;
      EXPECT_THAT(line.y, SizeIs(30)) << chart.y.title;
    }
  }
}

TEST(ErrorCharts, BreakWhereTruthIsMissing) {
  const FigureRun run = drive("gap", 30, [](RunStep& step) {
    if (step.step >= 10 && step.step < 14) step.truth_in_enu.reset();
  });
  for (const ChartSpec& chart : charts_over_time(run)) {
    for (const LineSpec& line : chart.lines) {
      EXPECT_EQ(pieces_of(line), 2U) << chart.y.title << ", " << line.name;
      ASSERT_EQ(line.x.size(), line.y.size());
      EXPECT_THAT(line.y[10], IsNan());
      EXPECT_NEAR(line.x[9], 4.5, 1e-9);
      EXPECT_NEAR(line.x[11], 7.0, 1e-9);
    }
    for (const BandSpec& band : chart.bands) {
      EXPECT_THAT(band.low[10], IsNan());
      EXPECT_THAT(band.high[10], IsNan());
      ASSERT_EQ(band.x.size(), band.high.size());
    }
  }
}

TEST(ErrorCharts, AreDrawnWithAHoleWhereTruthIsMissing) {
  const FigureRun run = drive("gap", 30, [](RunStep& step) {
    if (step.step >= 10 && step.step < 14) step.truth_in_enu.reset();
  });
  RecordingCanvas canvas;
  const XyChart chart(axis_error_chart(run, PoseAxis::kEast, light()), light(), 1.0);
  const PageRect where{0.0, 0.0, 400.0, 200.0};
  chart.draw(canvas, where, 400, 200);
  EXPECT_THAT(canvas.strokes_in(light().estimate), SizeIs(2));
  EXPECT_THAT(canvas.fills_in(with_opacity(light().estimate, 0.34)), SizeIs(2));
  const double in_gap = chart.page_from_data({5.75, 0.0}, where).x();
  for (const auto& stroke : canvas.strokes_in(light().estimate)) {
    const bool is_before = stroke.points.back().x() < in_gap;
    EXPECT_TRUE(is_before || stroke.points.front().x() > in_gap);
  }
}

TEST(ErrorCharts, BreakWhereARunPauses) {
  const FigureRun run = drive("pause", 30, [](RunStep& step) {
    if (step.step >= 20) step.time_s += 60.0;
  });
  std::vector<ChartSpec> charts = charts_over_time(run);
  charts.push_back(sample_size_chart(run, light()));
  charts.push_back(agreement_chart({&run, 1}, light()));
  charts.push_back(timing_chart(run, light()));
  for (const ChartSpec& chart : charts) {
    for (const LineSpec& line : chart.lines) {
      EXPECT_EQ(pieces_of(line), 2U) << chart.y.title << ", " << line.name;
    }
  }
}

TEST(ErrorCharts, NameNoOdometryWhereThereIsNone) {
  const FigureRun run = without_odometry();
  const std::span<const FigureRun> runs(&run, 1);
  for (const ChartSpec& chart :
       {position_error_chart(runs, true, light()), cdf_chart(runs, ErrorKind::kPosition, light()),
        cdf_chart(runs, ErrorKind::kOrientation, light()),
        mse_chart(runs, ErrorKind::kPosition, light())}) {
    EXPECT_THAT(names_of(chart), ElementsAre("estimate"));
    EXPECT_LE(chart.lines.size(), 1U);
  }
  const ChartSpec bars = mse_chart(runs, ErrorKind::kPosition, light());
  EXPECT_THAT(bars.bars->series, SizeIs(1));
}

TEST(ErrorCharts, OfRunsOfWhichSomeHaveOdometryNameIt) {
  const std::vector<FigureRun> runs = {without_odometry(), drive("seeing")};
  const ChartSpec bars = mse_chart(runs, ErrorKind::kOrientation, light());
  EXPECT_THAT(names_of(bars), ElementsAre("odometry (input)", "estimate"));
  EXPECT_THAT(bars.bars->groups, ElementsAre("blind", "seeing"));
  EXPECT_THAT(bars.bars->series[0].heights[0], IsNan());
  EXPECT_GT(bars.bars->series[0].heights[1], 0.0);
  EXPECT_THAT(names_of(cdf_chart(runs, ErrorKind::kPosition, light())),
              ElementsAre("blind", "seeing"));
}

TEST(CdfChart, HasRoomForTheLinesAtItsEnds) {
  const FigureRun run = drive("a");
  const ChartSpec chart = cdf_chart({&run, 1}, ErrorKind::kPosition, light());
  RecordingCanvas canvas;
  const XyChart drawn(chart, light(), 2.0);
  const PageRect where{0.0, 0.0, 500.0, 300.0};
  drawn.draw(canvas, where, 500, 300);
  const PageRect plot = drawn.plot_area(where);
  const double half_line = chart.lines[0].width_pt;  // of 2 pixels per point
  EXPECT_GT(drawn.page_from_data({0.0, 0.0}, where).y(), plot.bottom + half_line);
  EXPECT_LT(drawn.page_from_data({0.0, 1.0}, where).y(), plot.top() - half_line);
  for (const LineSpec& line : chart.lines) {
    EXPECT_LT(drawn.page_from_data({line.x.back(), 0.0}, where).x(), plot.right() - half_line);
    EXPECT_EQ(line.y.front(), 0.0);
    EXPECT_EQ(line.y.back(), 1.0);
  }
  std::vector<std::string> labels;
  for (const auto& text : canvas.texts) labels.push_back(text.line);
  EXPECT_THAT(labels, Contains("0.0"));
  EXPECT_THAT(labels, Contains("1.0"));
}

TEST(ErrorCharts, TellEightRunsApart) {
  std::vector<FigureRun> runs;
  for (int i = 0; i < 8; ++i) runs.push_back(drive("run-" + std::to_string(i), 5));
  for (const ChartSpec& chart :
       {position_error_chart(runs, false, light()), orientation_error_chart(runs, false, light()),
        agreement_chart(runs, light())}) {
    ASSERT_THAT(chart.lines, SizeIs(8));
    for (std::size_t a = 0; a < 8; ++a) {
      EXPECT_EQ(chart.lines[a].colour, run_colour(light(), a));
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_TRUE(chart.lines[a].colour != chart.lines[b].colour ||
                    chart.lines[a].is_dashed != chart.lines[b].is_dashed);
      }
    }
  }
}

TEST(CdfChart, HasTheOdometryOfEachFlight) {
  std::vector<FigureRun> runs = {drive("a"), drive("b")};
  EXPECT_THAT(names_of(cdf_chart(runs, ErrorKind::kPosition, light())),
              ElementsAre("odometry (input)", "a", "b"));
  runs[1].evaluation.flight = "another";
  const ChartSpec chart = cdf_chart(runs, ErrorKind::kPosition, light());
  EXPECT_THAT(names_of(chart),
              ElementsAre("odometry (input) of a", "odometry (input) of b", "a", "b"));
  const std::vector<LegendEntry> entries = legend_of(chart);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(entries[i].colour != entries[j].colour || entries[i].kind != entries[j].kind);
    }
  }
}

TEST(MseChart, IsInTheUnitsOfTheReportAndSaysItsScale) {
  const FigureRun run = drive("a");
  const ChartSpec chart = mse_chart({&run, 1}, ErrorKind::kOrientation, light());
  EXPECT_EQ(chart.y.title, "MSE [deg²], log scale");
  const double degrees = 180.0 / 3.141592653589793;
  EXPECT_NEAR(chart.bars->series[1].heights[0],
              run.evaluation.estimate->orientation_rad.mean_square * degrees * degrees, 1e-9);
  EXPECT_EQ(mse_chart({&run, 1}, ErrorKind::kPosition, light()).y.title, "MSE [m²], log scale");
}

TEST(MseChart, HasTicksAboveAndBelowItsBarsAndTheirValues) {
  const std::vector<FigureRun> runs = {drive("a"), drive("b", 12)};
  for (const ErrorKind kind : {ErrorKind::kPosition, ErrorKind::kOrientation}) {
    const ChartSpec chart = mse_chart(runs, kind, light());
    const AxisRange range = y_range_of(chart);
    RecordingCanvas canvas;
    XyChart(chart, light(), 2.0).draw(canvas, {0.0, 0.0, 600.0, 400.0}, 600, 400);
    std::vector<std::string> texts;
    for (const auto& text : canvas.texts) texts.push_back(text.line);
    for (const BarsSpec::Series& series : chart.bars->series) {
      for (const double height : series.heights) {
        EXPECT_GT(height, range.low);
        EXPECT_LT(height, range.high);
        EXPECT_THAT(texts, Contains(short_number(height)));
      }
    }
  }
}

TEST(AxisErrorChart, HasBandsOfOneAndTwoSigmaInTheUnitsOfItsError) {
  const FigureRun run = drive("a");  // variances 0.3 m^2, 0.1 m^2 and 0.002 rad^2
  const ChartSpec east = axis_error_chart(run, PoseAxis::kEast, light());
  const ChartSpec north = axis_error_chart(run, PoseAxis::kNorth, light());
  const ChartSpec yaw = axis_error_chart(run, PoseAxis::kYaw, light());
  const auto expect_bands = [](const ChartSpec& chart, double sigma) {
    ASSERT_THAT(chart.bands, SizeIs(2));
    EXPECT_THAT(chart.bands[0].low, Each(DoubleNear(-2.0 * sigma, 1e-4)));
    EXPECT_THAT(chart.bands[0].high, Each(DoubleNear(2.0 * sigma, 1e-4)));
    EXPECT_THAT(chart.bands[1].low, Each(DoubleNear(-sigma, 1e-4)));
    EXPECT_THAT(chart.bands[1].high, Each(DoubleNear(sigma, 1e-4)));
  };
  expect_bands(east, 0.54772);
  expect_bands(north, 0.31623);
  expect_bands(yaw, 2.56235);  // degrees
  EXPECT_THAT(east.lines[0].y, Each(DoubleNear(0.2, 1e-9)));
  EXPECT_NEAR(north.lines[0].y[0], -0.2, 1e-9);
  EXPECT_THAT(yaw.lines[0].y, Each(DoubleNear(0.572958, 1e-5)));  // 0.01 rad
}

TEST(ErrorCharts, CountTimeFromTheRunsStartAlsoWhereItsFirstStepsAreLeftOut) {
  FigureRun run = drive("later");
  run.steps.erase(run.steps.begin(), run.steps.begin() + 10);
  run.judged.erase(run.judged.begin(), run.judged.begin() + 10);
  run.judged[0].truth_in_enu.reset();
  const std::vector<double> elapsed = elapsed_of(run, error_series(run.judged));
  ASSERT_THAT(elapsed, SizeIs(19));
  EXPECT_NEAR(elapsed.front(), 5.5, 1e-9);
  EXPECT_NEAR(elapsed.back(), 14.5, 1e-9);
  for (const ChartSpec& chart : charts_over_time(run)) {
    for (const LineSpec& line : chart.lines) EXPECT_NEAR(line.x.front(), 5.5, 1e-9);
  }
}

}  // namespace error_charts_test
}  // namespace nadir
