// SPDX-License-Identifier: Apache-2.0
#include "core/map/label_tiff.h"

#include <cpl_string.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/require.h"
#include "core/map/crs.h"
#include "core/map/gdal_raster.h"
#include "core/map/map_warp.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

/// Whether the file's own coordinate reference system is `plane`, told by where two of its points
/// lie, for the same system can be written in many ways. @errors kMalformed.
Result<void> check_plane(const Placement& placement,
                         const ProjectPlane& plane,
                         const std::string& name) {
  constexpr double kToleranceDeg = 1e-7;  // about a centimetre
  const auto geodetic_from_crs = CrsTransform::create(crs_from_wkt(placement.crs_wkt), wgs84());
  if (!geodetic_from_crs) return forward_error(geodetic_from_crs, name);
  for (const Eigen::Vector2d& point : {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1e3, 1e3)}) {
    const Geodetic expected = plane.geodetic_from_enu(point);
    const std::optional<Eigen::Vector2d> found = (*geodetic_from_crs)(point);
    if (!found || !(std::abs(found->x() - expected.longitude_deg) < kToleranceDeg) ||
        !(std::abs(found->y() - expected.latitude_deg) < kToleranceDeg)) {
      return fail(
          ErrorCode::kMalformed,
          "{}: its coordinate reference system is not the plane of map.toml, import it anew", name);
    }
  }
  return {};
}

Result<TiffPlace> place_on(GDALDataset& dataset,
                           const ProjectPlane& plane,
                           const std::string& name,
                           const GdalMessages& messages) {
  const auto placement = placement_of(dataset, {}, name, messages);
  if (!placement) return forward_error(placement);
  if (!placement->has_value()) return fail(ErrorCode::kMalformed, "{}: has no georeference", name);
  if (const auto same = check_plane(**placement, plane, name); !same) return forward_error(same);

  const Affine2& affine = (*placement)->crs_from_pixel;
  const double cell_m = affine.linear(0, 0);
  const int longest = std::max((*placement)->width, (*placement)->height);
  // Less than a hundredth of a cell over the whole raster is rounding, not a rotation.
  const double tolerance_m = 0.01 * std::abs(cell_m) / longest;
  if (!(cell_m > 0.0) || std::abs(affine.linear(0, 1)) > tolerance_m ||
      std::abs(affine.linear(1, 0)) > tolerance_m || !(affine.linear(1, 1) < 0.0)) {
    return fail(ErrorCode::kMalformed, "{}: is not north-up, import it anew", name);
  }
  if (std::abs(cell_m + affine.linear(1, 1)) > tolerance_m) {
    return fail(ErrorCode::kMalformed, "{}: its cells of {} x {} m are not square, import it anew",
                name, cell_m, -affine.linear(1, 1));
  }
  return TiffPlace{cell_m, affine.offset, (*placement)->width, (*placement)->height};
}

/// Overviews of halved size down to one that fits a small window.
std::vector<int> overview_factors(int width, int height) {
  constexpr int kSmallest = 256;
  std::vector<int> factors;
  for (int factor = 2; std::max(width, height) / factor >= kSmallest / 2; factor *= 2) {
    factors.push_back(factor);
  }
  return factors;
}

Result<GdalDataset> create_tiff(const MapGrid& grid,
                                const fs::path& path,
                                int bands,
                                const CPLStringList& options,
                                const GdalMessages& messages) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  NADIR_REQUIRE(driver != nullptr && grid.width > 0 && grid.height > 0);
  NADIR_REQUIRE(grid.metres_per_cell > 0.0);
  GdalDataset dataset(
      driver->Create(path.c_str(), grid.width, grid.height, bands, GDT_Byte, options.List()));
  if (dataset == nullptr) return fail(ErrorCode::kIo, "{}: {}", path.string(), messages.text());
  set_placement(*dataset, placement_on(grid));
  return dataset;
}

/// Makes overviews and closes, which is when GDAL writes most of a file. @errors kIo, such as a
/// full disk.
Result<void> finish_tiff(GdalDataset dataset,
                         const char* resampling,
                         const fs::path& path,
                         const GdalMessages& messages) {
  std::vector<int> factors = overview_factors(dataset->GetRasterXSize(), dataset->GetRasterYSize());
  if (!factors.empty() && !messages.has_failed()) {
    dataset->BuildOverviews(resampling, static_cast<int>(factors.size()), factors.data(), 0,
                            nullptr, nullptr, nullptr);
  }
  dataset->FlushCache(false);
  dataset.reset();
  if (messages.has_failed()) {
    return fail(ErrorCode::kIo, "{}: cannot be written ({})", path.string(), messages.text());
  }
  return {};
}

Result<void> check_ids(const Raster<ClassId>& labels, const std::string& name) {
  const auto& values = labels.values();
  const auto bad = std::find_if(values.begin(), values.end(), [](ClassId id) {
    return id >= kClassCount && id != kUnclassified;
  });
  if (bad == values.end()) return {};
  const auto index = static_cast<std::size_t>(bad - values.begin());
  const auto width = static_cast<std::size_t>(labels.width());
  return fail(ErrorCode::kMalformed, "{}: id {} at column {}, row {} is no class", name,
              static_cast<int>(*bad), index % width, index / width);
}

MapGrid grid_of(const OverheadMap& map) {
  return {map.plane, map.metres_per_cell, map.top_left_in_enu_m, map.labels.width(),
          map.labels.height()};
}

}  // namespace

void describe_classes(GDALRasterBand& band) {
  GDALColorTable colours;
  CPLStringList names;
  for (int id = 0; id < kClassCount; ++id) {
    const ClassInfo& info = class_info(static_cast<ClassId>(id));
    const GDALColorEntry entry{info.colour.red, info.colour.green, info.colour.blue, 255};
    colours.SetColorEntry(id, &entry);
    names.AddString(std::string(info.name).c_str());
  }
  const GDALColorEntry nothing{0, 0, 0, 0};
  colours.SetColorEntry(kUnclassified, &nothing);
  band.SetColorTable(&colours);
  band.SetNoDataValue(kUnclassified);
  band.SetDescription("semantic class");
  // GDAL keeps category names in a file beside the TIFF, where GIS programs look; inside it they
  // are plain metadata.
  band.SetCategoryNames(names.List());
  for (int id = 0; id < kClassCount; ++id) {
    band.SetMetadataItem(fmt::format("CLASS_{}", id).c_str(), names[id]);
  }
}

Result<void> check_no_data(GDALDataset& dataset, const std::string& name) {
  const std::optional<double> no_data = no_data_of(dataset);
  if (!no_data || *no_data == double{kUnclassified}) return {};
  return fail(ErrorCode::kMalformed, "{}: its no-data value is {} and not {}, import it anew", name,
              *no_data, static_cast<int>(kUnclassified));
}

Result<LabelTiff> read_label_tiff(const fs::path& path, const ProjectPlane& plane) {
  const GdalMessages messages;
  const auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  const auto place = place_on(**dataset, plane, path.string(), messages);
  if (!place) return forward_error(place);
  if (const auto checked = check_no_data(**dataset, path.string()); !checked) {
    return forward_error(checked);
  }
  auto labels = read_ids(**dataset, path.string(), messages);
  if (!labels) return forward_error(labels);
  if (const auto checked = check_ids(*labels, path.string()); !checked) {
    return forward_error(checked);
  }
  return LabelTiff{*place, std::move(*labels)};
}

Result<TiffPlace> read_tiff_place(const fs::path& path, const ProjectPlane& plane) {
  const GdalMessages messages;
  const auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  return place_on(**dataset, plane, path.string(), messages);
}

Result<ColourRaster> read_image_tiff(const fs::path& path) {
  const GdalMessages messages;
  const auto dataset = open_raster(path, messages);
  if (!dataset) return forward_error(dataset);
  return read_colours(**dataset, path.string(), messages);
}

Result<void> write_label_tiff(const OverheadMap& map, const fs::path& path) {
  const auto rows = [&map](int first, int count) -> Result<Raster<ClassId>> {
    Raster<ClassId> strip(map.labels.width(), count);
    std::copy_n(map.labels.row(first).data(), strip.size(), strip.data());
    return strip;
  };
  return write_label_tiff({map.name, map.plane, map.metres_per_cell, map.top_left_in_enu_m,
                           map.labels.width(), map.labels.height(), rows},
                          path);
}

Result<void> write_label_tiff(const LabelStrips& labels, const fs::path& path) {
  constexpr int kRowsAtOnce = 1024;  // A whole number of rows of tiles.
  const GdalMessages messages;
  CPLStringList options;
  // Level 9 takes four times as long and saves nothing.
  for (const char* option : {"TILED=YES", "COMPRESS=DEFLATE", "ZLEVEL=7", "BIGTIFF=IF_SAFER"}) {
    options.AddString(option);
  }
  auto dataset = create_tiff(
      {labels.plane, labels.metres_per_cell, labels.top_left_in_enu_m, labels.width, labels.height},
      path, 1, options, messages);
  if (!dataset) return forward_error(dataset);
  GDALRasterBand& band = *(*dataset)->GetRasterBand(1);
  describe_classes(band);
  for (int first = 0; first < labels.height; first += kRowsAtOnce) {
    const int count = std::min(kRowsAtOnce, labels.height - first);
    auto strip = labels.rows(first, count);
    if (!strip) return forward_error(strip);
    NADIR_REQUIRE(strip->width() == labels.width && strip->height() == count);
    if (band.RasterIO(GF_Write, 0, first, labels.width, count, strip->data(), labels.width, count,
                      GDT_Byte, 0, 0, nullptr) != CE_None) {
      return fail(ErrorCode::kIo, "{}: cannot be written ({})", path.string(), messages.text());
    }
  }
  return finish_tiff(std::move(*dataset), "NEAREST", path, messages);
}

Result<void> write_image_tiff(const OverheadMap& map,
                              const ColourRaster& image,
                              const fs::path& path) {
  const GdalMessages messages;
  CPLStringList options;
  for (const char* option : {"TILED=YES", "COMPRESS=JPEG", "JPEG_QUALITY=85", "PHOTOMETRIC=YCBCR",
                             "INTERLEAVE=PIXEL", "BIGTIFF=IF_SAFER"}) {
    options.AddString(option);
  }
  auto dataset = create_tiff(grid_of(map), path, 3, options, messages);
  if (!dataset) return forward_error(dataset);
  auto* pixels = const_cast<Colour*>(image.data());  // as above
  std::array<int, 3> channels{1, 2, 3};
  const int width = image.width();
  const int height = image.height();
  if ((*dataset)->RasterIO(GF_Write, 0, 0, width, height, pixels, width, height, GDT_Byte, 3,
                           channels.data(), 3, GSpacing{3} * width, 1, nullptr) != CE_None) {
    return fail(ErrorCode::kIo, "{}: cannot be written ({})", path.string(), messages.text());
  }
  return finish_tiff(std::move(*dataset), "AVERAGE", path, messages);
}

}  // namespace nadir
