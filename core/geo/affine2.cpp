// SPDX-License-Identifier: Apache-2.0
#include "core/geo/affine2.h"

#include <cmath>
#include <vector>

#include "core/geo/number_lines.h"

namespace nadir {
namespace {

const Eigen::Vector2d first_pixel_centre(0.5, 0.5);

}  // namespace

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

Result<Affine2> parse_world_file(std::string_view text, const std::string& name) {
  constexpr std::size_t kNumbers = 6;
  NumberLines lines(text, name);
  std::vector<double> values;
  while (true) {
    const auto line = lines.next();
    if (!line) return forward_error(line);
    if (!line->has_value()) break;
    if ((*line)->values.size() != 1) {
      return fail(ErrorCode::kMalformed, "{}: has {} numbers, but a world file has one a line",
                  lines.where((*line)->line), (*line)->values.size());
    }
    values.push_back((*line)->values[0]);
  }
  if (values.size() != kNumbers) {
    return fail(ErrorCode::kMalformed, "{}: holds {} numbers, but a world file has six", name,
                values.size());
  }
  Affine2 plane_from_pixel;
  plane_from_pixel.linear << values[0], values[2], values[1], values[3];
  plane_from_pixel.offset =
      Eigen::Vector2d(values[4], values[5]) - plane_from_pixel.linear * first_pixel_centre;
  if (const auto inverse = plane_from_pixel.inverse(); !inverse) {
    return forward_error(inverse, name);
  }
  return plane_from_pixel;
}

std::string world_file_text(const Affine2& plane_from_pixel) {
  const Eigen::Matrix2d& linear = plane_from_pixel.linear;
  const Eigen::Vector2d centre = plane_from_pixel * first_pixel_centre;
  // The shortest text that reads back as the same double.
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", linear(0, 0), linear(1, 0), linear(0, 1),
                     linear(1, 1), centre.x(), centre.y());
}

}  // namespace nadir
