// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "core/session/worst_moments.h"

namespace nadir::detail {

/// Where a run was lost and where it was found, all of them: by the truth and ConvergenceRule, or without truth by the
/// spread and `rule`. A first find before `rule.found_after_s` is none.
[[nodiscard]] std::array<std::vector<WorstMoment>, 2> tracking_moments(const RunDocument& run,
                                                                       const WorstMomentRule& rule);

}  // namespace nadir::detail
