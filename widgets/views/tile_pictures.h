// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/label/label_grid.h"
#include "core/map/overhead_tiles.h"
#include "widgets/canvas/canvas.h"

namespace nadir {

/// Where the pictures of tiles come from: something of any size that lies on the plane, in levels, each with half as many
/// pixels a side as the one before. Never changes once it is made; all of it may be asked from several threads.
class TilePictures {
 public:
  /// @param grid  Cells of level 0: pixel (column, row) of the whole begins at enu_from_cells({column, row}).
  explicit TilePictures(const LabelGrid& grid) : grid_(grid) {}
  virtual ~TilePictures() = default;
  TilePictures(const TilePictures&) = delete;
  TilePictures& operator=(const TilePictures&) = delete;

  [[nodiscard]] const LabelGrid& grid() const { return grid_; }
  /// The last level fits into one tile.
  [[nodiscard]] int level_count() const;
  /// Tiles of a level.
  [[nodiscard]] int columns(int level) const;
  [[nodiscard]] int rows(int level) const;
  /// Cells of level 0 that the pixels of a tile share evenly. Here none outside of the grid.
  [[nodiscard]] virtual CellRect cells_of(const TileAddress& tile) const;
  /// Whether colours between pixels may be mixed: not where they stand for classes.
  [[nodiscard]] virtual bool is_smooth() const = 0;
  /// Whether part() takes little more than it takes to show it, so that a frame may wait for it.
  [[nodiscard]] virtual bool is_quick() const { return false; }
  /// At most kTileSide a side, not empty. @errors kMalformed: the file is damaged there; kIo.
  [[nodiscard]] virtual Result<Raster<Rgba>> picture(const TileAddress& tile) const = 0;
  /// Some pixels of picture(), which may cost less than all. @param pixels  Of the tile, not empty, within it.
  [[nodiscard]] virtual Result<Raster<Rgba>> part(const TileAddress& tile,
                                                  const CellRect& pixels) const;

 private:
  LabelGrid grid_;
};

/// The rasters of a map package, or an overhead image, as their file has them.
class OverheadPictures final : public TilePictures {
 public:
  /// @param tiles  Not null. @param look  Brightness and contrast of a picture; labels have none.
  /// @param offset_in_enu_m  Besides that of the tiles.
  OverheadPictures(std::shared_ptr<const OverheadTiles> tiles,
                   OverheadTiles::Layer layer,
                   const ImageLook& look = {},
                   const Eigen::Vector2d& offset_in_enu_m = Eigen::Vector2d::Zero());

  [[nodiscard]] bool is_smooth() const override;
  [[nodiscard]] Result<Raster<Rgba>> picture(const TileAddress& tile) const override;

 private:
  std::shared_ptr<const OverheadTiles> tiles_;
  OverheadTiles::Layer layer_;
  ImageLook look_;
};

}  // namespace nadir
