// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <stop_token>
#include <string>

#include "app/cli/console.h"
#include "core/eval/run_evaluation.h"
#include "core/run/localise_flight.h"

namespace nadir::cli {

/// A moment of a recorded run from which to go on.
struct LocaliseFrom {
  std::filesystem::path run;
  double elapsed_s = 0.0;  ///< Since the first step of that run.
};

/// What `nadir localise` was asked to do; `nadir demo` asks for the same.
struct LocaliseTask {
  std::filesystem::path flight, map;
  std::optional<std::filesystem::path> run;  ///< Run file to write; without one nothing is kept.
  std::optional<std::filesystem::path> trajectory;  ///< TUM file of the estimates to write.
  std::string preset = "default";
  LocaliseRequest request;
  std::optional<LocaliseFrom> from;  ///< Instead of a prior; the request holds no resume point yet.
  bool is_quiet = false;
  ProgressShare share = {};  ///< Of a demo.
};

/// What a run came to.
struct LocaliseResult {
  RunEvaluation evaluation;
  std::string
      ending;  ///< Where the vehicle is at the end and how sure that is, in one line for people.
};

/// Localises with a progress bar and judges the result. Words go to `err`. `stop` stops it cleanly (kCancelled): the run
/// file then holds the steps so far, an earlier one of that name that was complete or longer lies beside it, where the
/// message says, and no trajectory is written. A run that goes on from another holds that one's steps before its own, in file,
/// evaluation and trajectory.
/// @errors as localise_flight: before the first step no new run file is left, and an earlier one of that name is as it was;
/// after that the steps so far stay as where it is stopped. kIo or
/// kUnsupported where run file or trajectory cannot be written or would take the place of something else, before any work.
/// A trajectory that cannot be written at the end (kIo) leaves the run file whole.
[[nodiscard]] Result<LocaliseResult> localise_and_evaluate(const LocaliseTask& task,
                                                           const std::stop_token& stop,
                                                           std::ostream& err);

}  // namespace nadir::cli
