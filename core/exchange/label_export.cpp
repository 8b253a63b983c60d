// SPDX-License-Identifier: Apache-2.0
#include "core/exchange/label_export.h"

#include <algorithm>
#include <cmath>

#include "core/base/require.h"
#include "core/exchange/export_writers.h"
#include "core/label/label_raster.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

Result<void> export_package(const ExportTask& task, const std::filesystem::path& target) {
  const LabelGrid& grid = task.grid;
  const auto rows = [&task](int first, int count) { return exported_rows(task, first, count); };
  return write_labels_of_map({task.provenance.name, task.document.plane(), grid.metres_per_cell,
                              grid.top_left_in_enu_m, grid.width, grid.height, rows},
                             task.provenance, target);
}

}  // namespace

LabelGrid export_grid(const LabelDocument& document, std::optional<double> metres_per_cell) {
  LabelGrid grid = document.grid();
  if (!metres_per_cell || *metres_per_cell == grid.metres_per_cell) return grid;
  NADIR_REQUIRE(*metres_per_cell > 0.0);
  const auto cells = [&](int count) {
    // Less than a millionth of a cell over is rounding.
    const double exact = count * grid.metres_per_cell / *metres_per_cell;
    return static_cast<int>(std::clamp(std::ceil(exact - 1e-6), 1.0, 2e9));
  };
  grid.width = cells(grid.width);
  grid.height = cells(grid.height);
  grid.metres_per_cell = *metres_per_cell;
  return grid;
}

Result<Raster<ClassId>> exported_rows(const ExportTask& task, int first, int count) {
  if (task.context.is_stopped()) return fail(ErrorCode::kCancelled, "export: cancelled");
  task.context.report(static_cast<double>(first) / task.grid.height, "drawing labels");
  return rasterise(task.document, task.grid, {0, first, task.grid.width, first + count});
}

Result<void> export_labels(const LabelDocument& document,
                           const LabelGrid& grid,
                           const MapProvenance& provenance,
                           LabelFormat format,
                           const std::filesystem::path& target,
                           const WorkContext& context,
                           const std::filesystem::path& picture) {
  NADIR_REQUIRE(grid.metres_per_cell > 0.0 && grid.width > 0 && grid.height > 0);
  if (std::int64_t{grid.width} * grid.height > kMaxMapCells) {
    return fail(ErrorCode::kUnsupported, "{}: {} x {} cells of {:.6g} m are more than {}",
                target.string(), grid.width, grid.height, grid.metres_per_cell, kMaxMapCells);
  }
  const ExportTask task{document, grid, provenance, context, picture};
  switch (format) {
    case LabelFormat::kMapPackage:
      return export_package(task, target);
    case LabelFormat::kGeoJson:
      return export_geojson(task, target);
    case LabelFormat::kShapefile:
      return export_shapefile(task, target);
    case LabelFormat::kClassImages:
      return export_class_images(task, target);
    case LabelFormat::kIndexedPng:
      return export_indexed_png(task, target);
    case LabelFormat::kCoco:
      return export_coco(task, target);
  }
  return {};
}

}  // namespace nadir
