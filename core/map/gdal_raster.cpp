// SPDX-License-Identifier: Apache-2.0
#include "core/map/gdal_raster.h"

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include "core/map/crs.h"

namespace nadir {
namespace {

constexpr int kRowsPerRead = 256;

void CPL_STDCALL note_message(CPLErr severity, CPLErrorNum, const char* message) {
  if (severity < CE_Failure) return;
  static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->note_failure(message);
}

bool is_whole_number_type(GDALDataType type) {
  return type == GDT_Byte || type == GDT_UInt16 || type == GDT_Int16 || type == GDT_UInt32 ||
         type == GDT_Int32;
}

tl::unexpected<Error> unreadable(const std::string& name, const GdalMessages& messages) {
  return fail(ErrorCode::kMalformed, "{}: cannot be read whole ({})", name, messages.text());
}

/// How far the ground control points are from where the raster was placed by them, in pixels.
/// @errors kMalformed: too far.
Result<double> check_control_points(GDALDataset& dataset,
                                    const Affine2& pixel_from_crs,
                                    const std::string& name) {
  constexpr double kMaxErrorPixels = 3.0;
  const std::span points(dataset.GetGCPs(), static_cast<std::size_t>(dataset.GetGCPCount()));
  double worst_px = 0.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const GDAL_GCP& point = points[i];
    const Eigen::Vector2d pixel = pixel_from_crs * Eigen::Vector2d(point.dfGCPX, point.dfGCPY);
    const double error_px = (pixel - Eigen::Vector2d(point.dfGCPPixel, point.dfGCPLine)).norm();
    if (error_px <= worst_px) continue;
    worst_px = error_px;
    worst = i;
  }
  if (worst_px <= kMaxErrorPixels) return worst_px;
  return fail(ErrorCode::kMalformed,
              "{}: its ground control points contradict each other, the worst at pixel ({:.6g}, "
              "{:.6g}) by {:.1f} pixels",
              name, points[worst].dfGCPPixel, points[worst].dfGCPLine, worst_px);
}

/// By geotransform or ground control points, still without reference system; nothing where there
/// is neither. @errors kMalformed.
Result<std::optional<Placement>> place_of(GDALDataset& dataset, const std::string& name) {
  Placement placement{{}, {}, dataset.GetRasterXSize(), dataset.GetRasterYSize()};
  std::array<double, 6> geotransform{};
  const bool has_geotransform = dataset.GetGeoTransform(geotransform.data()) == CE_None;
  // Three points always fit; of more, check_control_points says how well.
  if (!has_geotransform &&
      (dataset.GetGCPCount() < 3 || GDALGCPsToGeoTransform(dataset.GetGCPCount(), dataset.GetGCPs(),
                                                           geotransform.data(), TRUE) == FALSE)) {
    return std::nullopt;
  }
  placement.crs_from_pixel = Affine2::from_gdal(geotransform);
  const auto inverse = placement.crs_from_pixel.inverse();
  if (!inverse) return forward_error(inverse, name);
  if (!has_geotransform) {
    const auto error_px = check_control_points(dataset, *inverse, name);
    if (!error_px) return forward_error(error_px);
    placement.control_point_error_px = *error_px;
  }
  return placement;
}

const OGRSpatialReference* own_crs(GDALDataset& dataset) {
  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own == nullptr) own = dataset.GetGCPSpatialRef();
  return own != nullptr && !own->IsEmpty() ? own : nullptr;
}

/// Some files claim to be in degrees and hold pixels. @errors kMalformed.
Result<void> check_latitudes(const Placement& placement, const std::string& name) {
  if (!crs_from_wkt(placement.crs_wkt).IsGeographic()) return {};
  for (const double column : {0.0, static_cast<double>(placement.width)}) {
    for (const double row : {0.0, static_cast<double>(placement.height)}) {
      const double latitude_deg = (placement.crs_from_pixel * Eigen::Vector2d(column, row)).y();
      if (std::abs(latitude_deg) <= 90.0) continue;
      return fail(ErrorCode::kMalformed, "{}: claims to be in degrees but reaches latitude {:.6g}",
                  name, latitude_deg);
    }
  }
  return {};
}

}  // namespace

void GdalCloser::operator()(GDALDataset* dataset) const { GDALClose(dataset); }

GdalMessages::GdalMessages() {
  // What GDAL keeps of pixels that were read; its own limit is a share of the machine's memory.
  constexpr GIntBig kMostKeptBytes = GIntBig{128} << 20;
  static std::once_flag once;
  std::call_once(once, [] {
    GDALAllRegister();
    GDALSetCacheMax64(kMostKeptBytes);
  });
  CPLPushErrorHandlerEx(note_message, this);
}

GdalMessages::~GdalMessages() { CPLPopErrorHandler(); }

std::string GdalMessages::text() const {
  return first_failure_.empty() ? "unknown fault" : first_failure_;
}

void GdalMessages::note_failure(const char* message) {
  has_failed_ = true;
  if (!first_failure_.empty()) return;
  first_failure_ = message;
  std::replace(first_failure_.begin(), first_failure_.end(), '\n', ' ');
  while (!first_failure_.empty() &&
         (first_failure_.back() == '.' || first_failure_.back() == ' ')) {
    first_failure_.pop_back();
  }
}

Result<GdalDataset> open_raster(const std::filesystem::path& path, const GdalMessages& messages) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return fail(ErrorCode::kNotFound, "{}: no such file", path.string());
  }
  if (std::filesystem::is_directory(path, error)) {
    return fail(ErrorCode::kMalformed, "{}: is a folder, not a raster", path.string());
  }
  GdalDataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (dataset == nullptr) {
    return fail(ErrorCode::kMalformed, "{}: is no readable raster ({})", path.string(),
                messages.text());
  }
  const std::int64_t width = dataset->GetRasterXSize();
  const std::int64_t height = dataset->GetRasterYSize();
  if (width < 1 || height < 1 || dataset->GetRasterCount() < 1) {
    return fail(ErrorCode::kMalformed, "{}: holds no pixel", path.string());
  }
  if (width * height > kMaxMapCells) {
    return fail(ErrorCode::kUnsupported,
                "{}: {} x {} cells are more than the {} that a map may have", path.string(), width,
                height, kMaxMapCells);
  }
  return dataset;
}

Result<void> read_rows(
    GDALDataset& dataset,
    const std::string& name,
    const GdalMessages& messages,
    const std::function<Result<void>(int row, std::span<const std::int32_t> values)>& take) {
  const int width = dataset.GetRasterXSize();
  const int height = dataset.GetRasterYSize();
  const auto row_length = static_cast<std::size_t>(width);
  std::vector<std::int32_t> strip(row_length * kRowsPerRead);
  for (int first = 0; first < height; first += kRowsPerRead) {
    const int rows = std::min(kRowsPerRead, height - first);
    if (dataset.GetRasterBand(1)->RasterIO(GF_Read, 0, first, width, rows, strip.data(), width,
                                           rows, GDT_Int32, 0, 0, nullptr) != CE_None ||
        messages.has_failed()) {
      return unreadable(name, messages);
    }
    for (int i = 0; i < rows; ++i) {
      const auto start = static_cast<std::size_t>(i) * row_length;
      const auto taken = take(first + i, std::span(strip).subspan(start, row_length));
      if (!taken) return forward_error(taken);
    }
  }
  return {};
}

std::optional<double> no_data_of(GDALDataset& dataset) {
  int has_no_data = FALSE;
  const double no_data = dataset.GetRasterBand(1)->GetNoDataValue(&has_no_data);
  return has_no_data != FALSE ? std::optional(no_data) : std::nullopt;
}

Result<Raster<std::uint8_t>> read_ids(GDALDataset& dataset,
                                      const std::string& name,
                                      const GdalMessages& messages) {
  if (dataset.GetRasterCount() != 1) {
    return fail(ErrorCode::kUnsupported, "{}: labels need one band of class ids, this has {}", name,
                dataset.GetRasterCount());
  }
  const GDALDataType type = dataset.GetRasterBand(1)->GetRasterDataType();
  if (!is_whole_number_type(type)) {
    return fail(ErrorCode::kUnsupported, "{}: labels need whole numbers, this has {}", name,
                GDALGetDataTypeName(type));
  }
  const std::optional<double> no_data = no_data_of(dataset);
  Raster<std::uint8_t> ids(dataset.GetRasterXSize(), dataset.GetRasterYSize());
  const auto done = read_rows(
      dataset, name, messages, [&](int row, std::span<const std::int32_t> values) -> Result<void> {
        std::uint8_t* out = ids.row(row).data();
        for (const std::int32_t value : values) {
          if (no_data && value == *no_data) {
            *out++ = kUnclassified;
          } else if (value < 0 || value > 255) {
            return fail(ErrorCode::kMalformed, "{}: value {} is no class id", name, value);
          } else {
            *out++ = static_cast<std::uint8_t>(value);
          }
        }
        return {};
      });
  if (!done) return forward_error(done);
  return ids;
}

Result<ColourRaster> read_colours(GDALDataset& dataset,
                                  const std::string& name,
                                  const GdalMessages& messages) {
  const int bands = dataset.GetRasterCount();
  for (int i = 1; i <= std::min(bands, 3); ++i) {
    if (dataset.GetRasterBand(i)->GetRasterDataType() != GDT_Byte) {
      return fail(ErrorCode::kUnsupported, "{}: a picture needs 8 bits a channel", name);
    }
  }
  static_assert(sizeof(Colour) == 3);
  const int width = dataset.GetRasterXSize();
  const int height = dataset.GetRasterYSize();
  ColourRaster colours(width, height);
  std::array<int, 3> channels{1, 2, 3};
  if (bands < 3) channels.fill(1);
  const GSpacing line = GSpacing{3} * width;
  if (dataset.RasterIO(GF_Read, 0, 0, width, height, colours.data(), width, height, GDT_Byte, 3,
                       channels.data(), 3, line, 1, nullptr) != CE_None ||
      messages.has_failed()) {
    return unreadable(name, messages);
  }
  const GDALColorTable* table = dataset.GetRasterBand(1)->GetColorTable();
  if (bands < 3 && table != nullptr) {
    for (Colour& colour : colours.values()) {
      GDALColorEntry entry{};
      table->GetColorEntryAsRGB(colour.red, &entry);
      colour = {static_cast<std::uint8_t>(entry.c1), static_cast<std::uint8_t>(entry.c2),
                static_cast<std::uint8_t>(entry.c3)};
    }
  }
  return colours;
}

Result<std::optional<Placement>> placement_of(GDALDataset& dataset,
                                              const std::string& crs,
                                              const std::string& name,
                                              const GdalMessages& messages) {
  auto placement = place_of(dataset, name);
  if (!placement || !*placement) return placement;
  const OGRSpatialReference* own = own_crs(dataset);
  std::string& wkt = (*placement)->crs_wkt;
  if (own != nullptr) wkt = wkt_of(*own);
  if (!crs.empty()) {
    const auto given = crs_from_text(crs, messages);
    if (!given) return forward_error(given);
    if (own != nullptr && own->IsSame(&*given) == FALSE) {
      return fail(ErrorCode::kInvalidOptions,
                  "{}: has a coordinate reference system of its own ({}), so --crs {} is refused",
                  name, own->GetName() != nullptr ? own->GetName() : "unnamed", crs);
    }
    wkt = wkt_of(*given);
  }
  if (wkt.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: has a georeference without a coordinate reference system; name it with --crs",
                name);
  }
  if (const auto checked = check_latitudes(**placement, name); !checked) {
    return forward_error(checked);
  }
  return placement;
}

bool has_own_crs(GDALDataset& dataset) { return own_crs(dataset) != nullptr; }

void set_placement(GDALDataset& dataset, const Placement& placement) {
  std::array<double, 6> geotransform = placement.crs_from_pixel.to_gdal();
  dataset.SetGeoTransform(geotransform.data());
  const OGRSpatialReference crs = crs_from_wkt(placement.crs_wkt);
  dataset.SetSpatialRef(&crs);
}

}  // namespace nadir
