// SPDX-License-Identifier: Apache-2.0
// Charts of the filter itself, step by step.
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/eval/consistency.h"
#include "widgets/figures/error_charts.h"

namespace nadir {
namespace {

constexpr double kMsPerS = 1000.0;
/// The mean NEES and the diagonal of the calibration look alike, for they say the same.
constexpr const char* kExpected = "expected of a consistent filter";
/// A budget so many times longer than the longest update is left out.
constexpr double kMostBudget = 3.0;

/// From 0 to 1 with some room, for the frame would cut lines along its ends in half.
AxisSpec share_axis(const std::string& title) { return {title, -0.02, 1.02}; }

/// A number of each step, over time.
LineSpec step_line(const FigureRun& run,
                   const std::string& name,
                   Rgba colour,
                   double (*value)(const RunStep&)) {
  std::vector<double> elapsed;
  std::vector<double> values;
  for (const RunStep& step : run.steps) {
    elapsed.push_back(run.elapsed_s(step));
    values.push_back(value(step));
  }
  const std::vector<std::size_t> gaps = time_gaps(elapsed);
  return {name, broken_at(gaps, elapsed), broken_at(gaps, values), colour, 1.25};
}

}  // namespace

ChartSpec nees_chart(const FigureRun& run, const Theme& theme) {
  const StepNeesBounds bounds = step_nees_bounds();
  const ErrorSeries series = error_series(run.judged);
  const std::vector<std::size_t> gaps = gaps_of(series);
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y = {"NEES", 0.0, {}};
  spec.lines.push_back({"", broken_at(gaps, elapsed_of(run, series)), broken_at(gaps, series.nees),
                        theme.estimate, 1.0});
  spec.levels.push_back({"95 % bounds of NEES", bounds.upper, theme.bad, true});
  spec.levels.push_back({"95 % bounds of NEES", bounds.lower, theme.bad, true});
  spec.levels.push_back({kExpected, 1.0 * bounds.degrees_of_freedom, theme.muted, false});
  return spec;
}

ChartSpec calibration_chart(const FigureRun& run, const Theme& theme) {
  ChartSpec spec;
  spec.x = share_axis("probability of the ellipse");
  spec.y = share_axis("share of truth inside");
  std::vector<double> probabilities;
  std::vector<double> all;
  for (const EvaluatedStep& step : run.judged) {
    if (!step.truth_in_enu || !is_finite(*step.truth_in_enu) || !is_finite(step.estimate_in_enu)) {
      continue;
    }
    if (!is_ellipse_known(step.covariance)) continue;
    const Eigen::Vector2d error =
        step.estimate_in_enu.translation_m() - step.truth_in_enu->translation_m();
    const auto distance2 =
        normalised_error_squared(error, Eigen::Matrix2d(step.covariance.topLeftCorner<2, 2>()));
    // With two degrees of freedom the chi-square distribution is 1 - exp(-d^2 / 2).
    all.push_back(distance2 ? 1.0 - std::exp(-*distance2 / 2.0) : 1.0);
  }
  std::sort(all.begin(), all.end());
  LineSpec line{"", {0.0}, {0.0}, theme.estimate, 1.5};
  if (all.empty()) line = {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    line.x.push_back(all[i]);
    line.y.push_back(static_cast<double>(i + 1) / static_cast<double>(all.size()));
  }
  if (!all.empty()) {
    line.x.push_back(1.0);
    line.y.push_back(1.0);
  }
  spec.lines.push_back(std::move(line));
  spec.lines.push_back({kExpected, {0.0, 1.0}, {0.0, 1.0}, theme.muted, 1.0});
  return spec;
}

ChartSpec sample_size_chart(const FigureRun& run, const Theme& theme) {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y = {"particles", 0.0, {}};
  spec.lines.push_back(step_line(run, "effective sample size", theme.estimate,
                                 [](const RunStep& step) { return step.effective_sample_size; }));
  spec.lines.push_back(step_line(run, "particles", theme.text, [](const RunStep& step) {
    return static_cast<double>(step.particle_count);
  }));
  spec.lines.back().is_dashed = true;
  return spec;
}

ChartSpec agreement_chart(std::span<const FigureRun> runs, const Theme& theme) {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y = share_axis("agreement");
  for (std::size_t r = 0; r < runs.size(); ++r) {
    spec.lines.push_back(
        step_line(runs[r], runs.size() == 1 ? "" : runs[r].name, run_colour(theme, r),
                  [](const RunStep& step) { return step.agreement.value_or(std::nan("")); }));
    spec.lines.back().is_dashed = is_run_dashed(r);
  }
  return spec;
}

std::optional<double> step_period_ms(const FigureRun& run) {
  if (run.steps.size() < 2) return std::nullopt;
  std::vector<double> periods_s;
  for (std::size_t i = 1; i < run.steps.size(); ++i) {
    periods_s.push_back(run.steps[i].time_s - run.steps[i - 1].time_s);
  }
  return kMsPerS * lower_median(std::move(periods_s));
}

ChartSpec timing_chart(const FigureRun& run, const Theme& theme) {
  ChartSpec spec;
  spec.x.title = "time [s]";
  spec.y = {"update time [ms]", 0.0, {}};
  spec.lines.push_back(
      step_line(run, "update", theme.text, [](const RunStep& step) { return step.update_ms; }));
  double longest_ms = 0.0;
  for (const double update_ms : spec.lines[0].y) {
    if (update_ms > longest_ms) longest_ms = update_ms;
  }
  const auto budget_ms = step_period_ms(run);
  if (budget_ms && *budget_ms <= kMostBudget * longest_ms) {
    spec.levels.push_back({"time between steps", *budget_ms, theme.bad, true});
  }
  return spec;
}

}  // namespace nadir
