// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tile_pictures.h"

#include <algorithm>
#include <utility>

#include "core/base/require.h"
#include "widgets/views/raster_pictures.h"

namespace nadir {
namespace {

int tiles_across(int cells, int level) {
  const std::int64_t side = std::int64_t{kTileSide} << level;
  return static_cast<int>((cells + side - 1) / side);
}

LabelGrid grid_of(const OverheadTiles& tiles, const Eigen::Vector2d& offset_in_enu_m) {
  return {tiles.metres_per_cell(), tiles.top_left_in_enu_m() + offset_in_enu_m, tiles.width(),
          tiles.height()};
}

}  // namespace

int TilePictures::columns(int level) const { return tiles_across(grid_.width, level); }
int TilePictures::rows(int level) const { return tiles_across(grid_.height, level); }

int TilePictures::level_count() const {
  int levels = 1;
  while (columns(levels - 1) > 1 || rows(levels - 1) > 1) ++levels;
  return levels;
}

CellRect TilePictures::cells_of(const TileAddress& tile) const {
  NADIR_REQUIRE(tile.level >= 0 && tile.level < level_count());
  const std::int64_t side = std::int64_t{kTileSide} << tile.level;
  const CellRect cells{tile.column * side, tile.row * side, (tile.column + 1) * side,
                       (tile.row + 1) * side};
  return cells.cut_to(grid_.whole());
}

Result<Raster<Rgba>> TilePictures::part(const TileAddress& tile, const CellRect& pixels) const {
  const auto whole = picture(tile);
  if (!whole) return forward_error(whole);
  Raster<Rgba> cut(static_cast<int>(pixels.width()), static_cast<int>(pixels.height()));
  for (int row = 0; row < cut.height(); ++row) {
    const auto from =
        whole->row(row + static_cast<int>(pixels.top))
            .subspan(static_cast<std::size_t>(pixels.left), static_cast<std::size_t>(cut.width()));
    std::copy(from.begin(), from.end(), cut.row(row).begin());
  }
  return cut;
}

OverheadPictures::OverheadPictures(std::shared_ptr<const OverheadTiles> tiles,
                                   OverheadTiles::Layer layer,
                                   const ImageLook& look,
                                   const Eigen::Vector2d& offset_in_enu_m)
    : TilePictures(grid_of(*tiles, offset_in_enu_m)),
      tiles_(std::move(tiles)),
      layer_(layer),
      look_(look) {}

bool OverheadPictures::is_smooth() const { return layer_ == OverheadTiles::Layer::kPicture; }

Result<Raster<Rgba>> OverheadPictures::picture(const TileAddress& tile) const {
  if (layer_ == OverheadTiles::Layer::kLabels) {
    const auto labels = tiles_->labels(tile);
    if (!labels) return forward_error(labels);
    return class_picture(*labels);
  }
  auto pixels = tiles_->picture(tile);
  if (!pixels) return forward_error(pixels);
  if (look_.brightness != 0.0 || look_.contrast != 0.0) apply_tones(tone_table(look_), *pixels);
  return colour_picture(*pixels);
}

}  // namespace nadir
