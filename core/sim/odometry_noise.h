// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/geo/trajectory.h"

namespace nadir {

/// How fast the errors of an odometry spread: standard deviation after one second.
struct OdometryDiffusion {
  double position_m_per_sqrt_s = 0.0;  ///< Of x and of y.
  double yaw_rad_per_sqrt_s = 0.0;
};

/// The diffusion for which the *expected* mean squared errors over the samples of `truth` are the
/// ones given. With standard deviation q sqrt(t) after t seconds, E[mean |e|^2] = 2 q^2 mean(t) for
/// the position and q^2 mean(t) for the yaw; exact for any duration and any spacing of the samples.
/// Zero for a trajectory without duration.
[[nodiscard]] OdometryDiffusion calibrated_diffusion(const Trajectory& truth,
                                                     double position_mse_m2,
                                                     double yaw_mse_rad2);

/// Odometry as the thesis makes it (4.2): noise added "in an integral fashion" to the true pose.
/// The pose is the true one plus random walks in x, y (along `enu`, not turned by the yaw error)
/// and yaw; height, roll and pitch are the true ones. Both start without error, so `odom` is `enu`
/// at the first pose.
///
/// Position and yaw err independently, so the path keeps its shape in `odom` while the heading
/// leaves it: the motion between two poses as the body reports it is the true one turned by minus
/// the yaw error, plus the step of the walk. With a wrong yaw, a vehicle that flies straight ahead
/// reports that it slides sideways; odometry that sums body motion would bend its path instead.
[[nodiscard]] Trajectory drifting_odometry(const Trajectory& truth,
                                           const OdometryDiffusion& diffusion,
                                           std::uint64_t seed);

}  // namespace nadir
