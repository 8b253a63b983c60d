// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_tiles.h"

#include <gdal_priv.h>

#include <algorithm>

#include "core/base/require.h"
#include "core/map/gdal_raster.h"
#include "core/map/label_tiff.h"
#include "core/map/tile_source.h"

namespace nadir {

OverheadTiles::OverheadTiles(std::unique_ptr<const TileSource> source)
    : source_(std::move(source)) {}
OverheadTiles::OverheadTiles(OverheadTiles&&) noexcept = default;
OverheadTiles::~OverheadTiles() = default;

Result<OverheadTiles> OverheadTiles::open(const std::filesystem::path& package, Layer layer) {
  const auto plane = read_map_plane(package);
  if (!plane) return forward_error(plane);
  const std::filesystem::path path =
      package / (layer == Layer::kPicture ? "image.tif" : "labels.tif");
  auto made = std::make_unique<TileSource>();
  made->name = path.string();
  const auto place = read_tiff_place(path, *plane);
  if (!place) return forward_error(place);
  made->place = *place;
  const GdalMessages messages;
  auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  made->on_plane = std::move(*dataset);
  if (layer == Layer::kPicture) {
    made->channels = {1, 2, 3};
  } else {
    made->channels = {1};
  }
  const auto bands = static_cast<int>(made->channels.size());
  if (made->on_plane->GetRasterCount() < bands) {
    return fail(ErrorCode::kMalformed, "{}: has {} bands instead of {}", made->name,
                made->on_plane->GetRasterCount(), bands);
  }
  if (layer == Layer::kLabels) {
    const GDALDataType type = made->on_plane->GetRasterBand(1)->GetRasterDataType();
    if (made->on_plane->GetRasterCount() != 1 || GDALDataTypeIsInteger(type) == FALSE) {
      return fail(ErrorCode::kUnsupported, "{}: labels need one band of whole numbers", made->name);
    }
    if (const auto same = check_no_data(*made->on_plane, made->name); !same) {
      return forward_error(same);
    }
  }
  return OverheadTiles(std::move(made));
}

int OverheadTiles::width() const { return source_->place.width; }
int OverheadTiles::height() const { return source_->place.height; }
double OverheadTiles::metres_per_cell() const { return source_->place.metres_per_cell; }
Eigen::Vector2d OverheadTiles::top_left_in_enu_m() const {
  return source_->place.top_left_in_enu_m + offset_in_enu_m_;
}

std::optional<Eigen::Vector2d> OverheadTiles::pixels_from_enu(
    const Eigen::Vector2d& point_in_enu_m) const {
  const Eigen::Vector2d offset_m = point_in_enu_m - top_left_in_enu_m();
  const Eigen::Vector2d cell =
      Eigen::Vector2d(offset_m.x(), -offset_m.y()) / source_->place.metres_per_cell;
  const std::lock_guard lock(source_->mutex);
  return source_->pixel_of_cell(cell);
}

int OverheadTiles::level_count() const {
  int levels = 1;
  while (columns(levels - 1) > 1 || rows(levels - 1) > 1) ++levels;
  return levels;
}

int OverheadTiles::columns(int level) const {
  const std::int64_t side = std::int64_t{kTileSide} << level;
  return static_cast<int>((width() + side - 1) / side);
}

int OverheadTiles::rows(int level) const {
  const std::int64_t side = std::int64_t{kTileSide} << level;
  return static_cast<int>((height() + side - 1) / side);
}

Eigen::Vector4i OverheadTiles::cells_of(const TileAddress& tile) const {
  NADIR_REQUIRE(tile.level >= 0 && tile.level < level_count());
  NADIR_REQUIRE(tile.column >= 0 && tile.column < columns(tile.level));
  NADIR_REQUIRE(tile.row >= 0 && tile.row < rows(tile.level));
  const std::int64_t side = std::int64_t{kTileSide} << tile.level;
  const auto left = static_cast<int>(tile.column * side);
  const auto top = static_cast<int>(tile.row * side);
  return {left, top, static_cast<int>(std::min<std::int64_t>(side, width() - left)),
          static_cast<int>(std::min<std::int64_t>(side, height() - top))};
}

TileWindow OverheadTiles::window_of(const TileAddress& tile) const {
  const Eigen::Vector4i cells = cells_of(tile);
  // Pixels of a side of so many cells: at least one.
  const auto pixels = [&tile](int count) {
    return std::max(1, (count + (1 << tile.level) - 1) >> tile.level);
  };
  return {cells, pixels(cells[2]), pixels(cells[3]),
          fmt::format("column {}, row {} of level {}", tile.column, tile.row, tile.level)};
}

Result<ImageRaster> OverheadTiles::picture(const TileAddress& tile) const {
  return source_->read_colours(window_of(tile));
}

Result<Raster<ClassId>> OverheadTiles::labels(const TileAddress& tile) const {
  // As whole numbers, for what is no class must not become one when it is cut to eight bits.
  const auto read = source_->read_numbers(window_of(tile));
  if (!read) return forward_error(read);
  const Raster<std::int32_t>& ids = *read;
  Raster<ClassId> pixels(ids.width(), ids.height());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::int32_t id = ids.values()[i];
    if (id != kUnclassified && (id < 0 || id >= kClassCount)) {
      const int index = static_cast<int>(i);
      return fail(ErrorCode::kMalformed, "{}: id {} at column {}, row {} of level {} is no class",
                  source_->name, id, tile.column * kTileSide + index % ids.width(),
                  tile.row * kTileSide + index / ids.width(), tile.level);
    }
    pixels.values()[i] = static_cast<ClassId>(id);
  }
  return pixels;
}

}  // namespace nadir
