// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/gdal_raster.h"
#include "core/map/image_look.h"
#include "core/map/label_tiff.h"

namespace nadir {

/// What tiles are read from. Private to this module.

/// So many pixels of a file are read while somebody waits: some tens of milliseconds.
inline constexpr std::int64_t kQuickPixels = std::int64_t{2048} * 2048;

struct GdalTransformerCloser {
  void operator()(void* transformer) const;
};
/// GDAL's way from a raster's pixels to another's, and back.
using GdalTransformer = std::unique_ptr<void, GdalTransformerCloser>;

/// The values of a band that become black and white.
struct Stretch {
  double low = 0.0, high = 255.0;
};

/// Cells of a source, and how many pixels they are to become.
struct TileWindow {
  Eigen::Vector4i cells;  ///< Left, top, width, height.
  int width = 0, height = 0;
  std::string where;  ///< For messages: "column 1, row 2 of level 0".
};

/// The members are in the order in which they are made; they go the other way round.
struct TileSource {
  std::string name;  ///< The file, for messages.
  TiffPlace place;
  GdalDataset file;                      ///< Null, or what `pixels` is made of.
  GdalDataset pixels;                    ///< Null, or what `on_plane` is warped from.
  GdalDataset on_plane;                  ///< North-up square cells, as `place` says.
  GdalTransformer on_plane_from_pixels;  ///< Null where nothing is warped.
  std::vector<int> channels;       ///< Bands of `on_plane` that are red, green and blue, or grey.
  std::vector<int> file_channels;  ///< The same bands of `pixels`.
  int alpha =
      0;  ///< Band of `on_plane` that is 255 where there is something; 0: there is everywhere.
  std::vector<Stretch> stretch;  ///< Of each channel; empty where their bytes are colours.
  bool is_waiting = false;       ///< To be copied first: all tiles are clear.
  /// Reads from several threads take turns, for GDAL's datasets are for one.
  mutable std::mutex mutex;

  /// Whole numbers of the first band, the nearest cell for each pixel. @errors kMalformed: damaged there.
  [[nodiscard]] Result<Raster<std::int32_t>> read_numbers(const TileWindow& window) const;
  /// Averaged where pixels are larger than cells. Where that would cost more than kQuickPixels, because overviews are still
  /// missing, 16 x 16 places of the file stand for all others. @errors kMalformed: damaged there.
  [[nodiscard]] Result<ImageRaster> read_colours(const TileWindow& window) const;
  /// The place in the file's own pixels of one in cells; nothing where nothing is warped, or there is none.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_cell(const Eigen::Vector2d& cell) const;
};

/// Sample values of a band for its stretch, at most 512 x 512, without those that stand for nothing: from the coarsest
/// overview, or where there is none from 16 x 16 places. @errors kMalformed.
[[nodiscard]] Result<Stretch> stretch_of_band(GDALDataset& pixels,
                                              int band,
                                              const std::string& name,
                                              const GdalMessages& messages);

}  // namespace nadir
