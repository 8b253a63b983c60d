// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/error_charts.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"

namespace nadir {
namespace {

constexpr const char* kTimeTitle = "time [s]";
constexpr double kDegPerRad = Angle::radians(1.0).degrees();

double degrees(double radians) { return kDegPerRad * radians; }

std::vector<double> in_degrees(std::vector<double> radians) {
  for (double& value : radians) value = degrees(value);
  return radians;
}

/// Errors of the odometry of a run as if it were the estimate.
ErrorSeries odometry_series(const FigureRun& run) {
  std::vector<EvaluatedStep> steps = run.judged;
  for (EvaluatedStep& step : steps) {
    if (step.odometry_in_enu) {
      step.estimate_in_enu = *step.odometry_in_enu;
    } else {
      step.truth_in_enu.reset();
    }
  }
  return error_series(steps);
}

std::vector<double> magnitudes(const ErrorSeries& series, ErrorKind kind) {
  if (kind == ErrorKind::kPosition) return series.position_error_m;
  std::vector<double> sizes = in_degrees(series.yaw_error_rad);
  for (double& size : sizes) size = std::abs(size);
  return sizes;
}

/// A line of a size over time, with its gaps.
LineSpec error_line(const std::string& name,
                    const FigureRun& run,
                    const ErrorSeries& series,
                    ErrorKind kind,
                    Rgba colour) {
  const std::vector<std::size_t> gaps = gaps_of(series);
  return {name, broken_at(gaps, elapsed_of(run, series)), broken_at(gaps, magnitudes(series, kind)),
          colour};
}

ChartSpec error_over_time(std::span<const FigureRun> runs,
                          bool with_odometry,
                          ErrorKind kind,
                          const Theme& theme) {
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  spec.y.title = kind == ErrorKind::kPosition ? "error [m]" : "error [deg]";
  spec.y.low = 0.0;
  if (with_odometry) {
    LineSpec line = error_line("odometry (input)", runs.front(), odometry_series(runs.front()),
                               kind, theme.odometry);
    line.width_pt = 1.25;
    line.is_dashed = true;
    if (!line.x.empty()) spec.lines.push_back(std::move(line));
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    LineSpec line = error_line(runs.size() == 1 ? "estimate" : runs[r].name, runs[r],
                               error_series(runs[r].judged), kind, run_colour(theme, r));
    line.is_dashed = is_run_dashed(r);
    spec.lines.push_back(std::move(line));
  }
  return spec;
}

/// What odometry says depends on the flight alone, and so tells flights apart.
bool are_of_one_flight(std::span<const FigureRun> runs) {
  const auto flight_of = [](const FigureRun& run) {
    return run.reader ? run.reader->header().flight_hash : run.evaluation.flight;
  };
  return std::all_of(runs.begin(), runs.end(), [&](const FigureRun& run) {
    return flight_of(run) == flight_of(runs.front());
  });
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> made(values.size());
  std::transform(values.begin(), values.end(), made.begin(),
                 [factor](double value) { return factor * value; });
  return made;
}

}  // namespace

std::vector<double> elapsed_of(const FigureRun& run, const ErrorSeries& series) {
  std::vector<double> elapsed = series.time_s;
  for (double& time_s : elapsed) time_s += run.elapsed_s(run.steps.front());
  return elapsed;
}

ChartSpec axis_error_chart(const FigureRun& run, PoseAxis axis, const Theme& theme) {
  const ErrorSeries series = error_series(run.judged);
  const std::vector<std::size_t> gaps = gaps_of(series);
  const std::vector<double> elapsed = broken_at(gaps, elapsed_of(run, series));
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  std::vector<double> error;
  std::vector<double> sigma;
  switch (axis) {
    case PoseAxis::kEast:
      spec.y.title = "error [m]";
      error = series.x_error_m;
      sigma = series.x_sigma_m;
      break;
    case PoseAxis::kNorth:
      spec.y.title = "error [m]";
      error = series.y_error_m;
      sigma = series.y_sigma_m;
      break;
    case PoseAxis::kYaw:
      spec.y.title = "error [deg]";
      error = in_degrees(series.yaw_error_rad);
      sigma = in_degrees(series.yaw_sigma_rad);
      break;
  }
  error = broken_at(gaps, error);
  sigma = broken_at(gaps, sigma);
  spec.bands.push_back({"2 sigma", elapsed, scaled(sigma, -2.0), scaled(sigma, 2.0),
                        with_opacity(theme.estimate, 0.14)});
  spec.bands.push_back(
      {"1 sigma", elapsed, scaled(sigma, -1.0), sigma, with_opacity(theme.estimate, 0.34)});
  spec.lines.push_back({"error of the estimate", elapsed, error, theme.estimate, 1.25});
  return spec;
}

ChartSpec position_error_chart(std::span<const FigureRun> runs,
                               bool with_odometry,
                               const Theme& theme) {
  return error_over_time(runs, with_odometry, ErrorKind::kPosition, theme);
}

ChartSpec orientation_error_chart(std::span<const FigureRun> runs,
                                  bool with_odometry,
                                  const Theme& theme) {
  return error_over_time(runs, with_odometry, ErrorKind::kOrientation, theme);
}

ChartSpec cdf_chart(std::span<const FigureRun> runs, ErrorKind kind, const Theme& theme) {
  ChartSpec spec;
  spec.x.title = kind == ErrorKind::kPosition ? "position error [m]" : "orientation error [deg]";
  spec.x.low = 0.0;
  // The frame would cut lines along 0, 1 and the largest error in half.
  constexpr double kRoom = 0.02;
  spec.y = {"share of steps", -kRoom, 1.0 + kRoom};
  const auto add = [&](const std::string& name, const ErrorSeries& series, Rgba colour,
                       bool is_dashed) {
    CumulativeDistribution cdf = cumulative_distribution(magnitudes(series, kind));
    if (cdf.value.empty()) return;
    cdf.value.insert(cdf.value.begin(), 0.0);
    cdf.share.insert(cdf.share.begin(), 0.0);
    spec.lines.push_back({name, cdf.value, cdf.share, colour, 1.5, is_dashed, true});
  };
  // Runs of one flight have one odometry; of several, each has its own.
  const bool are_alike = are_of_one_flight(runs);
  add(runs.size() == 1 || are_alike ? "odometry (input)"
                                    : "odometry (input) of " + runs.front().name,
      odometry_series(runs.front()), theme.odometry, true);
  for (std::size_t r = 1; !are_alike && r < runs.size(); ++r) {
    add("odometry (input) of " + runs[r].name, odometry_series(runs[r]), run_colour(theme, r),
        true);
    if (!spec.lines.empty()) spec.lines.back().width_pt = 1.0;
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    add(runs.size() == 1 ? "estimate" : runs[r].name, error_series(runs[r].judged),
        run_colour(theme, r), is_run_dashed(r));
  }
  double largest = 0.0;
  for (const LineSpec& line : spec.lines) {
    for (const double value : line.x) {
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  }
  if (largest > 0.0) spec.x.high = (1.0 + kRoom) * largest;
  return spec;
}

ChartSpec mse_chart(std::span<const FigureRun> runs, ErrorKind kind, const Theme& theme) {
  ChartSpec spec;
  spec.y.title = kind == ErrorKind::kPosition ? "MSE [m²]" : "MSE [deg²]";
  spec.y.title += ", log scale";
  BarsSpec bars;
  bars.is_logarithmic = true;
  bars.shows_values = true;
  bars.series = {{"odometry (input)", {}, theme.odometry}, {"estimate", {}, theme.estimate}};
  const auto mse = [kind](const std::optional<PoseErrorSummary>& summary) {
    if (!summary) return std::nan("");
    return kind == ErrorKind::kPosition
               ? summary->position_m.mean_square
               : summary->orientation_rad.mean_square * kDegPerRad * kDegPerRad;
  };
  for (const FigureRun& run : runs) {
    bars.groups.push_back(run.name);
    bars.series[0].heights.push_back(mse(run.evaluation.odometry));
    bars.series[1].heights.push_back(mse(run.evaluation.estimate));
  }
  std::erase_if(bars.series, [](const BarsSpec::Series& series) {
    return std::none_of(series.heights.begin(), series.heights.end(),
                        [](double height) { return std::isfinite(height); });
  });
  spec.bars = std::move(bars);
  return spec;
}

}  // namespace nadir
