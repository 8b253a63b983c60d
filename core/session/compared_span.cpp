// SPDX-License-Identifier: Apache-2.0
#include "core/session/compared_span.h"

#include <algorithm>
#include <limits>

#include "core/session/run_comparison.h"

namespace nadir {
namespace {

/// The recording's clock where a run does not say anything any more.
double covered_until_s(const RunDocument& run) {
  // Of a run that was cut off, the next step that another run has is not covered, however its frames jitter.
  const double periods = run.is_complete ? 1.0 : 0.5;
  return run.clock_s(run.duration_s()) + std::max(periods * run.median_period_s, 2.0 * kSameTimeS);
}

/// Places of the first step within two times of the recording's clock, and of the one behind the last.
std::pair<std::size_t, std::size_t> steps_within(const RunDocument& run,
                                                 double from_clock_s,
                                                 double until_clock_s) {
  const auto place = [&](double clock_s) {
    const auto at = std::lower_bound(run.time_s.begin(), run.time_s.end(),
                                     clock_s - kSameTimeS - run.start_clock_s);
    return static_cast<std::size_t>(at - run.time_s.begin());
  };
  const std::size_t begin = place(from_clock_s);
  return {begin, std::max(begin, place(until_clock_s))};
}

/// What of the recording's clock all runs cover; from the first to before the second.
struct ClockSpan {
  double from_s = -std::numeric_limits<double>::infinity();
  double until_s = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> begins_last, ends_first, first;
};

ClockSpan shared_clock(RunDocuments runs) {
  ClockSpan shared;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i]->steps.empty()) continue;
    if (!shared.first) shared.first = i;
    if (runs[i]->start_clock_s > shared.from_s) {
      shared.from_s = runs[i]->start_clock_s;
      shared.begins_last = i;
    }
    if (const double until_s = covered_until_s(*runs[i]); until_s < shared.until_s) {
      shared.until_s = until_s;
      shared.ends_first = i;
    }
  }
  return shared;
}

}  // namespace

ComparedSpan compared_span(RunDocuments runs) {
  ComparedSpan span;
  span.is_whole.assign(runs.size(), true);
  const ClockSpan shared = shared_clock(runs);
  if (!shared.first) return span;
  const RunDocument& first = *runs[*shared.first];
  const bool is_same_flight = std::all_of(runs.begin(), runs.end(), [&](const auto& run) {
    return are_of_same_flight(first.header, run->header);
  });
  span.is_shared = is_same_flight && shared.from_s < shared.until_s;
  span.to_s = first.duration_s();
  if (!span.is_shared) return span;
  bool is_cut_before = false, is_cut_behind = false;
  span.from_s = std::numeric_limits<double>::infinity();
  span.to_s = -span.from_s;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunDocument& run = *runs[i];
    const auto [begin, end] = steps_within(run, shared.from_s, shared.until_s);
    is_cut_before = is_cut_before || begin > 0;
    is_cut_behind = is_cut_behind || end < run.steps.size();
    span.is_whole[i] = begin == 0 && end == run.steps.size();
    if (begin == end) continue;
    span.from_s = std::min(span.from_s, run.time_in(first, run.time_s[begin]));
    span.to_s = std::max(span.to_s, run.time_in(first, run.time_s[end - 1]));
  }
  if (is_cut_before) span.begins_last = shared.begins_last;
  if (is_cut_behind) span.ends_first = shared.ends_first;
  return span;
}

std::vector<RunEvaluation> evaluations_within(RunDocuments runs, const ComparedSpan& span) {
  const ClockSpan shared = shared_clock(runs);
  std::vector<RunEvaluation> evaluations;
  evaluations.reserve(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunDocument& run = *runs[i];
    if (!span.is_shared || span.is_whole[i]) {
      evaluations.push_back(run.evaluation);
      continue;
    }
    const auto [begin, end] = steps_within(run, shared.from_s, shared.until_s);
    const auto judged = std::span(run.judged).subspan(begin, end - begin);
    // Nothing fails without alignment.
    evaluations.push_back(evaluate_steps(judged).value_or(RunEvaluation{}));
  }
  return evaluations;
}

}  // namespace nadir
