// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/session/worst_moments.h"
#include "tests/core/session/made_run.h"

namespace nadir {

/// Whether a step's number is in [first, last].
[[nodiscard]] inline bool is_within(const RunStep& step, int first, int last) {
  return step.step >= first && step.step <= last;
}

[[nodiscard]] inline std::vector<WorstMoment> of_kind(const RunDocument& run, MomentKind kind) {
  std::vector<WorstMoment> moments;
  for (const WorstMoment& moment : run.worst_moments) {
    if (moment.kind == kind) moments.push_back(moment);
  }
  return moments;
}

}  // namespace nadir
