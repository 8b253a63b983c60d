// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_metric_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nadir {
namespace {

constexpr double kPercentOfSteps = 100.0;

constexpr std::array<ShownMetric, 11> kShownMetrics = {{
    {"estimate_position_rmse_m", "position RMSE", "Position error [m]", "RMSE", "m",
     "Root of the mean squared distance from estimate to truth, over the steps with truth"},
    {"estimate_position_median_m", "position median", "Position error [m]", "median", "m",
     "Half of the steps with truth have a smaller position error"},
    {"estimate_position_p90_m", "position P90", "Position error [m]", "P90", "m",
     "90th percentile: nine in ten steps with truth have a smaller position error"},
    {"estimate_position_max_m", "position max", "Position error [m]", "max", "m",
     "The largest position error of a step"},
    {"estimate_orientation_rmse_rad", "heading RMSE", "Heading error [deg]", "RMSE", "deg",
     "Root of the mean squared angle between estimated and true heading, over the steps with "
     "truth"},
    {"estimate_orientation_median_rad", "heading median", "Heading error [deg]", "median", "deg",
     "Half of the steps with truth have a smaller heading error"},
    {"nees_mean", "NEES mean", "NEES, 3 if consistent", "mean", "",
     "Mean over the steps of the squared error in the filter's own sigmas (x, y and heading, 3 "
     "degrees of freedom): 3 for a consistent filter, more where it is over-confident",
     1.0, 2, 0, 3.0},
    {"coverage_95", "in 95 % ellipse", "Share of steps [%]", "in ellipse", "%",
     "Share of the steps whose true position lies inside the filter's 95 % ellipse",
     kPercentOfSteps, 1, 0, 95.0},
    {"estimate_recall_1m", "within 1 m", "Share of steps [%]", "< 1 m", "%",
     "Share of the steps with truth whose position error is below 1 m", kPercentOfSteps, 1, 1},
    {"estimate_recall_3m", "within 3 m", "Share of steps [%]", "< 3 m", "%",
     "Share of the steps with truth whose position error is below 3 m", kPercentOfSteps, 1, 1},
    {"estimate_recall_5m", "within 5 m", "Share of steps [%]", "< 5 m", "%",
     "Share of the steps with truth whose position error is below 5 m", kPercentOfSteps, 1, 1},
}};

}  // namespace

std::span<const ShownMetric> shown_metrics() { return kShownMetrics; }

std::string metric_label(const ShownMetric& metric) {
  return metric.unit.empty() ? std::string(metric.name)
                             : fmt::format("{} [{}]", metric.name, metric.unit);
}

std::string better_words(const ShownMetric& metric) {
  if (metric.better == 0) return fmt::format("nearer to {:g} is better", metric.expected);
  return metric.better < 0 ? "lower is better" : "higher is better";
}

std::string metric_digits(const ShownMetric& metric, double value) {
  return fmt::format("{:.{}f}", value * metric.factor, metric.decimals);
}

namespace {

/// How far a value is from what is expected. A ratio for NEES, where twice as large is as wrong as half as large; a difference
/// for shares.
double away_from_expected(const ShownMetric& metric, double value) {
  const double shown = value * metric.factor;
  return metric.unit.empty() ? std::abs(std::log(std::max(shown, 1e-9) / metric.expected))
                             : std::abs(shown - metric.expected);
}

}  // namespace

std::vector<std::size_t> best_runs(const ShownMetric& metric,
                                   const MetricRow& row,
                                   bool do_compete) {
  constexpr double kAsFar = 1e-9;
  const auto away = [&](double value) { return away_from_expected(metric, value); };
  if (!do_compete || (metric.better != 0 && row.best.empty())) return {};
  std::optional<double> best;
  if (metric.better != 0) best = row.values[row.best.front()];
  std::size_t known = 0;
  for (const auto& value : row.values) {
    if (!value) continue;
    ++known;
    if (metric.better == 0 && (!best || away(*value) < away(*best))) best = value;
  }
  std::vector<std::size_t> all;
  for (std::size_t i = 0; known >= 2 && i < row.values.size(); ++i) {
    const auto& value = row.values[i];
    if (!value) continue;
    const bool shows_same = metric_digits(metric, *value) == metric_digits(metric, *best);
    const bool is_as_far = metric.better == 0 && away(*value) - away(*best) < kAsFar;
    if (shows_same || is_as_far) all.push_back(i);
  }
  return all;
}

}  // namespace nadir
