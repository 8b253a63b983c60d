// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/map/gdal_raster.h"
#include "core/map/overhead_image.h"
#include "core/map/tile_source.h"

namespace nadir {

/// Images from anywhere by way of GDAL. Private to this module.

/// More pixels than this are taken for a damaged header.
inline constexpr std::int64_t kMaxImageCells = 100'000'000'000;

/// An image file and what its bands are.
struct ImageFile {
  GdalDataset file;           ///< Null, or the paletted file that `pixels` is a view of.
  GdalDataset pixels;         ///< Without palette.
  std::vector<int> channels;  ///< Bands of red, green and blue, or of grey alone.
  int alpha = 0;              ///< Band, or 0.
  ImageReadiness readiness = ImageReadiness::kReady;
  bool is_sequential = false;  ///< Any part of it costs all that comes before.

  /// The dataset that says where it lies and when it was taken.
  [[nodiscard]] GDALDataset& said() const { return file != nullptr ? *file : *pixels; }
};

/// Of the kinds that open_overhead_image names, and of no other, for some of GDAL's kinds reach out to the network.
/// @errors kNotFound, kMalformed (no image, cut short), kUnsupported (complex, too large).
[[nodiscard]] Result<ImageFile> open_image_file(const std::filesystem::path& path,
                                                const GdalMessages& messages);

/// The world file beside an image, by the names that programs give it.
[[nodiscard]] std::optional<std::filesystem::path> world_file_beside(
    const std::filesystem::path& image);
/// What a .prj beside an image says; empty where there is none. @errors kMalformed: no reference system.
[[nodiscard]] Result<std::string> crs_beside(const std::filesystem::path& image,
                                             const GdalMessages& messages);

/// What prepare_image has made of an image, if it is of this very state of the file.
[[nodiscard]] std::optional<std::filesystem::path> prepared_pixels(
    const std::filesystem::path& image, const std::filesystem::path& cache);
/// Opens it. @errors as open_image_file.
[[nodiscard]] Result<ImageFile> open_prepared_pixels(const std::filesystem::path& pixels,
                                                     const GdalMessages& messages);

}  // namespace nadir
