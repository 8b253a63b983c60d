// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/raster.h"
#include "core/base/result.h"
#include "core/map/image_look.h"
#include "core/map/overhead_map_file.h"

namespace nadir {

/// One square of an overhead at some resolution. Level 0 has the file's own cells, each next one half as many a side;
/// tile (0, 0) of every level begins at the map's upper left corner.
struct TileAddress {
  int level = 0, column = 0, row = 0;
  friend auto operator<=>(const TileAddress&, const TileAddress&) = default;
};

/// Side of a tile in its own pixels. Tiles at the right and lower border are smaller, and there a pixel need not be 2^level
/// cells: the pixels of a tile share the cells of cells_of(tile) evenly, so their size follows from those.
inline constexpr int kTileSide = 512;

struct TileSource;
struct TileWindow;

/// The rasters of a map package, or an image from anywhere (open_overhead_image), piece by piece, for looking at overheads
/// of any size: opening reads no pixels, and a tile costs what its own pixels cost, by way of the file's overviews. Those
/// that write_overhead_map makes have them; of a package's file without any, a coarse tile costs all the cells that it covers.
/// Tiles may be asked for from several threads, which then take turns; what GDAL keeps of them is bounded (128 MB in all).
class OverheadTiles {
 public:
  enum class Layer { kPicture, kLabels };

  /// @errors kNotFound (no such layer in the package), kMalformed, kUnsupported, as read_overhead_map. Ids that are no class
  /// show only where labels() comes across them.
  [[nodiscard]] static Result<OverheadTiles> open(const std::filesystem::path& package,
                                                  Layer layer);
  /// From inside this module.
  explicit OverheadTiles(std::unique_ptr<const TileSource> source);
  OverheadTiles(OverheadTiles&&) noexcept;
  ~OverheadTiles();

  [[nodiscard]] int width() const;   ///< Cells of level 0.
  [[nodiscard]] int height() const;  ///< Cells of level 0.
  [[nodiscard]] double metres_per_cell() const;
  /// Corner of the map, project plane, with the offset.
  [[nodiscard]] Eigen::Vector2d top_left_in_enu_m() const;
  /// Moves all of it on the plane, for imagery that is metres off. What the file says of itself stays as it is.
  void set_offset(const Eigen::Vector2d& offset_in_enu_m) { offset_in_enu_m_ = offset_in_enu_m; }
  /// Where a place of the plane is in an image's own pixels, (column, row) from its upper-left corner, also outside it.
  /// Nothing for a package's rasters, whose pixels are cells, and where there is no such place.
  [[nodiscard]] std::optional<Eigen::Vector2d> pixels_from_enu(
      const Eigen::Vector2d& point_in_enu_m) const;
  /// The last level fits into one tile.
  [[nodiscard]] int level_count() const;
  /// Tiles of a level.
  [[nodiscard]] int columns(int level) const;
  [[nodiscard]] int rows(int level) const;
  /// Level-0 cells that a tile covers: left, top, width, height.
  [[nodiscard]] Eigen::Vector4i cells_of(const TileAddress& tile) const;

  /// Averaged for levels above 0, clear where nothing was seen. Only of a picture. Of an image whose overviews are still to be
  /// made a coarse tile is 16 x 16 places of the file. @errors kMalformed: the file is damaged there.
  [[nodiscard]] Result<ImageRaster> picture(const TileAddress& tile) const;
  /// The nearest cell for levels above 0, so that no class is invented. Only of labels. @errors kMalformed: the file is
  /// damaged there, or holds an id that is no class.
  [[nodiscard]] Result<Raster<ClassId>> labels(const TileAddress& tile) const;

 private:
  [[nodiscard]] TileWindow window_of(const TileAddress& tile) const;

  std::unique_ptr<const TileSource> source_;
  Eigen::Vector2d offset_in_enu_m_ = Eigen::Vector2d::Zero();
};

}  // namespace nadir
