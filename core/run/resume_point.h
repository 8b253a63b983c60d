// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/project_plane.h"
#include "core/run/run_file.h"
#include "core/run/run_options.h"

namespace nadir {

/// A moment of a recorded run from which another run goes on: it takes the place of a prior.
///
/// The new run begins with the next frame after the step, with exactly the recorded particles and their weights; its steps are
/// numbered on, so that no random draw of the steps before comes again, and dead reckoning goes on where the recorded one was.
/// Particles are recorded as float32, so the same options give a run that is alike, not the same bits.
struct ResumePoint {
  std::string run;          ///< Name of the run file, for header and messages.
  std::string flight_hash;  ///< Of the flight that the run was made on; empty: not checked.
  std::optional<Geodetic> plane_origin;  ///< Of its poses; nothing: not checked.
  double elapsed_s = 0.0;                ///< Time of the step since the first step of its run.
  RunStep after;                         ///< With its particles.
};

/// The last step of a run that is not later than so many seconds after its first one.
/// @param name  Stands for the run file in the header of the new run and in messages.
/// @errors kInvalidOptions: a time before the first or after the last step, or no particles were recorded there; kMalformed: as
/// RunReader::step.
[[nodiscard]] Result<ResumePoint> resume_point(const RunReader& run,
                                               const std::string& name,
                                               double elapsed_s);

/// The options that a run was made with. What its header does not hold is as in the preset `default`; what this version does
/// not know is passed over. @errors kMalformed: a value that is none, named.
[[nodiscard]] Result<RunOptions> recorded_options(const RunHeader& header);

}  // namespace nadir
