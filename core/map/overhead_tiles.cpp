// SPDX-License-Identifier: Apache-2.0
#include "core/map/overhead_tiles.h"

#include <gdal_priv.h>

#include <algorithm>

#include "core/base/require.h"
#include "core/map/gdal_raster.h"
#include "core/map/label_tiff.h"

namespace nadir {

struct OverheadTiles::Implementation {
  std::string name;
  TiffPlace place;
  GdalDataset dataset;

  /// Reads bands 1 to `bands` of a tile, interleaved by pixel, as numbers of `type`.
  Result<void> read(const TileAddress& tile,
                    const Eigen::Vector4i& cells,
                    int bands,
                    GDALRIOResampleAlg resampling,
                    int width,
                    int height,
                    GDALDataType type,
                    void* into) const {
    const GdalMessages messages;
    GDALRasterIOExtraArg extra;
    INIT_RASTERIO_EXTRA_ARG(extra);
    extra.eResampleAlg = resampling;
    const GSpacing size = GDALGetDataTypeSizeBytes(type);
    const CPLErr error =
        dataset->RasterIO(GF_Read, cells[0], cells[1], cells[2], cells[3], into, width, height,
                          type, bands, nullptr, bands * size, bands * size * width, size, &extra);
    if (error == CE_None && !messages.has_failed()) return {};
    return fail(ErrorCode::kMalformed, "{}: cannot be read at column {}, row {} of level {} ({})",
                name, tile.column, tile.row, tile.level, messages.text());
  }
};

OverheadTiles::OverheadTiles(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
OverheadTiles::OverheadTiles(OverheadTiles&&) noexcept = default;
OverheadTiles::~OverheadTiles() = default;

Result<OverheadTiles> OverheadTiles::open(const std::filesystem::path& package, Layer layer) {
  const auto plane = read_map_plane(package);
  if (!plane) return forward_error(plane);
  const std::filesystem::path path =
      package / (layer == Layer::kPicture ? "image.tif" : "labels.tif");
  auto made = std::make_unique<Implementation>();
  made->name = path.string();
  const auto place = read_tiff_place(path, *plane);
  if (!place) return forward_error(place);
  made->place = *place;
  const GdalMessages messages;
  auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  made->dataset = std::move(*dataset);
  const int bands = layer == Layer::kPicture ? 3 : 1;
  if (made->dataset->GetRasterCount() < bands) {
    return fail(ErrorCode::kMalformed, "{}: has {} bands instead of {}", made->name,
                made->dataset->GetRasterCount(), bands);
  }
  if (layer == Layer::kLabels) {
    const GDALDataType type = made->dataset->GetRasterBand(1)->GetRasterDataType();
    if (made->dataset->GetRasterCount() != 1 || GDALDataTypeIsInteger(type) == FALSE) {
      return fail(ErrorCode::kUnsupported, "{}: labels need one band of whole numbers", made->name);
    }
    if (const auto same = check_no_data(*made->dataset, made->name); !same) {
      return forward_error(same);
    }
  }
  return OverheadTiles(std::move(made));
}

int OverheadTiles::width() const { return implementation_->place.width; }
int OverheadTiles::height() const { return implementation_->place.height; }
double OverheadTiles::metres_per_cell() const { return implementation_->place.metres_per_cell; }
Eigen::Vector2d OverheadTiles::top_left_in_enu_m() const {
  return implementation_->place.top_left_in_enu_m;
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

namespace {

/// Pixels of a side of so many cells at a level: at least one.
int pixels_of(int cells, int level) { return std::max(1, (cells + (1 << level) - 1) >> level); }

}  // namespace

Result<ColourRaster> OverheadTiles::picture(const TileAddress& tile) const {
  static_assert(sizeof(Colour) == 3);
  const Eigen::Vector4i cells = cells_of(tile);
  ColourRaster pixels(pixels_of(cells[2], tile.level), pixels_of(cells[3], tile.level));
  auto* const bytes = reinterpret_cast<std::uint8_t*>(pixels.data());
  if (auto read = implementation_->read(tile, cells, 3, GRIORA_Average, pixels.width(),
                                        pixels.height(), GDT_Byte, bytes);
      !read) {
    return forward_error(read);
  }
  return pixels;
}

Result<Raster<ClassId>> OverheadTiles::labels(const TileAddress& tile) const {
  const Eigen::Vector4i cells = cells_of(tile);
  // As whole numbers, for what is no class must not become one when it is cut to eight bits.
  Raster<std::int32_t> ids(pixels_of(cells[2], tile.level), pixels_of(cells[3], tile.level));
  if (auto read = implementation_->read(tile, cells, 1, GRIORA_NearestNeighbour, ids.width(),
                                        ids.height(), GDT_Int32, ids.data());
      !read) {
    return forward_error(read);
  }
  Raster<ClassId> pixels(ids.width(), ids.height());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::int32_t id = ids.values()[i];
    if (id != kUnclassified && (id < 0 || id >= kClassCount)) {
      const int index = static_cast<int>(i);
      return fail(ErrorCode::kMalformed, "{}: id {} at column {}, row {} of level {} is no class",
                  implementation_->name, id, tile.column * kTileSide + index % ids.width(),
                  tile.row * kTileSide + index / ids.width(), tile.level);
    }
    pixels.values()[i] = static_cast<ClassId>(id);
  }
  return pixels;
}

}  // namespace nadir
