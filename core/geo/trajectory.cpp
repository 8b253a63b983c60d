// SPDX-License-Identifier: Apache-2.0
#include "core/geo/trajectory.h"

#include <algorithm>
#include <cmath>

namespace nadir {
namespace {

/// Recorders round times; a pose asked for that little beyond an end is the pose at that end.
constexpr double kEndToleranceS = 1e-3;

bool is_finite(const Rigid3& pose) {
  return pose.translation_m.allFinite() && pose.rotation.coeffs().allFinite();
}

}  // namespace

Result<Trajectory> Trajectory::create(std::vector<TimedPose> poses, const std::string& name) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!std::isfinite(poses[i].time_s)) {
      return fail(ErrorCode::kMalformed, "{}: pose {}: its time {} is not finite", name, i + 1,
                  poses[i].time_s);
    }
    if (!is_finite(poses[i].pose)) {
      return fail(ErrorCode::kMalformed, "{}: pose {}: is not finite", name, i + 1);
    }
    if (i > 0 && !(poses[i - 1].time_s < poses[i].time_s)) {
      return fail(ErrorCode::kMalformed, "{}: pose {}: time {} does not come after {}", name, i + 1,
                  poses[i].time_s, poses[i - 1].time_s);
    }
  }
  Trajectory trajectory;
  trajectory.poses_ = std::move(poses);
  return trajectory;
}

std::optional<Rigid3> Trajectory::at(double time_s, double max_gap_s) const {
  if (poses_.empty() || !std::isfinite(time_s)) return std::nullopt;
  if (time_s < start_s() - kEndToleranceS || time_s > end_s() + kEndToleranceS) {
    return std::nullopt;
  }
  const auto after = std::lower_bound(
      poses_.begin(), poses_.end(), time_s,
      [](const TimedPose& pose, double wanted_s) { return pose.time_s < wanted_s; });
  if (after == poses_.end()) return poses_.back().pose;
  if (after == poses_.begin() || after->time_s == time_s) return after->pose;

  const TimedPose& before = *(after - 1);
  const double gap_s = after->time_s - before.time_s;
  if (!(gap_s <= max_gap_s) || !std::isfinite(gap_s)) return std::nullopt;
  const double part = (time_s - before.time_s) / gap_s;
  return Rigid3{before.pose.rotation.slerp(part, after->pose.rotation).normalized(),
                (1.0 - part) * before.pose.translation_m + part * after->pose.translation_m};
}

double Trajectory::planar_length_m() const {
  double length_m = 0.0;
  for (std::size_t i = 1; i < poses_.size(); ++i) {
    const Eigen::Vector3d step_m = poses_[i].pose.translation_m - poses_[i - 1].pose.translation_m;
    length_m += std::hypot(step_m.x(), step_m.y());
  }
  return length_m;
}

}  // namespace nadir
