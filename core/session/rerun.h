// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/progress.h"
#include "core/flight/flight_recording.h"
#include "core/map/map_index.h"
#include "core/mcl/prior.h"
#include "core/run/run_options.h"

namespace nadir {

/// A flight to localise in the background.
struct RerunTask {
  std::shared_ptr<const FlightRecording> flight;  ///< Not null.
  std::shared_ptr<const MapIndex> map;            ///< Not null.
  std::string map_path, preset;
  RunOptions options;
  std::optional<Prior> prior;    ///< Without one, the truth of the flight's first frame.
  std::filesystem::path parent;  ///< Run to go on from; empty: from the flight's start.
  double from_s = 0.0;           ///< Moment to go on from, after the parent's first step.
  std::filesystem::path run;     ///< File to write; nothing has this name.
  int threads = 0;               ///< At most; 0: as many as there are.
};

/// How far it is: so many steps are in the file.
struct RerunProgress {
  int steps = 0;
};

struct RerunOutcome {
  int steps = 0;
  bool was_stopped = false;  ///< Before its end; the steps so far are in the file.
  std::string
      fault;  ///< Why it failed before its end, with the steps so far in the file; empty: it did not.
};

/// Localises the flight and records it. Where it fails or is stopped before its first own step, or where none of its steps
/// says anything, no file stays.
/// @param publish  Called after each step that is in the file.
/// @errors as localise_flight, RunWriter and resume_point, where no file stays; kCancelled: stopped before there was a step.
[[nodiscard]] Result<RerunOutcome> rerun(const RerunTask& task,
                                         const WorkContext& context,
                                         const std::function<void(RerunProgress)>& publish);

}  // namespace nadir
