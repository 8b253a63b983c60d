// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>

#include "core/geo/rigid2.h"

namespace nadir {

[[nodiscard]] inline bool is_finite(const Rigid2& pose) {
  return std::isfinite(pose.x_m) && std::isfinite(pose.y_m) && std::isfinite(pose.yaw_rad);
}

/// One update of a localiser, as far as judging it needs. All poses are `enu_from_body`: metres in
/// the project plane, yaw counter-clockwise from east. Estimate, odometry and truth belong to the
/// same moment, so pairs need no tolerance.
struct EvaluatedStep {
  double time_s = 0.0;
  std::optional<Rigid2> truth_in_enu = {};  ///< Absent where the flight does not know it.
  Rigid2 estimate_in_enu = {};
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Zero();  ///< Of the estimate: x, y (m), yaw (rad) in enu.
  /// Odometry input laid at the start: what dead reckoning alone says. Absent where nobody knows where that was.
  std::optional<Rigid2> odometry_in_enu = {};
  double update_ms = 0.0;  ///< Computing time of the update; NaN where it is not known.
};

}  // namespace nadir
