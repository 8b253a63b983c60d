// SPDX-License-Identifier: Apache-2.0
#include "core/geo/rigid3.h"

#include <cmath>

namespace nadir {

Attitude attitude_of(const Eigen::Quaterniond& rotation) {
  // Below this cosine of the pitch the nose points straight up or down, where roll and yaw turn
  // about the same axis.
  constexpr double kGimbalLock = 1e-9;
  const Eigen::Matrix3d r = rotation.toRotationMatrix();
  const double cos_pitch = std::hypot(r(0, 0), r(1, 0));
  const double pitch_rad = std::atan2(-r(2, 0), cos_pitch);
  if (cos_pitch < kGimbalLock) {
    return {0.0, pitch_rad, wrap_rad(std::atan2(-r(0, 1), r(1, 1)))};
  }
  return {wrap_rad(std::atan2(r(2, 1), r(2, 2))), pitch_rad,
          wrap_rad(std::atan2(r(1, 0), r(0, 0)))};
}

Eigen::Quaterniond rotation_of(const Attitude& attitude) {
  return Eigen::AngleAxisd(attitude.yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(attitude.pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(attitude.roll_rad, Eigen::Vector3d::UnitX());
}

Rigid2 planar(const Rigid3& pose) {
  return {pose.translation_m.x(), pose.translation_m.y(), attitude_of(pose.rotation).yaw_rad};
}

Eigen::Quaterniond level_from_body(const Eigen::Quaterniond& world_from_body) {
  const double yaw_rad = attitude_of(world_from_body).yaw_rad;
  const Eigen::Quaterniond level_from_world(Eigen::AngleAxisd(-yaw_rad, Eigen::Vector3d::UnitZ()));
  return (level_from_world * world_from_body).normalized();
}

Eigen::Quaterniond forward_body_from_camera() {
  // Rows of the matrix: forward is camera z, left is minus camera x, up is minus camera y.
  return {0.5, -0.5, 0.5, -0.5};
}

}  // namespace nadir
