// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/base/result.h"

namespace nadir {

/// No image, and no camera, is wider or higher: a damaged header does not make us ask for gigabytes.
inline constexpr int kLargestImageSide = 16384;

/// Pinhole camera without distortion. Pixel centres are at +0.5, so the image spans [0, width] x
/// [0, height]. `camera` has x right, y down, z forward; depth is along z.
struct CameraModel {
  int width = 0;
  int height = 0;
  double focal_x_px = 0.0;
  double focal_y_px = 0.0;
  double centre_x_px = 0.0;
  double centre_y_px = 0.0;

  /// Square pixels, optical axis through the middle of the image. Angle in radians, in (0, pi).
  [[nodiscard]] static CameraModel from_horizontal_view(int width, int height, double view_rad);

  /// Point at depth 1 m seen at `point_in_image` (thesis equation 3.2 with D = 1), metres in
  /// `camera`.
  [[nodiscard]] Eigen::Vector3d ray(const Eigen::Vector2d& point_in_image) const {
    return {(point_in_image.x() - centre_x_px) / focal_x_px,
            (point_in_image.y() - centre_y_px) / focal_y_px, 1.0};
  }
  /// Image of a point in front of the camera (z > 0).
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point_in_camera_m) const {
    return {focal_x_px * point_in_camera_m.x() / point_in_camera_m.z() + centre_x_px,
            focal_y_px * point_in_camera_m.y() / point_in_camera_m.z() + centre_y_px};
  }
};

/// @errors kInvalidOptions: sizes outside [1, kLargestImageSide], focal lengths that are not positive, NaN.
[[nodiscard]] Result<void> validate(const CameraModel& camera);

}  // namespace nadir
