// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>

#include "core/base/result.h"

namespace nadir {

/// Where a raster lies: `plane = linear * (column, row) + offset`, columns to the right and rows
/// down from the *corner* of the upper-left pixel, whose centre is (0.5, 0.5). Rotation, shear and
/// non-square pixels are all allowed.
struct Affine2 {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Eigen::Vector2d offset = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& pixel) const {
    return linear * pixel + offset;
  }
  /// @errors kMalformed where it is singular or not finite, for then no pixel has a place.
  [[nodiscard]] Result<Affine2> inverse() const;
  /// Length on the plane of one pixel along a row and along a column: column norms, not GT[1], so
  /// rotation is harmless.
  [[nodiscard]] Eigen::Vector2d pixel_size() const {
    return {linear.col(0).norm(), linear.col(1).norm()};
  }
  [[nodiscard]] bool is_north_up() const {
    return linear(0, 1) == 0.0 && linear(1, 0) == 0.0 && linear(0, 0) > 0.0 && linear(1, 1) < 0.0;
  }

  /// GDAL's six numbers, which are corner-based always; GDAL shifts PixelIsPoint itself.
  [[nodiscard]] static Affine2 from_gdal(const std::array<double, 6>& geotransform);
  [[nodiscard]] std::array<double, 6> to_gdal() const;
};

}  // namespace nadir
