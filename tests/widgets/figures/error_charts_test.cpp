// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/error_charts.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/run/evaluate_run.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/figures/chart_panel.h"
#include "widgets/figures/moment_panels.h"
#include "widgets/views/chart_axis.h"

namespace nadir {
namespace error_charts_test {

using testing::Contains;
using testing::DoubleNear;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsNan;
using testing::SizeIs;
using testing::UnorderedElementsAre;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const Theme& light() { return theme(ThemeName::kLight); }

/// The drive of recorded_flight.h with its steps changed one by one; not read from a file.
FigureRun drive(
    const std::string& name,
    int steps = 30,
    const std::function<void(RunStep&)>& change = [](RunStep&) {}) {
  FigureRun run;
  run.name = name;
  for (int i = 0; i < steps; ++i) {
    run.steps.push_back(street_step(i, {.has_particles = false, .has_topviews = false}));
    change(run.steps.back());
    run.judged.push_back(evaluated_step(run.steps.back()));
  }
  run.start_s = run.steps.front().time_s;
  run.evaluation = evaluate_steps(run.judged).value();
  return run;
}

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

std::vector<std::string> names_of(const ChartSpec& chart) {
  std::vector<std::string> names;
  for (const LegendEntry& entry : legend_of(chart)) names.push_back(entry.name);
  return names;
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

CellAgreement agreement_of(ClassId id, std::uint32_t agreeing, std::uint32_t disagreeing) {
  CellAgreement made;
  made.of_class.at(id) = {agreeing, disagreeing, 0};
  return made;
}

TEST(AgreementBars, StandForEachClassSeenOnKnownGround) {
  CellAgreement at_estimate = agreement_of(kRoad, 3, 1);
  at_estimate.of_class[kCurb] = {0, 5, 0};
  at_estimate.of_class[kTerrain] = {0, 0, 7};  // off the map
  const auto chart = agreement_bars({at_estimate, agreement_of(kRoad, 4, 0)}, light());
  ASSERT_TRUE(chart);
  EXPECT_EQ(chart->y.title, "agreeing [%]");
  EXPECT_EQ(chart->y.high, 100.0);
  const auto& bars = *chart->bars;
  const std::string road_name(class_info(kRoad).name);
  EXPECT_THAT(bars.groups,
              testing::UnorderedElementsAre(road_name, std::string(class_info(kCurb).name)));
  const std::size_t road = bars.groups[0] == road_name ? 0 : 1;
  EXPECT_DOUBLE_EQ(bars.series[0].heights[road], 75.0);
  EXPECT_DOUBLE_EQ(bars.series[0].heights[1 - road], 0.0);
  EXPECT_DOUBLE_EQ(bars.series[1].heights[road], 100.0);
  EXPECT_THAT(bars.series[1].heights[1 - road], IsNan());
  EXPECT_THAT(names_of(*chart), ElementsAre("at estimate", "at truth"));
}

TEST(AgreementBars, StandAlsoForClassesThatOnlyTheTruthKnows) {
  const auto chart = agreement_bars({{}, agreement_of(kRoad, 1, 1)}, light());
  ASSERT_TRUE(chart);
  EXPECT_THAT(chart->bars->groups, SizeIs(1));
  EXPECT_THAT(names_of(*chart), ElementsAre("at truth"));
}

TEST(AgreementBars, AreNoneWithoutCellsOnKnownGroundAndOneSeriesWithoutTruth) {
  EXPECT_FALSE(agreement_bars({}, light()));
  EXPECT_FALSE(agreement_bars({{}, CellAgreement{}}, light()));
  const auto chart = agreement_bars({agreement_of(kRoad, 1, 1), {}}, light());
  ASSERT_TRUE(chart);
  EXPECT_THAT(chart->bars->series, SizeIs(1));
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

TEST(NeesChart, HasTheBoundsAndTheMeanOfThreeDegreesOfFreedom) {
  const ChartSpec chart = nees_chart(drive("a"), light());
  std::vector<double> levels;
  for (const auto& level : chart.levels) levels.push_back(level.y);
  EXPECT_THAT(levels, UnorderedElementsAre(DoubleNear(0.216, 5e-4), DoubleNear(9.348, 5e-4), 3.0));
  // 0.2^2 / 0.3 + 0.2^2 / 0.1 + 0.01^2 / 0.002
  EXPECT_NEAR(chart.lines[0].y[0], 0.583333, 1e-6);
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

}  // namespace error_charts_test
}  // namespace nadir
