// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/geo/rigid2.h"

namespace nadir {

/// What was said and what was true at one moment; both `enu_from_body`.
struct PosePair {
  double time_s = 0.0;
  Rigid2 estimate_in_enu;
  Rigid2 truth_in_enu;
};

/// Estimate minus truth: x, y (m, east and north in enu), yaw wrapped into (-pi, pi] (rad). NaN where
/// a pose is.
[[nodiscard]] Eigen::Vector3d pose_error(const Rigid2& estimate_in_enu, const Rigid2& truth_in_enu);

/// Statistics of the size |e| of one kind of error, in the unit of the error (mean_square: its
/// square).
struct ErrorStatistics {
  double mean_square = 0.0;
  double root_mean_square = 0.0;
  double mean = 0.0;
  double median = 0.0;
  double p90 = 0.0;  ///< 90th percentile, see order_statistic().
  double maximum = 0.0;
};

/// Drift: error of the motion over a stretch of the true path, per metre of that stretch, averaged
/// over all stretches. A stretch begins at every pair and ends at the first pair at least
/// `segment_m` of true path later. The length is the longest of 100, 50 and 10 m that fits into the
/// true path at least twice.
struct RelativeError {
  double segment_m = 0.0;
  std::size_t segments = 0;
  double position_m_per_m = 0.0;
  double orientation_rad_per_m = 0.0;
};

/// Errors of one trajectory against the truth.
struct PoseErrorSummary {
  std::size_t matched_pairs = 0;
  ErrorStatistics position_m;       ///< Distance in the plane.
  ErrorStatistics orientation_rad;  ///< Wrapped, in [0, pi].
  ErrorStatistics longitudinal_m;   ///< Along the true heading.
  ErrorStatistics lateral_m;        ///< Across the true heading.
  double recall_1m = 0.0;           ///< Share of pairs whose position error is at most 1 m.
  double recall_3m = 0.0;
  double recall_5m = 0.0;
  std::optional<RelativeError> relative;  ///< Absent where the true path is shorter than 20 m.
};

/// Value below which `share` of the sorted values lie, linear between neighbours: position share *
/// (n - 1), as in Hyndman & Fan 1996, type 7 (the default of NumPy and R). The median of an even
/// number is the mean of the middle two.
/// @param sorted  Rising, not empty.   @param share  In [0, 1].
[[nodiscard]] double order_statistic(std::span<const double> sorted, double share);

/// @param errors  Not empty; the sign does not matter. O(n log n).
[[nodiscard]] ErrorStatistics summarise_errors(std::vector<double> errors);

/// Length of the true path from the first pair to each pair, metres. Same length as `pairs`.
[[nodiscard]] std::vector<double> travelled_m(std::span<const PosePair> pairs);

/// @param pairs  In order of time, finite. @returns nothing where there are no pairs.
[[nodiscard]] std::optional<PoseErrorSummary> summarise_pose_errors(
    std::span<const PosePair> pairs);

}  // namespace nadir
