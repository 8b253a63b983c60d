// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "core/eval/run_evaluation.h"

namespace nadir {

/// Tables for people, one a run: odometry and estimate side by side with their ratio (estimate /
/// odometry, below 1 where the localiser helped), numbers aligned at the decimal point, units,
/// alignment, matched pairs and dropped steps. UTF-8 free.
[[nodiscard]] std::string report_as_text(std::span<const RunEvaluation> evaluations);

/// One JSON object `{"runs": [...]}` with SI units in the key names; unknown values are null, never
/// left out. Numbers are the shortest decimals that give the same double again. Holds nothing that
/// depends on the machine or on its speed, so the same seed gives the same bytes. Ends with a line
/// feed.
[[nodiscard]] std::string report_as_json(std::span<const RunEvaluation> evaluations);

/// A header line and one line a run, RFC 4180, with the keys of the JSON joined by '_'
/// ("estimate_position_rmse_m"), then the mean computing time. Unknown values are empty.
[[nodiscard]] std::string report_as_csv(std::span<const RunEvaluation> evaluations);

}  // namespace nadir
