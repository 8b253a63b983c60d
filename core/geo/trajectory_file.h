// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/geo/trajectory.h"

namespace nadir {

/// Reads a trajectory of either format, told apart by the number of columns.
///
/// TUM: `time_s x y z qx qy qz qw` a line, `#` starts a comment; poses are taken as
/// world_from_body. KITTI odometry: twelve numbers a line, the top of a 4 x 4 camera pose (x right,
/// y down, z forward) row by row; times come from `times.txt` beside it (or from the file given),
/// one a line. KITTI poses are turned into world_from_body with body x forward, y left, z up, so
/// that the first pose (identity) stays identity.
/// @errors kNotFound, kMalformed (file, line and fault), kUnsupported.
[[nodiscard]] Result<Trajectory> read_trajectory(const std::filesystem::path& path,
                                                 const std::filesystem::path& kitti_times = {});

/// Parses the text of a TUM file; `name` stands for the file in messages.
[[nodiscard]] Result<Trajectory> parse_tum_trajectory(std::string_view text,
                                                      const std::string& name);

/// Parses the text of a KITTI pose file with the time of each line.
[[nodiscard]] Result<Trajectory> parse_kitti_trajectory(std::string_view text,
                                                        const std::vector<double>& times_s,
                                                        const std::string& name);

/// Parses one time a line (KITTI times.txt).
[[nodiscard]] Result<std::vector<double>> parse_times(std::string_view text,
                                                      const std::string& name);

/// Text of a TUM file with enough digits to read back the same numbers.
[[nodiscard]] std::string tum_text(const Trajectory& trajectory, std::string_view comment);

}  // namespace nadir
