// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/session/run_document.h"

namespace nadir {

using RunDocuments = std::span<const std::shared_ptr<const RunDocument>>;

/// The part of a flight that runs are compared over: all of them cover it. A run that is still computed, was stopped, or
/// begins in the middle of the flight covers only a part; over different parts no number of theirs compares.
struct ComparedSpan {
  /// First and last step of any run within it, after the first step of the first run that has steps. Without a shared span
  /// those of that run itself.
  double from_s = 0.0, to_s = 0.0;
  /// False: the runs share no time, or are of different flights. Then each one's numbers are over all of it.
  bool is_shared = true;
  std::vector<bool> is_whole;  ///< One a run: none of its steps lies outside.
  std::optional<std::size_t>
      begins_last;  ///< The run before whose beginning others have steps that do not count.
  std::optional<std::size_t> ends_first;  ///< The same after its end.
};

/// Runs without steps count for nothing. A complete run covers the time up to where its next step would have been, so that runs
/// of different rates that reach the end of the flight are whole.
[[nodiscard]] ComparedSpan compared_span(RunDocuments runs);

/// The evaluation of the steps within a span, one a run; that of a run which is whole is its own.
/// @param span  compared_span() of these runs.
[[nodiscard]] std::vector<RunEvaluation> evaluations_within(RunDocuments runs,
                                                            const ComparedSpan& span);

}  // namespace nadir
