// SPDX-License-Identifier: Apache-2.0
#include <cpl_string.h>
#include <gdal_pam.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <utility>

#include "core/base/settings.h"
#include "core/base/staged_output.h"
#include "core/exchange/export_writers.h"
#include "core/map/crs.h"
#include "core/map/gdal_raster.h"
#include "core/map/label_tiff.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr int kRowsOfBlock = 256;

/// Gives rows of cells, made when they are asked for.
using ByteRows = std::function<Result<Raster<std::uint8_t>>(int first, int count)>;

class RowsBand final : public GDALPamRasterBand {
 public:
  RowsBand(GDALDataset& dataset, int width, int height, ByteRows rows) : rows_(std::move(rows)) {
    poDS = &dataset;
    nBand = 1;
    eDataType = GDT_Byte;
    nBlockXSize = width;
    nBlockYSize = std::min(kRowsOfBlock, height);
  }
  CPLErr IReadBlock(int /*column*/, int block, void* into) override {
    const int first = block * nBlockYSize;
    const auto made = rows_(first, std::min(nBlockYSize, nRasterYSize - first));
    if (!made) {
      fault_ = made.error();
      return CE_Failure;
    }
    std::copy(made->values().begin(), made->values().end(), static_cast<std::uint8_t*>(into));
    return CE_None;
  }
  [[nodiscard]] const std::optional<Error>& fault() const { return fault_; }

 private:
  ByteRows rows_;
  std::optional<Error> fault_;
};

/// A raster that GDAL's drivers copy, and that never is in memory as a whole.
class RowsDataset final : public GDALPamDataset {
 public:
  RowsDataset(const LabelGrid& grid, const ProjectPlane& plane, ByteRows rows)
      : grid_(grid), crs_(crs_from_wkt(plane.wkt())) {
    nRasterXSize = grid.width;
    nRasterYSize = grid.height;
    auto band = std::make_unique<RowsBand>(*this, grid.width, grid.height, std::move(rows));
    band_ = band.get();
    SetBand(1, band.release());
  }
  CPLErr GetGeoTransform(double* transform) override {
    const std::array<double, 6> made{
        grid_.top_left_in_enu_m.x(), grid_.metres_per_cell, 0.0, grid_.top_left_in_enu_m.y(), 0.0,
        -grid_.metres_per_cell};
    std::copy(made.begin(), made.end(), transform);
    return CE_None;
  }
  const OGRSpatialReference* GetSpatialRef() const override { return &crs_; }
  [[nodiscard]] const std::optional<Error>& fault() const { return band_->fault(); }

 private:
  LabelGrid grid_;
  OGRSpatialReference crs_;
  RowsBand* band_ = nullptr;
};

/// @errors kIo; those of its rows.
Result<void> write_png(RowsDataset& rows, const fs::path& path, const std::string& name) {
  const GdalMessages messages;
  GDALDriver* const driver = GetGDALDriverManager()->GetDriverByName("PNG");
  if (driver == nullptr) return fail(ErrorCode::kIo, "{}: GDAL has no PNG driver", name);
  const GdalDataset written(
      driver->CreateCopy(path.c_str(), &rows, FALSE, nullptr, nullptr, nullptr));
  if (rows.fault()) return tl::unexpected(*rows.fault());
  if (written != nullptr && !messages.has_failed()) return {};
  return fail(ErrorCode::kIo, "{}: cannot be written ({})", name, messages.text());
}

/// Of the *centre* of the first pixel; GDAL's transforms are of its corner.
std::string world_file(const LabelGrid& grid) {
  const double half_m = grid.metres_per_cell / 2.0;
  return fmt::format("{:.17g}\n0\n0\n{:.17g}\n{:.17g}\n{:.17g}\n", grid.metres_per_cell,
                     -grid.metres_per_cell, grid.top_left_in_enu_m.x() + half_m,
                     grid.top_left_in_enu_m.y() - half_m);
}

std::string file_name_of(ClassId id) {
  std::string name(class_info(id).name);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

std::string scale_text(const ExportTask& task) {
  const LabelGrid& grid = task.grid;
  const Geodetic corner = task.document.plane().geodetic_from_enu(grid.top_left_in_enu_m);
  const Geodetic origin = task.document.plane().origin();
  return fmt::format(
      "# Where the images of this folder lie. White belongs to the class that gives the name.\n"
      "name = {}\n"
      "metres_per_cell = {:.17g}\n"
      "width = {}\n"
      "height = {}\n"
      "# Outer corner of the first cell; rows go east, columns south on the plane below.\n"
      "[top_left]\n"
      "latitude_deg = {:#.17g}\n"
      "longitude_deg = {:#.17g}\n"
      "east_m = {:#.17g}\n"
      "north_m = {:#.17g}\n"
      "# Origin of the plane: transverse Mercator, scale 1, WGS 84.\n"
      "[plane]\n"
      "latitude_deg = {:#.17g}\n"
      "longitude_deg = {:#.17g}\n",
      toml_quoted(task.provenance.name), grid.metres_per_cell, grid.width, grid.height,
      corner.latitude_deg, corner.longitude_deg, grid.top_left_in_enu_m.x(),
      grid.top_left_in_enu_m.y(), origin.latitude_deg, origin.longitude_deg);
}

/// Which classes the task's raster holds. @errors kCancelled.
Result<std::array<bool, kClassCount>> classes_in(const ExportTask& task) {
  std::array<bool, 256> is_there{};
  for (int first = 0; first < task.grid.height; first += kRowsOfBlock) {
    const auto strip = exported_rows(task, first, std::min(kRowsOfBlock, task.grid.height - first));
    if (!strip) return forward_error(strip);
    for (const ClassId id : strip->values()) is_there.at(id) = true;
  }
  std::array<bool, kClassCount> classes{};
  std::copy_n(is_there.begin(), kClassCount, classes.begin());
  return classes;
}

}  // namespace

Result<void> export_class_images(const ExportTask& task, const fs::path& target) {
  std::vector<std::string> names{"scale.toml"};
  for (int id = 0; id < kClassCount; ++id) {
    for (const char* end : {".png", ".pgw", ".png.aux.xml"}) {
      names.push_back(file_name_of(static_cast<ClassId>(id)) + end);
    }
  }
  const std::vector<std::string_view> own(names.begin(), names.end());
  auto staged = StagedOutput::folder(target, own.front(), own);
  if (!staged) return forward_error(staged);
  const auto classes = classes_in(task);
  if (!classes) return forward_error(classes);
  for (int i = 0; i < kClassCount; ++i) {
    if (!classes->at(static_cast<std::size_t>(i))) continue;
    const auto id = static_cast<ClassId>(i);
    const auto in_class = [&](int first, int count) {
      auto rows = exported_rows(task, first, count);
      if (rows) {
        for (std::uint8_t& cell : rows->values()) cell = cell == id ? 255 : 0;
      }
      return rows;
    };
    RowsDataset rows(task.grid, task.document.plane(), in_class);
    const fs::path path = staged->path() / (file_name_of(id) + ".png");
    if (const auto done = write_png(rows, path, target.string()); !done) return forward_error(done);
    const auto placed =
        write_text_file(fs::path(path).replace_extension(".pgw"), world_file(task.grid));
    if (!placed) return forward_error(placed);
  }
  const auto scaled = write_text_file(staged->path() / "scale.toml", scale_text(task));
  if (!scaled) return forward_error(scaled);
  return staged->commit();
}

Result<void> export_indexed_png(const ExportTask& task, const fs::path& target) {
  // The picture last, so that there is never one without what tells where it lies.
  std::vector<StagedOutput> files;
  files.reserve(3);
  for (const fs::path& path : {fs::path(target).replace_extension(".pgw"),
                               fs::path(target.string() + ".aux.xml"), target}) {
    auto staged = StagedOutput::file(path);
    if (!staged) return forward_error(staged);
    files.push_back(std::move(*staged));
  }
  const auto cells = [&](int first, int count) { return exported_rows(task, first, count); };
  RowsDataset rows(task.grid, task.document.plane(), cells);
  {
    const GdalMessages quiet;
    describe_classes(*rows.GetRasterBand(1));
  }
  const auto done = write_png(rows, files[2].path(), target.string());
  // GDAL calls it by the picture's name.
  std::error_code error;
  fs::rename(files[2].path().string() + ".aux.xml", files[1].path(), error);
  if (!done) return forward_error(done);
  if (error) {
    return fail(ErrorCode::kIo, "{}.aux.xml: cannot be written ({})", target.string(),
                error.message());
  }
  const auto placed = write_text_file(files[0].path(), world_file(task.grid));
  if (!placed) return forward_error(placed);
  return StagedOutput::commit_all(files);
}

}  // namespace nadir
