// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

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

/// Which run is the best by a metric; nothing where several are, or fewer than two are known, or they do not compete.
[[nodiscard]] std::optional<std::size_t> best_run(const ShownMetric& metric,
                                                  const MetricRow& row,
                                                  bool do_compete);

}  // namespace nadir
