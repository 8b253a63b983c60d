// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/run/run_file.h"
#include "core/session/view_state.h"

namespace nadir {

/// The body's pose in enu at a step, as one source has it. Nothing where that is not known; need not be finite.
[[nodiscard]] inline std::optional<Rigid2> pose_of(const RunStep& step, PoseSource source) {
  if (source == PoseSource::kTruth) return step.truth_in_enu;
  if (source == PoseSource::kOdometry) return step.odometry_in_enu;
  return step.estimate.moments.mean;
}

}  // namespace nadir
