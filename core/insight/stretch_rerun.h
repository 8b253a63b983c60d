// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/flight/flight_recording.h"
#include "core/map/map_index.h"
#include "core/mcl/cell_agreement.h"
#include "core/run/localise_flight.h"

namespace nadir {

/// How many frames with labels and depth come later than `from_s` and not later than `to_s`, both as FlightFrame::time_s.
[[nodiscard]] std::size_t frames_between(const FlightDescription& flight,
                                         double from_s,
                                         double to_s);

/// A stretch of a recorded run to localise again, on labels that have been edited since.
struct StretchTask {
  std::shared_ptr<const FlightRecording> flight;  ///< Not null.
  std::shared_ptr<const MapIndex> before;         ///< Labels that the run was made on. Not null.
  std::shared_ptr<const MapIndex>
      after;  ///< Labels as they are now, on cells of the same size (labelled_ground()). Not null.
  RunOptions options;  ///< Those of the run: recorded_options().
  double from_s =
      0.0;  ///< Begin with the particles recorded here; seconds after the run's first step.
  double to_s = 0.0;  ///< Last moment, likewise.
};

/// A step, on both.
struct StretchStep {
  double time_s = 0.0;  ///< As RunStep::time_s.
  Rigid2 before_in_enu, after_in_enu;
  /// Distance in the plane from estimate to truth, and size of the angle; nothing where the truth is not known.
  std::optional<double> error_before_m = {}, error_after_m = {}, error_before_rad = {},
                        error_after_rad = {};
  CellAgreement::Count agreement_before = {},
                       agreement_after = {};  ///< Each at its own estimate, on its own labels.
};

/// Of the steps that both runs have.
struct StretchRerun {
  std::vector<StretchStep> steps;
  std::array<CellAgreement::Count, kClassCount> class_before,
      class_after;  ///< By the class that was seen.
  std::optional<double> mean_error_before_m,
      mean_error_after_m;  ///< Nothing where no truth is known.
  std::optional<double> mean_error_before_rad, mean_error_after_rad;
};

/// Goes on from the particles of a recorded run with the labels as they are now, frame by frame until the end of the stretch, and sets
/// what comes out beside what was recorded: what did the edit change? As "Rerun from here" does, but for the end and for where it is
/// kept, which is nowhere.
///
/// Particles are recorded as float32, so that a rerun on unchanged labels is alike, not the same bits.
/// @param publish  Called after each step with all so far, means included; may be empty.
/// @errors kInvalidOptions: an empty stretch, no particles at its beginning, another flight or plane, as resume_point() and
///         localise_flight(); kCancelled.
[[nodiscard]] Result<StretchRerun> rerun_stretch(
    const RunReader& run,
    const StretchTask& task,
    const WorkContext& context = {},
    const std::function<void(const StretchRerun&)>& publish = {});

}  // namespace nadir
