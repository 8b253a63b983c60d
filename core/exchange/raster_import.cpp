// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/exchange/label_import.h"
#include "core/label/paint_objects.h"
#include "core/label/tile_painter.h"
#include "core/map/overhead_map.h"

namespace nadir {
namespace {

Eigen::Vector2d onto(const ProjectPlane& to, const ProjectPlane& from, const Eigen::Vector2d& at) {
  return to == from ? at : to.enu_from_geodetic(from.geodetic_from_enu(at));
}

/// Where the cells of a square of the document's grid lie in a raster, whose plane may be another: over so short a way the
/// two planes differ by a linear map to far less than a millimetre.
class RasterPlace {
 public:
  RasterPlace(const OverheadMap& raster, const LabelDocument& document, const CellRect& cells)
      : cells_(cells) {
    const auto at = [&](std::int64_t column, std::int64_t row) {
      const Eigen::Vector2d cell(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      return raster.overhead_from_enu(
          onto(raster.plane, document.plane(), document.grid().enu_from_cells(cell)));
    };
    first_ = at(cells.left, cells.top);
    a_column_ = (at(cells.right, cells.top) - first_) / static_cast<double>(cells.width());
    a_row_ = (at(cells.left, cells.bottom) - first_) / static_cast<double>(cells.height());
  }
  [[nodiscard]] Eigen::Vector2d of(std::int64_t column, std::int64_t row) const {
    return first_ + static_cast<double>(column - cells_.left) * a_column_ +
           static_cast<double>(row - cells_.top) * a_row_;
  }

 private:
  CellRect cells_;
  Eigen::Vector2d first_, a_column_, a_row_;
};

/// kUnclassified outside.
ClassId class_in(const Raster<ClassId>& labels, const Eigen::Vector2d& at) {
  const double column = std::floor(at.x());
  const double row = std::floor(at.y());
  if (!(column >= 0.0) || !(row >= 0.0) || column >= labels.width() || row >= labels.height()) {
    return kUnclassified;
  }
  const ClassId id = labels.at(static_cast<int>(column), static_cast<int>(row));
  return can_lie_in_overhead(id) ? id : ClassId{kUnclassified};
}

Result<ImportedLabels> as_paint(const OverheadMap& raster,
                                const LabelDocument& document,
                                const WorkContext& context) {
  const CellRect whole = document.grid().whole();
  TilePainter painter(document);
  std::size_t taken = 0;
  for (std::int64_t top = 0; top < whole.bottom; top += kPaintTileSide) {
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "import: cancelled");
    context.report(static_cast<double>(top) / static_cast<double>(whole.bottom), "painting");
    for (std::int64_t left = 0; left < whole.right; left += kPaintTileSide) {
      const CellRect cells =
          CellRect{left, top, left + kPaintTileSide, top + kPaintTileSide}.cut_to(whole);
      const RasterPlace place(raster, document, cells);
      for (std::int64_t row = cells.top; row < cells.bottom; ++row) {
        for (std::int64_t column = cells.left; column < cells.right;) {
          const ClassId id = class_in(raster.labels, place.of(column, row));
          std::int64_t end = column + 1;
          while (end < cells.right && class_in(raster.labels, place.of(end, row)) == id) ++end;
          if (id != kUnclassified) {
            painter.put(row, column, end, id);
            taken += static_cast<std::size_t>(end - column);
          }
          column = end;
        }
      }
    }
  }
  return ImportedLabels{painter.edit("Import labels as paint"), {}, raster.labels.size(), taken};
}

Result<ImportedLabels> as_areas(const OverheadMap& raster,
                                const LabelDocument& document,
                                const WorkContext& context) {
  Raster<std::uint8_t> labels = raster.labels;
  for (std::uint8_t& id : labels.values()) {
    if (!can_lie_in_overhead(id)) id = kUnclassified;
  }
  context.report(0.0, "finding areas");
  const auto regions = polygonise(labels, kUnclassified);
  if (!regions) return forward_error(regions);
  ImportedLabels made;
  made.edit.title = "Import labels as areas";
  made.read = regions->size();
  std::array<std::int64_t, kClassCount> orders{};
  for (int id = 0; id < kClassCount; ++id) {
    orders.at(static_cast<std::size_t>(id)) = document.next_order(static_cast<ClassId>(id));
  }
  ObjectId next_id = document.next_id();
  for (const CellRegion& region : *regions) {
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "import: cancelled");
    LabelObject object{.id = next_id,
                       .kind = ObjectKind::kArea,
                       .class_id = region.value,
                       .order = orders.at(region.value),  // They do not cover each other.
                       .width_m = 0.0,
                       .rings = region.rings_in_cells,
                       .note = {}};
    for (Ring& ring : object.rings) {
      for (Eigen::Vector2d& point : ring) {
        point = onto(document.plane(), raster.plane, raster.enu_from_overhead(point));
      }
    }
    const CellRect cells = document.grid().cells_of(drawn_bounds(object), 0);
    if (cells.cut_to(document.grid().whole()).empty()) continue;
    if (const auto sound = check_object(object); !sound) return forward_error(sound);
    ++next_id;
    made.edit.objects.push_back({nullptr, std::make_shared<const LabelObject>(std::move(object))});
  }
  made.taken = made.edit.objects.size();
  return made;
}

}  // namespace

Result<ImportedLabels> import_raster(const OverheadMap& raster,
                                     RasterAs as,
                                     const LabelDocument& document,
                                     const WorkContext& context) {
  return as == RasterAs::kPaint ? as_paint(raster, document, context)
                                : as_areas(raster, document, context);
}

}  // namespace nadir
