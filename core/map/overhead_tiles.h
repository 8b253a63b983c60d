// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <memory>
#include <string>

#include "core/base/raster.h"
#include "core/base/result.h"
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

/// The rasters of a map package piece by piece, for looking at maps of any size: opening reads no pixels, and a tile costs
/// what its own pixels cost, by way of the file's overviews. Those that write_overhead_map makes have them; of a file without
/// any, a coarse tile costs all the cells that it covers. Not to be shared between threads.
class OverheadTiles {
 public:
  enum class Layer { kPicture, kLabels };

  /// @errors kNotFound (no such layer in the package), kMalformed, kUnsupported, as read_overhead_map. Ids that are no class
  /// show only where labels() comes across them.
  [[nodiscard]] static Result<OverheadTiles> open(const std::filesystem::path& package,
                                                  Layer layer);
  OverheadTiles(OverheadTiles&&) noexcept;
  ~OverheadTiles();

  [[nodiscard]] int width() const;   ///< Cells of level 0.
  [[nodiscard]] int height() const;  ///< Cells of level 0.
  [[nodiscard]] double metres_per_cell() const;
  [[nodiscard]] Eigen::Vector2d top_left_in_enu_m() const;  ///< Corner of the map, project plane.
  /// The last level fits into one tile.
  [[nodiscard]] int level_count() const;
  /// Tiles of a level.
  [[nodiscard]] int columns(int level) const;
  [[nodiscard]] int rows(int level) const;
  /// Level-0 cells that a tile covers: left, top, width, height.
  [[nodiscard]] Eigen::Vector4i cells_of(const TileAddress& tile) const;

  /// Averaged for levels above 0. Only of a picture. @errors kMalformed: the file is damaged there.
  [[nodiscard]] Result<ColourRaster> picture(const TileAddress& tile) const;
  /// The nearest cell for levels above 0, so that no class is invented. Only of labels. @errors kMalformed: the file is
  /// damaged there, or holds an id that is no class.
  [[nodiscard]] Result<Raster<ClassId>> labels(const TileAddress& tile) const;

 private:
  struct Implementation;
  explicit OverheadTiles(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
