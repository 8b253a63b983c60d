// SPDX-License-Identifier: Apache-2.0
#include "app/cli/trajectory_output.h"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "core/base/staged_output.h"
#include "core/base/version.h"
#include "core/geo/trajectory_file.h"

namespace nadir::cli {
namespace {

std::string head_of(const std::string& flight, const Geodetic& plane_origin) {
  return fmt::format(
      "estimated trajectory of flight {}, written by Nadir {}\n"
      "frame enu: x east and y north in metres on the transverse Mercator plane (scale 1) whose\n"
      "origin (0, 0) is latitude {} longitude {} in degrees (WGS 84)\n"
      "poses enu_from_body, body x forward, y left, z up; z, roll and pitch are not estimated and "
      "0\n"
      "times in seconds as in the flight; nothing is aligned",
      flight, kVersion, plane_origin.latitude_deg, plane_origin.longitude_deg);
}

}  // namespace

bool names_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  namespace fs = std::filesystem;
  if (a.empty() || b.empty()) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const auto in_full = [&error](const fs::path& path) {
    // Made absolute first: a name whose first part is not there yet would be left relative.
    const fs::path absolute = fs::absolute(path, error);
    const fs::path full = fs::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : full;
  };
  return in_full(a) == in_full(b);
}

Result<void> check_trajectory_file(const std::filesystem::path& file) {
  const auto staged = StagedOutput::file(file);
  if (!staged) return forward_error(staged, "--trajectory");
  return {};
}

Result<void> write_estimated_trajectory(const std::filesystem::path& file,
                                        std::span<const EvaluatedStep> steps,
                                        const Geodetic& plane_origin,
                                        const std::string& flight) {
  if (steps.empty()) {
    return fail(ErrorCode::kMalformed, "{}: has no steps, so there is no trajectory to write",
                flight);
  }
  std::vector<TimedPose> poses;
  poses.reserve(steps.size());
  for (const EvaluatedStep& step : steps) {
    const Rigid2& pose = step.estimate_in_enu;
    poses.push_back(
        {step.time_s, {rotation_of({.yaw_rad = pose.yaw_rad}), {pose.x_m, pose.y_m, 0.0}}});
  }
  const auto trajectory = Trajectory::create(std::move(poses), flight);
  if (!trajectory) return forward_error(trajectory);
  const auto written = write_text_file(file, tum_text(*trajectory, head_of(flight, plane_origin)));
  if (!written) return forward_error(written, "--trajectory");
  return {};
}

}  // namespace nadir::cli
