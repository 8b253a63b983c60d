// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "core/geo/rigid2.h"

namespace nadir {

/// A rigid motion of space: `target_from_source * point_in_source`. The quaternion is of unit
/// length; metres.
struct Rigid3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

  [[nodiscard]] Rigid3 inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, back * -translation_m};
  }
};

[[nodiscard]] inline Eigen::Vector3d operator*(const Rigid3& target_from_source,
                                               const Eigen::Vector3d& point_in_source) {
  return target_from_source.rotation * point_in_source + target_from_source.translation_m;
}

[[nodiscard]] inline Rigid3 operator*(const Rigid3& c_from_b, const Rigid3& b_from_a) {
  return {(c_from_b.rotation * b_from_a.rotation).normalized(), c_from_b * b_from_a.translation_m};
}

/// Aircraft angles in a frame whose x is forward, y left and z up: R = Rz(yaw) Ry(pitch) Rx(roll).
/// Positive roll lowers the right side, positive pitch lowers the nose. Pitch is in [-pi/2, pi/2].
struct Attitude {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

[[nodiscard]] Attitude attitude_of(const Eigen::Quaterniond& rotation);
[[nodiscard]] Eigen::Quaterniond rotation_of(const Attitude& attitude);

/// The pose in the plane that is left when height, roll and pitch are taken out.
[[nodiscard]] Rigid2 planar(const Rigid3& pose);

/// Rotation that takes points of `body` to `level`: same heading, roll and pitch taken out.
[[nodiscard]] Eigen::Quaterniond level_from_body(const Eigen::Quaterniond& world_from_body);

/// `body` (x forward, y left, z up) from `camera` (x right, y down, z forward) for a camera that
/// looks straight ahead.
[[nodiscard]] Eigen::Quaterniond forward_body_from_camera();

}  // namespace nadir
