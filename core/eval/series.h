// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/eval/evaluated_step.h"

namespace nadir {

/// The numbers behind the charts of a run: element i of every array belongs to the i-th step whose
/// truth is known. NaN where a number is not known, which breaks a line and is no point.
struct ErrorSeries {
  std::vector<std::size_t>
      step;                    ///< Index of the step; more than one apart where truth is missing.
  std::vector<double> time_s;  ///< Since the first step of all, with truth or without.
  std::vector<double> x_error_m, y_error_m;  ///< Estimate minus truth, east and north in enu.
  std::vector<double> yaw_error_rad;         ///< Estimate minus truth, in (-pi, pi].
  std::vector<double> position_error_m;      ///< Distance in the plane.
  std::vector<double> x_sigma_m, y_sigma_m, yaw_sigma_rad;  ///< Roots of the variances.
  std::vector<double> nees;        ///< As in Consistency; NaN where the covariance gives none.
  std::vector<bool> is_inside_95;  ///< True position inside the 95 % ellipse; a singular one has no
                                   ///< inside. Its mean where is_ellipse_known is
                                   ///< Consistency::coverage_95.
  std::vector<bool> is_ellipse_known;  ///< Whether the step has a covariance of the position.

  [[nodiscard]] std::size_t size() const { return time_s.size(); }
};

/// @param steps  In order of time. Poses need not be finite. O(n).
[[nodiscard]] ErrorSeries error_series(std::span<const EvaluatedStep> steps);

/// The middle one of some values; of an even number the lower one in the middle, so that a distance which half of all
/// have is the usual one. @param values  At least one, none NaN. O(n).
[[nodiscard]] double lower_median(std::vector<double> values);

/// Where a line through points at these times has to break: every i whose distance from i - 1 is more than so many times
/// the median distance. Ascending. @param time_s  Never falling. O(n).
[[nodiscard]] std::vector<std::size_t> time_gaps(std::span<const double> time_s,
                                                 double most_periods = 5.0);

/// The same of a series, and every i that has more steps without truth before it than usual: whose distance from i - 1, in
/// steps, is more than 1.5 times the median one. So truth at a lower rate than the estimate, evenly or nearly so, makes one
/// line, and of truth at every step a single one that is missing breaks it.
[[nodiscard]] std::vector<std::size_t> gaps_of(const ErrorSeries& series);

/// The values with a NaN put before those of the given indices, which breaks a line or band there.
/// @param gaps  Ascending, each below the number of values.
[[nodiscard]] std::vector<double> broken_at(std::span<const std::size_t> gaps,
                                            std::span<const double> values);

/// How large a share of some values is at most so large.
struct CumulativeDistribution {
  std::vector<double> value;  ///< Rising.
  std::vector<double> share;  ///< (i + 1) / n beside the i-th value, so the last is 1.
};

/// Sorts the values. NaN is left out and does not count into n; signs stay, so the caller takes the
/// absolute values of errors. O(n log n).
[[nodiscard]] CumulativeDistribution cumulative_distribution(std::vector<double> values);

/// The points of a line, in order.
struct PointLine {
  std::vector<double> x, y;
};

/// A line with fewer points that looks the same where it is drawn `buckets` pixels wide.
///
/// [x.front(), x.back()] is cut into `buckets` intervals of equal width; of the points in one, the
/// lowest and the highest stay (the first of several), in order of x. A y that is not finite breaks
/// the line. Each piece keeps its first and its last point, so gaps are as wide as before; between
/// two pieces there is one point whose y is NaN, and breaks before the first and after the last
/// piece, which draw nothing, are left out. A line of at most 2 buckets points keeps all that are
/// finite. No more than 2 buckets + 5 pieces - 3 points stay. O(n).
///
/// @param x        Finite and never falling.
/// @param y        As many.
/// @param buckets  At least 1.
[[nodiscard]] PointLine decimate_min_max(std::span<const double> x,
                                         std::span<const double> y,
                                         std::size_t buckets);

}  // namespace nadir
