// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>
#include <vector>

#include "core/eval/report.h"
#include "core/eval/report_keys.h"

namespace nadir {
namespace {

using Cells = std::vector<std::pair<std::string, std::string>>;  // Column name and value.

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char letter : text) {
    if (letter == '"') result += '"';
    result += letter;
  }
  return result + "\"";
}

std::string number(std::optional<double> value) {
  return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
}

void append_errors(Cells& cells,
                   const std::string& prefix,
                   const std::optional<PoseErrorSummary>& summary) {
  for (const detail::ErrorKey& entry : detail::kErrorKeys) {
    cells.emplace_back(prefix + std::string(entry.key),
                       summary ? number(entry.value(*summary)) : std::string());
  }
}

Cells cells_of(const RunEvaluation& e) {
  Cells cells = {{"run", quoted(e.run)},
                 {"flight", quoted(e.flight)},
                 {"map", quoted(e.map)},
                 {"preset", quoted(e.preset)},
                 {"seed", std::to_string(e.seed)},
                 {"steps", std::to_string(e.steps)},
                 {"matched_pairs", std::to_string(e.matched_pairs)},
                 {"dropped_steps", std::to_string(e.dropped_steps)},
                 {"is_complete", e.is_complete ? "true" : "false"},
                 {"alignment", std::string(enum_name(e.alignment))}};
  append_errors(cells, "estimate_", e.estimate);
  append_errors(cells, "odometry_", e.odometry);
  cells.emplace_back("nees_mean", number(e.consistency.nees_mean));
  cells.emplace_back("nees_lower_95", number(e.consistency.nees_lower_95));
  cells.emplace_back("nees_upper_95", number(e.consistency.nees_upper_95));
  cells.emplace_back("coverage_95", number(e.consistency.coverage_95));
  cells.emplace_back("converged_after_s", number(e.convergence.after_s));
  cells.emplace_back("converged_after_m", number(e.convergence.after_m));
  cells.emplace_back("lost_stretches", std::to_string(e.convergence.lost_stretches));
  cells.emplace_back("lost_m", number(e.convergence.lost_m));
  cells.emplace_back("duration_s", number(e.duration_s));
  cells.emplace_back("distance_m", e.matched_pairs > 0 ? number(e.distance_m) : std::string());
  cells.emplace_back("update_rate_hz", number(e.update_rate_hz));
  cells.emplace_back("computing_ms_mean", number(e.computing_ms_mean));
  cells.emplace_back("nees_steps", std::to_string(e.consistency.nees_steps));
  cells.emplace_back("nees_excluded_steps", std::to_string(e.consistency.excluded_steps));
  cells.emplace_back("coverage_steps", std::to_string(e.consistency.coverage_steps));
  return cells;
}

std::string line(const Cells& cells, std::string Cells::value_type::*part) {
  std::string text;
  for (const auto& cell : cells) text += (text.empty() ? "" : ",") + cell.*part;
  return text + "\n";
}

}  // namespace

std::string report_as_csv(std::span<const RunEvaluation> evaluations) {
  std::string text = line(cells_of(RunEvaluation{}), &Cells::value_type::first);
  for (const RunEvaluation& evaluation : evaluations) {
    text += line(cells_of(evaluation), &Cells::value_type::second);
  }
  return text;
}

}  // namespace nadir
