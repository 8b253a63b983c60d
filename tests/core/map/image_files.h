// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/geo/affine2.h"
#include "core/map/image_look.h"
#include "core/map/overhead_tiles.h"

namespace nadir {

/// An image file for a test, as another program would have written it.
struct DrawnImage {
  ImageRaster pixels;
  bool has_alpha = false;
  bool is_grey = false;  ///< Red alone.
  int value_factor = 1;  ///< More than 1: 16 bits of so many times the value.
  std::string driver = "GTiff";
  std::vector<std::string> options{};  ///< "TILED=YES"
  std::optional<Affine2> crs_from_pixel{};
  std::string crs{};
  bool is_pixel_is_point = false;
  std::optional<int> no_data{};
  std::vector<std::array<std::string, 3>> metadata{};  ///< Key, value, domain.
};
void write_image(const DrawnImage& image, const std::filesystem::path& path);

/// A tiled GeoTIFF of nothing, of any size, in a few kilobytes.
void write_sparse_image(int side, const std::filesystem::path& path);

/// Squares of 16 pixels, whose colours tell the place and repeat nowhere near.
[[nodiscard]] ImageRaster mosaic(int width, int height);
[[nodiscard]] ImagePixel mosaic_colour(int column, int row);

/// What tiles of level 0 show at a place of the plane; clear outside them.
[[nodiscard]] ImagePixel shown_at(const OverheadTiles& tiles,
                                  const Eigen::Vector2d& point_in_enu_m);
/// Level 0 put together from its tiles.
[[nodiscard]] ImageRaster whole_picture(const OverheadTiles& tiles);

}  // namespace nadir
