// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/run_comparison.h"

namespace nadir {

/// A number of `nadir evaluate` that the runs panel has room for.
struct ShownMetric {
  std::string_view key;        ///< As in RunComparison::metrics.
  std::string_view name;       ///< Quantity and statistic: "heading median".
  std::string_view group;      ///< Heading of those that follow each other: "Heading error [deg]".
  std::string_view statistic;  ///< What tells it from the others there: "median".
  std::string_view unit;       ///< Shown; empty: none.
  std::string_view help;       ///< How it is made, a sentence without a full stop.
  double factor = 1.0;         ///< From the comparison's unit to the shown one.
  int decimals = 2;
  int better = -1;  ///< -1 lower, 1 higher, 0 nearer to `expected`.
  double expected = 0.0;
};
[[nodiscard]] std::span<const ShownMetric> shown_metrics();

/// "heading median [deg]".
[[nodiscard]] std::string metric_label(const ShownMetric& metric);
/// "lower is better", "nearer to 95 is better".
[[nodiscard]] std::string better_words(const ShownMetric& metric);

/// A value as the table shows it: "0.79", "87.5".
[[nodiscard]] std::string metric_digits(const ShownMetric& metric, double value);

/// Which runs are the best by a metric: that one, and those that show the same digits or are as far from what is expected.
/// Empty where fewer than two are known, or they do not compete.
[[nodiscard]] std::vector<std::size_t> best_runs(const ShownMetric& metric,
                                                 const MetricRow& row,
                                                 bool do_compete);

}  // namespace nadir
