// SPDX-License-Identifier: Apache-2.0
#include "core/sim/odometry_noise.h"

#include <cmath>

#include "core/base/random.h"

namespace nadir {

OdometryDiffusion calibrated_diffusion(const Trajectory& truth,
                                       double position_mse_m2,
                                       double yaw_mse_rad2) {
  double sum_s = 0.0;
  for (const TimedPose& timed : truth.poses()) sum_s += timed.time_s - truth.start_s();
  if (sum_s == 0.0) return {};
  const double mean_s = sum_s / static_cast<double>(truth.size());
  return {std::sqrt(position_mse_m2 / (2.0 * mean_s)), std::sqrt(yaw_mse_rad2 / mean_s)};
}

Trajectory drifting_odometry(const Trajectory& truth,
                             const OdometryDiffusion& diffusion,
                             std::uint64_t seed) {
  std::vector<TimedPose> poses = truth.poses();
  Eigen::Vector2d position_error_m = Eigen::Vector2d::Zero();
  double yaw_error_rad = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    const double root_s = std::sqrt(poses[i].time_s - poses[i - 1].time_s);
    const auto step = static_cast<std::uint32_t>(i);
    const auto [east, north] = standard_normals({seed, kOdometryNoise, step, 0, 0});
    const double turn = standard_normals({seed, kOdometryNoise, step, 0, 1})[0];
    position_error_m += diffusion.position_m_per_sqrt_s * root_s * Eigen::Vector2d(east, north);
    yaw_error_rad += diffusion.yaw_rad_per_sqrt_s * root_s * turn;
    Rigid3& pose = poses[i].pose;
    pose.translation_m.head<2>() += position_error_m;
    // A turn about the vertical on the left keeps roll and pitch.
    pose.rotation =
        (Eigen::AngleAxisd(yaw_error_rad, Eigen::Vector3d::UnitZ()) * pose.rotation).normalized();
  }
  return Trajectory::create(std::move(poses), "simulated odometry").value();
}

}  // namespace nadir
