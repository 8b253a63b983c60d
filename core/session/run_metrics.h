// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/run_comparison.h"

namespace nadir::detail {

/// The table of a comparison: every number of `nadir evaluate`, in its order, one value a run.
/// @param is_same_flight  Whether there is a best one.
[[nodiscard]] std::vector<MetricRow> metric_rows(RunDocuments runs, bool is_same_flight);

}  // namespace nadir::detail
