// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/run/run_file.h"

namespace nadir::detail {

/// What the values of a run file must be, said once for who writes one and for who reads one: a run
/// that was written can be read.

inline constexpr double kLargestLatitudeDeg = 90.0, kLargestLongitudeDeg = 180.0;
inline constexpr const char* kNoCount = "not a whole number from 0 to 2147483647";

/// A value that a run cannot hold.
struct RunFault {
  std::optional<int> column;  ///< In kStepColumns or kModeColumns; none: the row as a whole.
  double value = 0.0;
  const char* what =
      "";  ///< "not a finite number", which follows the value; or all of the sentence.
};

/// The first value in the order of the columns that the row of this step in table `step` cannot hold:
/// times and poses are finite, places within 10^8 m of the plane's origin (twice around the Earth),
/// shares in [0, 1], amounts and counts not negative. Covariances may be NaN or infinite, which is "not
/// known"; what is known must be variances that are not negative and correlations of at most 1 (to
/// 1e-6, for a filter that has collapsed rounds).
[[nodiscard]] std::optional<RunFault> fault_of(const RunStep& step);

/// The same of a row of table `mode`.
[[nodiscard]] std::optional<RunFault> fault_of(const PoseMode& mode);

/// "estimate_x_m is nan, not a finite number". @param columns  kStepColumns or kModeColumns.
[[nodiscard]] std::string fault_text(const RunFault& fault, std::string_view columns);

}  // namespace nadir::detail
