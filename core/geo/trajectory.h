// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/geo/rigid3.h"

namespace nadir {

struct TimedPose {
  double time_s = 0.0;
  Rigid3 pose;  ///< world_from_body: `enu` for truth, `odom` for odometry.
};

/// Poses of one body over time. Invariant: times are finite and strictly increasing, poses are
/// finite.
class Trajectory {
 public:
  Trajectory() = default;
  /// `name` stands for the file in messages. @errors kMalformed: a time that goes back or repeats,
  /// a NaN; says which line.
  [[nodiscard]] static Result<Trajectory> create(std::vector<TimedPose> poses,
                                                 const std::string& name);

  [[nodiscard]] bool empty() const { return poses_.empty(); }
  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  [[nodiscard]] const std::vector<TimedPose>& poses() const { return poses_; }
  [[nodiscard]] double start_s() const { return poses_.front().time_s; }  ///< Not empty.
  [[nodiscard]] double end_s() const { return poses_.back().time_s; }     ///< Not empty.

  /// Pose at a time: linear in position, slerp in rotation. Nothing outside the trajectory or
  /// inside a gap longer than `max_gap_s`; times within 1 ms of an end count as that end. O(log n).
  [[nodiscard]] std::optional<Rigid3> at(double time_s, double max_gap_s = 1.0) const;

  /// Metres travelled in the plane between first and last pose.
  [[nodiscard]] double planar_length_m() const;

 private:
  std::vector<TimedPose> poses_;
};

}  // namespace nadir
