// SPDX-License-Identifier: Apache-2.0
#include "core/session/moment_tracking.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "core/eval/convergence.h"
#include "core/session/moment_episodes.h"
#include "core/session/run_document.h"

namespace nadir::detail {
namespace {

/// What tells being lost, by step.
struct LostMeasure {
  std::vector<double> metres;  ///< NaN where not known.
  double limit_m = 0.0;        ///< From here on lost.
  const char* what = "";       ///< "off"
};

LostMeasure measure_by_truth(const RunDocument& run, const ConvergenceRule& limits) {
  LostMeasure measure{{}, limits.lost_from_m, "off"};
  measure.metres.assign(run.steps.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < run.errors.size(); ++i) {
    measure.metres[run.errors.step[i]] = run.errors.position_error_m[i];
  }
  return measure;
}

/// Found below the one limit, lost from the other on; unknown spreads say nothing.
std::vector<TrackingChange> changes_by_spread(const std::vector<double>& sigma_m,
                                              const WorstMomentRule& rule) {
  std::vector<TrackingChange> changes;
  bool is_found = false;
  for (std::size_t i = 0; i < sigma_m.size(); ++i) {
    const bool changes_now =
        is_found ? sigma_m[i] >= rule.lost_from_sigma_m : sigma_m[i] < rule.found_below_sigma_m;
    if (!changes_now) continue;
    is_found = !is_found;
    changes.push_back({i, is_found});
  }
  return changes;
}

/// @param until  The step that is found again; nothing where none is.
WorstMoment lost_moment(const RunDocument& run,
                        const LostMeasure& measure,
                        std::size_t step,
                        std::optional<std::size_t> until) {
  const std::size_t last = until.value_or(run.steps.size() - 1);
  double largest_m = 0.0;
  for (std::size_t i = step; i <= last; ++i) {
    if (measure.metres[i] > largest_m) largest_m = measure.metres[i];
  }
  const std::string end = until ? fmt::format("found again {} later",
                                              duration_words(run.time_s[last] - run.time_s[step]))
                                : "not found again";
  return moment_of(run, {step, last, step, largest_m / measure.limit_m}, MomentKind::kLost,
                   fmt::format("lost: {} {}, up to {}, {}", length_words(measure.metres[step]),
                               measure.what, length_words(largest_m), end));
}

/// @param since  The step that was lost; nothing where it had never been found.
WorstMoment found_moment(const RunDocument& run,
                         std::size_t step,
                         std::optional<std::size_t> since) {
  const double lost_s = run.time_s[step] - (since ? run.time_s[*since] : 0.0);
  return moment_of(run, {step, step, step, 1.0}, MomentKind::kFound,
                   since ? fmt::format("found again after {}", duration_words(lost_s))
                         : fmt::format("found {} after the start", duration_words(lost_s)));
}

}  // namespace

std::array<std::vector<WorstMoment>, 2> tracking_moments(const RunDocument& run,
                                                         const WorstMomentRule& rule) {
  const ConvergenceRule limits;
  const LostMeasure measure = run.has_truth() ? measure_by_truth(run, limits)
                                              : LostMeasure{run.series.position_sigma_m,
                                                            rule.lost_from_sigma_m, "of spread"};
  const std::vector<TrackingChange> changes =
      run.has_truth() ? find_tracking_changes(run.judged, limits)
                      : changes_by_spread(run.series.position_sigma_m, rule);
  std::vector<WorstMoment> lost;
  std::vector<WorstMoment> found;
  std::optional<std::size_t> before;
  for (std::size_t c = 0; c < changes.size(); ++c) {
    const std::size_t step = changes[c].step;
    if (!changes[c].is_found) {
      const bool is_found_again = c + 1 < changes.size();
      lost.push_back(lost_moment(
          run, measure, step, is_found_again ? std::optional(changes[c + 1].step) : std::nullopt));
    } else if (before || run.time_s[step] >= rule.found_after_s) {
      found.push_back(found_moment(run, step, before));
    }
    before = step;
  }
  return {std::move(lost), std::move(found)};
}

}  // namespace nadir::detail
