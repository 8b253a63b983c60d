// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/run_comparison.h"

namespace nadir::detail {

/// The table of a comparison: every number of `nadir evaluate`, in its order, one value a run.
/// @param do_compete  Whether there is a best one.
[[nodiscard]] std::vector<MetricRow> metric_rows(const std::vector<RunEvaluation>& evaluations,
                                                 bool do_compete);

}  // namespace nadir::detail
