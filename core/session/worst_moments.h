// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/field.h"

namespace nadir {

struct RunDocument;

/// What was wrong, or right again, at a moment worth a look.
enum class MomentKind {
  kLargestError,   ///< The estimate was far from the truth.
  kOverConfident,  ///< The truth was farther away than the filter held possible.
  kLowAgreement,   ///< What was seen did not fit the map.
  kLost,           ///< The estimate was good and is no more.
  kFound,          ///< It is good again, or for the first time.
  kMissingData,    ///< No step for a while, or nothing was seen.
};

template <>
struct EnumNames<MomentKind> {
  static constexpr std::array<std::string_view, 6> kNames = {
      "largest error", "over-confident", "low agreement", "lost", "found", "missing data"};
};

/// One moment of a run that stands for an episode.
struct WorstMoment {
  std::size_t step = 0;  ///< Index in RunDocument::steps.
  double time_s = 0.0;   ///< Of the step, after the run's first.
  MomentKind kind = MomentKind::kLargestError;
  /// How many times its limit, so 1 is just worth a look; comparable between kinds, roughly. The square root of that for
  /// NEES and durations. Below 1 where a run's largest error is small.
  double severity = 0.0;
  std::string words;                ///< "2.8 m off, 95 % ellipse 0.9 m"
  double from_s = 0.0, to_s = 0.0;  ///< The episode, after the run's first step; holds time_s.
  /// The estimate was as near to the truth at the step as MomentVerdict::kFound asks: worth a look, but not wrong.
  bool is_near_truth = false;
};

/// When something is worth a look. A stretch of steps beyond a limit is an episode; stretches of one kind less than
/// `merged_within_s` apart are one. An episode gives one moment, where it is worst.
struct WorstMomentRule {
  /// Position errors: beyond both of these, the second in units of the run's median. The largest of a run always counts.
  double error_from_m = 1.0;
  double error_from_medians = 2.5;
  /// Over-confident: NEES above the chi-square quantile (3 degrees of freedom) of this probability.
  double nees_probability = 0.999;
  /// Low agreement: below the run's median by both of these, the second in standard deviations, which are estimated from
  /// the median deviation.
  double agreement_drop = 0.1;
  double agreement_sigmas = 4.0;
  /// Lost and found by ConvergenceRule's own limits; without truth the square root of position_spread_m2() rises to the one
  /// and falls below the other.
  double lost_from_sigma_m = 5.0;
  double found_below_sigma_m = 1.5;
  double found_after_s = 2.0;  ///< A run that is found earlier than this began as runs do.
  /// Missing data: no step for more than so many median periods (time_gaps()), or topviews without any cell for so long in
  /// a run that has some.
  double gap_from_periods = 5.0;
  double unseen_for_s = 1.0;
  double merged_within_s = 3.0;
  /// Errors, over-confidence and low agreement whose worst steps are closer than this are one moment: the run's largest
  /// error, or else the most severe.
  double same_moment_within_s = 1.0;
  std::size_t most_of_a_kind = 12;  ///< The most severe ones stay.
};

/// The moments of a run in order of time, then of kind. Works without truth, where agreement, covariance and gaps
/// remain; a run that began lost has a first kFound. Reads `steps`, `series`, `errors`, `judged` and `time_s` of the run.
/// O(n log n).
[[nodiscard]] std::vector<WorstMoment> find_worst_moments(const RunDocument& run,
                                                          const WorstMomentRule& rule = {});

/// The first moment after a time, and the last one before it; null where there is none. A moment at the very time (to a
/// microsecond) is passed over, so asking again goes on. @param moments  In order of time.
[[nodiscard]] const WorstMoment* next_moment(std::span<const WorstMoment> moments, double time_s);
[[nodiscard]] const WorstMoment* previous_moment(std::span<const WorstMoment> moments,
                                                 double time_s);

/// The most severe one; null where there are none. Of several the first.
[[nodiscard]] const WorstMoment* most_severe(std::span<const WorstMoment> moments);

}  // namespace nadir
