// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/session/worst_moments.h"

namespace nadir::detail {

/// A stretch of steps beyond a limit. Indices of steps.
struct Episode {
  std::size_t first = 0, last = 0;  ///< Both inside.
  std::size_t peak = 0;             ///< The worst step, of several the first.
  double severity = 0.0;            ///< There.
};

/// The episodes of a run. Stretches less than `merged_within_s` apart, from the last step of one to the first of the next,
/// are one.
/// @param severity  Of a step: how many times its limit; NaN, where nobody knows, is not beyond it.
[[nodiscard]] std::vector<Episode> find_episodes(
    const std::vector<double>& time_s,
    double merged_within_s,
    const std::function<double(std::size_t step)>& severity);

/// The moment of an episode's peak.
[[nodiscard]] WorstMoment moment_of(const RunDocument& run,
                                    const Episode& episode,
                                    MomentKind kind,
                                    std::string words);

/// "0.12 m", "2.8 m", "134 m".
[[nodiscard]] std::string length_words(double length_m);
/// "0.4 s", "12.3 s", "2 min 5 s".
[[nodiscard]] std::string duration_words(double duration_s);

/// "2.8 m off, 95 % ellipse 0.9 m": how far the estimate of a step is from the truth and how far the filter held possible in
/// that direction; without the second where the ellipse is singular or not known. Empty without truth.
[[nodiscard]] std::string error_words(const RunDocument& run, std::size_t step);
/// "heading 7.5 deg off, 95 % within 2.1 deg". Empty without truth or variance.
[[nodiscard]] std::string heading_words(const RunDocument& run, std::size_t step);
/// Whether the heading of a step is farther out, in standard deviations of its 95 % bounds, than the position.
[[nodiscard]] bool is_heading_worse(const RunDocument& run, std::size_t step);

}  // namespace nadir::detail
