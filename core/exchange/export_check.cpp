// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/exchange/label_export.h"
#include "core/label/label_raster.h"
#include "core/map/gdal_raster.h"
#include "core/map/label_tiff.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

constexpr int kRowsChecked = 1024;
constexpr double kCornerToleranceCells = 1e-6;
constexpr double kAreaTolerance = 0.001;

using CellCounts = std::array<std::int64_t, 256>;

void count_cells(const Raster<ClassId>& labels, CellCounts& counts) {
  for (const ClassId id : labels.values()) ++counts.at(id);
}

std::string name_of(int id) {
  const bool is_class = id < kClassCount || id == kUnclassified;
  return is_class ? std::string(class_info(static_cast<ClassId>(id)).name)
                  : fmt::format("{}, which is no class", id);
}

/// Compares one package with its document.
class Comparison {
 public:
  Comparison(const LabelDocument& document, const fs::path& package, const WorkContext& context)
      : document_(document), package_(package), context_(context) {}

  Result<ExportCheck> run() {
    const auto plane = read_map_plane(package_);
    if (!plane) return forward_error(plane);
    if (!(*plane == document_.plane())) {
      found_.faults.emplace_back("it lies on another plane than its document");
      return std::move(found_);
    }
    const fs::path path = package_ / "labels.tif";
    const auto place = read_tiff_place(path, *plane);
    if (!place) return forward_error(place);
    const GdalMessages messages;
    const auto dataset = open_raster(path, messages);
    if (!dataset) return forward_error(dataset);
    if (!check_place(*place)) return std::move(found_);
    if (const auto same = check_no_data(**dataset, "labels.tif"); !same) {
      found_.faults.push_back(same.error().message);
    }
    GDALRasterBand& band = *(*dataset)->GetRasterBand(1);
    check_palette(band);
    for (const auto& step : {&Comparison::compare_cells, &Comparison::check_overviews}) {
      if (const auto done = (this->*step)(band, messages); !done) return forward_error(done);
    }
    if (const auto done = compare_areas(); !done) return forward_error(done);
    return std::move(found_);
  }

 private:
  Result<void> go_on(double fraction, const std::string& activity) const {
    if (context_.is_stopped()) {
      return fail(ErrorCode::kCancelled, "{}: cancelled", package_.string());
    }
    context_.report(fraction, activity);
    return {};
  }

  bool check_place(const TiffPlace& place) {
    grid_ = export_grid(document_, place.metres_per_cell);
    if (place.width != grid_.width || place.height != grid_.height) {
      found_.faults.push_back(fmt::format("it has {} x {} cells of {:.6g} m, its document {} x {}",
                                          place.width, place.height, place.metres_per_cell,
                                          grid_.width, grid_.height));
      return false;
    }
    const LabelGrid written{place.metres_per_cell, place.top_left_in_enu_m, place.width,
                            place.height};
    double worst = 0.0;
    for (const Eigen::Vector2d& share : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                         Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 1)}) {
      const Eigen::Vector2d corner = share.cwiseProduct(Eigen::Vector2d(place.width, place.height));
      worst =
          std::max(worst, (grid_.cells_from_enu(written.enu_from_cells(corner)) - corner).norm());
    }
    if (worst > kCornerToleranceCells) {
      found_.faults.push_back(
          fmt::format("a corner is {:.3g} cells from where its document has it", worst));
    }
    return true;
  }

  void check_palette(GDALRasterBand& band) {
    const GDALColorTable* const table = band.GetColorTable();
    for (int id = 0; id < kClassCount; ++id) {
      const Colour wanted = class_info(static_cast<ClassId>(id)).colour;
      const GDALColorEntry* const entry =
          table != nullptr && id < table->GetColorEntryCount() ? table->GetColorEntry(id) : nullptr;
      if (entry == nullptr || entry->c1 != wanted.red || entry->c2 != wanted.green ||
          entry->c3 != wanted.blue) {
        found_.faults.push_back(fmt::format("its palette has no {} as the program has it",
                                            class_info(static_cast<ClassId>(id)).name));
        return;
      }
    }
  }

  /// @errors kMalformed.
  Result<Raster<ClassId>> read_strip(GDALRasterBand& band,
                                     int first,
                                     int count,
                                     const GdalMessages& messages) const {
    Raster<ClassId> strip(band.GetXSize(), count);
    if (band.RasterIO(GF_Read, 0, first, strip.width(), count, strip.data(), strip.width(), count,
                      GDT_Byte, 0, 0, nullptr) != CE_None) {
      return fail(ErrorCode::kMalformed, "{}: labels.tif cannot be read whole ({})",
                  package_.string(), messages.text());
    }
    return strip;
  }

  Result<void> compare_cells(GDALRasterBand& band, const GdalMessages& messages) {
    std::int64_t different = 0;
    for (int first = 0; first < grid_.height; first += kRowsChecked) {
      if (const auto on = go_on(0.2 * first / grid_.height, "comparing cells"); !on)
        return forward_error(on);
      const int count = std::min(kRowsChecked, grid_.height - first);
      const auto written = read_strip(band, first, count, messages);
      if (!written) return forward_error(written);
      const Raster<ClassId> drawn =
          rasterise(document_, grid_, {0, first, grid_.width, first + count});
      different += std::inner_product(written->values().begin(), written->values().end(),
                                      drawn.values().begin(), std::int64_t{0}, std::plus<>(),
                                      [](ClassId a, ClassId b) { return a != b ? 1 : 0; });
      count_cells(*written, cells_);
    }
    if (different > 0) {
      found_.faults.push_back(fmt::format("{} of {} cells are not as they are drawn", different,
                                          std::int64_t{grid_.width} * grid_.height));
    }
    for (int id = 0; id < 256; ++id) {
      if (cells_.at(static_cast<std::size_t>(id)) > 0 && id >= kClassCount && id != kUnclassified) {
        found_.faults.push_back(fmt::format("its cells hold {}", name_of(id)));
      }
    }
    return {};
  }

  Result<void> check_overviews(GDALRasterBand& band, const GdalMessages& messages) {
    for (int level = 0; level < band.GetOverviewCount(); ++level) {
      GDALRasterBand& overview = *band.GetOverview(level);
      CellCounts counts{};
      for (int first = 0; first < overview.GetYSize(); first += kRowsChecked) {
        const int count = std::min(kRowsChecked, overview.GetYSize() - first);
        const auto strip = read_strip(overview, first, count, messages);
        if (!strip) return forward_error(strip);
        count_cells(*strip, counts);
      }
      for (std::size_t id = 0; id < counts.size(); ++id) {
        if (counts.at(id) > 0 && cells_.at(id) == 0) {
          found_.faults.push_back(fmt::format("its overview of {} x {} holds {}, which nobody drew",
                                              overview.GetXSize(), overview.GetYSize(),
                                              name_of(static_cast<int>(id))));
        }
      }
    }
    return {};
  }

  Result<void> compare_areas() {
    constexpr double kMostFineCells = 1e9;
    const double all = static_cast<double>(grid_.width) * grid_.height;
    const double parts = std::clamp(std::floor(std::sqrt(kMostFineCells / all)), 2.0, 4.0);
    const LabelGrid fine = export_grid(document_, grid_.metres_per_cell / parts);
    CellCounts counts{};
    for (int first = 0; first < fine.height; first += kRowsChecked) {
      if (const auto on = go_on(0.2 + 0.8 * first / fine.height, "measuring areas"); !on)
        return forward_error(on);
      const int last = std::min(fine.height, first + kRowsChecked);
      count_cells(rasterise(document_, fine, {0, first, fine.width, last}), counts);
    }
    for (int i = 0; i < kClassCount; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const ClassArea area{
          static_cast<ClassId>(i),
          static_cast<double>(counts.at(index)) * std::pow(fine.metres_per_cell, 2),
          static_cast<double>(cells_.at(index)) * std::pow(grid_.metres_per_cell, 2)};
      if (counts.at(index) == 0 && cells_.at(index) == 0) continue;
      found_.areas.push_back(area);
      if (std::abs(area.exported_m2 - area.drawn_m2) <= kAreaTolerance * area.drawn_m2) continue;
      const std::string text =
          fmt::format("{} covers {:.1f} m2, its objects {:.1f} m2", class_info(area.id).name,
                      area.exported_m2, area.drawn_m2);
      // Cells that are as drawn can only err where they are too coarse for the objects.
      if (found_.faults.empty()) {
        found_.notices.push_back(
            fmt::format("{}: cells of {:.6g} m are coarse for it", text, grid_.metres_per_cell));
      } else {
        found_.faults.push_back(text);
      }
    }
    return {};
  }

  const LabelDocument& document_;
  const fs::path& package_;
  const WorkContext& context_;
  LabelGrid grid_;
  CellCounts cells_{};
  ExportCheck found_;
};

}  // namespace

Result<ExportCheck> check_export(const LabelDocument& document,
                                 const fs::path& package,
                                 const WorkContext& context) {
  return Comparison(document, package, context).run();
}

}  // namespace nadir
