// SPDX-License-Identifier: Apache-2.0
#include "core/session/run_metrics.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/angle.h"
#include "core/eval/report_keys.h"

namespace nadir::detail {
namespace {

constexpr double kDegrees = Angle::radians(1.0).degrees();

/// How people read an error of detail::kErrorKeys.
struct ErrorLabel {
  std::string_view label, unit;
  double factor = 1.0;
  int better = -1;
};

/// In the order of detail::kErrorKeys.
constexpr std::array<ErrorLabel, kErrorKeys.size()> kErrorLabels = {{
    {"position MSE", "m^2"},
    {"position RMSE", "m"},
    {"position mean", "m"},
    {"position median", "m"},
    {"position 90th percentile", "m"},
    {"position maximum", "m"},
    {"heading MSE", "deg^2", kDegrees* kDegrees},
    {"heading median", "deg", kDegrees},
    {"heading 90th percentile", "deg", kDegrees},
    {"within 1 m", "", 1.0, 1},
    {"within 3 m", "", 1.0, 1},
    {"within 5 m", "", 1.0, 1},
    {"heading RMSE", "deg", kDegrees},
    {"heading mean", "deg", kDegrees},
    {"heading maximum", "deg", kDegrees},
    {"lateral RMSE", "m"},
    {"lateral median", "m"},
    {"lateral 90th percentile", "m"},
    {"longitudinal RMSE", "m"},
    {"longitudinal median", "m"},
    {"longitudinal 90th percentile", "m"},
    {"relative error over", "m", 1.0, 0},
    {"relative position", "m/m"},
    {"relative heading", "deg/m", kDegrees},
}};

/// One number that is not in detail::kErrorKeys.
struct FactKey {
  std::string_view key, label, unit;
  int better;
  std::optional<double> (*value)(const RunEvaluation& evaluation);
};

template <typename Count>
std::optional<double> counted(Count count) {
  return static_cast<double>(count);
}

using E = RunEvaluation;
constexpr std::array<FactKey, 3> kCounts = {{
    {"steps", "steps", "", 0, [](const E& e) { return counted(e.steps); }},
    {"matched_pairs", "matched pairs", "", 0, [](const E& e) { return counted(e.matched_pairs); }},
    {"dropped_steps", "dropped steps", "", 0, [](const E& e) { return counted(e.dropped_steps); }},
}};
constexpr std::array<FactKey, 15> kFacts = {{
    {"nees_mean", "NEES mean", "", 0, [](const E& e) { return e.consistency.nees_mean; }},
    {"nees_lower_95", "NEES lower bound", "", 0,
     [](const E& e) { return e.consistency.nees_lower_95; }},
    {"nees_upper_95", "NEES upper bound", "", 0,
     [](const E& e) { return e.consistency.nees_upper_95; }},
    {"coverage_95", "inside the 95 % ellipse", "", 0,
     [](const E& e) { return e.consistency.coverage_95; }},
    {"converged_after_s", "converged after", "s", -1,
     [](const E& e) { return e.convergence.after_s; }},
    {"converged_after_m", "converged after", "m", -1,
     [](const E& e) { return e.convergence.after_m; }},
    {"lost_stretches", "times lost", "", -1,
     [](const E& e) { return counted(e.convergence.lost_stretches); }},
    {"lost_m", "lost for", "m", -1, [](const E& e) { return counted(e.convergence.lost_m); }},
    {"duration_s", "duration", "s", 0, [](const E& e) { return counted(e.duration_s); }},
    {"distance_m", "distance", "m", 0,
     [](const E& e) {
       return e.matched_pairs > 0 ? counted(e.distance_m) : std::optional<double>();
     }},
    {"update_rate_hz", "update rate", "Hz", 0, [](const E& e) { return e.update_rate_hz; }},
    {"computing_ms_mean", "computing time an update", "ms", -1,
     [](const E& e) { return e.computing_ms_mean; }},
    {"nees_steps", "steps with NEES", "", 0,
     [](const E& e) { return counted(e.consistency.nees_steps); }},
    {"nees_excluded_steps", "steps without NEES", "", 0,
     [](const E& e) { return counted(e.consistency.excluded_steps); }},
    {"coverage_steps", "steps with an ellipse", "", 0,
     [](const E& e) { return counted(e.consistency.coverage_steps); }},
}};

std::optional<double> if_finite(std::optional<double> value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// The best of the known values, and those that differ from it by rounding only; empty where there is nothing to compare.
std::vector<std::size_t> best_of(const MetricRow& row) {
  constexpr double kRounding = 1e-9;  // of the value
  if (row.better == 0) return {};
  std::optional<double> best;
  std::size_t known = 0;
  for (const auto& value : row.values) {
    if (!value) continue;
    ++known;
    if (!best || row.better * (*value - *best) > 0.0) best = value;
  }
  std::vector<std::size_t> all;
  for (std::size_t i = 0; known >= 2 && i < row.values.size(); ++i) {
    const auto& value = row.values[i];
    if (value && std::abs(*value - *best) <= kRounding * std::abs(*best)) all.push_back(i);
  }
  return all;
}

}  // namespace

std::vector<MetricRow> metric_rows(const std::vector<RunEvaluation>& evaluations, bool do_compete) {
  std::vector<MetricRow> rows;
  const auto add = [&](MetricRow row, const auto& value) {
    for (const RunEvaluation& run : evaluations) row.values.push_back(if_finite(value(run)));
    if (do_compete) row.best = best_of(row);
    rows.push_back(std::move(row));
  };
  const auto add_facts = [&](const auto& facts) {
    for (const FactKey& fact : facts) {
      add({std::string(fact.key), std::string(fact.label), std::string(fact.unit), {}, fact.better},
          fact.value);
    }
  };
  const auto add_errors = [&](const std::string& prefix, const std::string& whose, bool competes,
                              std::optional<PoseErrorSummary> RunEvaluation::*part) {
    for (std::size_t i = 0; i < kErrorKeys.size(); ++i) {
      const ErrorLabel& label = kErrorLabels.at(i);
      add({prefix + std::string(kErrorKeys.at(i).key),
           whose + std::string(label.label),
           std::string(label.unit),
           {},
           competes ? label.better : 0},
          [&](const RunEvaluation& evaluation) -> std::optional<double> {
            const auto& summary = evaluation.*part;
            if (!summary) return std::nullopt;
            return label.factor * kErrorKeys.at(i).value(*summary);
          });
    }
  };
  add_facts(kCounts);
  add_errors("estimate_", "", true, &RunEvaluation::estimate);
  add_errors("odometry_", "odometry: ", false, &RunEvaluation::odometry);
  add_facts(kFacts);
  return rows;
}

}  // namespace nadir::detail
