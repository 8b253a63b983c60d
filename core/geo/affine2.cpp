// SPDX-License-Identifier: Apache-2.0
#include "core/geo/affine2.h"

#include <cmath>

namespace nadir {

Result<Affine2> Affine2::inverse() const {
  // Relative to the pixel's size, which is 1e-6 where the plane is in degrees.
  constexpr double kSmallestSine = 1e-12;
  const double area = linear.determinant();
  const double rectangle = linear.col(0).norm() * linear.col(1).norm();
  if (!linear.allFinite() || !offset.allFinite() || !std::isfinite(rectangle)) {
    return fail(ErrorCode::kMalformed, "georeference: holds a number that is not finite");
  }
  if (!(std::abs(area) > kSmallestSine * rectangle)) {
    return fail(ErrorCode::kMalformed, "georeference: is singular, its pixels have no area");
  }
  Affine2 pixel_from_plane;
  pixel_from_plane.linear = linear.inverse();
  pixel_from_plane.offset = -(pixel_from_plane.linear * offset);
  if (!pixel_from_plane.linear.allFinite() || !pixel_from_plane.offset.allFinite()) {
    return fail(ErrorCode::kMalformed, "georeference: its pixels are too small or too far away");
  }
  return pixel_from_plane;
}

Affine2 Affine2::from_gdal(const std::array<double, 6>& geotransform) {
  Affine2 plane_from_pixel;
  plane_from_pixel.linear << geotransform[1], geotransform[2], geotransform[4], geotransform[5];
  plane_from_pixel.offset = {geotransform[0], geotransform[3]};
  return plane_from_pixel;
}

std::array<double, 6> Affine2::to_gdal() const {
  return {offset.x(), linear(0, 0), linear(0, 1), offset.y(), linear(1, 0), linear(1, 1)};
}

}  // namespace nadir
