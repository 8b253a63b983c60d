// SPDX-License-Identifier: Apache-2.0
#include "core/topview/camera_model.h"

#include <cmath>
#include <numbers>

#include "core/base/require.h"

namespace nadir {

CameraModel CameraModel::from_horizontal_view(int width, int height, double view_rad) {
  NADIR_REQUIRE(view_rad > 0.0 && view_rad < std::numbers::pi);
  const double focal_px = 0.5 * width / std::tan(0.5 * view_rad);
  return {width, height, focal_px, focal_px, 0.5 * width, 0.5 * height};
}

Result<void> validate(const CameraModel& camera) {
  const auto is_side = [](int side) { return side >= 1 && side <= kLargestImageSide; };
  if (!is_side(camera.width) || !is_side(camera.height)) {
    return fail(ErrorCode::kInvalidOptions, "camera: size {} x {} is not in [1, {}] pixels",
                camera.width, camera.height, kLargestImageSide);
  }
  const auto is_focal = [](double focal_px) { return std::isfinite(focal_px) && focal_px > 0.0; };
  if (!is_focal(camera.focal_x_px) || !is_focal(camera.focal_y_px)) {
    return fail(ErrorCode::kInvalidOptions,
                "camera: focal lengths {} and {} px are not positive numbers", camera.focal_x_px,
                camera.focal_y_px);
  }
  if (!std::isfinite(camera.centre_x_px) || !std::isfinite(camera.centre_y_px)) {
    return fail(ErrorCode::kInvalidOptions, "camera: the principal point is not finite");
  }
  return {};
}

}  // namespace nadir
