// SPDX-License-Identifier: Apache-2.0
#include "tests/core/map/image_files.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace nadir {
namespace {

struct ImageCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using ImageDataset = std::unique_ptr<GDALDataset, ImageCloser>;

void demand_of_image(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("test image: " + what);
}

GDALDriver& image_driver(const std::string& name) {
  GDALAllRegister();
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName(name.c_str());
  demand_of_image(driver != nullptr, name);
  return *driver;
}

}  // namespace

void write_image(const DrawnImage& image, const std::filesystem::path& path) {
  const int width = image.pixels.width(), height = image.pixels.height();
  const int colours = image.is_grey ? 1 : 3;
  const int bands = colours + (image.has_alpha ? 1 : 0);
  const ImageDataset dataset(image_driver("MEM").Create(
      "", width, height, bands, image.value_factor > 1 ? GDT_UInt16 : GDT_Byte, nullptr));
  for (int number = 1; number <= bands; ++number) {
    GDALRasterBand& band = *dataset->GetRasterBand(number);
    std::vector<int> values;
    values.reserve(image.pixels.size());
    for (const ImagePixel& pixel : image.pixels.values()) {
      const std::array<std::uint8_t, 4> channels{pixel.red, pixel.green, pixel.blue, pixel.alpha};
      const bool is_alpha = number > colours;
      values.push_back(channels.at(is_alpha ? 3 : static_cast<std::size_t>(number - 1)) *
                       image.value_factor);
    }
    demand_of_image(band.RasterIO(GF_Write, 0, 0, width, height, values.data(), width, height,
                                  GDT_Int32, 0, 0, nullptr) == CE_None,
                    "values");
    if (image.no_data) band.SetNoDataValue(*image.no_data);
    if (number > colours) band.SetColorInterpretation(GCI_AlphaBand);
    if (number <= colours && colours == 3) {
      band.SetColorInterpretation(static_cast<GDALColorInterp>(GCI_RedBand + number - 1));
    }
  }
  if (image.crs_from_pixel) {
    std::array<double, 6> geotransform = image.crs_from_pixel->to_gdal();
    dataset->SetGeoTransform(geotransform.data());
  }
  if (!image.crs.empty()) {
    OGRSpatialReference crs;
    demand_of_image(crs.SetFromUserInput(image.crs.c_str()) == OGRERR_NONE, image.crs);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    dataset->SetSpatialRef(&crs);
  }
  if (image.is_pixel_is_point) dataset->SetMetadataItem("AREA_OR_POINT", "Point");
  for (const auto& [key, value, domain] : image.metadata) {
    dataset->SetMetadataItem(key.c_str(), value.c_str(), domain.c_str());
  }
  CPLStringList options;
  for (const std::string& option : image.options) options.AddString(option.c_str());
  const ImageDataset copy(
      image_driver(image.driver)
          .CreateCopy(path.c_str(), dataset.get(), FALSE, options.List(), nullptr, nullptr));
  demand_of_image(copy != nullptr, path.string());
}

void write_sparse_image(int side, const std::filesystem::path& path) {
  CPLStringList options;
  for (const char* const option : {"TILED=YES", "COMPRESS=DEFLATE", "SPARSE_OK=TRUE"}) {
    options.AddString(option);
  }
  const ImageDataset dataset(
      image_driver("GTiff").Create(path.c_str(), side, side, 3, GDT_Byte, options.List()));
  demand_of_image(dataset != nullptr, path.string());
  std::array<double, 6> geotransform{500'000.0, 0.25, 0.0, 5'300'000.0, 0.0, -0.25};
  dataset->SetGeoTransform(geotransform.data());
  OGRSpatialReference crs;
  crs.importFromEPSG(32632);
  dataset->SetSpatialRef(&crs);
}

ImagePixel mosaic_colour(int column, int row) {
  const int x = column / 16, y = row / 16;
  return {static_cast<std::uint8_t>(20 + x * 37 % 200),
          static_cast<std::uint8_t>(20 + y * 53 % 200),
          static_cast<std::uint8_t>(20 + (x + y) * 29 % 200), 255};
}

ImageRaster mosaic(int width, int height) {
  ImageRaster pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      pixels.at(column, row) = mosaic_colour(column, row);
    }
  }
  return pixels;
}

ImagePixel shown_at(const OverheadTiles& tiles, const Eigen::Vector2d& point_in_enu_m) {
  const Eigen::Vector2d offset_m = point_in_enu_m - tiles.top_left_in_enu_m();
  const double column = std::floor(offset_m.x() / tiles.metres_per_cell());
  const double row = std::floor(-offset_m.y() / tiles.metres_per_cell());
  if (!(column >= 0.0 && row >= 0.0 && column < tiles.width() && row < tiles.height())) {
    return {0, 0, 0, 0};
  }
  const int x = static_cast<int>(column), y = static_cast<int>(row);
  const TileAddress tile{0, x / kTileSide, y / kTileSide};
  return tiles.picture(tile).value().at(x % kTileSide, y % kTileSide);
}

ImageRaster whole_picture(const OverheadTiles& tiles) {
  ImageRaster whole(tiles.width(), tiles.height());
  for (int tile_row = 0; tile_row < tiles.rows(0); ++tile_row) {
    for (int tile_column = 0; tile_column < tiles.columns(0); ++tile_column) {
      const ImageRaster part = tiles.picture({0, tile_column, tile_row}).value();
      for (int row = 0; row < part.height(); ++row) {
        for (int column = 0; column < part.width(); ++column) {
          whole.at(tile_column * kTileSide + column, tile_row * kTileSide + row) =
              part.at(column, row);
        }
      }
    }
  }
  return whole;
}

}  // namespace nadir
