// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/geo/rigid3.h"
#include "core/topview/camera_model.h"

namespace nadir {

/// What a camera sees up to a depth: a pyramid with the optical centre at its tip.
struct CameraFrustum {
  Eigen::Vector3d eye_in_enu_m;
  /// Of the image laid at that depth: upper left, upper right, lower right, lower left.
  std::array<Eigen::Vector3d, 4> corners_in_enu_m;
};

/// @param depth_m  Along the optical axis, > 0.
[[nodiscard]] CameraFrustum camera_frustum(const CameraModel& camera,
                                           const Rigid3& enu_from_camera,
                                           double depth_m);

/// The part of the ground (z = 0) inside of it: corners of a convex polygon in order, counter-clockwise. Empty where it
/// sees no ground.
[[nodiscard]] std::vector<Eigen::Vector2d> ground_inside(const CameraFrustum& frustum);

}  // namespace nadir
