// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/eval/consistency.h"
#include "core/eval/convergence.h"
#include "core/eval/evaluated_step.h"
#include "core/eval/trajectory_error.h"
#include "core/geo/similarity2.h"

namespace nadir {

/// Whether a trajectory is laid onto the truth by least squares of its positions before it is
/// judged. A localiser on a map must not be: alignment hides the very error under test.
enum class Alignment { kNone, kSe2, kSim2 };

template <>
struct EnumNames<Alignment> {
  static constexpr std::array<std::string_view, 3> kNames = {"none", "se2", "sim2"};
};

[[nodiscard]] std::optional<Alignment> alignment_from_name(std::string_view name);

/// One run of a localiser, judged. Text fields come from the run and are for people.
struct RunEvaluation {
  std::string run, flight, map, preset;
  std::uint64_t seed = 0;
  bool is_complete = true;  ///< False: killed or stopped before the end of the flight.
  std::size_t steps = 0;
  std::size_t matched_pairs = 0;  ///< Steps whose truth is known.
  std::size_t dropped_steps = 0;  ///< The others, and those with a pose that is not finite.
  double duration_s = 0.0;        ///< From the first step to the last.
  double distance_m = 0.0;        ///< Length of the true path.
  Alignment alignment = Alignment::kNone;
  Similarity2 estimate_alignment,
      odometry_alignment;  ///< enu_from_estimate and enu_from_odometry as applied.
  std::optional<PoseErrorSummary> estimate, odometry;  ///< Absent without truth.
  Consistency consistency;  ///< Of the estimate; the covariance is aligned with it.
  Convergence convergence;  ///< Of the estimate, by the default ConvergenceRule.
  std::optional<double>
      update_rate_hz;  ///< Updates per second of flight time; nothing for fewer than two steps.
  std::optional<double> computing_ms_mean;  ///< Computing time an update: differs from run to run,
                                            ///< so not in the JSON.
};

/// Judges estimate and odometry of a run; each is aligned on its own. Fills all fields but the
/// texts, seed and is_complete.
/// @param steps  In order of time.
/// @errors kMalformed: asked to align, but fewer than two pairs or all of them at one place.
/// Nothing fails with kNone.
[[nodiscard]] Result<RunEvaluation> evaluate_steps(std::span<const EvaluatedStep> steps,
                                                   Alignment alignment = Alignment::kNone);

}  // namespace nadir
