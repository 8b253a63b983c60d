// SPDX-License-Identifier: Apache-2.0
#include "widgets/figures/error_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/eval/consistency.h"

namespace nadir {
namespace {

constexpr const char* kTimeTitle = "time [s]";

double degrees(double radians) { return Angle::radians(radians).degrees(); }

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

ChartSpec error_over_time(std::span<const FigureRun> runs,
                          bool with_odometry,
                          ErrorKind kind,
                          const Theme& theme) {
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  spec.y.title = kind == ErrorKind::kPosition ? "position error [m]" : "orientation error [deg]";
  spec.y.low = 0.0;
  if (with_odometry) {
    const ErrorSeries series = odometry_series(runs.front());
    spec.lines.push_back({"odometry (input)", elapsed_of(runs.front(), series),
                          magnitudes(series, kind), theme.odometry, 1.25, true});
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const ErrorSeries series = error_series(runs[r].judged);
    spec.lines.push_back({runs.size() == 1 ? "estimate" : runs[r].name, elapsed_of(runs[r], series),
                          magnitudes(series, kind), run_colour(theme, r), 1.5});
  }
  return spec;
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
  std::vector<double> made(values.size());
  std::transform(values.begin(), values.end(), made.begin(),
                 [factor](double value) { return factor * value; });
  return made;
}

}  // namespace

Rgba run_colour(const Theme& theme, std::size_t run) {
  const std::array<Rgba, 3> colours = {theme.estimate, theme.second_run, theme.third_run};
  return colours.at(run % colours.size());
}

std::vector<double> elapsed_of(const FigureRun& run, const ErrorSeries& series) {
  std::vector<double> elapsed = series.time_s;
  for (double& time_s : elapsed) time_s += run.elapsed_s(run.steps.front());
  return elapsed;
}

ChartSpec axis_error_chart(const FigureRun& run, PoseAxis axis, const Theme& theme) {
  const ErrorSeries series = error_series(run.judged);
  const std::vector<double> elapsed = elapsed_of(run, series);
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  std::vector<double> error;
  std::vector<double> sigma;
  switch (axis) {
    case PoseAxis::kEast:
      spec.y.title = "east error [m]";
      error = series.x_error_m;
      sigma = series.x_sigma_m;
      break;
    case PoseAxis::kNorth:
      spec.y.title = "north error [m]";
      error = series.y_error_m;
      sigma = series.y_sigma_m;
      break;
    case PoseAxis::kYaw:
      spec.y.title = "yaw error [deg]";
      error = in_degrees(series.yaw_error_rad);
      sigma = in_degrees(series.yaw_sigma_rad);
      break;
  }
  spec.bands.push_back({"2 sigma of the particles", elapsed, scaled(sigma, -2.0),
                        scaled(sigma, 2.0), with_opacity(theme.estimate, 0.14)});
  spec.bands.push_back(
      {"1 sigma", elapsed, scaled(sigma, -1.0), sigma, with_opacity(theme.estimate, 0.22)});
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
  spec.y.title = "share of steps";
  spec.y.low = 0.0;
  spec.y.high = 1.0;
  const auto add = [&](const std::string& name, const ErrorSeries& series, Rgba colour,
                       bool is_dashed) {
    CumulativeDistribution cdf = cumulative_distribution(magnitudes(series, kind));
    cdf.value.insert(cdf.value.begin(), 0.0);
    cdf.share.insert(cdf.share.begin(), 0.0);
    spec.lines.push_back({name, cdf.value, cdf.share, colour, 1.5, is_dashed, true});
  };
  add(runs.size() == 1 ? "odometry (input)" : "odometry of " + runs.front().name,
      odometry_series(runs.front()), theme.odometry, true);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    add(runs.size() == 1 ? "estimate" : runs[r].name, error_series(runs[r].judged),
        run_colour(theme, r), false);
  }
  return spec;
}

ChartSpec mse_chart(std::span<const FigureRun> runs, ErrorKind kind, const Theme& theme) {
  ChartSpec spec;
  spec.y.title = kind == ErrorKind::kPosition ? "position MSE [m^2]" : "orientation MSE [rad^2]";
  BarsSpec bars;
  bars.is_logarithmic = true;
  bars.series = {{"odometry (input)", {}, theme.odometry}, {"estimate", {}, theme.estimate}};
  const auto mse = [kind](const std::optional<PoseErrorSummary>& summary) {
    if (!summary) return std::nan("");
    return kind == ErrorKind::kPosition ? summary->position_m.mean_square
                                        : summary->orientation_rad.mean_square;
  };
  for (const FigureRun& run : runs) {
    bars.groups.push_back(run.name);
    bars.series[0].heights.push_back(mse(run.evaluation.odometry));
    bars.series[1].heights.push_back(mse(run.evaluation.estimate));
  }
  spec.bars = std::move(bars);
  return spec;
}

ChartSpec nees_chart(const FigureRun& run, const Theme& theme) {
  constexpr double kFreedom = 3.0;
  const ErrorSeries series = error_series(run.judged);
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  spec.y.title = "NEES";
  spec.y.low = 0.0;
  spec.lines.push_back({"", elapsed_of(run, series), series.nees, theme.estimate, 1.0});
  spec.levels.push_back({"95 % bounds", chi_square_quantile(0.975, kFreedom), theme.bad, true});
  spec.levels.push_back({"95 % bounds", chi_square_quantile(0.025, kFreedom), theme.bad, true});
  spec.levels.push_back({"expected mean", kFreedom, theme.muted, false});
  return spec;
}

namespace {

ChartSpec over_time(const FigureRun& run,
                    const std::string& title,
                    const std::string& name,
                    Rgba colour,
                    double (*value)(const RunStep&)) {
  ChartSpec spec;
  spec.x.title = kTimeTitle;
  spec.y.title = title;
  spec.y.low = 0.0;
  LineSpec line{name, {}, {}, colour, 1.25};
  for (const RunStep& step : run.steps) {
    line.x.push_back(run.elapsed_s(step));
    line.y.push_back(value(step));
  }
  spec.lines.push_back(std::move(line));
  return spec;
}

}  // namespace

ChartSpec sample_size_chart(const FigureRun& run, const Theme& theme) {
  ChartSpec spec = over_time(run, "particles", "effective sample size", theme.estimate,
                             [](const RunStep& step) { return step.effective_sample_size; });
  ChartSpec all = over_time(run, "", "particles", theme.muted, [](const RunStep& step) {
    return static_cast<double>(step.particle_count);
  });
  all.lines.front().is_dashed = true;
  spec.lines.push_back(std::move(all.lines.front()));
  return spec;
}

ChartSpec agreement_chart(std::span<const FigureRun> runs, const Theme& theme) {
  ChartSpec spec;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    ChartSpec one =
        over_time(runs[r], "agreement", runs.size() == 1 ? "" : runs[r].name, run_colour(theme, r),
                  [](const RunStep& step) { return step.agreement.value_or(std::nan("")); });
    if (r == 0) {
      spec = std::move(one);
    } else {
      spec.lines.push_back(std::move(one.lines.front()));
    }
  }
  spec.y.high = 1.0;
  return spec;
}

ChartSpec timing_chart(const FigureRun& run, const Theme& theme) {
  return over_time(run, "update time [ms]", "update", theme.muted,
                   [](const RunStep& step) { return step.update_ms; });
}

ChartSpec calibration_chart(const FigureRun& run, const Theme& theme) {
  ChartSpec spec;
  spec.x = {"probability of the ellipse", 0.0, 1.0};
  spec.y = {"share of truth inside", 0.0, 1.0};
  std::vector<double> probabilities;
  std::vector<double> all;
  for (const EvaluatedStep& step : run.judged) {
    if (!step.truth_in_enu || !is_finite(*step.truth_in_enu) || !is_finite(step.estimate_in_enu)) {
      continue;
    }
    const Eigen::Vector2d error =
        step.estimate_in_enu.translation_m() - step.truth_in_enu->translation_m();
    const auto distance2 =
        normalised_error_squared(error, Eigen::Matrix2d(step.covariance.topLeftCorner<2, 2>()));
    // With two degrees of freedom the chi-square distribution is 1 - exp(-d^2 / 2).
    all.push_back(distance2 ? 1.0 - std::exp(-*distance2 / 2.0) : 1.0);
  }
  std::sort(all.begin(), all.end());
  LineSpec line{"", {0.0}, {0.0}, theme.estimate, 1.5};
  for (std::size_t i = 0; i < all.size(); ++i) {
    line.x.push_back(all[i]);
    line.y.push_back(static_cast<double>(i + 1) / static_cast<double>(all.size()));
  }
  line.x.push_back(1.0);
  line.y.push_back(1.0);
  spec.lines.push_back(std::move(line));
  spec.lines.push_back({"consistent filter", {0.0, 1.0}, {0.0, 1.0}, theme.muted, 1.0, true});
  return spec;
}

}  // namespace nadir
