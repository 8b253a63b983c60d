// SPDX-License-Identifier: Apache-2.0
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/staged_output.h"
#include "core/exchange/export_writers.h"
#include "core/label/label_raster.h"
#include "core/label/paint_objects.h"
#include "core/map/gdal_raster.h"

namespace nadir {
namespace {

/// Regions are looked for in all of the raster at once.
constexpr std::int64_t kMostCocoCells = 100'000'000;

double area_within(const Ring& ring) {
  double twice = 0.0;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    twice += ring[j].x() * ring[i].y() - ring[i].x() * ring[j].y();
  }
  return std::abs(twice) / 2.0;
}

/// Cells of a region by columns, as COCO counts them: so many outside, so many inside, and so on.
std::string run_lengths(const CellRegion& region, int width, int height) {
  std::vector<std::vector<int>> borders(static_cast<std::size_t>(width));
  for (const Ring& ring : region.rings_in_cells) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      if (ring[i].y() != ring[j].y()) continue;
      const auto [from, to] = std::minmax(ring[i].x(), ring[j].x());
      for (int column = static_cast<int>(from); column < static_cast<int>(to); ++column) {
        borders[static_cast<std::size_t>(column)].push_back(static_cast<int>(ring[i].y()));
      }
    }
  }
  std::string counts;
  std::int64_t at = 0;  // End of what has been counted.
  std::int64_t inside = 0;
  for (std::size_t column = 0; column < borders.size(); ++column) {
    std::vector<int>& rows = borders[column];
    std::sort(rows.begin(), rows.end());
    const std::int64_t top = static_cast<std::int64_t>(column) * height;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
      if (top + rows[i] > at + inside || (counts.empty() && inside == 0)) {
        if (inside > 0) counts += fmt::format("{},", inside);
        at += inside;
        counts += fmt::format("{},", top + rows[i] - at);
        at = top + rows[i];
        inside = 0;
      }
      inside += rows[i + 1] - rows[i];
    }
  }
  const std::int64_t rest = std::int64_t{width} * height - at - inside;
  return fmt::format(R"({{"counts":[{}{}{}],"size":[{},{}]}})", counts, inside,
                     rest > 0 ? fmt::format(",{}", rest) : "", height, width);
}

/// As a polygon where it has no hole, for polygons cannot have any.
std::string segmentation_of(const CellRegion& region, int width, int height) {
  if (region.rings_in_cells.size() > 1) return run_lengths(region, width, height);
  std::string places;
  for (const Eigen::Vector2d& place : region.rings_in_cells.front()) {
    places += fmt::format("{}{:.0f},{:.0f}", places.empty() ? "" : ",", place.x(), place.y());
  }
  return fmt::format("[[{}]]", places);
}

std::string annotation_of(const CellRegion& region, int id, int width, int height) {
  const Ring& border = region.rings_in_cells.front();
  double cells = area_within(border);
  for (std::size_t i = 1; i < region.rings_in_cells.size(); ++i) {
    cells -= area_within(region.rings_in_cells[i]);
  }
  PlaneBounds box;
  for (const Eigen::Vector2d& place : border) box.include(place);
  return fmt::format(R"({{"id":{},"image_id":1,"category_id":{},"iscrowd":0,"area":{:.0f},)"
                     R"("bbox":[{:.0f},{:.0f},{:.0f},{:.0f}],"segmentation":{}}})",
                     id, region.value + 1, cells, box.low.x(), box.low.y(),
                     box.high.x() - box.low.x(), box.high.y() - box.low.y(),
                     segmentation_of(region, width, height));
}

/// What the annotations lie on: the picture where each of its pixels is a cell of the labels, else their own raster, as a
/// package has it.
std::string image_name(const ExportTask& task) {
  constexpr const char* kOfLabels = "labels.tif";
  if (task.picture.empty()) return kOfLabels;
  const GdalMessages quiet;
  const auto picture = open_raster(task.picture, quiet);
  const bool has_same_cells = picture && (*picture)->GetRasterXSize() == task.grid.width &&
                              (*picture)->GetRasterYSize() == task.grid.height;
  return has_same_cells ? task.picture.filename().string() : kOfLabels;
}

/// Everything before the annotations.
std::string head_of(const ExportTask& task) {
  nlohmann::ordered_json head;
  head["info"] = {{"description", task.provenance.name},
                  {"contributor", task.provenance.source},
                  {"date_created", task.provenance.date},
                  {"metres_per_cell", task.grid.metres_per_cell}};
  head["licenses"] =
      nlohmann::ordered_json::array({{{"id", 1}, {"name", task.provenance.licence}, {"url", ""}}});
  head["images"] = nlohmann::ordered_json::array({{{"id", 1},
                                                   {"license", 1},
                                                   {"file_name", image_name(task)},
                                                   {"width", task.grid.width},
                                                   {"height", task.grid.height}}});
  head["categories"] = nlohmann::ordered_json::array();
  for (int id = 0; id < kClassCount; ++id) {
    const auto class_id = static_cast<ClassId>(id);
    if (!can_lie_in_overhead(class_id)) continue;
    head["categories"].push_back(
        {{"id", id + 1}, {"name", class_info(class_id).name}, {"supercategory", ""}});
  }
  std::string text = head.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  text.pop_back();  // The closing brace.
  return text;
}

}  // namespace

Result<void> export_coco(const ExportTask& task, const std::filesystem::path& target) {
  const int width = task.grid.width;
  const int height = task.grid.height;
  if (std::int64_t{width} * height > kMostCocoCells) {
    return fail(ErrorCode::kUnsupported,
                "{}: {} x {} cells are too many for COCO, take larger ones (--resolution)",
                target.string(), width, height);
  }
  auto staged = StagedOutput::file(target);
  if (!staged) return forward_error(staged);
  const auto labels = exported_rows(task, 0, height);
  if (!labels) return forward_error(labels);
  const auto regions = polygonise(*labels, kUnclassified);
  if (!regions) return forward_error(regions, target.string());
  std::ofstream file(staged->path(), std::ios::binary);
  file << head_of(task) << ",\"annotations\":[";
  int id = 0;
  for (const CellRegion& region : *regions) {
    if (task.context.is_stopped()) return fail(ErrorCode::kCancelled, "export: cancelled");
    file << (id == 0 ? "\n" : ",\n") << annotation_of(region, id + 1, width, height);
    ++id;
  }
  file << "\n]}\n";
  file.close();
  if (!file) return fail(ErrorCode::kIo, "{}: cannot be written", target.string());
  return staged->commit();
}

}  // namespace nadir
