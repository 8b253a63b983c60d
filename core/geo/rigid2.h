// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "core/base/angle.h"

namespace nadir {

/// A rigid motion of the plane: `target_from_source * point_in_source`. Metres; yaw
/// counter-clockwise in radians.
struct Rigid2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;

  [[nodiscard]] Eigen::Vector2d translation_m() const { return {x_m, y_m}; }
  [[nodiscard]] Rigid2 inverse() const;
  friend bool operator==(const Rigid2&, const Rigid2&) = default;
};

[[nodiscard]] inline Eigen::Vector2d operator*(const Rigid2& target_from_source,
                                               const Eigen::Vector2d& point_in_source) {
  const double c = std::cos(target_from_source.yaw_rad);
  const double s = std::sin(target_from_source.yaw_rad);
  return {target_from_source.x_m + c * point_in_source.x() - s * point_in_source.y(),
          target_from_source.y_m + s * point_in_source.x() + c * point_in_source.y()};
}

/// c_from_a = c_from_b * b_from_a. The yaw of the product is in (-pi, pi].
[[nodiscard]] inline Rigid2 operator*(const Rigid2& c_from_b, const Rigid2& b_from_a) {
  const Eigen::Vector2d translation_m = c_from_b * b_from_a.translation_m();
  return {translation_m.x(), translation_m.y(), wrap_rad(c_from_b.yaw_rad + b_from_a.yaw_rad)};
}

inline Rigid2 Rigid2::inverse() const {
  const Eigen::Vector2d moved = Rigid2{0.0, 0.0, -yaw_rad} * Eigen::Vector2d(-x_m, -y_m);
  return {moved.x(), moved.y(), wrap_rad(-yaw_rad)};
}

}  // namespace nadir
