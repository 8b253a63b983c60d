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

std::optional<Affine2> affine_of(GDALDataset& dataset) {
  std::array<double, 6> geotransform{};
  if (dataset.GetGeoTransform(geotransform.data()) == CE_None) {
    return Affine2::from_gdal(geotransform);
  }
  const int points = dataset.GetGCPCount();
  if (points >= 3 &&
      GDALGCPsToGeoTransform(points, dataset.GetGCPs(), geotransform.data(), TRUE) != FALSE) {
    return Affine2::from_gdal(geotransform);
  }
  return std::nullopt;
}

/// Some files claim to be in degrees and hold pixels. @errors kMalformed.
Result<void> check_latitudes(const Placement& placement, const std::string& name) {
  OGRSpatialReference crs;
  crs.importFromWkt(placement.crs_wkt.c_str());
  if (!crs.IsGeographic()) return {};
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
  static std::once_flag once;
  std::call_once(once, GDALAllRegister);
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

Result<Raster<std::uint8_t>> read_ids(GDALDataset& dataset,
                                      const std::string& name,
                                      const GdalMessages& messages) {
  if (dataset.GetRasterCount() != 1) {
    return fail(ErrorCode::kUnsupported, "{}: labels need one band of class ids, this has {}", name,
                dataset.GetRasterCount());
  }
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  if (!is_whole_number_type(band.GetRasterDataType())) {
    return fail(ErrorCode::kUnsupported, "{}: labels need whole numbers, this has {}", name,
                GDALGetDataTypeName(band.GetRasterDataType()));
  }
  int has_no_data = FALSE;
  const double no_data = band.GetNoDataValue(&has_no_data);
  Raster<std::uint8_t> ids(dataset.GetRasterXSize(), dataset.GetRasterYSize());
  std::vector<std::int32_t> strip(static_cast<std::size_t>(ids.width()) * kRowsPerRead);
  for (int first = 0; first < ids.height(); first += kRowsPerRead) {
    const int rows = std::min(kRowsPerRead, ids.height() - first);
    if (band.RasterIO(GF_Read, 0, first, ids.width(), rows, strip.data(), ids.width(), rows,
                      GDT_Int32, 0, 0, nullptr) != CE_None ||
        messages.has_failed()) {
      return unreadable(name, messages);
    }
    const auto count = static_cast<std::size_t>(ids.width()) * static_cast<std::size_t>(rows);
    std::uint8_t* out = ids.row(first).data();
    for (std::size_t i = 0; i < count; ++i) {
      const std::int32_t value = strip[i];
      if (has_no_data != FALSE && value == no_data) {
        out[i] = kUnclassified;
      } else if (value < 0 || value > 255) {
        return fail(ErrorCode::kMalformed, "{}: value {} is no class id", name, value);
      } else {
        out[i] = static_cast<std::uint8_t>(value);
      }
    }
  }
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
  const std::optional<Affine2> affine = affine_of(dataset);
  if (!affine) return std::nullopt;
  if (const auto inverse = affine->inverse(); !inverse) return forward_error(inverse, name);

  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own == nullptr) own = dataset.GetGCPSpatialRef();
  Placement placement{*affine, {}, dataset.GetRasterXSize(), dataset.GetRasterYSize()};
  if (own != nullptr && !own->IsEmpty()) {
    placement.crs_wkt = wkt_of(*own);
  }
  if (!crs.empty()) {
    const auto given = crs_from_text(crs, messages);
    if (!given) return forward_error(given);
    if (!placement.crs_wkt.empty() && own->IsSame(&*given) == FALSE) {
      return fail(ErrorCode::kInvalidOptions,
                  "{}: has a coordinate reference system of its own ({}), so --crs {} is refused",
                  name, own->GetName() != nullptr ? own->GetName() : "unnamed", crs);
    }
    placement.crs_wkt = wkt_of(*given);
  }
  if (placement.crs_wkt.empty()) {
    return fail(ErrorCode::kMalformed,
                "{}: has a georeference without a coordinate reference system; name it with --crs",
                name);
  }
  if (const auto checked = check_latitudes(placement, name); !checked) {
    return forward_error(checked);
  }
  return placement;
}

}  // namespace nadir
