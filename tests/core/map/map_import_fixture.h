// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "core/map/map_import.h"
#include "tests/core/map/raster_files.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

[[nodiscard]] inline Affine2 affine(double a, double b, double c, double d, double x, double y) {
  Affine2 crs_from_pixel;
  crs_from_pixel.linear << a, b, c, d;
  crs_from_pixel.offset = {x, y};
  return crs_from_pixel;
}

/// North-up square pixels whose top-left corner is at a longitude and latitude.
[[nodiscard]] inline RasterFile placed(const std::string& crs,
                                       double longitude,
                                       double latitude,
                                       double pixel) {
  const Eigen::Vector2d corner = crs_from_lon_lat(crs, {longitude, latitude});
  RasterFile file{.ids = patchwork(60, 45), .crs = crs, .category_names = our_class_names()};
  file.crs_from_pixel = affine(pixel, 0, 0, -pixel, corner.x(), corner.y());
  return file;
}

/// Writes a raster and imports it.
class MapImport : public testing::Test {
 protected:
  [[nodiscard]] ImportedMap imported(const RasterFile& file, const ImportOptions& options = {}) {
    write_raster(file, path());
    auto result = import_map(path(), options);
    if (!result) throw std::runtime_error(error_text(result));
    return std::move(*result);
  }
  [[nodiscard]] std::string fault(const RasterFile& file, const ImportOptions& options = {}) {
    write_raster(file, path());
    return error_text(import_map(path(), options));
  }
  [[nodiscard]] std::filesystem::path path() const { return folder.path() / "source.tif"; }

  ScratchFolder folder;
};

}  // namespace nadir
