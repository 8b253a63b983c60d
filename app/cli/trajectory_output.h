// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/eval/evaluated_step.h"
#include "core/geo/project_plane.h"

namespace nadir::cli {

/// Whether two names mean one file: also where they are spelt differently ("run.nadir" and "./run.nadir", by way of a link),
/// and where the file is still to be written. An empty name means none.
[[nodiscard]] bool names_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Whether a trajectory can be written there: asked before long work begins. @errors kIo, naming --trajectory.
[[nodiscard]] Result<void> check_trajectory_file(const std::filesystem::path& file);

/// Writes the estimates of a run as TUM text, which evo and its like read: `time_s x y z qx qy qz qw`, enu_from_body in
/// metres of the project plane, z, roll and pitch 0. Comments at its head tell the frame and where the plane lies. The
/// file appears whole or not at all.
/// @param steps         In order of time.
/// @param plane_origin  Where the project plane of the poses touches the Earth, WGS 84.
/// @param flight        Name of the flight, for the head of the file and for messages.
/// @errors kMalformed: a run without steps, or whose times or poses are not sane. kIo: not writable, naming --trajectory.
[[nodiscard]] Result<void> write_estimated_trajectory(const std::filesystem::path& file,
                                                      std::span<const EvaluatedStep> steps,
                                                      const Geodetic& plane_origin,
                                                      const std::string& flight);

}  // namespace nadir::cli
