// SPDX-License-Identifier: Apache-2.0
#include "tests/core/map/raster_files.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "core/base/random.h"

namespace nadir {
namespace {

struct Closer {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Closer>;

void need(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error("test raster: " + what);
}

OGRSpatialReference crs_of(const std::string& text) {
  OGRSpatialReference crs;
  need(crs.SetFromUserInput(text.c_str()) == OGRERR_NONE, text);
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

Dataset open(const std::filesystem::path& path) {
  GDALAllRegister();
  Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  need(dataset != nullptr, path.string());
  return dataset;
}

Dataset in_memory(int width, int height, int bands, GDALDataType type = GDT_Byte) {
  GDALAllRegister();
  GDALDriver* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  return Dataset(memory->Create("", width, height, bands, type, nullptr));
}

void fill_band(GDALRasterBand& band, const RasterFile& file) {
  const int width = file.ids.width();
  const int height = file.ids.height();
  std::vector<int> values(file.ids.values().begin(), file.ids.values().end());
  if (file.bits == 16) {
    for (int& value : values) value *= 257;
  }
  need(band.RasterIO(GF_Write, 0, 0, width, height, values.data(), width, height, GDT_Int32, 0, 0,
                     nullptr) == CE_None,
       "values");
  if (!file.palette.empty()) {
    GDALColorTable table;
    for (std::size_t i = 0; i < file.palette.size(); ++i) {
      const Colour& colour = file.palette[i];
      const GDALColorEntry entry{colour.red, colour.green, colour.blue, 255};
      table.SetColorEntry(static_cast<int>(i), &entry);
    }
    band.SetColorTable(&table);
  }
  if (file.no_data) band.SetNoDataValue(*file.no_data);
  CPLStringList names;
  for (const std::string& name : file.category_names) names.AddString(name.c_str());
  if (!file.category_names.empty()) band.SetCategoryNames(names.List());
}

void set_control_points(GDALDataset& dataset, const RasterFile& file) {
  std::vector<GDAL_GCP> points(file.control_points.size());
  GDALInitGCPs(static_cast<int>(points.size()), points.data());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].dfGCPPixel = file.control_points[i].pixel.x();
    points[i].dfGCPLine = file.control_points[i].pixel.y();
    points[i].dfGCPX = file.control_points[i].point_in_crs.x();
    points[i].dfGCPY = file.control_points[i].point_in_crs.y();
  }
  const OGRSpatialReference crs = crs_of(file.crs);
  dataset.SetGCPs(static_cast<int>(points.size()), points.data(), &crs);
  GDALDeinitGCPs(static_cast<int>(points.size()), points.data());
}

void copy_to(GDALDataset& dataset,
             const std::string& driver_name,
             const std::filesystem::path& path,
             const CPLStringList& options = {}) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name.c_str());
  const Dataset copy(
      driver->CreateCopy(path.c_str(), &dataset, FALSE, options.List(), nullptr, nullptr));
  need(copy != nullptr, path.string());
}

Eigen::Vector2d transformed(const std::string& source,
                            const std::string& target,
                            const Eigen::Vector2d& point) {
  const OGRSpatialReference from = crs_of(source);
  const OGRSpatialReference to = crs_of(target);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&from, &to));
  double x = point.x();
  double y = point.y();
  need(transformation->Transform(1, &x, &y) != FALSE, target);
  return {x, y};
}

}  // namespace

void write_raster(const RasterFile& file, const std::filesystem::path& path) {
  const Dataset dataset = in_memory(file.ids.width(), file.ids.height(), file.copies,
                                    file.bits == 16 ? GDT_UInt16 : GDT_Byte);
  for (int i = 1; i <= file.copies; ++i) fill_band(*dataset->GetRasterBand(i), file);
  if (file.crs_from_pixel) {
    std::array<double, 6> geotransform = file.crs_from_pixel->to_gdal();
    dataset->SetGeoTransform(geotransform.data());
  }
  if (!file.control_points.empty()) {
    set_control_points(*dataset, file);
  } else if (!file.crs.empty()) {
    const OGRSpatialReference crs = crs_of(file.crs);
    dataset->SetSpatialRef(&crs);
  }
  if (file.is_pixel_is_point) dataset->SetMetadataItem("AREA_OR_POINT", "Point");
  CPLStringList options;
  if (file.bits < 8) options.SetNameValue("NBITS", std::to_string(file.bits).c_str());
  copy_to(*dataset, file.driver, path, options);
}

void write_picture(const ColourRaster& picture, const std::filesystem::path& path) {
  const int width = picture.width();
  const int height = picture.height();
  const Dataset dataset = in_memory(width, height, 3);
  std::array<int, 3> bands{1, 2, 3};
  need(dataset->RasterIO(GF_Write, 0, 0, width, height, const_cast<Colour*>(picture.data()), width,
                         height, GDT_Byte, 3, bands.data(), 3, GSpacing{3} * width, 1,
                         nullptr) == CE_None,
       "values");
  copy_to(*dataset, "PNG", path);
}

Raster<std::uint8_t> read_overview(const std::filesystem::path& path, int level) {
  const Dataset dataset = open(path);
  GDALRasterBand* overview = dataset->GetRasterBand(1)->GetOverview(level);
  need(overview != nullptr, "overview");
  Raster<std::uint8_t> values(overview->GetXSize(), overview->GetYSize());
  need(overview->RasterIO(GF_Read, 0, 0, values.width(), values.height(), values.data(),
                          values.width(), values.height(), GDT_Byte, 0, 0, nullptr) == CE_None,
       "overview values");
  return values;
}

int overview_count(const std::filesystem::path& path) {
  return open(path)->GetRasterBand(1)->GetOverviewCount();
}

std::array<int, 3> palette_entry(const std::filesystem::path& path, int index) {
  const Dataset dataset = open(path);
  const GDALColorTable* table = dataset->GetRasterBand(1)->GetColorTable();
  need(table != nullptr, "palette");
  const GDALColorEntry* entry = table->GetColorEntry(index);
  return {entry->c1, entry->c2, entry->c3};
}

std::string band_metadata(const std::filesystem::path& path, const std::string& key) {
  const Dataset dataset = open(path);
  const char* text = dataset->GetRasterBand(1)->GetMetadataItem(key.c_str());
  return text != nullptr ? text : "";
}

std::vector<std::string> category_names(const std::filesystem::path& path) {
  const Dataset dataset = open(path);
  // GDAL reads the file beside a GeoTIFF only once the place is asked for.
  std::array<double, 6> geotransform{};
  static_cast<void>(dataset->GetGeoTransform(geotransform.data()));
  std::vector<std::string> names;
  for (char** name = dataset->GetRasterBand(1)->GetCategoryNames();
       name != nullptr && *name != nullptr; ++name) {
    names.emplace_back(*name);
  }
  return names;
}

Eigen::Vector2d crs_from_lon_lat(const std::string& crs, const Eigen::Vector2d& point) {
  return transformed("EPSG:4326", crs, point);
}

Eigen::Vector2d lon_lat_from_crs(const std::string& crs, const Eigen::Vector2d& point) {
  return transformed(crs, "EPSG:4326", point);
}

std::int64_t cells_that_disagree(const OverheadMap& map,
                                 const RasterFile& source,
                                 double margin_px) {
  const OGRSpatialReference from = crs_of("EPSG:4326");
  const OGRSpatialReference to = crs_of(source.crs);
  const std::unique_ptr<OGRCoordinateTransformation> transformation(
      OGRCreateCoordinateTransformation(&from, &to));
  const Affine2 pixel_from_crs = source.crs_from_pixel.value().inverse().value();
  std::int64_t disagreeing = 0;
  for (int row = 0; row < map.labels.height(); ++row) {
    for (int column = 0; column < map.labels.width(); ++column) {
      const Geodetic geodetic =
          map.plane.geodetic_from_enu(map.enu_from_overhead({column + 0.5, row + 0.5}));
      double x = geodetic.longitude_deg;
      double y = geodetic.latitude_deg;
      need(transformation->Transform(1, &x, &y) != FALSE, source.crs);
      const Eigen::Vector2d pixel = pixel_from_crs * Eigen::Vector2d(x, y);
      const Eigen::Array2d to_border = (pixel.array() - pixel.array().round()).abs();
      if (to_border.minCoeff() < margin_px) continue;
      const int source_column = static_cast<int>(std::floor(pixel.x()));
      const int source_row = static_cast<int>(std::floor(pixel.y()));
      const ClassId expected = source.ids.contains(source_column, source_row)
                                   ? source.ids.at(source_column, source_row)
                                   : ClassId{kUnclassified};
      if (map.labels.at(column, row) != expected) ++disagreeing;
    }
  }
  return disagreeing;
}

std::string world_file(const Affine2& crs_from_pixel) {
  const Eigen::Vector2d centre = crs_from_pixel * Eigen::Vector2d(0.5, 0.5);
  const Eigen::Matrix2d& linear = crs_from_pixel.linear;
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n", linear(0, 0), linear(1, 0), linear(0, 1),
                     linear(1, 1), centre.x(), centre.y());
}

std::vector<std::string> our_class_names() {
  std::vector<std::string> names;
  for (int id = 0; id < kClassCount; ++id) {
    names.emplace_back(class_info(static_cast<ClassId>(id)).name);
  }
  return names;
}

Raster<std::uint8_t> patchwork(int width, int height) {
  constexpr std::array<ClassId, 3> kClasses{kRoad, kTerrain, kSidewalk};
  Raster<std::uint8_t> ids(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const DrawId block{7, 0, static_cast<std::uint32_t>(row / 3),
                         static_cast<std::uint32_t>(column / 3), 0};
      ids.at(column, row) = kClasses.at(random_words(block)[0] % kClasses.size());
    }
  }
  return ids;
}

}  // namespace nadir
