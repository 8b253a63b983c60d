// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/geo/affine2.h"
#include "core/map/overhead_map_file.h"

class GDALDataset;

namespace nadir {

/// What the readers of rasters share. Private to this module: nothing else includes it.

/// More cells than this are taken for a damaged header or a mistaken resolution.
inline constexpr std::int64_t kMaxMapCells = 1'000'000'000;

struct GdalCloser {
  void operator()(GDALDataset* dataset) const;
};
using GdalDataset = std::unique_ptr<GDALDataset, GdalCloser>;

/// While it lives, GDAL prints nothing from this thread; its first failure is kept instead.
/// Registers the drivers too.
class GdalMessages {
 public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  [[nodiscard]] bool has_failed() const { return has_failed_; }
  /// GDAL's words for the first failure on one line without full stop, or "unknown fault".
  [[nodiscard]] std::string text() const;
  void note_failure(const char* message);

 private:
  bool has_failed_ = false;
  std::string first_failure_;
};

/// Where a raster lies in some coordinate reference system, x before y and longitude before
/// latitude.
struct Placement {
  Affine2 crs_from_pixel;
  std::string crs_wkt;
  int width = 0;
  int height = 0;
  /// How far its worst ground control point is from where the raster was placed; 0 where it has
  /// none.
  double control_point_error_px = 0.0;
};

/// Opens for reading. @errors kNotFound, kMalformed (no raster, truncated header), kUnsupported
/// (too many cells).
[[nodiscard]] Result<GdalDataset> open_raster(const std::filesystem::path& path,
                                              const GdalMessages& messages);

/// Gives `take` the values of the first band as they are, row by row from the top. @errors
/// kMalformed: truncated, and whatever `take` returns.
[[nodiscard]] Result<void> read_rows(
    GDALDataset& dataset,
    const std::string& name,
    const GdalMessages& messages,
    const std::function<Result<void>(int row, std::span<const std::int32_t> values)>& take);
/// The first band's no-data value, if it has one.
[[nodiscard]] std::optional<double> no_data_of(GDALDataset& dataset);
/// The only band, 8-bit ids; the source's own no-data value becomes kUnclassified.
/// @errors kMalformed: truncated, or values outside [0, 255]; kUnsupported: more bands, not whole
/// numbers.
[[nodiscard]] Result<Raster<std::uint8_t>> read_ids(GDALDataset& dataset,
                                                    const std::string& name,
                                                    const GdalMessages& messages);
/// The first three bands, or one band by its colour table or as grey. @errors kMalformed,
/// kUnsupported (not 8 bit).
[[nodiscard]] Result<ColourRaster> read_colours(GDALDataset& dataset,
                                                const std::string& name,
                                                const GdalMessages& messages);

/// Where the file says it lies, by geotransform, world file or ground control points; nothing where
/// it says nothing.
/// @param crs  "EPSG:25832" or WKT for a file that has none; empty otherwise.
/// @errors kMalformed (singular, not finite, latitude beyond a pole, place without CRS, ground
/// control points that contradict each other by more than 3 pixels),
/// kInvalidOptions (bad `crs`, or the file has another).
[[nodiscard]] Result<std::optional<Placement>> placement_of(GDALDataset& dataset,
                                                            const std::string& crs,
                                                            const std::string& name,
                                                            const GdalMessages& messages);
/// Whether the file names a coordinate reference system itself.
[[nodiscard]] bool has_own_crs(GDALDataset& dataset);
/// Says in a dataset that is being written where it lies.
void set_placement(GDALDataset& dataset, const Placement& placement);

}  // namespace nadir
