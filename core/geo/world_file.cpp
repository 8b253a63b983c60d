// SPDX-License-Identifier: Apache-2.0
#include "core/geo/world_file.h"

#include <array>

#include "core/geo/number_lines.h"

namespace nadir {
namespace {

Eigen::Vector2d first_pixel_centre() { return {0.5, 0.5}; }

}  // namespace

Result<Affine2> parse_world_file(std::string_view text, const std::string& name) {
  NumberLines lines(text, name);
  std::array<double, 6> numbers{};
  std::size_t found = 0;
  while (true) {
    const auto line = lines.next();
    if (!line) return forward_error(line);
    if (!*line) break;
    for (const double value : (*line)->values) {
      if (found == numbers.size()) {
        return fail(ErrorCode::kMalformed, "{}: holds more than the six numbers of a world file",
                    name);
      }
      numbers.at(found++) = value;
    }
  }
  if (found != numbers.size()) {
    return fail(ErrorCode::kMalformed, "{}: holds {} of the six numbers of a world file", name,
                found);
  }
  Affine2 plane_from_pixels;
  plane_from_pixels.linear << numbers[0], numbers[2], numbers[1], numbers[3];
  plane_from_pixels.offset =
      Eigen::Vector2d(numbers[4], numbers[5]) - plane_from_pixels.linear * first_pixel_centre();
  if (const auto inverse = plane_from_pixels.inverse(); !inverse) {
    return forward_error(inverse, name);
  }
  return plane_from_pixels;
}

std::string world_file_text(const Affine2& plane_from_pixels) {
  const Eigen::Matrix2d& linear = plane_from_pixels.linear;
  const Eigen::Vector2d centre = plane_from_pixels * first_pixel_centre();
  return fmt::format("{:.17g}\n{:.17g}\n{:.17g}\n{:.17g}\n{:.17g}\n{:.17g}\n", linear(0, 0),
                     linear(1, 0), linear(0, 1), linear(1, 1), centre.x(), centre.y());
}

}  // namespace nadir
