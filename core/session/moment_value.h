// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/session/run_document.h"

namespace nadir {

/// The one number that a moment of worst_moments.h is about, for lists.
struct MomentValue {
  std::string digits;  ///< As many as are known; "–" where there is none.
  std::string unit;    ///< "m", "%", "s"; empty for NEES, which has none.
};

/// Largest error: the position error. Over-confident: the NEES. Low agreement: the agreement. Lost: the largest position error
/// (without truth the largest spread) of the episode. Found: the same at the step. Missing data: how long.
/// @param moment  Of this run.
[[nodiscard]] MomentValue moment_value(const RunDocument& run, const WorstMoment& moment);

}  // namespace nadir
