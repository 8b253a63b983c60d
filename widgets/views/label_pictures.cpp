// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/label_pictures.h"

#include <cmath>
#include <utility>

#include "core/base/require.h"
#include "core/label/label_raster.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {

LabelPictures::LabelPictures(std::shared_ptr<const LabelDocument> document)
    : TilePictures(document->grid()), document_(std::move(document)) {}

LabelGrid LabelPictures::grid_of_level(int level) const {
  const auto pixels = [level](int cells) {
    return static_cast<int>((std::int64_t{cells} + (std::int64_t{1} << level) - 1) >> level);
  };
  return {std::ldexp(grid().metres_per_cell, level), grid().top_left_in_enu_m, pixels(grid().width),
          pixels(grid().height)};
}

CellRect LabelPictures::pixels_of(const TileAddress& tile) const {
  const CellRect square{std::int64_t{tile.column} * kTileSide, std::int64_t{tile.row} * kTileSide,
                        std::int64_t{tile.column + 1} * kTileSide,
                        std::int64_t{tile.row + 1} * kTileSide};
  return square.cut_to(grid_of_level(tile.level).whole());
}

CellRect LabelPictures::cells_of(const TileAddress& tile) const {
  NADIR_REQUIRE(tile.level >= 0 && tile.level < level_count());
  const CellRect pixels = pixels_of(tile);
  const std::int64_t side = std::int64_t{1} << tile.level;
  return {pixels.left * side, pixels.top * side, pixels.right * side, pixels.bottom * side};
}

Result<Raster<Rgba>> LabelPictures::picture(const TileAddress& tile) const {
  const CellRect pixels = pixels_of(tile);
  return part(tile, {0, 0, pixels.width(), pixels.height()});
}

Result<Raster<Rgba>> LabelPictures::part(const TileAddress& tile, const CellRect& pixels) const {
  const CellRect all = pixels_of(tile);
  const CellRect window{all.left + pixels.left, all.top + pixels.top, all.left + pixels.right,
                        all.top + pixels.bottom};
  return class_picture(rasterise(*document_, grid_of_level(tile.level), window));
}

}  // namespace nadir
