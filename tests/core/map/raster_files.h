// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/raster.h"
#include "core/geo/affine2.h"
#include "core/map/overhead_map.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// A point of a raster whose place is known.
struct PlacedPixel {
  Eigen::Vector2d pixel;
  Eigen::Vector2d point_in_crs;
};

/// A raster file for a test, as another program would have written it.
struct RasterFile {
  Raster<std::uint8_t> ids;
  std::optional<Affine2> crs_from_pixel{};
  std::string crs{};  ///< "EPSG:32617" or empty.
  bool is_pixel_is_point = false;
  std::optional<int> no_data{};
  std::vector<std::string> category_names{};
  std::string driver = "GTiff";  ///< Or "PNG".
  int copies = 1;                ///< Number of equal bands.
  /// Of a value in the file: 1, 2 and 4 for a PNG, 8, or 16 for values times 257.
  int bits = 8;
  std::vector<Colour> palette{};  ///< Colours of the values 0, 1, 2, ...
  std::vector<PlacedPixel> control_points{};
};

void write_raster(const RasterFile& file, const std::filesystem::path& path);
void write_picture(const ColourRaster& picture, const std::filesystem::path& path);

/// Values of overview `level` of the only band.
[[nodiscard]] Raster<std::uint8_t> read_overview(const std::filesystem::path& path, int level);
[[nodiscard]] int overview_count(const std::filesystem::path& path);
[[nodiscard]] std::array<int, 3> palette_entry(const std::filesystem::path& path, int index);
[[nodiscard]] std::string band_metadata(const std::filesystem::path& path, const std::string& key);
[[nodiscard]] std::vector<std::string> category_names(const std::filesystem::path& path);

/// Longitude and latitude to a reference system, or back, by PROJ: an opinion independent of ours.
[[nodiscard]] Eigen::Vector2d crs_from_lon_lat(const std::string& crs,
                                               const Eigen::Vector2d& point);
[[nodiscard]] Eigen::Vector2d lon_lat_from_crs(const std::string& crs,
                                               const Eigen::Vector2d& point);

/// Goes from every cell of `map` by latitude and longitude to the pixel of the source and counts
/// the cells whose class is not that pixel's, leaving out those within `margin_px` of a pixel's
/// border, where rounding decides.
[[nodiscard]] std::int64_t cells_that_disagree(const OverheadMap& map,
                                               const RasterFile& source,
                                               double margin_px = 0.05);

/// The six lines of a world file.
[[nodiscard]] std::string world_file(const Affine2& crs_from_pixel);

/// Names for the values of a raster that means by them what we mean.
[[nodiscard]] std::vector<std::string> our_class_names();

/// Blocks of road, terrain and sidewalk whose pattern repeats nowhere near.
[[nodiscard]] Raster<std::uint8_t> patchwork(int width, int height);

}  // namespace nadir
